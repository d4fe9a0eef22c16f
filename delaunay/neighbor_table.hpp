#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// A node near a query point: its row (of repeated rows the first) and how far it is.
struct Neighbor {
  Node row = none;
  double distance = 0;
  friend bool operator==(const Neighbor&, const Neighbor&) = default;
};

/// The nodes near each of many query points, in flat arrays: those of query i are entries
/// offsets[i] to offsets[i + 1] - 1 of `rows` and `distances`, nearest first.
struct NeighborTable {
  std::vector<std::int64_t> offsets{0};
  std::vector<Node> rows;
  std::vector<double> distances;

  [[nodiscard]] std::int64_t num_queries() const noexcept {
    return static_cast<std::int64_t>(offsets.size()) - 1;
  }
  [[nodiscard]] std::span<const Node> rows_of(std::int64_t query) const noexcept {
    return std::span(rows).subspan(begin(query), count(query));
  }
  [[nodiscard]] std::span<const double> distances_of(std::int64_t query) const noexcept {
    return std::span(distances).subspan(begin(query), count(query));
  }
  friend bool operator==(const NeighborTable&, const NeighborTable&) = default;

 private:
  [[nodiscard]] std::size_t begin(std::int64_t query) const noexcept {
    return static_cast<std::size_t>(offsets[static_cast<std::size_t>(query)]);
  }
  [[nodiscard]] std::size_t count(std::int64_t query) const noexcept {
    return static_cast<std::size_t>(offsets[static_cast<std::size_t>(query) + 1]) -
           begin(query);
  }
};

}  // namespace delone::delaunay
