#include "stripack/direction.hpp"

#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Math.hpp>
#include <algorithm>
#include <cmath>
#include <string>

#include "delaunay/error.hpp"

namespace delone::stripack {

namespace {

// Adding +0 turns -0 into +0, so that equal directions have equal bits.
double no_negative_zero(double v) { return v + 0.0; }

}  // namespace

Direction Direction::from(LonLat p) {
  if (!(std::abs(p.lat_deg) <= 90)) {
    throw Error("latitude " + std::to_string(p.lat_deg) + " is outside -90..90 degrees");
  }
  if (!std::isfinite(p.lon_deg)) throw Error("longitude is not finite");
  double sin_lon, cos_lon, sin_lat, cos_lat;
  GeographicLib::Math::sincosd(p.lon_deg, sin_lon, cos_lon);
  GeographicLib::Math::sincosd(p.lat_deg, sin_lat, cos_lat);
  return {no_negative_zero(cos_lat * cos_lon), no_negative_zero(cos_lat * sin_lon),
          no_negative_zero(sin_lat)};
}

Direction Direction::from(double x, double y, double z) {
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (!(largest > 0) || !std::isfinite(largest) || !std::isfinite(x + y + z)) {
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
      throw Error("a direction's components must be finite");
    }
    if (largest == 0) throw Error("the zero vector has no direction");
  }
  if (std::abs(x * x + y * y + z * z - 1) <= 0x1p-51) {
    return {no_negative_zero(x), no_negative_zero(y), no_negative_zero(z)};
  }
  const int exponent = -std::ilogb(largest);
  x = std::scalbn(x, exponent);
  y = std::scalbn(y, exponent);
  z = std::scalbn(z, exponent);
  const double length = std::sqrt(x * x + y * y + z * z);
  return {no_negative_zero(x / length), no_negative_zero(y / length),
          no_negative_zero(z / length)};
}

LonLat lonlat(const Direction& d) {
  const double across = std::hypot(d.x(), d.y());
  return {across == 0 ? 0 : GeographicLib::Math::atan2d(d.y(), d.x()),
          GeographicLib::Math::atan2d(d.z(), across)};
}

double angle(const Direction& a, const Direction& b) noexcept {
  const double dx = a.x() - b.x(), dy = a.y() - b.y(), dz = a.z() - b.z();
  const double sx = a.x() + b.x(), sy = a.y() + b.y(), sz = a.z() + b.z();
  return 2 * std::atan2(std::sqrt(dx * dx + dy * dy + dz * dz),
                        std::sqrt(sx * sx + sy * sy + sz * sz));
}

double geodesic_km(LonLat a, LonLat b) {
  double meters = 0;
  GeographicLib::Geodesic::WGS84().Inverse(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg,
                                           meters);
  return meters / 1000;
}

EastNorth curvature_radii_km_wgs84(double lat_deg) {
  const auto& wgs84 = GeographicLib::Ellipsoid::WGS84();
  return {wgs84.TransverseCurvatureRadius(lat_deg) / 1000,
          wgs84.MeridionalCurvatureRadius(lat_deg) / 1000};
}

}  // namespace delone::stripack
