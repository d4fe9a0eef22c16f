#pragma once

#include <cstdint>
#include <limits>

#include "interp/values.hpp"

namespace delone::interp {

/// What a surface gives outside the triangulated region.
enum class Outside : std::uint8_t {
  missing,  ///< NaN
  nearest,  ///< the value of the nearest observation
  linear    ///< see PlaneLinear; on the sphere of SphereC1 only (else Error)
};

/// What `max_distance` is measured in on the globe (kilometres both).
enum class GlobeDistance : std::uint8_t {
  great_circle,   ///< on the sphere of stripack::earth_radius_km
  geodesic_wgs84  ///< on the ellipsoid, the latitude of a direction taken as geodetic
};

/// Options common to the surfaces of this room.
struct SurfaceOptions {
  Duplicates duplicates = Duplicates::mean;
  Outside outside = Outside::missing;
  /// Leaves missing whatever is farther than this from every observation: data units in
  /// the plane, kilometres on the globe. Must not be negative or NaN.
  double max_distance = std::numeric_limits<double>::infinity();
  GlobeDistance distance = GlobeDistance::great_circle;
};

/// Throws Error if max_distance is negative or NaN.
void check(const SurfaceOptions& options);

}  // namespace delone::interp
