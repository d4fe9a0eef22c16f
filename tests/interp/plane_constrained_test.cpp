// Surfaces that do not reach across curves, on the plane.

#include <gtest/gtest.h>

#include <algorithm>

#include "delaunay/error.hpp"
#include "interp/constrained_sets.hpp"

namespace delone::interp {
namespace {

using namespace support;
using tripack::PlanarGraph;
using tripack::Point2;

constexpr delaunay::ConstraintOptions whole_hull{.domain = delaunay::Domain::hull};
constexpr std::size_t num_points = 200;

double smooth(Point2 p) { return std::sin(4 * p.x) + p.y * p.y; }
double plane(Point2 p) { return 3 + 2 * p.x - 5 * p.y; }

/// Random points in the unit square and its corners.
PlanePoints points_of_square(std::size_t n) {
  PlanePoints points = uniform_points(n - 4, 5);
  for (const Point2 corner : square_ring({0.5, 0.5}, 0.5)) points.push_back(corner);
  return points;
}

/// The same and a fault that divides their hull.
PlanarGraph faulted() {
  PlanarGraph graph{.points = points_of_square(num_points)};
  add_line(graph, bent_fault());
  return graph;
}

class PlaneConstrainedKinds : public testing::TestWithParam<ConstrainedKind> {
 protected:
  static ConstrainedOptions options() {
    ConstrainedOptions result;
    result.kind = GetParam();
    return result;
  }
  /// Fits of polynomials are held back a little where data determine them badly.
  static double rounding() {
    return GetParam() == ConstrainedKind::linear ? 1e-10 : 1e-5;
  }
  static PlaneConstrained surface(const PlaneCurves& curves,
                                  const std::vector<double>& values) {
    return {curves, values, options()};
  }
};

INSTANTIATE_TEST_SUITE_P(, PlaneConstrainedKinds,
                         testing::Values(ConstrainedKind::linear, ConstrainedKind::c1),
                         [](const auto& param) {
                           return param.param == ConstrainedKind::linear ? "Linear"
                                                                         : "C1";
                         });

TEST_P(PlaneConstrainedKinds, DataBeyondAFaultChangeNoBit) {
  const PlanarGraph graph = faulted();
  const PlaneCurves curves = constrained(graph, whole_hull);
  const auto changed = [](Point2 p) {
    return is_left_of_fault(p) ? smooth(p) : 1000 * smooth({p.y, p.x}) - 77;
  };
  const PlaneConstrained before =
      surface(curves, values_beside_curves(graph.points, num_points, smooth));
  const PlaneConstrained after =
      surface(curves, values_beside_curves(graph.points, num_points, changed));
  std::size_t num_left = 0, num_changed = 0;
  for (const Point2 p : uniform_points(2000, 9)) {
    const bool is_equal = is_same(before.value(p), after.value(p));
    if (is_left_of_fault(p)) {
      ++num_left;
      ASSERT_TRUE(is_equal) << p.x << ' ' << p.y;
    } else {
      num_changed += is_equal ? 0 : 1;
    }
  }
  EXPECT_GT(num_left, 900U);
  EXPECT_GT(num_changed, 900U);
}

TEST_P(PlaneConstrainedKinds, DifferentConstantsBesideAFaultComeOutExactly) {
  const PlanarGraph graph = faulted();
  const PlaneConstrained stepped = surface(
      constrained(graph, whole_hull),
      values_beside_curves(graph.points, num_points,
                           [](Point2 p) { return is_left_of_fault(p) ? 0.1 : 7.3; }));
  for (const Point2 p : uniform_points(1000, 3))
    ASSERT_EQ(stepped.value(p), is_left_of_fault(p) ? 0.1 : 7.3) << p.x << ' ' << p.y;
}

TEST_P(PlaneConstrainedKinds, LinearFunctionsComeOutUpToTheFault) {
  const PlanarGraph graph = faulted();
  const auto f = [](Point2 p) { return is_left_of_fault(p) ? plane(p) : 9 - plane(p); };
  const PlaneConstrained surface_of_planes = surface(
      constrained(graph, whole_hull), values_beside_curves(graph.points, num_points, f));
  for (const Point2 p : uniform_points(1000, 3)) {
    // Beyond, the fault's ends are far from all data and kept near their range.
    if (p.y > 0.2 && p.y < 0.7 && std::abs(p.x - 0.5) < 0.4) {
      ASSERT_NEAR(surface_of_planes.value(p), f(p), rounding()) << p.x << ' ' << p.y;
    }
  }
}

TEST_P(PlaneConstrainedKinds, NodesKeepTheirValuesBitForBit) {
  const PlanarGraph graph = faulted();
  const auto values = values_beside_curves(graph.points, num_points, smooth);
  const PlaneConstrained s = surface(constrained(graph, whole_hull), values);
  for (std::size_t i = 0; i < num_points; ++i)
    ASSERT_TRUE(is_same(s.value(graph.points[i]), values[i]));
}

TEST_P(PlaneConstrainedKinds, ARidgeWithValuesIsContinuousAndKeepsItsBend) {
  PlanarGraph graph = faulted();
  const auto roof = [](Point2 p) { return 10 - 3 * std::abs(p.x - 0.5); };
  for (std::size_t i = num_points; i < graph.points.size(); ++i) graph.points[i].x = 0.5;
  const PlaneConstrained s =
      surface(constrained(graph, whole_hull), sampled(graph.points, roof));
  for (const Point2 p : uniform_points(300, 3)) {
    if (p.y < 0.1 || p.y > 0.9) continue;
    const double left = s.value({0.5 - 1e-9, p.y}), right = s.value({0.5 + 1e-9, p.y});
    ASSERT_NEAR(left, right, 1e-7) << p.y;
    ASSERT_NEAR(s.value({0.5, p.y}), right, 1e-7) << p.y;
    ASSERT_NEAR(s.value(p), roof(p), rounding()) << p.x << ' ' << p.y;
    ASSERT_NEAR(s.gradient({0.5 + 1e-9, p.y}).x, -3, 1e-6);
    ASSERT_NEAR(s.gradient({0.5 - 1e-9, p.y}).x, 3, 1e-6);
  }
}

TEST_P(PlaneConstrainedKinds, OutsideTheCoastAndInHolesTheValueIsMissing) {
  PlanarGraph graph{.points = points_of_square(num_points)};
  add_ring(graph, square_ring({0.5, 0.5}, 0.4));
  add_ring(graph, square_ring({0.5, 0.5}, 0.1));
  const auto values = values_beside_curves(graph.points, num_points, smooth);
  const PlaneConstrained land =
      surface(constrained(graph, {.domain = delaunay::Domain::even_odd}), values);
  const PlaneConstrained all = surface(constrained(graph, whole_hull), values);
  for (const Point2 p : uniform_points(1000, 3)) {
    const double away = std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5));
    ASSERT_EQ(std::isnan(land.value(p)), away > 0.4 || away < 0.1);
    if (away < 0.45) {
      ASSERT_FALSE(std::isnan(all.value(p)));
    }
  }
  EXPECT_TRUE(std::isnan(land.value({5, 5})));
  EXPECT_TRUE(std::isnan(land.value({no_value, 0})));
  EXPECT_TRUE(std::isnan(land.gradient({0.5, 0.5}).x));
  EXPECT_FALSE(std::isnan(land.value({0.9, 0.5})));  // on the coast
}

