// Smooth surfaces that do not reach across curves.

#include <gtest/gtest.h>

#include <algorithm>

#include "interp/barrier_stencil.hpp"
#include "interp/blend_fit.hpp"
#include "interp/constrained_sets.hpp"
#include "tripack/predicates.hpp"

namespace delone::interp {
namespace {

using namespace support;
using tripack::PlanarGraph;
using tripack::Point2;

constexpr delaunay::ConstraintOptions whole_hull{.domain = delaunay::Domain::hull};

double smooth(Point2 p) { return std::sin(5 * p.x) * std::cos(4 * p.y) + p.x; }
double faulted_function(Point2 p) {
  return is_left_of_fault(p) ? smooth(p) : 3 - smooth({p.y, p.x});
}

PlanarGraph faulted(std::size_t n) {
  PlanarGraph graph{.points = uniform_points(n - 4, 5)};
  for (const Point2 corner : square_ring({0.5, 0.5}, 0.5)) graph.points.push_back(corner);
  add_line(graph, bent_fault());
  return graph;
}

ConstrainedOptions smooth_options(std::optional<double> tension = {}) {
  ConstrainedOptions options;
  options.kind = ConstrainedKind::c1;
  options.tension = tension;
  return options;
}

/// Root mean square error at points near the fault.
double error_near_fault(std::size_t n, const ConstrainedOptions& options) {
  const PlanarGraph graph = faulted(n);
  const PlaneConstrained s(constrained(graph, whole_hull),
                           values_beside_curves(graph.points, n, faulted_function),
                           options);
  double sum = 0;
  int count = 0;
  for (const Point2 p : uniform_points(4000, 3)) {
    if (std::abs(p.x - 0.5) > 0.1 || std::abs(p.y - 0.5) > 0.3) continue;
    const double error = s.value(p) - faulted_function(p);
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(ConstrainedC1, IsMoreAccurateThanLinearAlongAFault) {
  const double linear = error_near_fault(1000, {});
  const double c1 = error_near_fault(1000, smooth_options());
  EXPECT_LT(linear, 0.02);
  EXPECT_LT(c1, 0.25 * linear);
}

TEST(ConstrainedC1, ErrorAlongAFaultFallsFasterThanTheSquareOfSpacing) {
  const double coarse = error_near_fault(400, smooth_options());
  const double fine = error_near_fault(1600, smooth_options());
  EXPECT_LT(fine, coarse / 5);
}

TEST(ConstrainedC1, WithoutCurvesItHasTheBitsOfPlaneC1) {
  const PlanePoints points = uniform_points(300, 8);
  const auto values = sampled(points, smooth);
  C1Options plain;
  plain.tension = 0.3;
  plain.gradients = Gradients::local;
  const PlaneC1 free(triangulated(points), values, plain);
  const PlaneConstrained s(constrained(PlanarGraph{.points = points}, whole_hull), values,
                           smooth_options(0.3));
  const auto queries = points_of_the_hull(*triangulated(points), 2);
  EXPECT_EQ(first_difference(free.values(queries), s.values(queries)), queries.size());
}

TEST(ConstrainedC1, WithoutCurvesItHasTheBitsOfSphereC1) {
  const SpherePoints points = uniform_directions(300, 8);
  const auto values = sampled(points, [](const auto& p) { return p.x() * p.y(); });
  C1Options plain;
  plain.tension = 0.3;
  plain.gradients = Gradients::local;
  const SphereC1 free(triangulated(points), values, plain);
  const SphereConstrained s(
      constrained(stripack::SphereGraph{.points = points},
                  stripack::SphereConstraintOptions{.domain = delaunay::Domain::hull}),
      values, smooth_options(0.3));
  const auto queries = uniform_directions(500, 2);
  EXPECT_EQ(first_difference(free.values(queries), s.values(queries)), queries.size());
}

TEST(ConstrainedC1, WhateverLiesBesideARidgeTheSurfaceIsContinuousAcrossIt) {
  const PlanarGraph graph = faulted(100);
  const PlaneConstrained s(constrained(graph, whole_hull),
                           random_values(graph.points.size(), 4), smooth_options(0));
  const PlanePoints line = bent_fault();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Point2 a = line[k], b = line[k + 1];
    for (double t = 0.01; t < 1; t += 0.0371) {
      const Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      const double left = s.value({p.x - 1e-10, p.y}),
                   right = s.value({p.x + 1e-10, p.y});
      if (std::isnan(left) || std::isnan(right))
        continue;  // beyond the hull's other side
      ASSERT_NEAR(left, right, 1e-7) << k << ' ' << t;
    }
  }
}

TEST(ConstrainedC1, ValueAndGradientAreContinuousWithinASide) {
  for (const bool is_ridge : {false, true}) {
    const PlanarGraph graph = faulted(100);
    auto values = random_values(graph.points.size(), 4);
    if (!is_ridge) std::fill(values.begin() + 100, values.end(), no_value);
    const PlaneCurves curves = constrained(graph, whole_hull);
    const PlaneConstrained s(curves, values, smooth_options(0));
    const auto pieces = curves->constraint_edges();
    for (const auto& t : curves->triangles()) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = t[k], to = t[(k + 1) % 3];
        const tripack::ConstrainedTriangulation::Segment piece{std::min(from, to),
                                                               std::max(from, to)};
        if (std::ranges::binary_search(pieces, piece)) continue;
        const Point2 a = curves->point(from), b = curves->point(to);
        const Point2 across{(a.y - b.y) * 1e-7, (b.x - a.x) * 1e-7};
        for (const double u : {0.2, 0.5, 0.77}) {
          const Point2 p{a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)};
          const Derivatives2 f = s.derivatives({p.x + across.x, p.y + across.y}),
                             g = s.derivatives({p.x - across.x, p.y - across.y});
          if (std::isnan(f.value) || std::isnan(g.value)) continue;
          ASSERT_NEAR(f.value, g.value, 1e-4);
          const double size = 1 + std::hypot(f.xx, f.xy, f.yy) + std::hypot(f.x, f.y) +
                              std::hypot(g.xx, g.xy, g.yy);
          ASSERT_NEAR(f.x, g.x, 1e-5 * size);
          ASSERT_NEAR(f.y, g.y, 1e-5 * size);
        }
      }
    }
  }
}

