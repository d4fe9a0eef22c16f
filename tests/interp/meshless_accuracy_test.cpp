#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/scatter_makers.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::PlanePoints;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

constexpr SurfaceOptions everywhere{.outside = Outside::linear};

// The mean over Renka and Brown's ten functions.
template <class Make>
double mean_error(const PlanePoints& nodes, Make make) {
  const auto t = triangulated(nodes);
  double sum = 0;
  for (const support::PlaneFunction f : support::renka_brown_functions)
    sum += support::relative_squared_error(make(t, support::sampled(nodes, f)), f);
  return sum / 10;
}

// Bounds: Algorithm 790 (CSHEP2D), as published with Algorithms 790 to 792.
TEST(PlaneShepard, IsAsAccurateAsTheCubicMethodPublished) {
  const auto make = [](const auto& t, const auto& values) {
    return PlaneShepard(t, values, {}, everywhere);
  };
  EXPECT_LE(mean_error(support::renka_brown_set_2(), make), 0.246960);
  EXPECT_LE(mean_error(support::renka_brown_set_3(), make), 0.206310);
  EXPECT_LE(mean_error(support::renka_brown_set_5(), make), 0.002129);
}

// One spline through all nodes is a definite function: SciPy's RBFInterpolator gives
// these figures.
TEST(PlaneRadial, IsTheSplineThatOthersCompute) {
  const auto make = [](RadialKernel kernel) {
    return [kernel](const auto& t, const auto& values) {
      return PlaneRadial(t, values, {.kernel = kernel}, everywhere);
    };
  };
  const auto plate = make(RadialKernel::thin_plate), cubic = make(RadialKernel::cubic);
  EXPECT_NEAR(mean_error(support::renka_brown_set_2(), plate), 0.250242, 1e-6);
  EXPECT_NEAR(mean_error(support::renka_brown_set_3(), plate), 0.137884, 1e-6);
  EXPECT_NEAR(mean_error(support::renka_brown_set_5(), plate), 0.001309, 1e-6);
  EXPECT_NEAR(mean_error(support::renka_brown_set_2(), cubic), 0.233377, 1e-6);
  EXPECT_NEAR(mean_error(support::renka_brown_set_3(), cubic), 0.148185, 1e-6);
  EXPECT_NEAR(mean_error(support::renka_brown_set_5(), cubic), 0.000622, 1e-6);
}

// z_k = 1 - (2 k - 1) / n, longitudes k times the golden angle, plus `turn`.
SpherePoints golden_spiral(int n, double turn) {
  SpherePoints points;
  for (int k = 1; k <= n; ++k) {
    const double z = 1 - (2.0 * k - 1) / n, r = std::sqrt(1 - z * z),
                 lon = k * std::numbers::pi * (3 - std::sqrt(5.0)) + turn;
    points.push_back(Direction::from(r * std::cos(lon), r * std::sin(lon), z));
  }
  return points;
}

double cubic_form(const Direction& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  return (9 * x * x * x - 2 * x * x * y + 3 * x * y * y - 4 * y * y * y + 2 * z * z * z -
          x * y * z) /
         10;
}
double exponentials(const Direction& p) {
  return std::exp(p.x()) + 2 * std::exp(p.y() + p.z());
}

template <class Surface, class Points, class F>
double rms_error(const Surface& surface, const Points& queries, F f) {
  const std::vector<double> values = surface.values(queries);
  double sum = 0;
  for (std::size_t i = 0; i < queries.size(); ++i)
    sum += support::square(values[i] - f(queries[i]));
  return std::sqrt(sum / static_cast<double>(queries.size()));
}

