#pragma once

#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "stripack/direction.hpp"

namespace delone::stripack {

/// By x, then y, then z.
[[nodiscard]] bool lexicographically_less(const Direction& a,
                                          const Direction& b) noexcept;

/// Do two stored triples have exactly the same direction? (Their lengths may differ by an
/// ulp.)
[[nodiscard]] bool is_same_direction(const Direction& a, const Direction& b) noexcept;

/// Sites that all lie on one great circle, in their order along it.
///
/// `order` lists them so that consecutive ones are less than pi apart; if the last and
/// the first are too, the chain is closed. An open chain begins after the gap of pi or
/// more.
struct GreatCircleChain {
  std::vector<delaunay::Site> order;
  delaunay::Adjacency::Chain kind = delaunay::Adjacency::Chain::open;
};

/// Exact. `points`: different directions with every three on one great circle. O(n log
/// n).
[[nodiscard]] GreatCircleChain order_along_great_circle(
    std::span<const Direction> points);

/// Is p, exactly, strictly inside the shorter arc from a to b (less than pi apart)?
[[nodiscard]] bool is_inside_arc(const Direction& a, const Direction& b,
                                 const Direction& p) noexcept;

}  // namespace delone::stripack
