#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/c1_surface.hpp"
#include "interp/least_curvature.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::PlanePoints;
using support::sampled;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

C1Options with(Gradients gradients) {
  C1Options options;
  options.gradients = gradients;
  return options;
}

double wave(Point2 p) { return std::sin(3 * p.x) * std::cos(2 * p.y) + p.x * p.y; }
Gradient2 gradient_of_wave(Point2 p) {
  return {3 * std::cos(3 * p.x) * std::cos(2 * p.y) + p.y,
          -2 * std::sin(3 * p.x) * std::sin(2 * p.y) + p.x};
}

// The integral of the squared second derivative of the Hermite curve over an edge, by
// Simpson's rule, which is exact for squares of linear functions.
double bending(double length, double rise, double first, double second) {
  const auto bend = [&](double t) {
    return (6 - 12 * t) * rise / (length * length) + (6 * t - 4) * first / length +
           (6 * t - 2) * second / length;
  };
  const auto square = [](double a) { return a * a; };
  return length / 6 * (square(bend(0)) + 4 * square(bend(0.5)) + square(bend(1)));
}

double area_of(const tripack::Triangulation& t, delaunay::Arc arc) {
  if (!t.adjacency().has_left(arc)) return 0;
  const auto c = t.adjacency().left(arc);
  const Point2 a = t.points()[at(c[0])], b = t.points()[at(c[1])],
               d = t.points()[at(c[2])];
  return 0.5 * std::abs((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x));
}

double energy(const tripack::Triangulation& t, const std::vector<double>& values,
              const std::vector<Point2>& gradients) {
  double sum = 0;
  const auto& adjacency = t.adjacency();
  for (Site v = 0; v < t.num_sites(); ++v) {
    delaunay::Arc arc = adjacency.first_arc(v);
    for (std::int32_t i = 0; i < adjacency.degree(v); ++i, arc = adjacency.next(arc)) {
      const Site w = adjacency.target(arc);
      if (w < v) continue;
      const Point2 p = t.points()[at(v)], q = t.points()[at(w)];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      const auto slope = [&](Site s) {
        return (gradients[at(s)].x * (q.x - p.x) + gradients[at(s)].y * (q.y - p.y)) /
               length;
      };
      const double area = area_of(t, arc) + area_of(t, adjacency.reverse(arc));
      sum += area / std::pow(length, 2.5) *
             bending(length, values[at(w)] - values[at(v)], slope(v), slope(w));
    }
  }
  return sum;
}

TEST(LeastCurvature, NoChangeOfAGradientLessensTheSumOverTheEdges) {
  const auto t = triangulated(support::uniform_points(60, 3));
  const PlanePoints points(t->points().begin(), t->points().end());
  const std::vector<double> values = sampled(points, wave);
  std::vector<Point2> gradients =
      least_curvature_gradients<PlaneSpace>({}, *t, values, {});
  const double least = energy(*t, values, gradients);
  ASSERT_GT(least, 0);
  for (Point2& g : gradients) {
    for (double Point2::*part : {&Point2::x, &Point2::y}) {
      const double before = g.*part;
      for (const double change : {-1e-3, 1e-3}) {
        g.*part = before + change;
        const double more = energy(*t, values, gradients) - least;
        EXPECT_GT(more, 0);
        g.*part = before - change;
        EXPECT_NEAR(energy(*t, values, gradients) - least, more, 1e-6 * more + 1e-12);
      }
      g.*part = before;
    }
  }
}

TEST(LeastCurvature, IsExactForLinearFunctionsOnAllPlaneSets) {
  for (const support::PlaneFamily& family : support::plane_families()) {
    const auto t = triangulated(family.make(120, 5));
    if (t->dimension() < 2) continue;
    double reach = 0;
    for (const Point2 p : t->points())
      reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    if (reach > 1e100 || reach < 1e-100) continue;
    const PlanePoints points(t->points().begin(), t->points().end());
    const std::vector<double> values =
        sampled(points, [&](Point2 p) { return (p.x - 2 * p.y) / reach; });
    // The directions across a thin set are no worse determined than its values.
    for (const Point2 g : least_curvature_gradients<PlaneSpace>({}, *t, values, {}))
      EXPECT_TRUE(std::isfinite(g.x) && std::isfinite(g.y)) << family.name;
  }
  const auto t = triangulated(support::uniform_points(300, 4));
  const PlanePoints points(t->points().begin(), t->points().end());
  const std::vector<double> values =
      sampled(points, [](Point2 p) { return p.x - 2 * p.y; });
  for (const Point2 g : least_curvature_gradients<PlaneSpace>({}, *t, values, {})) {
    EXPECT_NEAR(g.x, 1, 1e-9);
    EXPECT_NEAR(g.y, -2, 1e-9);
  }
}