TEST(SphereRadial, IsTheSplineThatOthersCompute) {
  const SpherePoints nodes = golden_spiral(400, 0), queries = golden_spiral(4000, 0.5);
  const auto t = triangulated(nodes);
  const RadialOptions cubic{.kernel = RadialKernel::cubic};
  EXPECT_NEAR(rms_error(SphereRadial(t, support::sampled(nodes, cubic_form), cubic),
                        queries, cubic_form),
              4.6e-6, 0.05e-6);
  EXPECT_NEAR(rms_error(SphereRadial(t, support::sampled(nodes, exponentials), cubic),
                        queries, exponentials),
              7.9e-6, 0.05e-6);
}

PlanePoints inner_points(std::size_t n) {
  PlanePoints points = support::uniform_points(n, 21);
  for (Point2& p : points) p = {0.15 + 0.7 * p.x, 0.15 + 0.7 * p.y};
  return points;
}

double quadratic(Point2 p) { return 1 + p.x - 2 * p.y + p.x * p.y - 3 * p.y * p.y; }
double cubic(Point2 p) { return quadratic(p) + p.x * p.x * p.y - 2 * p.y * p.y * p.y; }
double linear(Point2 p) { return 1 + 2 * p.x - 3 * p.y; }

TEST(PlaneShepard, ReproducesPolynomialsOfItsDegree) {
  const PlanePoints nodes = support::uniform_points(500, 22), queries = inner_points(500);
  const auto t = triangulated(nodes);
  EXPECT_LE(rms_error(PlaneShepard(t, support::sampled(nodes, quadratic),
                                   {.degree = ShepardDegree::quadratic}),
                      queries, quadratic),
            1e-12);
  EXPECT_LE(rms_error(PlaneShepard(t, support::sampled(nodes, cubic)), queries, cubic),
            1e-12);
}

TEST(PlaneRadial, ReproducesPolynomialsOfItsDegree) {
  const PlanePoints nodes = support::uniform_points(500, 23), queries = inner_points(500);
  const auto t = triangulated(nodes);
  for (const int most : {40, 512}) {
    for (const auto kernel : {RadialKernel::thin_plate, RadialKernel::cubic}) {
      const PlaneRadial surface(t, support::sampled(nodes, linear),
                                {.kernel = kernel, .most_at_once = most});
      EXPECT_LE(rms_error(surface, queries, linear), 1e-11);
      const PlaneRadial more(t, support::sampled(nodes, quadratic),
                             {.kernel = kernel, .degree = 2, .most_at_once = most});
      EXPECT_LE(rms_error(more, queries, quadratic), 1e-11);
    }
  }
}

// From h to h / 2 on shuffled lattices, whose density is even.
template <class Make>
double order_of_convergence(Make make) {
  const auto error = [&](std::size_t side) {
    PlanePoints nodes = support::rotated_lattice_points(side * side, 30);
    for (Point2& p : nodes) {
      p = {0.5 + 2 * p.x / static_cast<double>(side - 1),
           -0.9 + 2 * p.y / static_cast<double>(side - 1)};
    }
    return rms_error(make(triangulated(nodes), support::sampled(nodes, support::franke)),
                     inner_points(2000), support::franke);
  };
  return std::log2(error(60) / error(120));
}

TEST(PlaneShepard, ConvergesWithTheOrderOfItsDegree) {
  EXPECT_GE(order_of_convergence([](const auto& t, const auto& values) {
              return PlaneShepard(t, values, {.degree = ShepardDegree::quadratic});
            }),
            2.8);
  EXPECT_GE(order_of_convergence([](const auto& t, const auto& values) {
              return PlaneShepard(t, values);
            }),
            3.8);
}

TEST(SphereShepard, ConvergesWithTheOrderOfItsDegree) {
  const SpherePoints queries = golden_spiral(2000, 0.5);
  const auto error = [&](int n, ShepardDegree degree) {
    const SpherePoints nodes = golden_spiral(n, 0);
    return rms_error(
        SphereShepard(triangulated(nodes), support::sampled(nodes, exponentials),
                      {.degree = degree}),
        queries, exponentials);
  };
  for (const auto& [degree, least] :
       {std::pair{ShepardDegree::quadratic, 2.8}, std::pair{ShepardDegree::cubic, 3.8}})
    EXPECT_GE(std::log2(error(1600, degree) / error(6400, degree)), least);
}