TEST(ConstrainedC1, DerivativesAreThoseOfTheValues) {
  const PlanarGraph graph = faulted(60);
  const PlaneConstrained s(constrained(graph, whole_hull),
                           sampled(graph.points, faulted_function), smooth_options(0.2));
  const double h = 1e-5;
  int num_checked = 0;
  for (const Point2 p : uniform_points(400, 7)) {
    const Derivatives2 d = s.derivatives(p);
    const Derivatives2 east = s.derivatives({p.x + h, p.y}),
                       west = s.derivatives({p.x - h, p.y});
    // Second derivatives jump at edges, and gradients at the fault.
    const double size = 1 + std::abs(d.xx);
    if (std::abs(east.xx - d.xx) + std::abs(west.xx - d.xx) > 0.01 * size ||
        std::abs(p.x - 0.5) < 0.05)
      continue;
    ++num_checked;
    ASSERT_NEAR(d.value, s.value(p), 1e-12);
    ASSERT_NEAR(d.x, (s.value({p.x + h, p.y}) - s.value({p.x - h, p.y})) / (2 * h),
                1e-5 * size);
    ASSERT_NEAR(d.xx, (east.x - west.x) / (2 * h), 1e-2 * size);
  }
  EXPECT_GT(num_checked, 200);
}

TEST(ConstrainedC1, DerivativesBesideARidgeOnTheSphereAreThoseOfTheValues) {
  stripack::SphereGraph graph{.points = uniform_directions(60, 5)};
  add_cap_ring(graph, 50, 20, 12);
  const SphereConstrained s(
      constrained(graph,
                  stripack::SphereConstraintOptions{.domain = delaunay::Domain::hull}),
      random_values(graph.points.size(), 9), smooth_options(0));
  const double h = 1e-6, degree = 180 / std::numbers::pi;
  int num_checked = 0;
  for (double lon = -180; lon < 180; lon += 3.1) {
    for (const double lat : {33.0, 47.0, 61.0}) {
      const DerivativesSphere d = s.derivatives(at_lonlat(lon, lat));
      const double north = s.value(at_lonlat(lon, lat + h * degree)),
                   south = s.value(at_lonlat(lon, lat - h * degree));
      if (std::abs(north + south - 2 * d.value) > 1e-9) continue;  // across the ridge
      ++num_checked;
      ASSERT_NEAR(d.north, (north - south) / (2 * h), 1e-4 * (1 + std::abs(d.north)));
    }
  }
  EXPECT_GT(num_checked, 250);
}

