#include "interp/ellipsoid_derivatives.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/surfaces.hpp"

// GeographicLib's geodesics judge derivatives on WGS84 and the triangulation of the
// normals.
namespace delone::interp {
namespace {

using GeographicLib::Geodesic;
using stripack::Direction;
using stripack::LonLat;
using support::at_lonlat;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

constexpr double radian = std::numbers::pi / 180;

/// Where a geodesic is after some metres, and its azimuth there.
struct Place {
  LonLat position;
  double azimuth_deg = 0;
};
Place along_geodesic(LonLat from, double azimuth_deg, double metres) {
  double lat = 0, lon = 0, azimuth = 0;
  Geodesic::WGS84().Direct(from.lat_deg, from.lon_deg, azimuth_deg, metres, lat, lon,
                           azimuth);
  return {{lon, lat}, azimuth};
}

const std::array<LonLat, 7> places{LonLat{10, 0}, {-70, 20}, {179.9, 45}, {100, -60},
                                   {33, 84},      {-5, -89}, {0, 89.9}};
const std::array<double, 5> azimuths{0, 30, 90, 135, 250};

// A function of space, c . r + r . M r with M symmetric, and its derivatives on the unit
// sphere of directions.
constexpr Vector3 linear_part{0.4, -0.9, 0.6};
Vector3 quadratic_part(Vector3 r) {
  return {0.7 * r.x + 0.2 * r.y - 0.5 * r.z, 0.2 * r.x - 0.3 * r.y + 0.9 * r.z,
          -0.5 * r.x + 0.9 * r.y + 0.1 * r.z};
}
double smooth(const Direction& p) {
  return dot(linear_part, vector(p)) + dot(vector(p), quadratic_part(vector(p)));
}
DerivativesSphere derivatives_of_smooth(const Direction& p) {
  const Vector3 r = vector(p), e = east_at(p), n = cross(r, e),
                slope = linear_part + 2.0 * quadratic_part(r);
  DerivativesSphere d;
  d.value = smooth(p);
  d.east = dot(slope, e);
  d.north = dot(slope, n);
  const double height = dot(slope, r);
  d.east_east = 2 * dot(e, quadratic_part(e)) - height;
  d.east_north = 2 * dot(e, quadratic_part(n));
  d.north_north = 2 * dot(n, quadratic_part(n)) - height;
  return d;
}
double smooth_at(LonLat p) { return smooth(Direction::from(p)); }

TEST(EllipsoidDerivatives, GradientIsTheSlopeAlongGeodesics) {
  for (const LonLat& p : places) {
    const DerivativesSphere d = derivatives_of_smooth(Direction::from(p));
    const GradientSphere g = per_metre_wgs84(GradientSphere{d.east, d.north}, p.lat_deg);
    for (const double azimuth : azimuths) {
      constexpr double h = 500;
      const double slope = (smooth_at(along_geodesic(p, azimuth, h).position) -
                            smooth_at(along_geodesic(p, azimuth, -h).position)) /
                           (2 * h);
      EXPECT_NEAR(
          (g.east * std::sin(azimuth * radian) + g.north * std::cos(azimuth * radian)) *
              6.4e6,
          slope * 6.4e6, 1e-7);
    }
  }
}

TEST(EllipsoidDerivatives, SecondDerivativesAreThoseAlongGeodesics) {
  for (const LonLat& p : places) {
    const DerivativesSphere d =
        per_metre_wgs84(derivatives_of_smooth(Direction::from(p)), p.lat_deg);
    for (const double azimuth : azimuths) {
      constexpr double h = 4000, unit = 6.4e6 * 6.4e6;
      const double bend =
          (smooth_at(along_geodesic(p, azimuth, h).position) +
           smooth_at(along_geodesic(p, azimuth, -h).position) - 2 * smooth_at(p)) /
          (h * h);
      const double sine = std::sin(azimuth * radian), cosine = std::cos(azimuth * radian);
      // The corrections that the sphere does not have are some 1e-2.
      EXPECT_NEAR((d.east_east * sine * sine + 2 * d.east_north * sine * cosine +
                   d.north_north * cosine * cosine) *
                      unit,
                  bend * unit, 1e-5)
          << p.lat_deg << " " << azimuth;
    }
  }
}

TEST(EllipsoidDerivatives, LaplacianIsTheDivergenceOfTheGradient) {
  for (const LonLat& p : places) {
    const DerivativesSphere d =
        per_metre_wgs84(derivatives_of_smooth(Direction::from(p)), p.lat_deg);
    // Means of second differences over two perpendicular geodesics.
    constexpr double h = 4000, unit = 6.4e6 * 6.4e6;
    double sum = -4 * smooth_at(p);
    for (const double azimuth : {20.0, 110.0, 200.0, 290.0})
      sum += smooth_at(along_geodesic(p, azimuth, h).position);
    EXPECT_NEAR(d.laplacian() * unit, sum / (h * h) * unit, 1e-5);
  }
}

// The tangential part of A r + b.
Vector3 affine(Vector3 r) {
  return Vector3{0.3, -0.2, 0.5} + Vector3{0.2 * r.x + 0.8 * r.y - 0.4 * r.z,
                                           -0.7 * r.x + 0.1 * r.y + 0.6 * r.z,
                                           0.3 * r.x - 0.9 * r.y + 0.5 * r.z};
}
EastNorth flow_at(LonLat p) {
  const double lon = p.lon_deg * radian;
  const Direction d = Direction::from(p);
  const Vector3 e{-std::sin(lon), std::cos(lon), 0}, n = cross(vector(d), e);
  return {dot(affine(vector(d)), e), dot(affine(vector(d)), n)};
}
VectorDerivatives derivatives_of_flow(const Direction& p) {
  const Vector3 r = vector(p), e = east_at(p), n = cross(r, e), v = affine(r);
  const Vector3 by_east = affine(e) - affine({}), by_north = affine(n) - affine({});
  const double height = dot(v, r);
  return {dot(v, e),        dot(v, n),       dot(by_east, e) - height,
          dot(by_north, e), dot(by_east, n), dot(by_north, n) - height};
}

// Along a geodesic its own direction and the one on its left are parallel fields.
EastNorth in_frame_of(const Place& place) {
  const EastNorth v = flow_at(place.position);
  const double sine = std::sin(place.azimuth_deg * radian),
               cosine = std::cos(place.azimuth_deg * radian);
  return {v.east * sine + v.north * cosine, v.north * sine - v.east * cosine};
}

TEST(EllipsoidDerivatives, CovariantDerivativeIsThatAlongGeodesics) {
  for (const LonLat& p : places) {
    const VectorDerivatives d =
        per_metre_wgs84(derivatives_of_flow(Direction::from(p)), p.lat_deg);
    for (const double azimuth : azimuths) {
      constexpr double h = 500;
      const EastNorth ahead = in_frame_of(along_geodesic(p, azimuth, h)),
                      behind = in_frame_of(along_geodesic(p, azimuth, -h));
      const double sine = std::sin(azimuth * radian), cosine = std::cos(azimuth * radian);
      const double east = d.east_by_east * sine + d.east_by_north * cosine,
                   north = d.north_by_east * sine + d.north_by_north * cosine;
      EXPECT_NEAR((east * sine + north * cosine) * 6.4e6,
                  (ahead.east - behind.east) / (2 * h) * 6.4e6, 1e-6);
      EXPECT_NEAR((north * sine - east * cosine) * 6.4e6,
                  (ahead.north - behind.north) / (2 * h) * 6.4e6, 1e-6);
    }
  }
}

TEST(EllipsoidDerivatives, OfASurfaceAreThoseOfItsValuesAlongGeodesics) {
  SpherePoints points;
  for (int k = 0; k < 500; ++k) {
    points.push_back(
        at_lonlat(137.508 * k, std::asin(-1 + (2 * k + 1) / 500.0) / radian));
  }
  const SphereC1 surface(triangulated(points), sampled(points, smooth));
  for (const LonLat& p : places) {
    const GradientSphere g =
        per_metre_wgs84(surface.gradient(Direction::from(p)), p.lat_deg);
    constexpr double h = 20;
    for (const double azimuth : azimuths) {
      const auto value = [&](double metres) {
        return surface.value(
            Direction::from(along_geodesic(p, azimuth, metres).position));
      };
      EXPECT_NEAR(
          (g.east * std::sin(azimuth * radian) + g.north * std::cos(azimuth * radian)) *
              6.4e6,
          (value(h) - value(-h)) / (2 * h) * 6.4e6, 2e-6);
    }
  }
}

TEST(EllipsoidDerivatives, RefuseWhatIsNoLatitudeAndKeepMissing) {
  EXPECT_THROW(static_cast<void>(per_metre_wgs84(GradientSphere{}, 91)), Error);
  EXPECT_THROW(static_cast<void>(per_metre_wgs84(GradientSphere{}, std::nan(""))), Error);
  EXPECT_TRUE(std::isnan(per_metre_wgs84(GradientSphere{std::nan(""), 1}, 90).east));
  const DerivativesSphere pole =
      per_metre_wgs84(derivatives_of_smooth(at_lonlat(0, 90)), 90);
  EXPECT_TRUE(std::isfinite(pole.laplacian()));
}

/// The centre of the geodesic circle through three positions.
LonLat geodesic_circumcenter(const std::array<LonLat, 3>& corners) {
  const GeographicLib::AzimuthalEquidistant chart(Geodesic::WGS84());
  LonLat center = corners[0];
  for (int step = 0; step < 7; ++step) {
    std::array<double, 3> x{}, y{};
    for (std::size_t k = 0; k < 3; ++k) {
      chart.Forward(center.lat_deg, center.lon_deg, corners[k].lat_deg,
                    corners[k].lon_deg, x[k], y[k]);
    }
    const double bx = x[1] - x[0], by = y[1] - y[0], cx = x[2] - x[0], cy = y[2] - y[0];
    const double b = bx * bx + by * by, c = cx * cx + cy * cy,
                 twice = 2 * (bx * cy - by * cx);
    const LonLat old = center;
    chart.Reverse(old.lat_deg, old.lon_deg, x[0] + (cy * b - by * c) / twice,
                  y[0] + (bx * c - cx * b) / twice, center.lat_deg, center.lon_deg);
  }
  return center;
}

/// How deep, in parts of the radius, a fourth point lies in the geodesic circle through
/// the triangle on the other side, edge by edge; not positive: not inside.
std::vector<double> depths(const std::vector<LonLat>& positions,
                           const stripack::Triangulation& t) {
  std::vector<double> result;
  const delaunay::Adjacency& adjacency = t.adjacency();
  const auto at = [&](delaunay::Site s) {
    return positions[static_cast<std::size_t>(t.rows()[static_cast<std::size_t>(s)])];
  };
  for (delaunay::Site v = 0; v < t.num_sites(); ++v) {
    delaunay::Arc a = adjacency.first_arc(v);
    for (std::int32_t i = 0; i < adjacency.degree(v); ++i, a = adjacency.next(a)) {
      if (adjacency.target(a) < v) continue;
      const auto c = adjacency.left(a);
      const LonLat fourth = at(adjacency.left(adjacency.reverse(a))[2]);
      const LonLat center = geodesic_circumcenter({at(c[0]), at(c[1]), at(c[2])});
      result.push_back(1 - stripack::geodesic_km(center, fourth) /
                               stripack::geodesic_km(center, at(c[0])));
    }
  }
  return result;
}

std::vector<LonLat> random_positions(int n) {
  support::SplitMix64 random(7);
  std::vector<LonLat> positions;
  for (int k = 0; k < n; ++k) {
    const double z = random.between(-1, 1);
    positions.push_back({random.between(-180, 180), std::asin(z) / radian});
  }
  return positions;
}

TEST(EllipsoidMapping, FewEdgesOfTheNormalsAreNotGeodesicDelaunayAndThoseNearly) {
  const std::vector<LonLat> positions = random_positions(1000);
  SpherePoints normals;
  for (const LonLat& p : positions) normals.push_back(Direction::from(p));
  const std::vector<double> found = depths(positions, *triangulated(normals));
  const auto num_wrong = std::ranges::count_if(found, [](double d) { return d > 0; });
  EXPECT_GT(num_wrong, 0);  // or the measure sees nothing
  EXPECT_LT(num_wrong, 0.003 * static_cast<double>(found.size()));
  EXPECT_LT(*std::ranges::max_element(found), 0.012);
}

TEST(EllipsoidMapping, TheConformalSphereHasTheGeodesicDelaunayTriangulation) {
  const std::vector<LonLat> positions = random_positions(1000);
  const auto& wgs84 = GeographicLib::Ellipsoid::WGS84();
  SpherePoints conformal;
  for (const LonLat& p : positions)
    conformal.push_back(at_lonlat(p.lon_deg, wgs84.ConformalLatitude(p.lat_deg)));
  const std::vector<double> found = depths(positions, *triangulated(conformal));
  EXPECT_LT(*std::ranges::max_element(found), 1e-3);
  EXPECT_LT(std::ranges::count_if(found, [](double d) { return d > 0; }), 2);
}

}  // namespace
}  // namespace delone::interp
