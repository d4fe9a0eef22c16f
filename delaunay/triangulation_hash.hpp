#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/hash.hpp"

/// What both rooms' hashes share. `T` is either room's Triangulation,
/// `coordinates(point)` an array of numbers, the same for equal positions.
namespace delone::delaunay {

/// Throws Error for a corner that is no row.
void check_corners(std::span<const std::array<std::int32_t, 3>> triangles,
                   std::size_t num_rows);

/// Of the positions in the order of their coordinates, and `triangles`, in sites.
template <class T, class Coordinates>
[[nodiscard]] Hash hash_of_sites(const T& t, Coordinates coordinates,
                                 std::vector<std::array<Node, 3>> triangles) {
  const auto points = t.points();
  const auto key = [&](Site s) {
    return coordinates(points[static_cast<std::size_t>(s)]);
  };
  std::vector<Site> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Site a, Site b) { return key(a) < key(b); });
  std::vector<double> numbers;
  std::size_t num_coordinates = 0;
  for (const auto& p : points) {
    const auto c = coordinates(p);
    num_coordinates = c.size();
    numbers.insert(numbers.end(), c.begin(), c.end());
  }
  return hash_of_positions(order, numbers, num_coordinates, std::move(triangles));
}

/// Of a triangulation as a figure.
template <class T, class Coordinates>
[[nodiscard]] Hash hash_of_figure(const T& t, Coordinates coordinates) {
  std::vector<std::array<Node, 3>> triangles;
  triangles.reserve(static_cast<std::size_t>(t.num_triangles()));
  t.adjacency().for_each_triangle(
      [&](Arc a) { triangles.push_back(t.adjacency().left(a)); });
  return hash_of_sites(t, coordinates, std::move(triangles));
}

/// Of a list of triangles over the rows of `t`, of either orientation.
template <class T, class Coordinates, class Orientation>
[[nodiscard]] Hash hash_of_list(const T& t, Coordinates coordinates,
                                Orientation orientation,
                                std::span<const std::array<std::int32_t, 3>> triangles) {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  std::vector<std::array<Node, 3>> in_sites;
  in_sites.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    in_sites.push_back({t.sites()[at(a)], t.sites()[at(b)], t.sites()[at(c)]});
    auto& [u, v, w] = in_sites.back();
    if (orientation(t.points()[at(u)], t.points()[at(v)], t.points()[at(w)]) < 0)
      std::swap(v, w);
  }
  return hash_of_sites(t, coordinates, std::move(in_sites));
}

}  // namespace delone::delaunay