TEST(LeastCurvature, TurnsWithTheSphere) {
  const SpherePoints points = support::uniform_directions(200, 6);
  const auto value = [](const Direction& p) { return p.x() * p.y() + p.z(); };
  const std::vector<double> values = sampled(points, value);
  // x -> y -> z -> x
  SpherePoints turned;
  for (const Direction& p : points)
    turned.push_back(Direction::from(p.z(), p.x(), p.y()));
  const SphereC1 surface(triangulated(points), values, with(Gradients::global)),
      other(triangulated(turned), values, with(Gradients::global));
  for (int k = 0; k < 200; ++k) {
    const Direction p = support::uniform_directions(200, 7)[static_cast<std::size_t>(k)];
    // Thin triangles turn the last bits of a position into more.
    EXPECT_NEAR(surface.value(p), other.value(Direction::from(p.z(), p.x(), p.y())),
                1e-10);
  }
}

TEST(GivenGradients, AreThoseOfTheSurfaceAtTheNodes) {
  const PlanePoints points = support::uniform_points(80, 8);
  const auto t = triangulated(points);
  std::vector<Gradient2> gradients;
  for (const Point2 p : points) gradients.push_back(gradient_of_wave(p));
  const PlaneC1 surface(t, sampled(points, wave), gradients);
  EXPECT_EQ(surface.fit().gradients, Gradients::given);
  for (const Point2 p : points) {
    const Gradient2 found = surface.gradient(p), wanted = gradient_of_wave(p);
    EXPECT_NEAR(found.x, wanted.x, 1e-11);
    EXPECT_NEAR(found.y, wanted.y, 1e-11);
  }
}

TEST(GivenGradients, OnTheSphereToo) {
  SpherePoints points = support::uniform_directions(80, 9);
  points.push_back(Direction::from(0, 0, 1));
  points.push_back(Direction::from(0, 0, -1));
  const auto value = [](const Direction& p) { return p.x() * p.y() + p.z() * p.z(); };
  std::vector<GradientSphere> gradients;
  for (const Direction& p : points) {
    const Vector3 east = east_at(p), north = cross(vector(p), east);
    const Vector3 g{p.y(), p.x(), 2 * p.z()};
    gradients.push_back({dot(g, east), dot(g, north)});
  }
  const SphereC1 surface(triangulated(points), sampled(points, value), gradients);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const GradientSphere found = surface.gradient(points[i]);
    EXPECT_NEAR(found.east, gradients[i].east, 1e-11);
    EXPECT_NEAR(found.north, gradients[i].north, 1e-11);
  }
}

TEST(GivenGradients, MakeASurfaceMoreAccurate) {
  const PlanePoints points = support::uniform_points(200, 10);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, wave);
  std::vector<Gradient2> gradients;
  for (const Point2 p : points) gradients.push_back(gradient_of_wave(p));
  C1Options options = with(Gradients::local);
  options.outside = Outside::linear;
  const double given =
      support::relative_squared_error(PlaneC1(t, values, gradients, options), wave);
  const double fitted =
      support::relative_squared_error(PlaneC1(t, values, options), wave);
  EXPECT_TRUE(given < fitted) << given << " " << fitted;
}

TEST(GivenGradients, ThatAreNotKnownAreFitted) {
  const PlanePoints points = support::uniform_points(50, 11);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, wave);
  C1Options options = with(Gradients::local);
  options.tension = 0.25;
  const PlaneC1 fitted(t, values, options);
  const PlaneC1 surface(
      t, values, std::vector<Gradient2>(points.size(), {unknown, unknown}), options);
  const PlanePoints queries = support::uniform_points(100, 12);
  EXPECT_EQ(support::first_difference(fitted.values(queries), surface.values(queries)),
            queries.size());
}