TEST_P(PlaneConstrainedKinds, ThePositionOfDataBeyondACoastDoesNotMatter) {
  PlanarGraph graph{.points = points_of_square(num_points)};
  add_ring(graph, square_ring({0.5, 0.5}, 0.3));
  const delaunay::ConstraintOptions enclosed{};
  const PlaneConstrained first =
      surface(constrained(graph, enclosed),
              values_beside_curves(graph.points, num_points, smooth));
  PlanarGraph moved = graph;
  for (std::size_t i = 0; i < num_points; ++i) {
    Point2& p = moved.points[i];
    if (std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)) > 0.3) p = {p.x + 4, -p.y};
  }
  const PlaneConstrained second =
      surface(constrained(moved, enclosed),
              values_beside_curves(moved.points, num_points, smooth));
  for (const Point2 p : uniform_points(1000, 3)) {
    // Sites are numbered anew, so sums may round anew.
    const double a = first.value(p), b = second.value(p);
    ASSERT_EQ(std::isnan(a), std::isnan(b));
    if (!std::isnan(a)) {
      ASSERT_NEAR(a, b, 1e-12);
    }
  }
}

TEST_P(PlaneConstrainedKinds, APartWithoutDataIsMissing) {
  PlanarGraph graph{.points = {{0.5, 0.5}, {1, 0.7}}};
  add_ring(graph, square_ring({0, 0}, 2));
  add_ring(graph, square_ring({10, 0}, 2));
  std::vector<double> values(graph.points.size(), no_value);
  values[0] = 3, values[1] = 4;
  const PlaneConstrained s =
      surface(constrained(graph, {.domain = delaunay::Domain::even_odd}), values);
  EXPECT_FALSE(std::isnan(s.value({-1.9, -1.9})));
  EXPECT_TRUE(std::isnan(s.value({10, 0.5})));
  EXPECT_TRUE(std::isnan(s.value({8, 2})));  // a vertex of that part
}

