// Smoothing surfaces: what they reproduce, how they choose, and what they are safe from.

#include "interp/smooth_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/smooth_fit.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using support::SplitMix64;
using support::triangulated;
using tripack::Point2;

constexpr double infinite = std::numeric_limits<double>::infinity();

SmoothOptions of_length(double wavelength) {
  SmoothOptions options;
  options.by = SmoothBy::wavelength;
  options.wavelength = wavelength;
  return options;
}

double gaussian(SplitMix64& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

std::vector<double> noisy(std::vector<double> values, double deviation,
                          std::uint64_t seed) {
  SplitMix64 random(seed);
  for (double& v : values) v += deviation * gaussian(random);
  return values;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Least squares of the values on columns.
std::vector<double> least_squares(const Eigen::MatrixXd& columns,
                                  const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> y(values.data(), std::ssize(values));
  const Eigen::VectorXd fit = columns * columns.colPivHouseholderQr().solve(y);
  return {fit.begin(), fit.end()};
}

double smooth_harmonic(const stripack::Direction& p) {
  return p.x() * p.y() + std::sin(3 * p.z()) * p.x() + 0.5 * p.z();
}

TEST(PlaneSmooth, ReproducesConstantsExactly) {
  const auto points = support::clustered_points(80, 1);
  const std::vector<double> values(points.size(), 0.1);
  for (const double length : {0.0, 0.01, 0.5, infinite}) {
    const PlaneSmooth surface(triangulated(points), values, of_length(length));
    for (const Point2 p :
         support::points_of_the_hull(tripack::Triangulation(points), 1)) {
      const double v = surface.value(p);  // missing where rounding led out of the hull
      ASSERT_TRUE(v == 0.1 || std::isnan(v)) << v;
    }
  }
  EXPECT_EQ(PlaneSmooth(triangulated(points), values).value(points[3]), 0.1);
}

TEST(PlaneSmooth, ReproducesLinearFunctionsWhateverTheLength) {
  const auto points = support::uniform_points(150, 1);
  const auto values =
      support::sampled(points, [](Point2 p) { return 3 * p.x - 2 * p.y + 1; });
  for (const double length : {0.0, 0.02, 0.5, 20.0, infinite}) {
    const PlaneSmooth surface(triangulated(points), values, of_length(length));
    EXPECT_LT(largest_difference(surface.smoothed_values(), values), 1e-11);
    EXPECT_NEAR(surface.gradient({0.5, 0.5}).x, 3, 1e-8);
  }
}

TEST(PlaneSmooth, OfLengthZeroInterpolatesBitForBit) {
  const auto points = support::uniform_points(120, 2);
  const auto values = support::random_values(points.size(), 3);
  const PlaneSmooth surface(triangulated(points), values, of_length(0));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(surface.value(points[i]), values[i]);
}

TEST(PlaneSmooth, OfInfiniteLengthIsThePlaneOfLeastSquares) {
  const auto points = support::uniform_points(90, 4);
  const auto values = support::random_values(points.size(), 5);
  Eigen::MatrixXd columns(90, 3);
  for (Eigen::Index i = 0; i < 90; ++i) {
    const Point2 p = points[static_cast<std::size_t>(i)];
    columns.row(i) << 1, p.x, p.y;
  }
  const auto plane = least_squares(columns, values);
  const PlaneSmooth surface(triangulated(points), values, of_length(infinite));
  EXPECT_LT(largest_difference(surface.smoothed_values(), plane), 1e-13);
  EXPECT_EQ(surface.fit().degrees_of_freedom, 3);
  const PlaneSmooth near(triangulated(points), values, of_length(30));
  EXPECT_LT(largest_difference(near.smoothed_values(), plane), 1e-4);
}

TEST(PlaneSmooth, KeepsHalfOfAWaveOfItsLength) {
  const auto lattice = support::lattice_points(900);
  const auto wave = [](Point2 p) { return std::sin(2 * std::numbers::pi * p.x / 10); };
  const PlaneSmooth surface(triangulated(lattice), support::sampled(lattice, wave),
                            of_length(10));
  EXPECT_NEAR(surface.value({12.5, 15}), 0.5, 0.02);
  EXPECT_NEAR(surface.value({17.5, 14}), -0.5, 0.02);
}

TEST(PlaneSmooth, LengthsMeanTheSameForFewDataAndForMany) {
  const auto freedom = [](std::size_t n) {
    const auto points = support::uniform_points(n, 7);
    return PlaneSmooth(triangulated(points), support::sampled(points, support::franke),
                       of_length(0.5))
        .fit()
        .degrees_of_freedom;
  };
  EXPECT_NEAR(freedom(1000) / freedom(250), 1, 0.1);
}

TEST(PlaneSmooth, DegreesOfFreedomAreTheTraceOfTheLinearMap) {
  const auto points = support::uniform_points(40, 11);
  double trace = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> unit(points.size());
    unit[i] = 1;
    trace += PlaneSmooth(triangulated(points), unit, of_length(0.6)).smoothed_values()[i];
  }
  const PlaneSmooth any(triangulated(points), support::random_values(40, 1),
                        of_length(0.6));
  EXPECT_NEAR(any.fit().degrees_of_freedom, trace, 1e-8 * trace);
}

TEST(PlaneSmooth, TakesNoiseFromFrankesFunctionAndTellsHowMuchThereWas) {
  const auto points = support::uniform_points(300, 21);
  const auto truth = support::sampled(points, support::franke);
  const auto values = noisy(truth, 0.1, 5);
  const auto t = triangulated(points);
  const PlaneSmooth surface(t, values);
  const auto error_of = [&](const PlaneSmooth& s) {
    return rms_difference(s.smoothed_values(), truth);
  };
  const double error = error_of(surface), chosen = surface.fit().wavelength;
  EXPECT_LT(error, 0.4 * rms_difference(values, truth));
  EXPECT_NEAR(surface.fit().noise, 0.1, 0.01);
  double best = error;
  for (const double factor : {0.5, 0.7, 1.4, 2.0})
    best = std::min(best, error_of(PlaneSmooth(t, values, of_length(factor * chosen))));
  EXPECT_LT(error, 1.15 * best);
}

TEST(PlaneSmooth, IsNearerToTheTruthBetweenNoisyDataThanC1) {
  const auto points = support::uniform_points(250, 22), queries = [] {
    auto q = support::uniform_points(500, 23);
    for (Point2& p : q) p = {0.1 + 0.8 * p.x, 0.1 + 0.8 * p.y};
    return q;
  }();
  const auto values = noisy(support::sampled(points, support::franke), 0.1, 6);
  const auto truth = support::sampled(queries, support::franke);
  const PlaneSmooth smooth(triangulated(points), values);
  const PlaneC1 c1(triangulated(points), values);
  EXPECT_LT(rms_difference(smooth.values(queries), truth),
            0.6 * rms_difference(c1.values(queries), truth));
}

TEST(PlaneSmooth, ByErrorsMissesTheDataByTheErrors) {
  const auto points = support::uniform_points(300, 31);
  SplitMix64 random(4);
  std::vector<double> values = support::sampled(points, support::franke), errors;
  for (double& v : values) {
    errors.push_back(random.between(0.02, 0.2));
    v += errors.back() * gaussian(random);
  }
  SmoothOptions options;
  options.by = SmoothBy::errors;
  options.errors = errors;
  const auto t = triangulated(points);
  const PlaneSmooth surface(t, values, options);
  EXPECT_NEAR(surface.fit().rms_misfit_over_errors, 1, 1e-3);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double misfit = (values[i] - surface.smoothed_values()[i]) / errors[i];
    sum += misfit * misfit / static_cast<double>(values.size());
  }
  EXPECT_NEAR(sum, 1, 2e-3);

  const std::vector<double> large(values.size(), 10.0);
  options.errors = large;
  EXPECT_EQ(PlaneSmooth(t, values, options).fit().wavelength, infinite);
}