// Along a line, the second differences of the gradient over the step: what is left of
// the jumps of second derivatives. They shrink with the step if there are none.
template <class Surface>
double largest_second_jump(const Surface& surface, int steps) {
  PlanePoints line;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    line.push_back({0.31 + 0.02 * s, 0.42 + 0.013 * s});
  }
  const std::vector<Gradient2> g = surface.gradients(line);
  double largest = 0;
  for (std::size_t i = 1; i + 1 < g.size(); ++i)
    largest = std::max(largest, std::abs(g[i + 1].x - 2 * g[i].x + g[i - 1].x) * steps);
  return largest;
}

TEST(PlaneShepard, IsTwiceContinuouslyDifferentiable) {
  const PlanePoints nodes = support::uniform_points(20000, 24);
  for (const auto degree : {ShepardDegree::quadratic, ShepardDegree::cubic}) {
    const PlaneShepard surface(triangulated(nodes),
                               support::sampled(nodes, support::cosine_peak),
                               {.degree = degree});
    EXPECT_LE(largest_second_jump(surface, 32000),
              0.35 * largest_second_jump(surface, 8000));
  }
}

TEST(PlaneRadial, LocalSplinesAreTwiceContinuouslyDifferentiable) {
  const PlanePoints nodes = support::uniform_points(20000, 25);
  for (const auto kernel : {RadialKernel::cubic, RadialKernel::quintic}) {
    const PlaneRadial surface(triangulated(nodes),
                              support::sampled(nodes, support::cosine_peak),
                              {.kernel = kernel});
    EXPECT_LE(largest_second_jump(surface, 32000),
              0.35 * largest_second_jump(surface, 8000));
  }
}

// Continuity where nodes come and go: steps of the value shrink with steps of the point.
TEST(PlaneInverseDistance, IsContinuous) {
  const PlanePoints nodes = support::uniform_points(300, 26);
  const PlaneInverseDistance surface(triangulated(nodes),
                                     support::random_values(300, 27));
  const auto largest_step = [&](int steps) {
    PlanePoints line;
    for (int i = 0; i <= steps; ++i) {
      const double s = static_cast<double>(i) / steps;
      line.push_back({0.2 + 0.6 * s, 0.7 - 0.5 * s});
    }
    const std::vector<double> v = surface.values(line);
    double largest = 0;
    for (std::size_t i = 1; i < v.size(); ++i)
      largest = std::max(largest, std::abs(v[i] - v[i - 1]));
    return largest;
  };
  EXPECT_LE(largest_step(40000), 0.35 * largest_step(10000));
}

TEST(PlaneInverseDistance, IsTheWeightedMeanOfThePaper) {
  const PlanePoints nodes = support::uniform_points(60, 28);
  const std::vector<double> values = support::random_values(60, 29);
  const PlaneInverseDistance near(triangulated(nodes), values,
                                  {.power = 3, .neighbors = 7}, everywhere);
  const PlaneInverseDistance within(triangulated(nodes), values,
                                    {.power = 1.5, .radius = 0.4}, everywhere);
  for (const Point2 p : support::uniform_points(50, 30)) {
    std::vector<std::pair<double, double>> by_distance;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      by_distance.emplace_back(std::hypot(nodes[i].x - p.x, nodes[i].y - p.y), values[i]);
    std::sort(by_distance.begin(), by_distance.end());
    const auto mean = [&](double end, double power) {
      double weights = 0, sum = 0;
      for (const auto& [d, v] : by_distance) {
        const double w = d < end ? std::pow((end - d) / (end * d), power) : 0;
        weights += w, sum += w * v;
      }
      return sum / weights;
    };
    EXPECT_NEAR(near.value(p), mean(by_distance[7].first, 3), 1e-12);
    EXPECT_NEAR(within.value(p), mean(0.4, 1.5), 1e-12);
  }
}

