#include "delaunay/hash.hpp"

#include <bit>
#include <cstddef>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/triangle_list.hpp"
#include "delaunay/triangulation_hash.hpp"

namespace delone::delaunay {

namespace {

std::uint64_t mixed(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

void add_triangles(Hasher& hasher, std::span<const std::array<Node, 3>> triangles) {
  hasher.add(std::uint64_t{triangles.size()});
  for (const auto& triangle : triangles) {
    for (const Node corner : triangle) hasher.add(static_cast<std::uint64_t>(corner));
  }
}

}  // namespace

std::string to_string(const Hash& hash) {
  std::string text;
  for (const std::uint64_t word : {hash.high, hash.low}) {
    for (int shift = 60; shift >= 0; shift -= 4)
      text += "0123456789abcdef"[(word >> shift) & 15u];
  }
  return text;
}

void Hasher::add(std::uint64_t word) noexcept {
  high_ = mixed(high_ ^ word);
  low_ = mixed(low_ ^ ~word);
}

void Hasher::add(double number) noexcept {
  add(std::bit_cast<std::uint64_t>(number + 0.0));
}

Hash hash_of_triangles(std::int64_t num_nodes,
                       std::span<const std::array<Node, 3>> triangles) {
  Hasher hasher;
  hasher.add(static_cast<std::uint64_t>(num_nodes));
  add_triangles(hasher, triangles);
  return hasher.result();
}

Hash hash_of_positions(std::span<const std::int32_t> order,
                       std::span<const double> coordinates, std::size_t num_coordinates,
                       std::vector<std::array<Node, 3>> triangles) {
  Hasher hasher;
  hasher.add(std::uint64_t{order.size()});
  std::vector<Node> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto number = static_cast<std::size_t>(order[i]);
    rank[number] = static_cast<Node>(i);
    for (const double c : coordinates.subspan(number * num_coordinates, num_coordinates))
      hasher.add(c);
  }
  for (auto& triangle : triangles) {
    for (Node& corner : triangle) corner = rank[static_cast<std::size_t>(corner)];
  }
  add_triangles(hasher, canonical(std::move(triangles)));
  return hasher.result();
}

void check_corners(std::span<const std::array<std::int32_t, 3>> triangles,
                   std::size_t num_rows) {
  for (const auto& triangle : triangles) {
    for (const std::int32_t corner : triangle) {
      if (corner >= 0 && static_cast<std::size_t>(corner) < num_rows) continue;
      throw Error("a triangle names row " + std::to_string(corner) + ", but there are " +
                  std::to_string(num_rows));
    }
  }
}

}  // namespace delone::delaunay
