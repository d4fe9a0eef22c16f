#include "stripack/hash.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using Triangles = std::vector<std::array<Node, 3>>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Sites in the order of their coordinates.
std::vector<Site> order_of_coordinates(const Triangulation& t) {
  const auto key = [&](Site s) {
    const Direction& p = t.points()[at(s)];
    return std::array{p.x(), p.y(), p.z()};
  };
  std::vector<Site> order(at(t.num_sites()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Site a, Site b) { return key(a) < key(b); });
  return order;
}

// `triangles` in sites.
Hash hash_of_sites(const Triangulation& t, Triangles triangles) {
  std::vector<double> coordinates;
  for (const Direction& p : t.points())
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return delaunay::hash_of_positions(order_of_coordinates(t), coordinates, 3,
                                     std::move(triangles));
}

void check_corners(std::span<const std::array<std::int32_t, 3>> triangles,
                   std::size_t num_rows) {
  for (const auto& triangle : triangles) {
    for (const std::int32_t corner : triangle) {
      if (corner >= 0 && at(corner) < num_rows) continue;
      throw Error("a triangle names row " + std::to_string(corner) + ", but there are " +
                  std::to_string(num_rows));
    }
  }
}

}  // namespace

Hash hash_of_rows(const Triangulation& t) {
  return delaunay::hash_of_triangles(t.num_rows(), t.triangles());
}

Hash hash_of_positions(const Triangulation& t) {
  Triangles triangles;
  triangles.reserve(static_cast<std::size_t>(t.num_triangles()));
  t.adjacency().for_each_triangle(
      [&](Arc a) { triangles.push_back(t.adjacency().left(a)); });
  return hash_of_sites(t, std::move(triangles));
}

Hash hash_of_positions(std::span<const Direction> points,
                       std::span<const std::array<std::int32_t, 3>> triangles) {
  check_corners(triangles, points.size());
  const Triangulation t(points);  // merges repeats
  Triangles in_sites;
  in_sites.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    in_sites.push_back({t.sites()[at(a)], t.sites()[at(b)], t.sites()[at(c)]});
    auto& [u, v, w] = in_sites.back();
    if (orientation(t.points()[at(u)], t.points()[at(v)], t.points()[at(w)]) < 0)
      std::swap(v, w);
  }
  return hash_of_sites(t, std::move(in_sites));
}

}  // namespace delone::stripack
