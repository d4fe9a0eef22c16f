#include "stripack/hash.hpp"

#include <array>

#include "delaunay/triangulation_hash.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

auto coordinates(const Direction& p) { return std::array{p.x(), p.y(), p.z()}; }

}  // namespace

Hash hash_of_rows(const Triangulation& t) {
  return delaunay::hash_of_triangles(t.num_rows(), t.triangles());
}

Hash hash_of_positions(const Triangulation& t) {
  return delaunay::hash_of_figure(t, coordinates);
}

Hash hash_of_positions(std::span<const Direction> points,
                       std::span<const std::array<std::int32_t, 3>> triangles) {
  delaunay::check_corners(triangles, points.size());
  // The triangulation merges repeats.
  return delaunay::hash_of_list(Triangulation(points), coordinates, orientation,
                                triangles);
}

}  // namespace delone::stripack
