#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/box_tree.hpp"

namespace delone::interp {

/// Nodes along a space-filling curve and their values.
template <std::size_t D>
struct ScatterNodes {
  std::vector<std::array<double, D>> points;
  std::vector<double> values;
};

/// Fewer nodes of about the same relative density: every eighth, and the outermost along
/// the axes, so that they reach as far. No more than an eighth and 2 D + 1; ascending.
template <std::size_t D>
[[nodiscard]] std::vector<std::int32_t> numbers_of_every_eighth(
    const ScatterNodes<D>& nodes) {
  std::vector<bool> is_taken(nodes.points.size());
  for (std::size_t i = 4; i < nodes.points.size(); i += 8) is_taken[i] = true;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto [low, high] = std::minmax_element(
        nodes.points.begin(), nodes.points.end(),
        [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    is_taken[static_cast<std::size_t>(low - nodes.points.begin())] = true;
    is_taken[static_cast<std::size_t>(high - nodes.points.begin())] = true;
  }
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < is_taken.size(); ++i)
    if (is_taken[i]) numbers.push_back(static_cast<std::int32_t>(i));
  return numbers;
}

/// Some of the nodes.
template <std::size_t D>
[[nodiscard]] ScatterNodes<D> selected(const ScatterNodes<D>& nodes,
                                       std::span<const std::int32_t> numbers) {
  ScatterNodes<D> result;
  for (const std::int32_t i : numbers) {
    result.points.push_back(nodes.points[at(i)]);
    result.values.push_back(nodes.values[at(i)]);
  }
  return result;
}

template <std::size_t D>
[[nodiscard]] ScatterNodes<D> every_eighth(const ScatterNodes<D>& nodes) {
  return selected(nodes, numbers_of_every_eighth(nodes));
}

/// Nodes as an index of points.
template <std::size_t D>
[[nodiscard]] BoxTree<D> point_tree(std::span<const std::array<double, D>> points) {
  std::vector<Box<D>> boxes;
  boxes.reserve(points.size());
  for (const auto& p : points) boxes.push_back({p, p});
  return BoxTree<D>(std::move(boxes));
}

/// The box of the ball of a radius; of an infinite one everything.
template <std::size_t D>
[[nodiscard]] Box<D> ball_box(const std::array<double, D>& center, double radius) {
  Box<D> box;
  for (std::size_t i = 0; i < D; ++i) {
    box.low[i] = center[i] - radius;
    box.high[i] = center[i] + radius;
  }
  return box;
}

/// How many nodes beyond the number asked for are looked up: on a lattice many are as
/// far as one another, and a radius that left them all out would leave too few.
inline constexpr std::size_t num_spare_nodes = 16;

/// Squares of less would vanish, where the set is about 1 wide.
inline constexpr double least_radius = 0x1p-500;

/// The radius within which the first `count` of `nearest` lie with all that are as far as
/// the last up to rounding: the distance of the first that is farther. `nearest` holds up
/// to num_spare_nodes more than `count`; infinite if it has no more than `count`.
template <class Found>
[[nodiscard]] double radius_beyond(std::span<const Found> nearest, std::size_t count) {
  if (nearest.size() <= count) return std::numeric_limits<double>::infinity();
  const double last = count == 0 ? 0 : nearest[count - 1].squared;
  for (const Found& f : nearest.subspan(count)) {
    if (f.squared > last * (1 + 0x1p-16))
      return std::max(std::sqrt(f.squared), least_radius);
  }
  return std::max(std::sqrt(nearest.back().squared) * 1.1, least_radius);
}

}  // namespace delone::interp
