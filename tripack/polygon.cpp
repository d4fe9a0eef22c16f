#include "tripack/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "delaunay/double_double.hpp"
#include "tripack/predicates.hpp"
#include "tripack/segments.hpp"

namespace delone::tripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;

struct WideMoments {
  DoubleDouble area2;   // twice the area
  DoubleDouble x6, y6;  // six times the first moments about the first corner
};

// Fan from the first corner: the triangles' areas are the cyclic formula's terms in
// coordinates that begin there.
WideMoments moments_of(std::span<const Point2> corners) {
  WideMoments sum;
  const Point2 o = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const DoubleDouble bx = two_difference(corners[i].x, o.x),
                       by = two_difference(corners[i].y, o.y),
                       cx = two_difference(corners[i + 1].x, o.x),
                       cy = two_difference(corners[i + 1].y, o.y);
    const DoubleDouble area2 = delaunay::determinant(bx, by, cx, cy);
    sum.area2 = sum.area2 + area2;
    sum.x6 = sum.x6 + area2 * (bx + cx);
    sum.y6 = sum.y6 + area2 * (by + cy);
  }
  return sum;
}

Point2 mean(std::span<const Point2> corners) {
  Point2 sum;
  const auto n = static_cast<double>(corners.size());
  for (const Point2 p : corners) {
    sum.x += p.x / n;
    sum.y += p.y / n;
  }
  return sum;
}

bool is_on_side(Point2 a, Point2 b, Point2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y) &&
         orientation(a, b, p) == 0;
}

// Is the side crossed by the ray from p in the direction of growing x? Its lower end
// belongs to it, its upper one does not.
bool is_crossed_by_ray(Point2 a, Point2 b, Point2 p) {
  if ((a.y <= p.y) == (b.y <= p.y)) return false;
  const int side = orientation(a, b, p);
  return a.y < b.y ? side > 0 : side < 0;
}

class SideSweep {
 public:
  explicit SideSweep(std::span<const Point2> corners) : corners_(corners) {}

  [[nodiscard]] std::optional<std::array<std::int32_t, 2>> find() {
    const std::size_t n = corners_.size();
    std::vector<std::int32_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return low_x(a) != low_x(b) ? low_x(a) < low_x(b) : a < b;
    });
    for (const std::int32_t side : order) {
      if (from(side) == to(side)) return std::array{side, side};
    }
    std::vector<std::int32_t> active;
    for (const std::int32_t side : order) {
      std::erase_if(active, [&](std::int32_t a) { return high_x(a) < low_x(side); });
      for (const std::int32_t other : active) {
        if (meet_badly(std::min(side, other), std::max(side, other)))
          return std::array{std::min(side, other), std::max(side, other)};
      }
      active.push_back(side);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Point2 from(std::int32_t side) const {
    return corners_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] Point2 to(std::int32_t side) const {
    return corners_[(static_cast<std::size_t>(side) + 1) % corners_.size()];
  }
  [[nodiscard]] double low_x(std::int32_t side) const {
    return std::min(from(side).x, to(side).x);
  }
  [[nodiscard]] double high_x(std::int32_t side) const {
    return std::max(from(side).x, to(side).x);
  }
  // Neighbours share one corner and nothing else.
  [[nodiscard]] bool meet_badly(std::int32_t a, std::int32_t b) const {
    const Meeting kind = meeting(from(a), to(a), from(b), to(b));
    const auto n = static_cast<std::int32_t>(corners_.size());
    const bool are_neighbors = b == a + 1 || (a == 0 && b == n - 1);
    if (!are_neighbors) return kind != Meeting::none;
    return kind == Meeting::overlap || n == 2;
  }

  std::span<const Point2> corners_;
};

}  // namespace

double signed_area(std::span<const Point2> corners) noexcept {
  if (corners.size() < 3) return 0;
  return moments_of(corners).area2.rounded() / 2;
}

Point2 centroid(std::span<const Point2> corners) noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (corners.empty()) return {nan, nan};
  if (corners.size() < 3) return mean(corners);
  const WideMoments m = moments_of(corners);
  if (m.area2.high == 0) return mean(corners);
  const DoubleDouble x = m.x6 / (m.area2 * 3), y = m.y6 / (m.area2 * 3);
  return {(x + DoubleDouble{corners[0].x, 0}).rounded(),
          (y + DoubleDouble{corners[0].y, 0}).rounded()};
}

double perimeter(std::span<const Point2> corners) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

Containment locate(std::span<const Point2> corners, Point2 p) noexcept {
  bool is_inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    if (is_on_side(a, b, p)) return Containment::boundary;
    if (is_crossed_by_ray(a, b, p)) is_inside = !is_inside;
  }
  return is_inside ? Containment::inside : Containment::outside;
}

bool contains(std::span<const Point2> corners, Point2 p) noexcept {
  return locate(corners, p) != Containment::outside;
}

std::optional<std::array<std::int32_t, 2>> find_self_intersection(
    std::span<const Point2> corners) {
  if (corners.size() < 2) return std::nullopt;
  return SideSweep(corners).find();
}

bool is_convex(std::span<const Point2> corners) noexcept {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0)
      return false;
  }
  return n >= 3;
}

}  // namespace delone::tripack