/// Two fingers of land, a spit and a fault with an open end: places where paths are
/// short and sight is blocked.
PlanarGraph narrows() {
  PlanarGraph graph{.points = uniform_points(250, 6)};
  add_line(graph, {{0.5, 0.1}, {0.52, 0.3}, {0.5, 0.5}});
  add_line(graph, {{0.1, 0.7}, {0.6, 0.72}, {0.6, 0.9}, {0.2, 0.85}});
  add_ring(graph, {{0.7, 0.2}, {0.9, 0.2}, {0.9, 0.6}, {0.8, 0.25}, {0.7, 0.6}});
  return graph;
}

bool do_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return tripack::orientation(a, b, c) * tripack::orientation(a, b, d) < 0 &&
         tripack::orientation(c, d, a) * tripack::orientation(c, d, b) < 0;
}

TEST(ConstrainedC1, StencilsHoldOnlyWhatIsSeen) {
  const PlanarGraph graph = narrows();
  const BarrierMeshIn<PlaneSpace> mesh(constrained(graph, whole_hull));
  const WedgeGraph<PlaneSpace> wedges(mesh);
  WedgeStencils<PlaneSpace> stencils(PlaneSpace{}, wedges);
  std::size_t num_nodes = 0;
  for (Wedge w = 0; w < mesh.num_wedges(); ++w) {
    if (wedges.degree(w) == 0) continue;
    const auto stencil = stencils.around(w, 16);
    num_nodes += stencil.size();
    ASSERT_GE(stencil.size(), 3U);
    for (const StencilNode& n : stencil) {
      for (const auto& [from, to] : graph.segments) {
        ASSERT_FALSE(do_cross(mesh.point_of(w), mesh.point_of(n.site),
                              graph.points[static_cast<std::size_t>(from)],
                              graph.points[static_cast<std::size_t>(to)]));
      }
    }
  }
  EXPECT_GT(num_nodes, 13 * static_cast<std::size_t>(mesh.num_wedges()));
}

TEST(ConstrainedC1, OnALatticeAVertexInTheWayBlocksTheSight) {
  PlanarGraph graph;
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j)
      graph.points.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  for (std::int32_t j = 0; j < 8; ++j) graph.segments.push_back({36 + j, 37 + j});
  const BarrierMeshIn<PlaneSpace> mesh(constrained(graph, whole_hull));
  const WedgeGraph<PlaneSpace> wedges(mesh);
  WedgeStencils<PlaneSpace> stencils(PlaneSpace{}, wedges);
  for (Wedge w = 0; w < mesh.num_wedges(); ++w) {
    const double x = mesh.point_of(w).x;
    double least = 8, most = 0;
    for (const StencilNode& n : stencils.around(w, 16)) {
      least = std::min(least, mesh.point_of(n.site).x);
      most = std::max(most, mesh.point_of(n.site).x);
    }
    ASSERT_TRUE(most <= 4 || least >= 4) << x;
  }
}

TEST(ConstrainedC1, HalfTheNodesAreASurfaceOfTheirOwn) {
  // Of each side of a fault that divides the hull the surface is that of this side's data
  // alone.
  const PlanarGraph graph = faulted(150);
  const auto values = values_beside_curves(graph.points, 150, faulted_function);
  std::vector<double> left = values;
  for (std::size_t i = 0; i < 150; ++i)
    if (!is_left_of_fault(graph.points[i])) left[i] = no_value;
  const PlaneCurves curves = constrained(graph, whole_hull);
  const PlaneConstrained both(curves, values, smooth_options()),
      alone(curves, left, smooth_options());
  for (const Point2 p : uniform_points(500, 3)) {
    if (is_left_of_fault(p)) {
      ASSERT_TRUE(is_same(both.value(p), alone.value(p)));
    } else {
      ASSERT_TRUE(std::isnan(alone.value(p)));
    }
  }
}

TEST(ConstrainedC1, QuarticFitsAndBoundsAreTaken) {
  const PlanarGraph graph = faulted(200);
  const auto values = values_beside_curves(graph.points, 200, faulted_function);
  ConstrainedOptions options = smooth_options();
  options.degree = FitDegree::quartic;
  const PlaneConstrained quartic(constrained(graph, whole_hull), values, options);
  EXPECT_NEAR(quartic.value({0.3, 0.4}), faulted_function({0.3, 0.4}), 0.02);
  options = smooth_options();
  options.bounds = Bounds::local;
  const PlaneConstrained bounded(constrained(graph, whole_hull), values, options);
  const auto [least, most] = std::minmax_element(values.begin(), values.begin() + 200);
  for (const double v : bounded.values(uniform_points(1000, 3))) {
    ASSERT_GE(v, *least);
    ASSERT_LE(v, *most);
  }
}

}  // namespace
}  // namespace delone::interp
