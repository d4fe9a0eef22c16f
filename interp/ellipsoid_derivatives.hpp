#pragma once

#include "interp/c1_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/vector_field.hpp"

namespace delone::interp {

// Derivatives along WGS84 in metres, from those of a surface whose directions are the
// normals of the ellipsoid: Direction::from(LonLat) of geodetic coordinates. This map is
// smooth, keeps east, north and the tangent plane, and turns a step of ds metres into ds
// over the radius of curvature radians: M(latitude) towards north, N(latitude) towards
// east. So what comes out are the exact derivatives of the same surface, seen as a
// function on the ellipsoid. All are defined at the poles; NaN stays NaN.
//
// Source: W. Torge, J. Mueller, Geodesy (2012), chapter 4; the second derivatives follow
// from the covariant derivative of the gradient.

/// By metre. Throws Error if the latitude is outside -90..90 or NaN; so the others.
[[nodiscard]] GradientSphere per_metre_wgs84(const GradientSphere& g, double lat_deg);

/// First derivatives by metre, second ones by square metre, along geodesics of the
/// ellipsoid; laplacian() is the Laplace-Beltrami operator. The value stays.
[[nodiscard]] DerivativesSphere per_metre_wgs84(const DerivativesSphere& d,
                                                double lat_deg);

/// The covariant derivative on the ellipsoid by metre: with components in metres a second
/// divergence() and curl() are in 1/s. The components stay.
[[nodiscard]] VectorDerivatives per_metre_wgs84(const VectorDerivatives& d,
                                                double lat_deg);

}  // namespace delone::interp