TEST_P(PlaneConstrainedKinds, RoundTheOpenEndOfAFaultTheSurfaceIsWhole) {
  PlanarGraph graph{.points = points_of_square(800)};
  add_line(graph, {{0.5, 0.3}, {0.5, 0.4}, {0.5, 0.5}, {0.5, 0.6}, {0.5, 0.7}});
  const auto step = [](Point2 p) { return p.x < 0.5 ? 0.0 : 1.0; };
  const PlaneConstrained s = surface(constrained(graph, whole_hull),
                                     values_beside_curves(graph.points, 800, step));
  EXPECT_EQ(s.value({0.4999, 0.5}), 0);
  EXPECT_EQ(s.value({0.5001, 0.5}), 1);
  for (const double y : {0.2, 0.8})
    EXPECT_NEAR(s.value({0.5 - 1e-9, y}), s.value({0.5 + 1e-9, y}), 1e-6) << y;
}

TEST_P(PlaneConstrainedKinds, GridsHaveTheBitsOfPoints) {
  PlanarGraph graph = faulted();
  add_ring(graph, square_ring({0.25, 0.5}, 0.125));
  for (const auto domain : {delaunay::Domain::hull, delaunay::Domain::enclosed}) {
    graph.holes = {{0.25, 0.5}};
    if (domain == delaunay::Domain::enclosed)
      add_ring(graph, square_ring({0.5, 0.5}, 0.4375));
    const PlaneConstrained s = surface(
        constrained(graph, {.domain = domain, .crossings = delaunay::Crossings::split}),
        values_beside_curves(graph.points, num_points, smooth));
    const Grid grid = plane_grid({-0.25, 1.25, -0.25, 1.25}, NodeCounts{97, 97});
    const auto nodes = plane_nodes(grid);
    const std::vector<double> scanned = s.grid(grid).values;
    EXPECT_EQ(first_difference(scanned, s.values(nodes)), nodes.size());
    EXPECT_EQ(
        first_difference(scanned, sampled(nodes, [&](Point2 p) { return s.value(p); })),
        nodes.size());
    EXPECT_LT(count_missing(scanned), nodes.size() * 3 / 4);
  }
}

