#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "tripack/constrained_triangulation.hpp"
#include "tripack/polygon.hpp"

namespace delone::interp {

/// The boundary of a region: sides from corner to corner, the region on their left. They
/// meet in corners only; more than two may meet there.
template <class Point>
struct RegionBoundary {
  std::vector<Point> corners;
  std::vector<std::array<std::int32_t, 2>> sides;
};

/// A part of the plane to integrate over: polygons, convex or not, with holes and with
/// islands in the holes; or everything.
class PlaneRegion {
 public:
  /// Everything.
  PlaneRegion() = default;
  /// What an odd number of rings enclose: outlines, holes and islands in either sense and
  /// any order, the last corner joined to the first. Corners on other sides and sides in
  /// common are allowed (what two rings share does not count). Without rings, or rings
  /// without area: empty. Throws Error for rings of fewer than three corners, coordinates
  /// that are not finite, and sides that cross (naming both, counted over all rings).
  /// O(n log n).
  explicit PlaneRegion(std::span<const tripack::Polygon> rings,
                       const RunOptions& run = {});
  /// The domain of a triangulation: whatever its segments, holes and options make of it.
  explicit PlaneRegion(const tripack::ConstrainedTriangulation& domain);

  [[nodiscard]] bool is_everything() const noexcept { return is_everything_; }
  /// Infinite for everything.
  [[nodiscard]] double area() const noexcept { return area_; }
  [[nodiscard]] const RegionBoundary<tripack::Point2>& boundary() const noexcept {
    return boundary_;
  }

 private:
  bool is_everything_ = true;
  double area_ = std::numeric_limits<double>::infinity();
  RegionBoundary<tripack::Point2> boundary_;
};

/// The same on the sphere, with sides that are arcs of great circles shorter than pi.
/// Poles, the date line and regions larger than a hemisphere are nothing special.
class SphereRegion {
 public:
  /// Everything.
  SphereRegion();
  /// What an odd number of rings part from `outside`. Without it the left of the first
  /// ring is inside: counter-clockwise, seen from above, round a region of any size.
  /// Throws Error as PlaneRegion does, for sides between antipodes, and for an `outside`
  /// on a ring.
  explicit SphereRegion(std::span<const std::vector<stripack::Direction>> rings,
                        std::optional<stripack::Direction> outside = {},
                        const RunOptions& run = {});
  explicit SphereRegion(const stripack::ConstrainedTriangulation& domain);

  [[nodiscard]] bool is_everything() const noexcept { return is_everything_; }
  /// Steradians; 4 pi for everything.
  [[nodiscard]] double area() const noexcept { return area_; }
  [[nodiscard]] const RegionBoundary<stripack::Direction>& boundary() const noexcept {
    return boundary_;
  }

 private:
  bool is_everything_ = true;
  double area_;
  RegionBoundary<stripack::Direction> boundary_;
};

/// What areas on the globe are measured in.
enum class AreaUnit : std::uint8_t {
  steradian,
  km2_sphere,  ///< of the sphere of radius stripack::earth_radius_km
  km2_wgs84    ///< of the ellipsoid, directions being geodetic; sides are arcs of great
               ///< circles of directions, not geodesics
};

/// Of the part of a region that a surface covers.
struct RegionIntegral {
  double integral = 0;  ///< value times area
  double area = 0;
  /// NaN without area.
  [[nodiscard]] double mean() const noexcept { return integral / area; }
};

// `integral(region)` of PlaneLinear, SphereLinear, PlaneC1 and SphereC1.
//
// A surface counts where it is triangulated: what of the region lies beyond the hull adds
// neither to the integral nor to the area, whatever the surface does there, and
// max_distance is not looked at. Triangles wholly inside are integrated by a rule of 36
// places (exact for polynomials of degree 10). A triangle that the boundary cuts is
// integrated piece by piece, corners of the boundary and its crossings with edges being
// corners of pieces; each piece by the same rule.
//
// Accuracy. In the plane a linear surface is integrated exactly, to rounding, however
// small the region or far from the origin; areas are off by 1e-16 of the squares of
// triangles' longest sides. On the sphere pieces wider than half a radian are divided,
// and areas are right to 1e-11 of themselves. The C1 surface is no polynomial and bends
// inside triangles, so parts of a set add up to the whole within 1e-6 of range times area
// with 300 nodes, 1e-8 with 3,000 and less beyond.
//
// Which nodes are inside and which edges are crossed is decided exactly, for the region
// moved by an infinitesimal, so that nothing is on its boundary: regions that share a
// border add up. The result is the same for every number of threads.
//
// Cost: for each corner of the region a walk from the one before, edges crossed,
// triangles covered; for sides from beyond the hull, besides, the square root of the
// hull's edges. A triangle takes some 0.5 (linear) to 5 microseconds (C1), one that is
// cut as much for every corner of its pieces.

}  // namespace delone::interp
