#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "interp/c1_surface.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/surfaces.hpp"

// Derivatives of the smooth surface at its nodes and as near to them as doubles come,
// where the weights of the edges are quotients of vanishing numbers.
namespace delone::interp {
namespace {

using stripack::Direction;
using support::PlanePoints;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

C1Options with(double tension, FitDegree degree) {
  C1Options options;
  options.tension = tension;
  options.degree = degree;
  return options;
}
const std::array<C1Options, 4> all_options{
    with(0, FitDegree::cubic), with(0.8, FitDegree::cubic), with(0, FitDegree::quartic),
    with(0.3, FitDegree::quartic)};

// Distances from a node, in units in which neighbours are some 0.1 apart.
constexpr std::array distances{1e-15, 1e-12, 1e-9, 1e-7, 1e-5};

PlanePoints some_plane_points() {
  PlanePoints points = support::uniform_points(60, 3);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) points.push_back({2 + i * 0.1, j * 0.1});
  return points;
}

TEST(C1AtNodes, PlaneGradientIsContinuousThere) {
  const PlanePoints points = some_plane_points();
  const auto t = triangulated(points);
  const std::vector<double> values =
      sampled(points, [](tripack::Point2 p) { return std::sin(3 * p.x) * p.y; });
  for (const C1Options& options : all_options) {
    const PlaneC1 surface(t, values, options);
    for (const tripack::Point2 node : points) {
      const Gradient2 there = surface.gradient(node);
      for (const double d : distances) {
        for (int k = 0; k < 7; ++k) {
          const tripack::Point2 p{node.x + d * std::cos(0.9 * k),
                                  node.y + d * std::sin(0.9 * k)};
          const Gradient2 beside = surface.gradient(p);
          if (std::isnan(beside.x)) continue;  // outside
          EXPECT_LT(std::hypot(beside.x - there.x, beside.y - there.y), 1e-9 + 2000 * d);
        }
      }
    }
  }
}

SpherePoints some_directions() {
  SpherePoints points;
  for (int lat = -90; lat <= 90; lat += 15)
    for (int lon = -180; lon < 180; lon += 15)
      if (std::abs(lat) < 90 || lon == 0) points.push_back(support::at_lonlat(lon, lat));
  return points;
}

TEST(C1AtNodes, SphereGradientIsContinuousThere) {
  const SpherePoints points = some_directions();
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(
      points, [](const Direction& p) { return std::sin(2 * p.x()) + p.y() * p.z(); });
  const auto in_space = [](const Direction& p, GradientSphere g) {
    return g.east * east_at(p) + g.north * cross(vector(p), east_at(p));
  };
  for (const C1Options& options : all_options) {
    const SphereC1 surface(t, values, options);
    for (std::size_t i = 0; i < points.size(); i += 3) {
      const Direction& node = points[i];
      const Vector3 there = in_space(node, surface.gradient(node));
      for (const double d : distances) {
        for (int k = 0; k < 7; ++k) {
          const Vector3 east = east_at(node), north = cross(vector(node), east);
          const Vector3 v = vector(node) + (d * std::cos(0.9 * k)) * east +
                            (d * std::sin(0.9 * k)) * north;
          const Direction p = Direction::from(v.x, v.y, v.z);
          EXPECT_LT(length(in_space(p, surface.gradient(p)) - there), 1e-9 + 2000 * d);
        }
      }
    }
  }
}

TEST(C1AtNodes, FirstDegreeHarmonicsHaveTheirGradientAtLatticeNodesAndPoles) {
  const SpherePoints points = some_directions();
  const SphereC1 surface(triangulated(points),
                         sampled(points, [](const Direction& p) { return p.x(); }),
                         with(0, FitDegree::cubic));
  for (const Direction& p : points) {
    const Vector3 east = east_at(p), north = cross(vector(p), east);
    const GradientSphere g = surface.gradient(p);
    EXPECT_NEAR(g.east, east.x, 1e-6);
    EXPECT_NEAR(g.north, north.x, 1e-6);
  }
}

}  // namespace
}  // namespace delone::interp
