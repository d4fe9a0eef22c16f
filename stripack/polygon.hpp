#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stripack/direction.hpp"

namespace delone::stripack {

enum class Containment : std::uint8_t { outside, boundary, inside };

/// A polygon on the sphere, of any size: poles, the date line and more than a hemisphere
/// included. Its sides are arcs shorter than pi; the last corner is joined to the first.
///
/// The inside is what lies on the left of the boundary, or the side of a point given. A
/// boundary that crosses itself encloses what is reached from there by an even number of
/// crossings.
class Polygon {
 public:
  /// The inside on the left. Throws Error naming the rows if there are fewer than three
  /// corners, or if two that follow each other are the same or opposite.
  explicit Polygon(std::vector<Direction> corners);
  /// The inside is where `inside` lies, in either orientation. Throws Error as well if
  /// that is on the boundary.
  Polygon(std::vector<Direction> corners, const Direction& inside);

  [[nodiscard]] std::span<const Direction> corners() const noexcept { return corners_; }

  /// Where is p? Exact for the directions given. O(n).
  [[nodiscard]] Containment locate(const Direction& p) const noexcept;
  /// Inside, or on the boundary.
  [[nodiscard]] bool contains(const Direction& p) const noexcept {
    return locate(p) != Containment::outside;
  }
  /// Steradians, 0 to 4 pi, of what lies inside. A polygon within 63 degrees of its first
  /// corner keeps its digits however small it is; others are off by 1e-15 for each side.
  [[nodiscard]] double area() const;
  /// Direction of the centre of mass of the surface inside. Throws Error where that is
  /// the centre of the sphere.
  [[nodiscard]] Direction centroid() const;
  /// Radians.
  [[nodiscard]] double perimeter() const noexcept;

 private:
  /// A point that is no corner and on no side, and whether it is inside.
  struct Reference {
    Direction point;
    Containment side = Containment::outside;
  };
  void check() const;
  void add_references();
  [[nodiscard]] bool is_on_boundary(const Direction& p) const noexcept;
  [[nodiscard]] int num_crossings(const Direction& p, const Direction& q) const noexcept;
  [[nodiscard]] const Direction& corner(std::size_t i) const noexcept {
    return corners_[i % corners_.size()];
  }

  std::vector<Direction> corners_;
  bool is_reversed_ = false;  // the inside is on the right
  std::vector<Reference> references_;
};

/// Area on WGS84 in square kilometres on the left of a polygon of geodesics whose corners
/// are directions of geodetic latitudes (0 to 510065621.724). Neighbouring corners not
/// nearly opposite. Source: C. F. F. Karney, J. Geod. 87 (2013) 43-55.
[[nodiscard]] double polygon_area_km2_wgs84(std::span<const Direction> corners);
/// Length of its boundary in kilometres.
[[nodiscard]] double polygon_perimeter_km_wgs84(std::span<const Direction> corners);
/// 510065621.724 km^2
[[nodiscard]] double wgs84_area_km2();

}  // namespace delone::stripack
