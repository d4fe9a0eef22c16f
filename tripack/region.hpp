#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tripack/point.hpp"
#include "tripack/polygon.hpp"

namespace delone::tripack {

/// A part of the plane to which cells are clipped: all of it, a box or a simple polygon.
///
/// A polygon keeps a grid of buckets (0.3 to 8 MB), so that whether a small cell lies
/// wholly inside or outside costs a few comparisons whatever the number of corners.
class Region {
 public:
  /// The whole plane.
  Region() = default;
  /// Throws Error unless both corners are finite and low is below high in x and in y.
  [[nodiscard]] static Region box(Point2 low, Point2 high);
  /// A simple polygon, convex or not, in either orientation. Throws Error naming the rows
  /// of corners that are not finite, or of two sides that cross or touch, or if there is
  /// no area.
  [[nodiscard]] static Region polygon(std::span<const Point2> corners);

  [[nodiscard]] bool is_plane() const noexcept { return corners_.empty(); }
  /// Counter-clockwise; none for the plane.
  [[nodiscard]] const Polygon& corners() const noexcept { return corners_; }
  /// Infinite for the plane.
  [[nodiscard]] double area() const noexcept;

  enum class Relation : std::uint8_t { outside, crossing, inside };
  /// How a box lies to the region: outside and inside are certain, crossing means
  /// perhaps. Not for the plane. O(1).
  [[nodiscard]] Relation relation(Point2 low, Point2 high) const noexcept;

 private:
  /// Counts of buckets: where no side passes, wholly inside or outside.
  class Buckets {
   public:
    Buckets() = default;
    Buckets(const Polygon& corners, Point2 low, Point2 high);
    [[nodiscard]] bool is_empty() const noexcept { return size_ == 0; }
    [[nodiscard]] Relation relation(Point2 low, Point2 high) const noexcept;

   private:
    enum class Mark : std::uint8_t { unknown, outside, crossing, inside };
    [[nodiscard]] std::int32_t column(double x) const noexcept;
    [[nodiscard]] std::int32_t row(double y) const noexcept;
    [[nodiscard]] std::size_t index(std::int32_t r, std::int32_t c) const noexcept {
      return static_cast<std::size_t>(r) * static_cast<std::size_t>(size_) +
             static_cast<std::size_t>(c);
    }
    void mark_side(std::vector<Mark>& marks, Point2 a, Point2 b) const;
    void classify(std::vector<Mark>& marks, const Polygon& corners) const;
    [[nodiscard]] std::vector<std::int32_t> sums_of(const std::vector<Mark>& marks,
                                                    Mark counted) const;
    [[nodiscard]] std::int64_t count(const std::vector<std::int32_t>& sums,
                                     std::int32_t r0, std::int32_t r1, std::int32_t c0,
                                     std::int32_t c1) const noexcept;

    std::int32_t size_ = 0;
    Point2 low_, step_;
    std::vector<std::int32_t> inside_, outside_;  // sums over all buckets below and left
  };

  Polygon corners_;
  Point2 low_, high_;
  Buckets buckets_;
};

}  // namespace delone::tripack
