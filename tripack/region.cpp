#include "tripack/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "delaunay/error.hpp"

namespace delone::tripack {

namespace {

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void check_finite(std::span<const Point2> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (is_finite(corners[i])) continue;
    throw Error("corner " + std::to_string(i) + " of the region is not finite; remove it",
                {static_cast<std::int64_t>(i)});
  }
}

void check_simple(std::span<const Point2> corners) {
  if (const auto sides = find_self_intersection(corners)) {
    throw Error("the region's boundary meets itself: the sides after corners " +
                    std::to_string((*sides)[0]) + " and " + std::to_string((*sides)[1]) +
                    "; give a simple polygon",
                {(*sides)[0], (*sides)[1]});
  }
}

}  // namespace

Region Region::box(Point2 low, Point2 high) {
  if (!is_finite(low) || !is_finite(high) || !(low.x < high.x) || !(low.y < high.y)) {
    throw Error(
        "a clip box needs finite corners, the first below and left of the second");
  }
  Region region;
  region.corners_ = {low, {high.x, low.y}, high, {low.x, high.y}};
  region.low_ = low;
  region.high_ = high;
  return region;
}

Region Region::polygon(std::span<const Point2> corners) {
  check_finite(corners);
  if (corners.size() < 3) throw Error("a clip polygon needs three corners");
  check_simple(corners);
  Region region;
  region.corners_.assign(corners.begin(), corners.end());
  const double area = signed_area(corners);
  if (area == 0) throw Error("the clip polygon encloses no area");
  if (area < 0) std::reverse(region.corners_.begin(), region.corners_.end());
  region.low_ = region.high_ = corners[0];
  for (const Point2 p : corners) {
    region.low_ = {std::min(region.low_.x, p.x), std::min(region.low_.y, p.y)};
    region.high_ = {std::max(region.high_.x, p.x), std::max(region.high_.y, p.y)};
  }
  region.buckets_ = Buckets(region.corners_, region.low_, region.high_);
  return region;
}

double Region::area() const noexcept {
  return is_plane() ? std::numeric_limits<double>::infinity() : signed_area(corners_);
}

Region::Relation Region::relation(Point2 low, Point2 high) const noexcept {
  if (high.x < low_.x || high.y < low_.y || high_.x < low.x || high_.y < low.y)
    return Relation::outside;
  const bool is_within =
      low_.x <= low.x && low_.y <= low.y && high.x <= high_.x && high.y <= high_.y;
  if (!is_within) return Relation::crossing;
  return buckets_.is_empty() ? Relation::inside : buckets_.relation(low, high);
}

Region::Buckets::Buckets(const Polygon& corners, Point2 low, Point2 high)
    : size_(corners.size() > 4096 ? 1024 : 256), low_(low) {
  const auto size = static_cast<double>(size_);
  step_ = {high.x / size - low.x / size, high.y / size - low.y / size};
  std::vector<Mark> marks(index(size_, 0), Mark::unknown);
  for (std::size_t i = 0; i < corners.size(); ++i)
    mark_side(marks, corners[i], corners[(i + 1) % corners.size()]);
  classify(marks, corners);
  inside_ = sums_of(marks, Mark::inside);
  outside_ = sums_of(marks, Mark::outside);
}

std::int32_t Region::Buckets::column(double x) const noexcept {
  return static_cast<std::int32_t>(
      std::clamp((x - low_.x) / step_.x, 0.0, static_cast<double>(size_ - 1)));
}

std::int32_t Region::Buckets::row(double y) const noexcept {
  return static_cast<std::int32_t>(
      std::clamp((y - low_.y) / step_.y, 0.0, static_cast<double>(size_ - 1)));
}

// Row by row, each widened by a bucket on every side, which is far more than rounding
// needs.
void Region::Buckets::mark_side(std::vector<Mark>& marks, Point2 a, Point2 b) const {
  if (b.y < a.y) std::swap(a, b);
  const double height = b.y - a.y;
  const std::int32_t first = std::max(0, row(a.y) - 1),
                     last = std::min(size_ - 1, row(b.y) + 1);
  const auto x_at = [&](double y) {
    const double t = height > 0 ? std::clamp((y - a.y) / height, 0.0, 1.0) : 0;
    return a.x * (1 - t) + b.x * t;
  };
  for (std::int32_t r = first; r <= last; ++r) {
    double from = x_at(low_.y + (r - 1) * step_.y), to = x_at(low_.y + (r + 2) * step_.y);
    if (height < 4 * step_.y) {
      from = a.x;
      to = b.x;
    }
    const std::int32_t c0 = std::max(0, column(std::min(from, to)) - 1),
                       c1 = std::min(size_ - 1, column(std::max(from, to)) + 1);
    for (std::int32_t c = c0; c <= c1; ++c) marks[index(r, c)] = Mark::crossing;
  }
}

// Buckets beside each other with no side in them are on one side of the polygon.
void Region::Buckets::classify(std::vector<Mark>& marks, const Polygon& corners) const {
  const auto is_known = [&](std::int32_t r, std::int32_t c) {
    return r >= 0 && c >= 0 && marks[index(r, c)] != Mark::crossing;
  };
  for (std::int32_t r = 0; r < size_; ++r) {
    for (std::int32_t c = 0; c < size_; ++c) {
      Mark& mark = marks[index(r, c)];
      if (mark == Mark::crossing) continue;
      if (is_known(r, c - 1)) {
        mark = marks[index(r, c - 1)];
      } else if (is_known(r - 1, c)) {
        mark = marks[index(r - 1, c)];
      } else {
        const Point2 middle{low_.x + (c + 0.5) * step_.x, low_.y + (r + 0.5) * step_.y};
        mark = contains(corners, middle) ? Mark::inside : Mark::outside;
      }
    }
  }
}

std::vector<std::int32_t> Region::Buckets::sums_of(const std::vector<Mark>& marks,
                                                   Mark counted) const {
  const auto width = static_cast<std::size_t>(size_) + 1;
  std::vector<std::int32_t> sums(width * width);
  for (std::int32_t r = 0; r < size_; ++r) {
    for (std::int32_t c = 0; c < size_; ++c) {
      const std::size_t i =
          static_cast<std::size_t>(r) * width + static_cast<std::size_t>(c);
      sums[i + width + 1] = sums[i + width] + sums[i + 1] - sums[i] +
                            static_cast<std::int32_t>(marks[index(r, c)] == counted);
    }
  }
  return sums;
}

std::int64_t Region::Buckets::count(const std::vector<std::int32_t>& sums,
                                    std::int32_t r0, std::int32_t r1, std::int32_t c0,
                                    std::int32_t c1) const noexcept {
  const auto sum = [&](std::int32_t r, std::int32_t c) {
    return sums[static_cast<std::size_t>(r) * (static_cast<std::size_t>(size_) + 1) +
                static_cast<std::size_t>(c)];
  };
  return sum(r1 + 1, c1 + 1) - sum(r0, c1 + 1) - sum(r1 + 1, c0) + sum(r0, c0);
}

Region::Relation Region::Buckets::relation(Point2 low, Point2 high) const noexcept {
  const std::int32_t r0 = row(low.y), r1 = row(high.y), c0 = column(low.x),
                     c1 = column(high.x);
  const std::int64_t all = std::int64_t{r1 - r0 + 1} * (c1 - c0 + 1);
  if (count(inside_, r0, r1, c0, c1) == all) return Relation::inside;
  if (count(outside_, r0, r1, c0, c1) == all) return Relation::outside;
  return Relation::crossing;
}

}  // namespace delone::tripack