TEST(PlaneSmooth, BelievesSureDataMoreThanUnsureOnes) {
  const auto points = support::uniform_points(200, 41);
  auto values = support::sampled(points, support::franke);
  const double truth = values[50];
  values[50] += 5;
  std::vector<double> errors(values.size(), 0.1);
  errors[50] = 1000;
  SmoothOptions options = of_length(0.3);
  options.errors = errors;
  const PlaneSmooth surface(triangulated(points), values, options);
  EXPECT_NEAR(surface.value(points[50]), truth, 0.1);
}

TEST(PlaneSmooth, RepeatedRowsCountAsOneOfTheirMeanWithTheWeightOfAll) {
  auto points = support::uniform_points(60, 42);
  auto values = support::random_values(points.size(), 43);
  const double half_error = std::sqrt(0.5);
  std::vector<double> errors(values.size(), 1.0);
  errors[7] = half_error;
  SmoothOptions options = of_length(0.5);
  options.errors = errors;
  const double once = PlaneSmooth(triangulated(points), values, options).value(points[7]);
  points.push_back(points[7]);
  values.push_back(values[7] + 0.25);
  values[7] -= 0.25;
  const std::vector<double> alike(values.size(), 1.0);
  options.errors = alike;
  const PlaneSmooth twice(triangulated(points), values, options);
  EXPECT_NEAR(twice.value(points[7]), once, 1e-12);
}