TEST_P(PlaneConstrainedKinds, TheOrderOfRowsAndSegmentsDoesNotMatter) {
  const PlanarGraph graph = faulted();
  const auto values = values_beside_curves(graph.points, num_points, smooth);
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < graph.points.size(); ++i)
    order.push_back(static_cast<std::int32_t>(i));
  order = shuffled(order, 4);
  PlanarGraph other{.points = graph.points, .segments = shuffled(graph.segments, 8)};
  std::vector<double> other_values(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    other.points[static_cast<std::size_t>(order[i])] = graph.points[i];
    other_values[static_cast<std::size_t>(order[i])] = values[i];
  }
  for (auto& [from, to] : other.segments) {
    from = order[static_cast<std::size_t>(from)];
    to = order[static_cast<std::size_t>(to)];
    std::swap(from, to);
  }
  const auto queries = uniform_points(500, 3);
  const auto a = surface(constrained(graph, whole_hull), values).values(queries);
  const auto b = surface(constrained(other, whole_hull), other_values).values(queries);
  EXPECT_EQ(first_difference(a, b), queries.size());
}

TEST_P(PlaneConstrainedKinds, WithManySegmentsConstantsComeOutExactlyOverEveryFamily) {
  for (const PlaneFamily& family : plane_families()) {
    SCOPED_TRACE(family.name);
    PlanarGraph graph{.points = family.make(40, 3)};
    const auto n = static_cast<std::int32_t>(graph.points.size());
    for (std::int32_t i = 0; i + 1 < std::min(n, 12); ++i)
      graph.segments.push_back({i, i + 1});
    std::vector<double> values(graph.points.size(), 0.3);
    for (std::size_t i = 0; i < values.size(); i += 3) values[i] = no_value;
    const PlaneCurves curves = constrained(
        graph,
        {.domain = delaunay::Domain::hull, .crossings = delaunay::Crossings::split});
    const PlaneConstrained s = surface(curves, values);
    for (const Point2 p : graph.points) {
      const double found = s.value(p);
      ASSERT_TRUE(found == 0.3 || std::isnan(found)) << found;
    }
    for (const auto& triangle : curves->triangles()) {
      const Point2 a = curves->point(triangle[0]), b = curves->point(triangle[1]);
      const double found = s.value({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
      ASSERT_TRUE(found == 0.3 || std::isnan(found)) << found;
    }
  }
}

TEST_P(PlaneConstrainedKinds, CollinearPointsEncloseNothing) {
  PlanarGraph graph{.points = {{0, 0}, {1, 1}, {2, 2}}, .segments = {{0, 2}}};
  const PlaneConstrained s = surface(constrained(graph, whole_hull), {1, 2, 3});
  EXPECT_TRUE(std::isnan(s.value({1, 1})));
  EXPECT_TRUE(std::isnan(s.value({0.5, 0.5})));
  EXPECT_EQ(count_missing(s.grid(plane_grid({0, 2, 0, 2}, Spacing{1, 1})).values), 9U);
  EXPECT_TRUE(std::isnan(surface(constrained(PlanarGraph{}, whole_hull), {}).value({})));
}

TEST_P(PlaneConstrainedKinds, WithoutAnyValueEverythingIsMissing) {
  const PlanarGraph graph = faulted();
  const PlaneConstrained s = surface(constrained(graph, whole_hull),
                                     std::vector<double>(graph.points.size(), no_value));
  EXPECT_TRUE(std::isnan(s.value({0.3, 0.3})));
  EXPECT_TRUE(std::isnan(s.derivatives({0.3, 0.3}).xx));
}

TEST_P(PlaneConstrainedKinds, MaxDistanceCountsObservationsNotVerticesOfCurves) {
  PlanarGraph graph{.points = {{0, 0}, {1, 0}, {0, 1}}};
  add_ring(graph, square_ring({0, 0}, 8));
  std::vector<double> values(graph.points.size(), no_value);
  values[0] = 1, values[1] = 2, values[2] = 3;
  ConstrainedOptions near = options();
  near.max_distance = 2;
  const PlaneConstrained s(constrained(graph), values, near);
  EXPECT_FALSE(std::isnan(s.value({-1.9, 0})));
  EXPECT_TRUE(std::isnan(s.value({-2.1, 0})));
  EXPECT_TRUE(std::isnan(s.value({7.9, 7.9})));
  const Grid grid = plane_grid({-8, 8, -8, 8}, Spacing{0.5, 0.5});
  EXPECT_EQ(first_difference(s.grid(grid).values, s.values(plane_nodes(grid))),
            static_cast<std::size_t>(grid.size()));
}

TEST(PlaneConstrained, WithoutCurvesTheLinearSurfaceHasTheBitsOfPlaneLinear) {
  const PlanePoints points = uniform_points(300, 8);
  const auto values = sampled(points, smooth);
  const PlaneLinear plain(triangulated(points), values);
  const PlaneConstrained s(constrained(PlanarGraph{.points = points}, whole_hull),
                           values);
  const auto queries = points_of_the_hull(*triangulated(points), 2);
  EXPECT_EQ(first_difference(plain.values(queries), s.values(queries)), queries.size());
}

TEST(PlaneConstrained, AnAddedVertexBetweenValuesIsLinearAlongItsSegment) {
  const PlanarGraph graph{.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}},
                          .segments = {{0, 2}, {1, 3}}};
  const PlaneCurves curves = constrained(
      graph, {.domain = delaunay::Domain::hull, .crossings = delaunay::Crossings::split});
  ASSERT_EQ(curves->num_rows(), 6);
  // Along the first segment from (1, 1) on: 10 + (30 - 10) / 3; along the second 7.
  const PlaneConstrained s(curves, std::vector<double>{0, 6, 30, 8, 10});
  EXPECT_NEAR(s.value({2, 2}), (50.0 / 3 + 7) / 2, 1e-12);
  PlanarGraph turned = graph;
  turned.segments = {{3, 1}, {2, 0}, {1, 3}};
  const PlaneConstrained other(
      constrained(turned, {.domain = delaunay::Domain::hull,
                           .crossings = delaunay::Crossings::split}),
      std::vector<double>{0, 6, 30, 8, 10});
  EXPECT_EQ(other.value({2, 2}), s.value({2, 2}));
}

