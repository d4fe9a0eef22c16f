// Any points and segments of the plane and the sphere: crossings split, the result is
// what the library's own check accepts, and the same for the input backwards; crossings
// refused, either an error that names two segments or a result without added vertices.
// The first bytes choose the segments, the rest the points (see fuzz_points.hpp).

#include <algorithm>
#include <cmath>
#include <vector>

#include "delaunay/error.hpp"
#include "fuzz/fuzz_points.hpp"
#include "stripack/constrained_defect.hpp"
#include "tripack/constrained_defect.hpp"
#include "tripack/refine.hpp"

namespace {

using delone::delaunay::ConstraintOptions;
using delone::delaunay::Crossings;
using delone::delaunay::Domain;
using delone::fuzz::fail;
using Bytes = std::span<const std::uint8_t>;
using Segments = std::vector<std::array<std::int32_t, 2>>;

// Two bytes a segment; points are few enough for one byte.
Segments segments_of(Bytes bytes, std::size_t num_points) {
  Segments segments;
  for (std::size_t i = 0; num_points > 0 && i + 1 < bytes.size(); i += 2) {
    segments.push_back({static_cast<std::int32_t>(bytes[i] % num_points),
                        static_cast<std::int32_t>(bytes[i + 1] % num_points)});
  }
  return segments;
}

template <class Triangulation>
void check(const Triangulation& t) {
  if (const auto defect = find_defect(t)) fail(defect->c_str());
}

Segments backwards(Segments segments, std::size_t num_points) {
  const auto last = static_cast<std::int32_t>(num_points) - 1;
  std::reverse(segments.begin(), segments.end());
  for (auto& [a, b] : segments) a = last - a, b = last - b, std::swap(a, b);
  return segments;
}

void check_plane(const delone::tripack::PlanarGraph& graph) {
  using namespace delone::tripack;
  const ConstraintOptions split{Domain::hull, Crossings::split};
  const ConstrainedTriangulation t(graph, split);
  check(t);
  PlanarGraph reversed = graph;
  std::reverse(reversed.points.begin(), reversed.points.end());
  reversed.segments = backwards(graph.segments, graph.points.size());
  const ConstrainedTriangulation other(reversed, split);
  if (!std::ranges::equal(t.points(), other.points()) ||
      t.num_triangles() != other.num_triangles())
    fail("depends on the input order");
  check(refine(graph, {.max_added = 200, .constraints = split}).triangulation);
  try {
    const ConstrainedTriangulation strict(graph, {Domain::enclosed, Crossings::error});
    check(strict);
    if (strict.num_rows() != strict.num_input_rows()) fail("a vertex was added");
  } catch (const delone::Error& error) {
    if (error.rows().size() != 2) fail("a crossing that names no two segments");
  }
}

void check_sphere(const delone::stripack::SphereGraph& graph) {
  using namespace delone::stripack;
  try {
    check(ConstrainedTriangulation(
        graph, {.domain = Domain::hull, .crossings = Crossings::split}));
  } catch (const delone::Error& error) {
    if (error.rows().size() != 1) throw;  // antipodes
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Bytes bytes(data, size);
  const std::size_t num = std::min<std::size_t>(2 * (bytes[0] % 24), size - 1);
  const Bytes chosen = bytes.subspan(1, num), rest = bytes.subspan(1 + num);
  delone::tripack::PlanarGraph graph;
  graph.points = delone::fuzz::plane_points(rest);
  const auto is_finite = [](auto p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (std::all_of(graph.points.begin(), graph.points.end(), is_finite)) {
    graph.segments = segments_of(chosen, graph.points.size());
    check_plane(graph);
  }
  delone::stripack::SphereGraph sphere{.points = delone::fuzz::sphere_points(rest)};
  sphere.arcs = segments_of(chosen, sphere.points.size());
  check_sphere(sphere);
  return 0;
}
