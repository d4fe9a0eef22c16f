#include "delaunay/triangle_list.hpp"

#include <algorithm>
#include <tuple>

namespace delone::delaunay {
namespace {

/// A side of a triangle.
struct Side {
  Node low, high;  // its ends
  std::int32_t triangle;
  std::uint8_t entry;  // of the triangle's neighbours
  [[nodiscard]] auto ends() const { return std::tie(low, high); }
  [[nodiscard]] auto key() const { return std::tie(low, high, triangle, entry); }
};

std::vector<Side> sorted_sides(std::span<const TriangleCorners> triangles,
                               SideOrder order) {
  const std::size_t first = order == SideOrder::opposite_corner ? 1 : 0;
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(triangles[t][(k + first) % 3], triangles[t][(k + first + 1) % 3]);
      sides.push_back(
          {low, high, static_cast<std::int32_t>(t), static_cast<std::uint8_t>(k)});
    }
  }
  std::ranges::sort(sides, {}, &Side::key);
  return sides;
}

/// In the ring of `from`, `next` comes after `to`.
struct Step {
  Node from, to, next;
  [[nodiscard]] auto arc() const { return std::tie(from, to); }
};

std::vector<Step> sorted_steps(const NeighborRings& rings) {
  std::vector<Step> steps;
  for (std::size_t v = 0; v < rings.size(); ++v) {
    const auto& ring = rings[v];
    for (std::size_t i = 0; i < ring.size(); ++i)
      steps.push_back({static_cast<Node>(v), ring[i], ring[(i + 1) % ring.size()]});
  }
  std::ranges::sort(steps, {}, &Step::arc);
  return steps;
}

/// What follows `to` in the ring of `from`; none if `to` is not in it.
Node next_of(const std::vector<Step>& steps, Node from, Node to) {
  const auto found = std::ranges::lower_bound(steps, std::tie(from, to), {}, &Step::arc);
  const bool is_there = found != steps.end() && found->from == from && found->to == to;
  return is_there ? found->next : none;
}

}  // namespace

std::vector<TriangleCorners> canonical(std::vector<TriangleCorners> triangles) {
  for (TriangleCorners& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

std::vector<std::array<std::int32_t, 3>> triangle_neighbors(
    std::span<const TriangleCorners> triangles, SideOrder order) {
  std::vector<std::array<std::int32_t, 3>> result(triangles.size(), {none, none, none});
  const std::vector<Side> sides = sorted_sides(triangles, order);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& a = sides[i];
    const Side& b = sides[i + 1];
    if (a.ends() != b.ends()) continue;
    result[static_cast<std::size_t>(a.triangle)][a.entry] = b.triangle;
    result[static_cast<std::size_t>(b.triangle)][b.entry] = a.triangle;
    ++i;
  }
  return result;
}

std::vector<TriangleCorners> triangles_of_rings(const NeighborRings& rings) {
  const std::vector<Step> steps = sorted_steps(rings);
  std::vector<TriangleCorners> triangles;
  for (const auto& [v, w, x] : steps) {
    if (w <= v || x <= v || w == x) continue;
    // Around w the side to v comes after that to x, around x that to w after that to v.
    if (next_of(steps, w, x) == v && next_of(steps, x, v) == w)
      triangles.push_back({v, w, x});
  }
  std::ranges::sort(triangles);
  return triangles;
}

LoneArc find_lone_arc(const NeighborRings& rings) {
  const std::vector<Step> steps = sorted_steps(rings);
  for (const Step& step : steps) {
    const bool is_answered =
        std::ranges::binary_search(steps, std::tie(step.to, step.from), {}, &Step::arc);
    if (!is_answered) return {step.from, step.to};
  }
  return {};
}

}  // namespace delone::delaunay