TEST(PlaneSmooth, DependsNeitherOnTheOrderOfRowsNorOnThreads) {
  const auto points = support::uniform_points(200, 51);
  const auto values = noisy(support::sampled(points, support::franke), 0.05, 8);
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  order = support::shuffled(order, 3);
  support::PlanePoints other_points;
  std::vector<double> other_values;
  for (const std::size_t i : order) {
    other_points.push_back(points[i]);
    other_values.push_back(values[i]);
  }
  const PlaneSmooth a(triangulated(points), values, {},
                      {.num_threads = 1, .progress = {}}),
      b(triangulated(other_points), other_values, {}, {.num_threads = 3, .progress = {}});
  EXPECT_EQ(a.fit().wavelength, b.fit().wavelength);
  for (const Point2 p : support::uniform_points(50, 9))
    EXPECT_TRUE(support::is_same(a.value(p), b.value(p)));
}

TEST(PlaneSmooth, IsTheSameAfterMovingAndScaling) {
  const auto points = support::uniform_points(80, 61);
  const auto values = noisy(support::sampled(points, support::franke), 0.05, 9);
  const PlaneSmooth plain(triangulated(points), values);
  for (const double scale : {1e-6, 1e6, 1e200, 1e-200}) {
    support::PlanePoints scaled = points;
    for (Point2& p : scaled) p = {scale * p.x, scale * p.y};
    const PlaneSmooth surface(triangulated(scaled), values);
    EXPECT_NEAR(surface.fit().wavelength / scale / plain.fit().wavelength, 1, 1e-6);
    EXPECT_LT(largest_difference(surface.smoothed_values(), plain.smoothed_values()),
              1e-6);
  }
  support::PlanePoints moved = points;
  for (Point2& p : moved) p = {p.x + 1e7, p.y - 1e7};
  EXPECT_LT(largest_difference(PlaneSmooth(triangulated(moved), values).smoothed_values(),
                               plain.smoothed_values()),
            1e-5);
  for (const double factor : {1e-200, 1e-120, 1e120}) {
    std::vector<double> large = values;
    for (double& v : large) v *= factor;
    const PlaneSmooth surface(triangulated(points), large);
    EXPECT_NEAR(surface.fit().noise / factor / plain.fit().noise, 1, 1e-6);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(surface.smoothed_values()[i] / factor, plain.smoothed_values()[i],
                  1e-7);
  }
}