TEST(GivenGradients, OfRepeatsAreAveragedWhateverTheOrder) {
  PlanePoints points = support::uniform_points(30, 13);
  std::vector<Gradient2> gradients(points.size(), {unknown, 0});
  for (const double slope : {0.1, 0.7, 0.4}) {
    points.push_back(points[0]);
    gradients.push_back({slope, 1});
  }
  std::vector<double> values = sampled(points, wave);
  const PlaneC1 surface(triangulated(points), values, gradients);
  EXPECT_NEAR(surface.gradient(points[0]).x, 0.4, 1e-13);
  EXPECT_NEAR(surface.gradient(points[0]).y, 1, 1e-13);
  std::ranges::reverse(points), std::ranges::reverse(gradients),
      std::ranges::reverse(values);
  const PlaneC1 other(triangulated(points), values, gradients);
  const PlanePoints queries = support::uniform_points(50, 14);
  EXPECT_EQ(support::first_difference(surface.values(queries), other.values(queries)),
            queries.size());
}

TEST(GivenGradients, ThatCannotBeUsedAreRefused) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  const auto t = triangulated(points);
  const std::vector<double> values{1, 2, 3};
  EXPECT_THROW(PlaneC1(t, values, std::vector<Gradient2>(2)), Error);
  std::vector<Gradient2> gradients(3);
  gradients[1].y = std::numeric_limits<double>::infinity();
  try {
    const PlaneC1 surface(t, values, gradients);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("row 1"), std::string::npos) << e.what();
  }
  EXPECT_THROW(PlaneC1(t, values, with(Gradients::given)), Error);
}

TEST(ChosenGradients, AreLocalOnDenseSetsAndGlobalWhereNodesAreFew) {
  const PlanePoints dense = support::uniform_points(2000, 15);
  const PlaneC1 fine(triangulated(dense), sampled(dense, wave));
  EXPECT_EQ(fine.fit().gradients, Gradients::local);
  EXPECT_GT(fine.fit().num_tested, 0);
  const PlanePoints sparse = support::renka_brown_set_5();
  const auto ripple = [](Point2 p) { return std::sin(12 * p.x) * std::sin(10 * p.y); };
  const auto t = triangulated(sparse);
  const std::vector<double> values = sampled(sparse, ripple);
  C1Options options;
  options.outside = Outside::linear;
  const PlaneC1 coarse(t, values, options);
  EXPECT_EQ(coarse.fit().gradients, Gradients::global);
  options.gradients = Gradients::local;
  const double local =
      support::relative_squared_error(PlaneC1(t, values, options), ripple);
  EXPECT_LT(support::relative_squared_error(coarse, ripple), 0.5 * local);
}

// Average squared error over squared deviation of Renka and Brown's ten functions, with
// continuation beyond the hull.
double average_error(const PlanePoints& nodes) {
  C1Options options;
  options.outside = Outside::linear;
  const auto t = triangulated(nodes);
  double sum = 0;
  for (const support::PlaneFunction f : support::renka_brown_functions)
    sum += support::relative_squared_error(PlaneC1(t, sampled(nodes, f), options), f);
  return sum / 10;
}

// Of all methods over triangles that are published: SRFPACK with global gradients 0.1553
// (set 3), with local ones 0.2500 (set 2), Akima's 0.0017 (set 5).
TEST(ChosenGradients, AreAsAccurateAsAnyOnRenkaAndBrownsSets) {
  EXPECT_LT(average_error(support::renka_brown_set_2()), 0.2500);
  EXPECT_LT(average_error(support::renka_brown_set_3()), 0.1553);
  EXPECT_LT(average_error(support::renka_brown_set_5()), 0.0017);
}

TEST(ChosenGradients, AreMoreAccurateThanAnyOnFrankesHundredNodes) {
  const std::filesystem::path path =
      std::filesystem::path(DELONE_SHARED_DATA_DIR) / "plane/franke_ds1.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  PlanePoints nodes;
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  char comma = 0;
  for (Point2 p; in >> p.x >> comma >> p.y; std::getline(in, line)) nodes.push_back(p);
  ASSERT_EQ(nodes.size(), 100U);
  EXPECT_LT(average_error(nodes), 0.0066);
}

}  // namespace
}  // namespace delone::interp
