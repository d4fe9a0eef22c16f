#include "tripack/hash.hpp"

#include <array>

#include "delaunay/triangulation_hash.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

auto coordinates(const Point2& p) { return std::array{p.x, p.y}; }

}  // namespace

Hash hash_of_rows(const Triangulation& t) {
  return delaunay::hash_of_triangles(t.num_rows(), t.triangles());
}

Hash hash_of_positions(const Triangulation& t) {
  return delaunay::hash_of_figure(t, coordinates);
}

Hash hash_of_positions(std::span<const Point2> points,
                       std::span<const std::array<std::int32_t, 3>> triangles) {
  delaunay::check_corners(triangles, points.size());
  // The triangulation merges repeats.
  return delaunay::hash_of_list(Triangulation(points), coordinates, orientation,
                                triangles);
}

}  // namespace delone::tripack
