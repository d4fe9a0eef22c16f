#include "interp/ellipsoid_derivatives.hpp"

#include <cmath>
#include <string>

#include "delaunay/error.hpp"
#include "stripack/direction.hpp"

namespace delone::interp {

namespace {

constexpr double equatorial_radius = 6378137, flattening = 1 / 298.257223563,
                 squared_eccentricity = flattening * (2 - flattening);

/// What a metre towards east and north is in radians of the normal, and how that changes
/// with latitude.
struct Metric {
  double east, north;  ///< 1 / N, 1 / M
  double bend_east;    ///< tan(latitude) (1 / N - 1 / M) / N
  double bend_north;   ///< -(dM / dlatitude) / M^3

  explicit Metric(double lat_deg) {
    if (!(std::abs(lat_deg) <= 90)) {
      throw Error("latitude " + std::to_string(lat_deg) + " is outside -90..90 degrees");
    }
    const stripack::Direction p = stripack::Direction::from(stripack::LonLat{0, lat_deg});
    const double sine = p.z(), cosine = p.x();
    const double squared = 1 - squared_eccentricity * sine * sine,
                 root = std::sqrt(squared),
                 polar = equatorial_radius * (1 - squared_eccentricity);
    east = root / equatorial_radius;
    north = squared * root / polar;
    // With both radii put in, tan and 1 / cos cancel: no trouble at the poles.
    const double tilt = squared_eccentricity * sine * cosine;
    bend_east = -tilt * squared / (polar * equatorial_radius);
    bend_north = -3 * tilt * squared * squared / (polar * polar);
  }
};

}  // namespace

GradientSphere per_metre_wgs84(const GradientSphere& g, double lat_deg) {
  const Metric m(lat_deg);
  return {g.east * m.east, g.north * m.north};
}

DerivativesSphere per_metre_wgs84(const DerivativesSphere& d, double lat_deg) {
  const Metric m(lat_deg);
  DerivativesSphere result;
  result.value = d.value;
  result.east = d.east * m.east;
  result.north = d.north * m.north;
  result.east_east = d.east_east * m.east * m.east + m.bend_east * d.north;
  result.east_north = d.east_north * m.east * m.north + m.bend_east * d.east;
  result.north_north = d.north_north * m.north * m.north + m.bend_north * d.north;
  return result;
}

VectorDerivatives per_metre_wgs84(const VectorDerivatives& d, double lat_deg) {
  const Metric m(lat_deg);
  return {d.east,
          d.north,
          d.east_by_east * m.east,
          d.east_by_north * m.north,
          d.north_by_east * m.east,
          d.north_by_north * m.north};
}

}  // namespace delone::interp