TEST(PlaneConstrained, BoundedValuesOfCurvesStayWithinTheDataOfTheirSide) {
  const PlanarGraph graph = faulted();
  const auto f = [](Point2 p) { return is_left_of_fault(p) ? p.x : 10 + p.x; };
  const auto values = values_beside_curves(graph.points, num_points, f);
  ConstrainedOptions bounded;
  bounded.bounds = Bounds::local;
  const PlaneConstrained s(constrained(graph, whole_hull), values, bounded);
  for (const Point2 p : uniform_points(1000, 3)) {
    const double low = is_left_of_fault(p) ? 0 : 10, found = s.value(p);
    ASSERT_TRUE(std::isnan(found) || (found >= low && found <= low + 1)) << found;
  }
}

TEST(PlaneConstrained, WhatCannotBeUsedIsAnErrorThatNamesTheMend) {
  const PlaneCurves curves = constrained(faulted(), whole_hull);
  std::vector<double> values(num_points + 5, 1);
  const auto complaint = [&](const ConstrainedOptions& options) {
    try {
      const PlaneConstrained s(curves, values, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint({}), "");
  ConstrainedOptions options;
  options.outside = Outside::nearest;
  EXPECT_NE(complaint(options).find("leave the outside missing"), std::string::npos);
  options = {};
  options.max_distance = -1;
  EXPECT_NE(complaint(options).find("max_distance"), std::string::npos);
  options = {};
  options.tension = 2;
  EXPECT_NE(complaint(options).find("between 0 and 1"), std::string::npos);
  values[7] = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint({}).find("row 7"), std::string::npos);
  values.pop_back();
  EXPECT_NE(complaint({}).find("NaN for a vertex without"), std::string::npos);
}

}  // namespace
}  // namespace delone::interp
