// Any directions: the triangulation that exact arithmetic and the library's own check
// accept, the same for the directions backwards.

#include <vector>

#include "fuzz/fuzz_points.hpp"
#include "stripack/defect.hpp"
#include "stripack/triangulation.hpp"
#include "support/exact.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using delone::stripack::Direction;
  using delone::stripack::Triangulation;
  const auto points = delone::fuzz::sphere_points({data, size});
  const Triangulation t(points);
  if (const auto defect = delone::support::exact_defect(points, t.triangles())) {
    delone::fuzz::fail(defect->c_str());
  }
  if (const auto defect = find_defect(t)) delone::fuzz::fail(defect->c_str());
  if (const auto defect = delone::stripack::find_defect(points, t.triangles())) {
    delone::fuzz::fail(defect->c_str());
  }
  const Triangulation backwards(std::vector<Direction>(points.rbegin(), points.rend()));
  if (!(backwards.adjacency() == t.adjacency()))
    delone::fuzz::fail("depends on the input order");
  for (const Direction& p : points) {
    if (t.locate(p).kind != delone::delaunay::Location::Kind::node) {
      delone::fuzz::fail("a node is not found");
    }
  }
  return 0;
}
