#pragma once

#include <cstddef>

namespace delone::interp {

/// Nodes of a grid inside one triangle, gathered across its rows, so that four or eight
/// are evaluated at once however short the rows are. Plain arrays: code for several
/// instruction sets reads them.
struct NodeBatch {
  static constexpr std::size_t lanes = 8, capacity = 64;

  double x[capacity], y[capacity], z[capacity];  ///< z on the sphere only
  double* values[capacity];                      ///< where they belong
  std::size_t count = 0;

  [[nodiscard, gnu::always_inline]] std::size_t size() const noexcept { return count; }
  [[nodiscard]] bool is_full() const noexcept { return count == capacity; }
  /// Not if it is full.
  void add(double* value, double px, double py, double pz = 0) noexcept {
    x[count] = px, y[count] = py, z[count] = pz;
    values[count] = value;
    ++count;
  }
  /// Repeats the last node up to a whole number of lanes.
  void fill_lanes() noexcept {
    for (std::size_t i = count; i % lanes != 0; ++i)
      x[i] = x[count - 1], y[i] = y[count - 1], z[i] = z[count - 1];
  }
  void clear() noexcept { count = 0; }
};

/// A surface in a triangle that evaluates batches; others fill rows.
template <class Facet>
concept FillsBatches = requires(const Facet& facet, NodeBatch& batch) {
  facet.fill(batch);
};

}  // namespace delone::interp
