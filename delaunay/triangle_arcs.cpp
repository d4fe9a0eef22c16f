#include "delaunay/triangle_arcs.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace delone::delaunay {

namespace {

using Ends = std::array<Node, 2>;

Ends side_opposite(const TriangleCorners& t, std::size_t k) {
  const auto [low, high] = std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
  return {low, high};
}

/// A side of a triangle, directed, and the corner on its left.
struct LeftSide {
  Node from, to, apex;
  friend auto operator<=>(const LeftSide&, const LeftSide&) = default;
};

class BoundaryWalk {
 public:
  explicit BoundaryWalk(std::span<const TriangleCorners> triangles) {
    for (const auto& [a, b, c] : triangles)
      sides_.insert(sides_.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
    std::ranges::sort(sides_);
    is_used_.resize(sides_.size());
  }

  [[nodiscard]] std::vector<std::vector<Node>> loops() {
    std::vector<std::vector<Node>> result;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (is_used_[i] || !is_boundary(sides_[i])) continue;
      result.push_back(loop_from(i));
    }
    for (auto& loop : result)
      std::rotate(loop.begin(), std::ranges::min_element(loop), loop.end());
    std::ranges::sort(result);
    return result;
  }

 private:
  static constexpr std::size_t absent = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t find(Node from, Node to) const {
    const auto found = std::ranges::lower_bound(sides_, LeftSide{from, to, 0});
    const bool is_there = found != sides_.end() && found->from == from && found->to == to;
    return is_there ? static_cast<std::size_t>(found - sides_.begin()) : absent;
  }
  [[nodiscard]] bool is_boundary(const LeftSide& s) const {
    return find(s.to, s.from) == absent;
  }

  // Around the end of a boundary side, from triangle to triangle, to the side that leaves
  // it with the outside on its right.
  [[nodiscard]] std::size_t next(std::size_t i) const {
    Node apex = sides_[i].apex;
    const Node pivot = sides_[i].to;
    std::size_t out = find(pivot, apex);
    // A list that is no surface may send it round for ever.
    for (std::size_t steps = 0; out != absent && steps < sides_.size(); ++steps) {
      const std::size_t back = find(apex, pivot);
      if (back == absent) return out;
      apex = sides_[back].apex;
      out = find(pivot, apex);
    }
    return absent;
  }

  std::vector<Node> loop_from(std::size_t first) {
    std::vector<Node> loop;
    for (std::size_t i = first; i != absent && !is_used_[i]; i = next(i)) {
      is_used_[i] = true;
      loop.push_back(sides_[i].from);
    }
    return loop;
  }

  std::vector<LeftSide> sides_;
  std::vector<bool> is_used_;
};

}  // namespace

TriangleArcs triangle_arcs(std::span<const TriangleCorners> triangles) {
  TriangleArcs arcs;
  for (const TriangleCorners& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) arcs.ends.push_back(side_opposite(t, k));
  }
  std::ranges::sort(arcs.ends);
  arcs.ends.erase(std::unique(arcs.ends.begin(), arcs.ends.end()), arcs.ends.end());
  for (const TriangleCorners& t : triangles) {
    auto& numbers = arcs.of_triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::ranges::lower_bound(arcs.ends, side_opposite(t, k));
      numbers[k] = static_cast<std::int32_t>(at - arcs.ends.begin());
    }
  }
  return arcs;
}

std::vector<std::vector<Node>> boundary_loops(
    std::span<const TriangleCorners> triangles) {
  return BoundaryWalk(triangles).loops();
}

}  // namespace delone::delaunay
