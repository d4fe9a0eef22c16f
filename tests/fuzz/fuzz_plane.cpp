// Any points of the plane: either a precise error, or the triangulation that exact
// arithmetic and the library's own check accept, the same for the points backwards.

#include <algorithm>
#include <cmath>
#include <vector>

#include "delaunay/error.hpp"
#include "fuzz/fuzz_points.hpp"
#include "support/exact.hpp"
#include "tripack/defect.hpp"
#include "tripack/triangulation.hpp"

namespace {

using delone::tripack::Point2;
using delone::tripack::Triangulation;

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void check(const std::vector<Point2>& points) {
  const Triangulation t(points);
  if (const auto defect = delone::support::exact_defect(points, t.triangles())) {
    delone::fuzz::fail(defect->c_str());
  }
  if (const auto defect = find_defect(t)) delone::fuzz::fail(defect->c_str());
  if (const auto defect = delone::tripack::find_defect(points, t.triangles())) {
    delone::fuzz::fail(defect->c_str());
  }
  const Triangulation backwards(std::vector<Point2>(points.rbegin(), points.rend()));
  if (!(backwards.adjacency() == t.adjacency()))
    delone::fuzz::fail("depends on the input order");
  for (const Point2 p : points) {
    if (t.locate(p).kind != delone::delaunay::Location::Kind::node) {
      delone::fuzz::fail("a node is not found");
    }
  }
}

void check_refusal(const std::vector<Point2>& points) {
  try {
    const Triangulation t(points);
  } catch (const delone::Error& error) {
    if (!error.rows().empty()) return;
  }
  delone::fuzz::fail("a coordinate that is not finite is not refused");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto points = delone::fuzz::plane_points({data, size});
  if (std::all_of(points.begin(), points.end(), is_finite)) {
    check(points);
  } else {
    check_refusal(points);
  }
  return 0;
}