TEST(PlaneInverseDistance, IsMissingBeyondItsRadius) {
  const PlaneInverseDistance surface(triangulated(PlanePoints{{0, 0}, {4, 0}, {0, 4}}),
                                     std::array{1.0, 2.0, 3.0}, {.radius = 0.5});
  EXPECT_EQ(surface.value({0.25, 0.25}), 1);
  EXPECT_TRUE(std::isnan(surface.value({1, 1})));
  EXPECT_TRUE(std::isnan(surface.gradient({1, 1}).x));
}

// Two soundings 1e-8 apart that do not agree: slopes between them
// say nothing of the rest.
TEST(MeshlessSurfaces, ArePutOutLittleByNearDuplicatesThatDiffer) {
  PlanePoints nodes = support::uniform_points(400, 31);
  std::vector<double> values = support::sampled(nodes, support::franke);
  nodes.push_back({nodes[0].x + 1e-8, nodes[0].y});
  values.push_back(values[0] + 1);
  const auto check = [&](const char* name, const auto& surface) {
    SCOPED_TRACE(name);
    for (const double v : surface.values(inner_points(4000))) {
      EXPECT_GE(v, -4.5);  // the values' range is 2.2: twice that beyond
      EXPECT_LE(v, 6.7);
    }
    EXPECT_EQ(surface.value(nodes[0]), values[0]);
    EXPECT_EQ(surface.value(nodes.back()), values.back());
  };
  const auto t = triangulated(nodes);
  check("CubicShepards", support::CubicShepards::make(t, values));
  check("QuadraticShepards", support::QuadraticShepards::make(t, values));
  check("ThinPlates", support::ThinPlates::make(t, values));
  check("LocalThinPlates", support::LocalThinPlates::make(t, values));
  check("LocalCubics", support::LocalCubics::make(t, values));
}

// SciPy's meaning: (K + smoothing I) w + P c = values. Much smoothing leaves the plane of
// least squares.
TEST(PlaneRadial, SmoothsToThePlaneOfLeastSquares) {
  const PlanePoints nodes = support::uniform_points(200, 32);
  std::vector<double> values = support::sampled(nodes, linear);
  const PlaneRadial exact(triangulated(nodes), values, {.smoothing = 0.1});
  EXPECT_LE(rms_error(exact, inner_points(100), linear), 1e-11);
  const std::vector<double> noise = support::random_values(200, 33);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.1 * noise[i];
  const auto error = [&](double smoothing) {
    return rms_error(PlaneRadial(triangulated(nodes), values, {.smoothing = smoothing}),
                     inner_points(500), linear);
  };
  EXPECT_LE(error(1e6), 0.02);
  EXPECT_LE(error(1e6), 0.5 * error(0));
}

TEST(MeshlessSurfaces, RefuseOptionsOutOfRange) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  const std::vector<double> v{1, 2, 3};
  for (const double power : {0.0, -1.0, 65.0, std::nan("")})
    EXPECT_THROW(PlaneInverseDistance(t, v, {.power = power}), Error);
  EXPECT_THROW(PlaneInverseDistance(t, v, {.neighbors = 0}), Error);
  EXPECT_THROW(PlaneInverseDistance(t, v, {.radius = 0}), Error);
  EXPECT_THROW(PlaneShepard(t, v, {.fitted_neighbors = 7}), Error);
  EXPECT_THROW(PlaneShepard(t, v, {.weighted_neighbors = -1}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.degree = 0}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.kernel = RadialKernel::quintic, .degree = 1}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.degree = 3}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.smoothing = -1}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.smoothing = std::nan("")}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.most_at_once = 11}), Error);
  EXPECT_THROW(PlaneRadial(t, v, {.neighbors = 11}), Error);
}

}  // namespace
}  // namespace delone::interp