TEST(PlaneSmooth, OfFewOrCollinearPoints) {
  EXPECT_TRUE(
      std::isnan(PlaneSmooth(triangulated(support::PlanePoints{}), {}).value({})));
  const support::PlanePoints two{{0, 0}, {1, 0}}, three{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(PlaneSmooth(triangulated(two), std::vector{1.0, 3.0}).value({1, 0}), 3);
  EXPECT_EQ(PlaneSmooth(triangulated(three), std::vector{1.0, 3.0, 4.0}).value({0, 1}),
            4);
  support::PlanePoints line;
  std::vector<double> zigzag;
  for (int i = 0; i < 40; ++i) {
    line.push_back({double(i), 2.0 * i});
    zigzag.push_back(0.5 * i + (i % 2 == 0 ? 1 : -1));
  }
  const PlaneSmooth chain(triangulated(line), zigzag, of_length(40));
  EXPECT_NEAR(chain.value({20, 40}), 10, 0.05);
  EXPECT_LT(
      PlaneSmooth(triangulated(line), zigzag, of_length(1e9)).fit().degrees_of_freedom,
      2.001);
}

TEST(PlaneSmooth, ReportsProgressAndCanBeCancelled) {
  const auto t = triangulated(support::uniform_points(60, 1));
  const auto values = support::random_values(60, 1);
  double last = 0;
  const auto watch = [&last](double part) {
    EXPECT_GE(part, last);
    last = part;
    return true;
  };
  const PlaneSmooth surface(t, values, {}, {.num_threads = 1, .progress = watch});
  EXPECT_EQ(last, 1);
  const auto stop = [](double) { return false; };
  EXPECT_THROW(PlaneSmooth(t, values, {}, {.num_threads = 1, .progress = stop}),
               Cancelled);
}

TEST(PlaneSmooth, ByTinyErrorsGoesThroughTheData) {
  const auto t = triangulated(support::uniform_points(50, 2));
  const auto values = support::random_values(50, 3);
  const std::vector<double> errors(50, 1e-9);
  SmoothOptions options;
  options.by = SmoothBy::errors;
  options.errors = errors;
  const PlaneSmooth surface(t, values, options);
  EXPECT_LT(largest_difference(surface.smoothed_values(), values), 1e-5);
}

TEST(PlaneSmooth, RefusesWhatMakesNoSense) {
  const auto t = triangulated(support::uniform_points(10, 1));
  const auto values = support::random_values(10, 1);
  const auto refuses = [&](const SmoothOptions& options) {
    EXPECT_THROW(PlaneSmooth(t, values, options), Error);
  };
  refuses(of_length(-1));
  refuses(of_length(std::nan("")));
  SmoothOptions options;
  options.by = SmoothBy::errors;
  refuses(options);
  for (const double bad : {0.0, -1.0, std::nan(""), infinite}) {
    std::vector<double> errors(10, 1.0);
    errors[4] = bad;
    options.errors = errors;
    try {
      const PlaneSmooth surface(t, values, options);
      ADD_FAILURE();
    } catch (const Error& error) {
      ASSERT_EQ(error.rows().size(), 1U);
      EXPECT_EQ(error.rows()[0], 4);
    }
  }
  const std::vector<double> few(3, 1.0);
  options.errors = few;
  refuses(options);
  std::vector<double> missing = values;
  missing[2] = std::nan("");
  EXPECT_THROW(PlaneSmooth(t, missing), Error);
}

class PlaneSmoothFamilies : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneSmoothFamilies, StayFiniteAndNearTheData) {
  const auto points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  const auto values = support::random_values(points.size(), 2);
  const Region r = support::region_of(*t);
  const double extent = std::max(r.east / 2 - r.west / 2, r.north / 2 - r.south / 2);
  for (const SmoothOptions& options :
       {SmoothOptions{}, of_length(0.1 * extent), of_length(10 * extent)}) {
    const PlaneSmooth surface(t, values, options);
    for (const double v : surface.smoothed_values()) ASSERT_LE(std::abs(v), 3);
    for (const Point2 p : points) ASSERT_LE(std::abs(surface.value(p)), 3);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlaneSmoothFamilies,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(SphereSmooth, ReproducesConstantsAndFirstDegreeHarmonicsWhateverTheLength) {
  const auto points = support::uniform_directions(150, 1);
  const auto t = triangulated(points);
  const std::vector<double> constant(points.size(), 0.3);
  const auto values = support::sampled(points, [](const stripack::Direction& p) {
    return 2 * p.x() - p.y() + 0.5 * p.z() + 3;
  });
  for (const double length : {0.0, 0.3, 2.0, 50.0, infinite}) {
    EXPECT_EQ(SphereSmooth(t, constant, of_length(length)).value(points[1]), 0.3);
    const SphereSmooth surface(t, values, of_length(length));
    EXPECT_LT(largest_difference(surface.smoothed_values(), values), 1e-11);
  }
}

TEST(SphereSmooth, OfInfiniteLengthIsTheHarmonicOfLeastSquares) {
  const auto points = support::uniform_directions(90, 4);
  const auto values = support::random_values(points.size(), 5);
  Eigen::MatrixXd columns(90, 4);
  for (Eigen::Index i = 0; i < 90; ++i) {
    const auto& p = points[static_cast<std::size_t>(i)];
    columns.row(i) << 1, p.x(), p.y(), p.z();
  }
  const SphereSmooth surface(triangulated(points), values, of_length(infinite));
  EXPECT_LT(largest_difference(surface.smoothed_values(), least_squares(columns, values)),
            1e-13);
}

TEST(SphereSmooth, MinimisesRoughnessAndMisfitTogetherWithTheHarmonic) {
  const auto points = support::uniform_directions(50, 6);
  const auto t = triangulated(points);
  const auto values = support::random_values(points.size(), 7);
  const auto system = smooth_system<SphereSpace>(*t, std::vector<double>(50, 1.0));
  const double parameter = system.parameter(1.5 * system.scale);
  // Unknowns of the sites, then those of the harmonic.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(153, 153);
  for (Eigen::Index k = 0; k < 150; ++k)
    matrix.col(k).head(150) = system.apply(parameter, Eigen::VectorXd::Unit(150, k));
  Eigen::VectorXd right = Eigen::VectorXd::Zero(153);
  const auto& rows = t->rows();
  for (Eigen::Index s = 0; s < 50; ++s) {
    const Eigen::Vector3d harmonic = system.trend.row(3 * s);
    matrix.row(3 * s).tail(3) += harmonic.transpose();
    matrix.col(3 * s).tail(3) += harmonic;
    matrix.bottomRightCorner(3, 3) += harmonic * harmonic.transpose();
    const double y = values[at(rows[at(static_cast<std::int64_t>(s))])];
    right[3 * s] = y;
    right.tail(3) += y * harmonic;
  }
  const Eigen::VectorXd x = matrix.colPivHouseholderQr().solve(right);
  const SphereSmooth surface(t, values, of_length(1.5));
  for (Eigen::Index s = 0; s < 50; ++s)
    EXPECT_NEAR(x[3 * s] + system.trend.row(3 * s).dot(x.tail(3)),
                surface.smoothed_values()[at(rows[at(static_cast<std::int64_t>(s))])],
                1e-8);
  double trace = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    std::vector<double> unit(50);
    unit[i] = 1;
    trace += SphereSmooth(t, unit, of_length(1.5)).smoothed_values()[i];
  }
  EXPECT_NEAR(surface.fit().degrees_of_freedom, trace, 1e-8 * trace);
}

TEST(SphereSmooth, TakesNoiseFromAHarmonicField) {
  const auto points = support::uniform_directions(300, 21);
  const auto truth = support::sampled(points, smooth_harmonic);
  const auto values = noisy(truth, 0.1, 5);
  const auto t = triangulated(points);
  const SphereSmooth surface(t, values);
  const double error = rms_difference(surface.smoothed_values(), truth);
  EXPECT_LT(error, 0.5 * rms_difference(values, truth));
  EXPECT_NEAR(surface.fit().noise, 0.1, 0.012);
  const std::vector<double> errors(points.size(), 0.1);
  SmoothOptions options;
  options.by = SmoothBy::errors;
  options.errors = errors;
  const SphereSmooth by_errors(t, values, options);
  EXPECT_NEAR(by_errors.fit().rms_misfit_over_errors, 1, 1e-3);
  EXPECT_LT(rms_difference(by_errors.smoothed_values(), truth), 2 * error);
}

TEST(SphereSmooth, DoesNotDependOnWhereThePolesAre) {
  const auto points = support::uniform_directions(150, 31);
  const auto values = noisy(support::sampled(points, smooth_harmonic), 0.1, 3);
  support::SpherePoints turned;
  for (const auto& p : points) {
    turned.push_back(stripack::Direction::from(0.36 * p.x() - 0.8 * p.y() + 0.48 * p.z(),
                                               0.48 * p.x() + 0.6 * p.y() + 0.64 * p.z(),
                                               -0.8 * p.x() + 0.6 * p.z()));
  }
  const SphereSmooth a(triangulated(points), values), b(triangulated(turned), values);
  EXPECT_NEAR(b.fit().wavelength / a.fit().wavelength, 1, 1e-5);
  EXPECT_LT(largest_difference(a.smoothed_values(), b.smoothed_values()), 1e-6);
}

TEST(SphereSmooth, AgreesWithThePlaneOverASmallRegion) {
  const double side = 1e-3;
  const auto points = support::box_directions(200, 3, side);
  support::PlanePoints flat;  // the tangent plane at the first one
  const Vector3 up = vector(points[0]);
  const auto axes = SphereSpace::axes(up);
  for (const auto& p : points) {
    const Vector3 v = vector(p);
    flat.push_back({dot(axes.u, v) / dot(up, v), dot(axes.v, v) / dot(up, v)});
  }
  const auto values = support::random_values(points.size(), 4);
  const SphereSmooth sphere(triangulated(points), values, of_length(0.3 * side));
  const PlaneSmooth plane(triangulated(flat), values, of_length(0.3 * side));
  EXPECT_LT(largest_difference(sphere.smoothed_values(), plane.smoothed_values()), 1e-2);
}

class SphereSmoothFamilies : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereSmoothFamilies, StayFiniteAndNearTheData) {
  const auto points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  const auto values = support::random_values(points.size(), 2);
  for (const SmoothOptions& options : {SmoothOptions{}, of_length(1e-3), of_length(1)}) {
    const SphereSmooth surface(t, values, options);
    for (const double v : surface.smoothed_values()) ASSERT_LE(std::abs(v), 3);
    for (const auto& p : points) ASSERT_LE(std::abs(surface.value(p)), 3);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SphereSmoothFamilies,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace delone::interp
