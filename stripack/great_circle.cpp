#include "stripack/great_circle.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::Adjacency;
using delaunay::Site;

std::array<Direction, 3> axes() {
  return {Direction::from(0, 0, 1), Direction::from(0, 1, 0), Direction::from(1, 0, 0)};
}

// An axis that a and b see on one side: their great circle does not hold it. {0} if a and
// b are parallel or opposite.
struct Viewpoint {
  Direction axis;
  int sign = 0;
  // +1 if b comes after a by less than pi, -1 if by more, 0 if they are opposite or
  // equal.
  [[nodiscard]] int turn(const Direction& a, const Direction& b) const {
    return sign * orientation(a, b, axis);
  }
};

Viewpoint viewpoint(const Direction& a, const Direction& b) {
  for (const Direction& axis : axes()) {
    const int sign = orientation(a, b, axis);
    if (sign != 0) return {axis, sign};
  }
  return {};
}

Viewpoint viewpoint_of(std::span<const Direction> points) {
  Viewpoint view;
  for (std::size_t i = 1; i < points.size() && view.sign == 0; ++i)
    view = viewpoint(points[0], points[i]);
  // The sense of rotation must not depend on which points came first.
  if (view.sign != 0) view.sign = 1;
  return view;
}

// Quarter of the turn from `start` in which p lies: 0 at it, 1 before, 2 at, 3 beyond the
// opposite.
int sector(const Viewpoint& view, const Direction& start, const Direction& p) {
  if (p == start) return 0;
  const int turn = view.turn(start, p);
  return turn > 0 ? 1 : turn == 0 ? 2 : 3;
}

}  // namespace

bool lexicographically_less(const Direction& a, const Direction& b) noexcept {
  return std::array{a.x(), a.y(), a.z()} < std::array{b.x(), b.y(), b.z()};
}

bool is_same_direction(const Direction& a, const Direction& b) noexcept {
  if (a == b) return true;
  if (a.x() * b.x() + a.y() * b.y() + a.z() * b.z() < 0) return false;
  const auto axis = axes();
  return std::all_of(axis.begin(), axis.end(),
                     [&](const Direction& e) { return orientation(a, b, e) == 0; });
}

GreatCircleChain order_along_great_circle(std::span<const Direction> points) {
  const auto at = [&](Site s) -> const Direction& {
    return points[static_cast<std::size_t>(s)];
  };
  GreatCircleChain chain;
  chain.order.resize(points.size());
  std::iota(chain.order.begin(), chain.order.end(), 0);
  if (points.empty()) return chain;
  const Viewpoint view = viewpoint_of(points);
  const Direction start =
      *std::min_element(points.begin(), points.end(), lexicographically_less);
  std::sort(chain.order.begin(), chain.order.end(), [&](Site s, Site t) {
    const int a = sector(view, start, at(s)), b = sector(view, start, at(t));
    return a != b ? a < b : view.turn(at(s), at(t)) > 0;
  });
  // A gap of pi or more: the chain begins after it.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t after = i + 1 == points.size() ? 0 : i + 1;
    if (view.turn(at(chain.order[i]), at(chain.order[after])) > 0) continue;
    std::rotate(chain.order.begin(),
                chain.order.begin() + static_cast<std::ptrdiff_t>(after),
                chain.order.end());
    return chain;
  }
  chain.kind = Adjacency::Chain::closed;
  return chain;
}

bool is_inside_arc(const Direction& a, const Direction& b, const Direction& p) noexcept {
  const Viewpoint view = viewpoint(a, b);
  return orientation(a, b, p) == 0 && view.turn(a, p) > 0 && view.turn(p, b) > 0;
}

}  // namespace delone::stripack
