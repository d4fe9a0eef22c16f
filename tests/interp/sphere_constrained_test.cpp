// Surfaces that do not reach across curves, on the sphere.

#include <gtest/gtest.h>

#include <algorithm>

#include "delaunay/error.hpp"
#include "interp/constrained_sets.hpp"

namespace delone::interp {
namespace {

using namespace support;
using stripack::Direction;
using stripack::SphereConstraintOptions;
using stripack::SphereGraph;

constexpr std::size_t num_points = 400;
const SphereConstraintOptions whole_sphere{.domain = delaunay::Domain::hull};

double smooth(const Direction& p) { return 2 * p.x() * p.y() + std::sin(3 * p.z()); }

/// Random points and a ring round a tilted pole; its cap holds the north pole, and the
/// ring crosses the date line.
SphereGraph capped() {
  SphereGraph graph{.points = uniform_directions(num_points, 5)};
  add_cap_ring(graph, 50, 20, 40);
  return graph;
}
/// Strictly inside of the ring's circle, or strictly outside of its chords.
double height_in_cap(const Direction& p) {
  const double tilt = 20 * std::numbers::pi / 180;
  return p.x() * std::sin(tilt) + p.z() * std::cos(tilt) -
         std::sin(50 * std::numbers::pi / 180);
}
bool is_in_cap(const Direction& p) { return height_in_cap(p) > 0; }
/// Between an arc and its circle either may be.
bool is_in_doubt(const Direction& p) { return std::abs(height_in_cap(p)) < 0.01; }

class SphereConstrainedKinds : public testing::TestWithParam<ConstrainedKind> {
 protected:
  static ConstrainedOptions options() {
    ConstrainedOptions result;
    result.kind = GetParam();
    return result;
  }
  static SphereConstrained surface(const SphereCurves& curves,
                                   const std::vector<double>& values) {
    return {curves, values, options()};
  }
};

INSTANTIATE_TEST_SUITE_P(, SphereConstrainedKinds,
                         testing::Values(ConstrainedKind::linear, ConstrainedKind::c1),
                         [](const auto& param) {
                           return param.param == ConstrainedKind::linear ? "Linear"
                                                                         : "C1";
                         });

TEST_P(SphereConstrainedKinds, DataBeyondARingRoundThePoleChangeNoBit) {
  const SphereGraph graph = capped();
  const SphereCurves curves = constrained(graph, whole_sphere);
  const auto changed = [](const Direction& p) {
    return is_in_cap(p) ? smooth(p) : 500 * p.x() - 77;
  };
  const SphereConstrained before =
      surface(curves, values_beside_curves(graph.points, num_points, smooth));
  const SphereConstrained after =
      surface(curves, values_beside_curves(graph.points, num_points, changed));
  std::size_t num_inside = 0;
  for (const Direction& p : uniform_directions(2000, 9)) {
    if (is_in_doubt(p)) continue;
    ASSERT_EQ(is_same(before.value(p), after.value(p)), is_in_cap(p));
    num_inside += is_in_cap(p) ? 1 : 0;
  }
  EXPECT_GT(num_inside, 150U);
}

TEST_P(SphereConstrainedKinds, DifferentConstantsBesideARingComeOutExactly) {
  const SphereGraph graph = capped();
  const auto step = [](const Direction& p) { return is_in_cap(p) ? 0.1 : 7.3; };
  const SphereConstrained s =
      surface(constrained(graph, whole_sphere),
              values_beside_curves(graph.points, num_points, step));
  for (const Direction& p : uniform_directions(1000, 3)) {
    if (!is_in_doubt(p)) {
      ASSERT_EQ(s.value(p), step(p));
    }
  }
  EXPECT_EQ(s.value(at_lonlat(0, 90)), 0.1);
  EXPECT_EQ(s.value(at_lonlat(180, -89.9)), 7.3);
}

TEST_P(SphereConstrainedKinds, OnlyTheLeftOfACoastHasValues) {
  const SphereGraph graph = capped();
  const SphereConstrained s =
      surface(constrained(graph), values_beside_curves(graph.points, num_points, smooth));
  for (const Direction& p : uniform_directions(1000, 3)) {
    if (!is_in_doubt(p)) {
      ASSERT_EQ(std::isnan(s.value(p)), !is_in_cap(p));
    }
  }
  EXPECT_FALSE(std::isnan(s.value(at_lonlat(17, 90))));
  EXPECT_FALSE(std::isnan(s.gradient(at_lonlat(0, 80)).east));
  EXPECT_TRUE(std::isnan(s.gradient(at_lonlat(0, -80)).east));
}

TEST_P(SphereConstrainedKinds, WhateverLiesBesideARingWithValuesTheSurfaceIsContinuous) {
  const SphereGraph graph = capped();
  const SphereConstrained s =
      surface(constrained(graph, whole_sphere), random_values(graph.points.size(), 7));
  for (std::size_t i = num_points; i + 1 < graph.points.size(); ++i) {
    const Direction &a = graph.points[i], &b = graph.points[i + 1];
    for (const double t : {0.0, 0.2, 0.5, 0.9}) {
      const auto beside = [&](double step) {
        const double tilt = 20 * std::numbers::pi / 180;
        return Direction::from(a.x() * (1 - t) + b.x() * t + step * std::sin(tilt),
                               a.y() * (1 - t) + b.y() * t,
                               a.z() * (1 - t) + b.z() * t + step * std::cos(tilt));
      };
      ASSERT_NEAR(s.value(beside(1e-9)), s.value(beside(-1e-9)), 1e-6) << i << ' ' << t;
    }
  }
}

TEST_P(SphereConstrainedKinds, NodesKeepTheirValuesBitForBit) {
  const SphereGraph graph = capped();
  const auto values = values_beside_curves(graph.points, num_points, smooth);
  const SphereConstrained s = surface(constrained(graph, whole_sphere), values);
  for (std::size_t i = 0; i < num_points; ++i)
    ASSERT_TRUE(is_same(s.value(graph.points[i]), values[i]));
}

TEST_P(SphereConstrainedKinds, GridsHaveTheBitsOfPoints) {
  const SphereGraph graph = capped();
  for (const SphereConstraintOptions& of_domain :
       {whole_sphere, SphereConstraintOptions{}}) {
    const SphereConstrained s =
        surface(constrained(graph, of_domain),
                values_beside_curves(graph.points, num_points, smooth));
    const Grid grid = globe_grid({-180, 180, -90, 90}, Spacing{5, 5});
    const auto nodes = globe_nodes(grid);
    const std::vector<double> scanned = s.grid(grid).values;
    EXPECT_EQ(first_difference(scanned, s.values(nodes)), nodes.size());
    EXPECT_LT(count_missing(scanned), nodes.size() * 9 / 10);
  }
}

TEST_P(SphereConstrainedKinds, AFaultInAHemisphereEndsAtTheHull) {
  SphereGraph graph;
  for (const auto p : uniform_points(150, 4))
    graph.points.push_back(at_lonlat(170 + 20 * p.x, -10 + 20 * p.y));
  const std::size_t num_data = graph.points.size();
  for (const double lat : {-14.0, -4.0, 5.0, 14.0})
    graph.points.push_back(at_lonlat(-180, lat));
  for (std::int32_t k = 0; k < 3; ++k)
    graph.arcs.push_back({static_cast<std::int32_t>(num_data) + k,
                          static_cast<std::int32_t>(num_data) + k + 1});
  const auto step = [](const Direction& p) { return p.y() > 0 ? 2.0 : 3.0; };
  const SphereConstrained s = surface(constrained(graph, whole_sphere),
                                      values_beside_curves(graph.points, num_data, step));
  for (const double lat : {-9.0, -3.0, 0.0, 8.0}) {
    EXPECT_EQ(s.value(at_lonlat(179.99, lat)), 2) << lat;
    EXPECT_EQ(s.value(at_lonlat(-179.99, lat)), 3) << lat;
  }
  EXPECT_TRUE(std::isnan(s.value(at_lonlat(0, 0))));
}

TEST_P(SphereConstrainedKinds, WithManyArcsConstantsComeOutExactlyOverEveryFamily) {
  for (const SphereFamily& family : sphere_families()) {
    SCOPED_TRACE(family.name);
    SphereGraph graph{.points = family.make(40, 3)};
    const auto n = static_cast<std::int32_t>(graph.points.size());
    for (std::int32_t i = 0; i + 1 < std::min(n, 10); ++i) {
      const Direction &a = graph.points[static_cast<std::size_t>(i)],
                      &b = graph.points[static_cast<std::size_t>(i) + 1];
      if (a.x() * b.x() + a.y() * b.y() + a.z() * b.z() > -0.9)
        graph.arcs.push_back({i, i + 1});
    }
    std::vector<double> values(graph.points.size(), 0.3);
    for (std::size_t i = 0; i < values.size(); i += 3) values[i] = no_value;
    const SphereCurves curves = constrained(
        graph,
        {.domain = delaunay::Domain::hull, .crossings = delaunay::Crossings::split});
    const SphereConstrained s = surface(curves, values);
    for (const Direction& p : graph.points) {
      const double found = s.value(p);
      ASSERT_TRUE(found == 0.3 || std::isnan(found)) << found;
    }
    for (const auto& triangle : curves->triangles()) {
      const Direction &a = curves->point(triangle[0]), &b = curves->point(triangle[1]);
      const double x = a.x() + b.x(), y = a.y() + b.y(), z = a.z() + b.z();
      const double found = s.value(Direction::from(x, y, z));
      ASSERT_TRUE(found == 0.3 || std::isnan(found)) << found;
    }
  }
}

TEST_P(SphereConstrainedKinds, PointsOnAGreatCircleEncloseNothing) {
  const SphereGraph graph{.points = {at_lonlat(0, 0), at_lonlat(40, 0), at_lonlat(90, 0)},
                          .arcs = {{0, 2}}};
  const SphereConstrained s = surface(constrained(graph, whole_sphere), {1, 2, 3});
  EXPECT_TRUE(std::isnan(s.value(at_lonlat(40, 0))));
  EXPECT_TRUE(std::isnan(s.value(at_lonlat(0, 90))));
}

TEST(SphereConstrained, WithoutCurvesTheLinearSurfaceHasTheBitsOfSphereLinear) {
  const SpherePoints points = uniform_directions(300, 8);
  const auto values = sampled(points, smooth);
  const SphereLinear plain(triangulated(points), values);
  const SphereConstrained s(constrained(SphereGraph{.points = points}, whole_sphere),
                            values);
  const auto queries = uniform_directions(1000, 2);
  EXPECT_EQ(first_difference(plain.values(queries), s.values(queries)), queries.size());
}

TEST(SphereConstrained, MaxDistanceIsInKilometresFromObservations) {
  const SphereGraph graph = capped();
  std::vector<double> values(graph.points.size(), no_value);
  for (std::size_t i = 0; i < num_points; ++i)
    if (graph.points[i].z() > 0) values[i] = smooth(graph.points[i]);
  ConstrainedOptions near;
  near.max_distance = 1500;
  const SphereConstrained s(constrained(graph, whole_sphere), values, near);
  EXPECT_FALSE(std::isnan(s.value(at_lonlat(10, 20))));
  EXPECT_TRUE(std::isnan(s.value(at_lonlat(10, -30))));
  const Grid grid = globe_grid({-180, 180, -90, 90}, Spacing{10, 10});
  EXPECT_EQ(first_difference(s.grid(grid).values, s.values(globe_nodes(grid))),
            static_cast<std::size_t>(grid.size()));
}

TEST(SphereConstrained, ContinuationIsRefused) {
  ConstrainedOptions options;
  options.outside = Outside::nearest;
  const SphereGraph graph = capped();
  EXPECT_THROW(SphereConstrained(constrained(graph, whole_sphere),
                                 std::vector<double>(graph.points.size(), 1), options),
               Error);
}

}  // namespace
}  // namespace delone::interp
