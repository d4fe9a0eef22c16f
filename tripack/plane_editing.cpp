#include "tripack/plane_editing.hpp"

#include <algorithm>
#include <limits>

namespace delone::tripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Of different points on a line.
bool is_between(Point2 a, Point2 p, Point2 b) {
  return lexicographically_less(a, p) == lexicographically_less(p, b);
}

// +1 if an even number of exchanges puts the points into lexicographic order.
int parity(std::array<Point2, 4> p) {
  int sign = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (lexicographically_less(p[j], p[i])) sign = -sign;
    }
  }
  return sign;
}

}  // namespace

bool PlaneEditing::sees(std::span<const Point2> points, const std::array<Site, 3>& corner,
                        Point2 q) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (corner[k] != infinity) continue;
    const Point2 from = points[at(corner[(k + 1) % 3])];
    const Point2 to = points[at(corner[(k + 2) % 3])];
    const int s = orientation(from, to, q);
    // A point on the line of a hull edge is inside its (infinite) circle if it is between
    // the ends.
    return s != 0 ? s > 0 : q != from && q != to && is_between(from, q, to);
  }
  return in_circle_perturbed(points[at(corner[0])], points[at(corner[1])],
                             points[at(corner[2])], q) > 0;
}

bool PlaneEditing::is_flat(std::span<const Point2> points,
                           std::span<const Site> nodes) noexcept {
  if (nodes.size() < 3) return true;
  const Point2 a = points[at(nodes[0])], b = points[at(nodes[1])];
  return std::all_of(nodes.begin() + 2, nodes.end(),
                     [&](Site v) { return orientation(a, b, points[at(v)]) == 0; });
}

PlaneEditing::Chart::Chart(std::span<const Point2> points, Point2 p) noexcept
    : low_(p), high_(p) {
  constexpr double cells = 4294967295.0, largest = std::numeric_limits<double>::max();
  for (const Point2 q : points) {
    low_ = {std::min(low_.x, q.x), std::min(low_.y, q.y)};
    high_ = {std::max(high_.x, q.x), std::max(high_.y, q.y)};
  }
  const double half = std::max(high_.x / 2 - low_.x / 2, high_.y / 2 - low_.y / 2);
  low_ = {std::max(low_.x - half, -largest), std::max(low_.y - half, -largest)};
  high_ = {std::min(high_.x + half, largest), std::min(high_.y + half, largest)};
  const auto scale = [=](double low, double high) {
    const double extent = high / 2 - low / 2;
    return extent > 0 ? std::min(cells / extent, largest) : 0.0;
  };
  scale_ = Point2{scale(low_.x, high_.x), scale(low_.y, high_.y)};
}

// Halves, so that the largest doubles do not overflow.
std::uint32_t PlaneEditing::Chart::cell(double v, double low, double scale) noexcept {
  const double c = (v / 2 - low / 2) * scale;
  return !(c > 0) ? 0 : c >= 4294967295.0 ? 4294967295u : static_cast<std::uint32_t>(c);
}

PlaneEditing::Star::Star(std::span<const Point2> points, Site removed,
                         std::span<const Site> rim)
    : removed_(points[at(removed)]), infinity_(none) {
  rim_.reserve(rim.size());
  for (const Site v : rim) {
    if (v == infinity) infinity_ = static_cast<Site>(rim_.size());
    rim_.push_back(points[at(v)]);
  }
}

// orientation(a, b, q) after bending; not 0, since removed_ is on no line with two of
// them.
int PlaneEditing::Star::bent_side(Point2 a, Point2 b, Point2 q) const noexcept {
  if (const int s = orientation(a, b, q); s != 0) return s;
  if (is_between(a, q, b)) return orientation(a, b, removed_);
  return is_between(b, a, q) ? orientation(b, q, removed_) : orientation(q, a, removed_);
}

bool PlaneEditing::Star::sees(const std::array<Site, 3>& corner, Site q) const noexcept {
  const Point2 a = point(corner[0]), b = point(corner[1]), c = point(corner[2]);
  const Point2 p = point(q);
  if (infinity_ != none) {
    if (q == infinity_) return bent_side(b, c, a) < 0;
    if (corner[0] == infinity_) return bent_side(b, c, p) > 0;
    if (corner[1] == infinity_) return bent_side(c, a, p) > 0;
    if (corner[2] == infinity_) return bent_side(a, b, p) > 0;
  }
  const int s = in_circle_perturbed(a, b, c, p);
  return s != 0 ? s > 0 : parity({a, b, c, p}) > 0;
}

}  // namespace delone::tripack
