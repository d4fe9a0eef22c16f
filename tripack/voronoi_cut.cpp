#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tripack/predicates.hpp"
#include "tripack/voronoi_cell.hpp"

namespace delone::tripack {

namespace {

// Up to here a new ring of corners for every neighbour costs less than linked ones.
constexpr std::int32_t many_neighbors = 32;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A convex polygon that is cut by half-planes in the order of their normals'
/// directions.
///
/// The corner farthest along a normal goes round as the normal does, so it is found from
/// the last one, and from it the corners to be cut off: O(1) for a cut on average.
class TurningCut {
 public:
  explicit TurningCut(const Polygon& convex) {
    const auto n = static_cast<std::int32_t>(convex.size());
    for (std::int32_t i = 0; i < n; ++i)
      corners_.push_back({convex[at(i)], (i + n - 1) % n, (i + 1) % n, delaunay::none});
    size_ = n;
  }

  [[nodiscard]] bool is_empty() const noexcept { return size_ == 0; }

  void cut(const HalfPlane& half, std::int32_t number) {
    find_farthest(half);
    if (height(half, here_) <= 0) return;
    std::int32_t before = here_, after = here_;
    while (height(half, before) > 0) {
      if (--size_ == 0) return;
      before = corners_[at(before)].previous;
    }
    while (height(half, corners_[at(after)].next) > 0) {
      --size_;
      after = corners_[at(after)].next;
    }
    const std::int32_t out = corners_[at(before)].next, in = corners_[at(after)].next;
    const std::int32_t first = add(crossing(half, before, out), number);
    here_ = add(crossing(half, in, after), corners_[at(after)].side);
    join(before, first);
    join(first, here_);
    join(here_, in);
  }

  [[nodiscard]] Polygon polygon() const {
    Polygon result;
    for_each([&](const Corner& c) { result.push_back(c.place); });
    return result;
  }
  /// The numbers of the half-planes that are left as sides.
  [[nodiscard]] std::vector<std::int32_t> sides() const {
    std::vector<std::int32_t> result;
    for_each([&](const Corner& c) {
      if (c.side != delaunay::none) result.push_back(c.side);
    });
    return result;
  }

 private:
  struct Corner {
    Point2 place;
    std::int32_t previous, next;
    std::int32_t side;  // the half-plane of the side that begins here
  };

  template <class F>
  void for_each(F f) const {
    std::int32_t i = here_;
    for (std::int32_t k = 0; k < size_; ++k, i = corners_[at(i)].next) f(corners_[at(i)]);
  }
  [[nodiscard]] double height(const HalfPlane& half, std::int32_t i) const noexcept {
    return tripack::height(half, corners_[at(i)].place);
  }
  [[nodiscard]] Point2 crossing(const HalfPlane& half, std::int32_t inside,
                                std::int32_t outside) const noexcept {
    const Point2 p = corners_[at(inside)].place, q = corners_[at(outside)].place;
    return tripack::crossing(p, q, height(half, inside), height(half, outside));
  }
  std::int32_t add(Point2 place, std::int32_t side) {
    corners_.push_back({place, delaunay::none, delaunay::none, side});
    ++size_;
    return static_cast<std::int32_t>(corners_.size()) - 1;
  }
  void join(std::int32_t i, std::int32_t j) noexcept {
    corners_[at(i)].next = j;
    corners_[at(j)].previous = i;
  }

  // Round a convex polygon heights rise once and fall once.
  void find_farthest(const HalfPlane& half) {
    climb(half, &Corner::next);
    climb(half, &Corner::previous);
  }
  // Equal corners, and sides shorter than rounding, are no tops.
  void climb(const HalfPlane& half, std::int32_t Corner::*step) {
    constexpr double rounding = 0x1p-48;
    double top = height(half, here_);
    const Point2 p = corners_[at(here_)].place;
    const double slack = rounding * (std::abs(p.x) + std::abs(p.y));
    const std::int32_t start = here_;
    for (std::int32_t i = corners_[at(start)].*step; i != start;
         i = corners_[at(i)].*step) {
      const double h = height(half, i);
      if (h < top - slack) return;
      if (h > top) top = h, here_ = i;
    }
  }

  std::vector<Corner> corners_;
  std::int32_t here_ = 0, size_ = 0;
};

bool is_convex(const Polygon& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0)
      return false;
  }
  return true;
}

Polygon box_around(const Polygon& corners) {
  Point2 low = corners[0], high = corners[0];
  for (const Point2 p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

std::vector<Polygon> one_after_another(Polygon region,
                                       std::span<const HalfPlane> halves) {
  std::vector<Polygon> parts;
  parts.push_back(std::move(region));
  for (const HalfPlane& half : halves) {
    parts = clip(std::move(parts), half);
    if (parts.empty()) break;
  }
  return parts;
}

TurningCut all_round(const Polygon& convex, std::span<const HalfPlane> halves) {
  TurningCut cell(convex);
  for (std::size_t k = 0; k < halves.size() && !cell.is_empty(); ++k)
    cell.cut(halves[k], static_cast<std::int32_t>(k));
  return cell;
}

std::vector<Polygon> cut_by_many(Polygon region, std::span<const HalfPlane> halves) {
  if (is_convex(region)) {
    const TurningCut cell = all_round(region, halves);
    if (cell.is_empty()) return {};
    return {cell.polygon()};
  }
  const TurningCut cell = all_round(box_around(region), halves);
  if (cell.is_empty()) return {};
  std::vector<HalfPlane> needed;
  for (const std::int32_t k : cell.sides()) needed.push_back(halves[at(k)]);
  return one_after_another(std::move(region), needed);
}

}  // namespace

std::vector<Polygon> cut_cell(const Triangulation& t, Site s, const Region& region) {
  const Point2 p = t.points()[at(s)];
  Polygon corners = region.corners();
  for (Point2& corner : corners) corner = {corner.x - p.x, corner.y - p.y};
  std::vector<HalfPlane> halves;
  for (const Site w : t.adjacency().neighbors(s)) {
    const Point2 q = t.points()[at(w)];
    halves.push_back(nearer_to_origin({q.x - p.x, q.y - p.y}));
  }
  if (t.adjacency().degree(s) < many_neighbors)
    return one_after_another(std::move(corners), halves);
  return cut_by_many(std::move(corners), halves);
}

}  // namespace delone::tripack
