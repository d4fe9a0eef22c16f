#pragma once

namespace delone::stripack {

/// Longitude (any wrap) and latitude (-90..90) in degrees.
struct LonLat {
  double lon_deg = 0, lat_deg = 0;
  friend bool operator==(const LonLat&, const LonLat&) = default;
};

/// A point of the unit sphere: a direction from the centre.
///
/// The components are doubles, so the length is 1 only to within 2^-51; every predicate
/// takes the exact direction of the stored triple. -0 never occurs.
class Direction {
 public:
  /// (1, 0, 0)
  Direction() = default;
  /// Degree-exact (GeographicLib::Math::sincosd): a pole is one point for every longitude
  /// and
  /// +-180 one meridian. Throws Error if lat is outside [-90, 90] or either is not
  /// finite.
  [[nodiscard]] static Direction from(LonLat p);
  /// Normalises; a vector already within 2^-51 of unit length is taken as it is. Any
  /// finite non-zero vector, no overflow or underflow. Throws Error on zero or non-finite
  /// vectors.
  [[nodiscard]] static Direction from(double x, double y, double z);

  [[nodiscard]] double x() const noexcept { return x_; }
  [[nodiscard]] double y() const noexcept { return y_; }
  [[nodiscard]] double z() const noexcept { return z_; }
  friend bool operator==(const Direction&, const Direction&) = default;

 private:
  Direction(double x, double y, double z) : x_(x), y_(y), z_(z) {}
  double x_ = 1, y_ = 0, z_ = 0;
};

/// Longitude in [-180, 180], latitude in [-90, 90]; longitude 0 at the poles.
[[nodiscard]] LonLat lonlat(const Direction& d);

/// Angle between two directions in radians, accurate at every separation.
[[nodiscard]] double angle(const Direction& a, const Direction& b) noexcept;

/// Mean radius of the Earth (IUGG R1), which turns angles into great-circle kilometres.
inline constexpr double earth_radius_km = 6371.0088;

/// Geodesic distance on WGS84 in kilometres (GeographicLib, nanometre accuracy).
[[nodiscard]] double geodesic_km(LonLat a, LonLat b);

struct EastNorth {
  double east = 0, north = 0;
};

/// Radii of curvature of WGS84 at a geodetic latitude, towards east (transverse) and
/// north (meridional): the kilometres that a radian of turn of the surface normal covers.
[[nodiscard]] EastNorth curvature_radii_km_wgs84(double lat_deg);

}  // namespace delone::stripack
