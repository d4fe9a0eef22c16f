#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// 128 bits that stand for a triangulation. Equal triangulations have equal hashes on
/// every machine; different ones by accident once in 10^19 pairs. Not cryptographic.
struct Hash {
  std::uint64_t high = 0, low = 0;
  friend auto operator<=>(const Hash&, const Hash&) = default;
};

/// 32 hexadecimal digits.
[[nodiscard]] std::string to_string(const Hash& hash);

/// Hashes a sequence of words.
///
/// Two lanes, each h <- mix(h xor word) with the finaliser of splitmix64 (G. L. Steele,
/// D. Lea, C. H. Flood, OOPSLA 2014), the second over the complement of the words.
class Hasher {
 public:
  void add(std::uint64_t word) noexcept;
  /// The bits of a number, those of +0 for -0.
  void add(double number) noexcept;
  [[nodiscard]] Hash result() const noexcept { return {high_, low_}; }

 private:
  std::uint64_t high_ = 0x243F6A8885A308D3u, low_ = 0x13198A2E03707344u;  // of pi
};

/// Of the number of nodes and the triangles as they stand.
[[nodiscard]] Hash hash_of_triangles(std::int64_t num_nodes,
                                     std::span<const std::array<Node, 3>> triangles);

/// Of coordinates in the order of `order` and then the triangles (counter-clockwise, in
/// the numbers that `order` lists) renumbered by it, canonical. `words`: for each number
/// its coordinates, `num_words` apiece. O(n log n).
[[nodiscard]] Hash hash_of_positions(std::span<const std::int32_t> order,
                                     std::span<const double> coordinates,
                                     std::size_t num_coordinates,
                                     std::vector<std::array<Node, 3>> triangles);

}  // namespace delone::delaunay
