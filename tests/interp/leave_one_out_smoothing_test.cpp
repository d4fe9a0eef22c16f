// Leave-one-out errors of smoothing surfaces, against surfaces in which a datum hardly
// counts.

#include "interp/leave_one_out_smoothing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "delaunay/error.hpp"
#include "interp/error_report.hpp"
#include "interp/left_out_checks.hpp"
#include "interp/smooth_surface.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"
#include "stripack/neighbor_search.hpp"
#include "tripack/neighbor_search.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::first_difference;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

constexpr double infinite = std::numeric_limits<double>::infinity();

SmoothOptions of_length(double wavelength) {
  SmoothOptions options;
  options.by = SmoothBy::wavelength;
  options.wavelength = wavelength;
  return options;
}

/// Smoothed values if the datum of a site weighs nothing, for the same parameter: weights
/// are divided by their mean, and the parameter goes with the length to the fourth.
template <class Surface, class Triangulation>
std::vector<double> without_datum(const std::shared_ptr<const Triangulation>& t,
                                  const std::vector<double>& values, double wavelength,
                                  delaunay::Site gone) {
  const auto num_sites = static_cast<double>(t->num_sites());
  std::vector<double> errors(values.size(), 1.0);
  const double left = num_sites - 1;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (t->sites()[row] == gone) errors[row] = 1e12;
  SmoothOptions options = of_length(wavelength * std::pow(num_sites / left, 0.25));
  options.errors = errors;
  return Surface(t, values, options).smoothed_values();
}

template <class Surface, class Points>
void expect_as_without_datum(const Points& points, double wavelength, double error) {
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  SmoothOptions options = of_length(wavelength);
  options.outside = Outside::nearest;
  const LeaveOneOut found = leave_out_smooth(t, values, options);
  const LeaveOneOut inside = leave_out_smooth(t, values, of_length(wavelength));
  for (delaunay::Site s = 0; s < t->num_sites(); s += 7) {
    const auto row = at(t->rows()[at(s)]);
    const auto wanted = without_datum<Surface>(t, values, wavelength, s);
    if (std::isnan(inside.predicted[row])) {
      const auto nearest = nearest_k(*t, t->points()[at(s)], 2, delaunay::none)[1].row;
      ASSERT_NEAR(found.predicted[row], wanted[at(nearest)], error) << "site " << s;
    } else {
      ASSERT_NEAR(found.predicted[row], wanted[row], error) << "site " << s;
      ASSERT_EQ(found.predicted[row], inside.predicted[row]);
    }
  }
}

TEST(LeaveOneOutSmoothing, IsTheSurfaceInWhichTheDatumDoesNotCount) {
  for (const double length : {0.1, 0.4, 2.0})
    expect_as_without_datum<PlaneSmooth>(support::uniform_points(120, 3), length, 1e-8);
  expect_as_without_datum<PlaneSmooth>(support::lattice_points(81), 3, 1e-8);
}

TEST(LeaveOneOutSmoothing, IsTheSurfaceInWhichTheDatumDoesNotCountOnTheSphere) {
  for (const double length : {0.5, 3.0})
    expect_as_without_datum<SphereSmooth>(support::uniform_directions(120, 3), length,
                                          1e-7);
  SpherePoints cap;
  for (const tripack::Point2 p : support::uniform_points(80, 5))
    cap.push_back(at_lonlat(40 * p.x, 40 * p.y));
  expect_as_without_datum<SphereSmooth>(cap, 0.3, 1e-7);
}

TEST(LeaveOneOutSmoothing, OfInfiniteLengthIsThePlaneThroughTheOthers) {
  expect_as_without_datum<PlaneSmooth>(support::uniform_points(60, 3), infinite, 1e-11);
  expect_as_without_datum<SphereSmooth>(support::uniform_directions(60, 3), infinite,
                                        1e-11);
}

TEST(LeaveOneOutSmoothing, OfLengthZeroIsTheLimitOfShortLengths) {
  const auto t = triangulated(support::uniform_points(150, 3));
  const std::vector<double> values = random_values(150, 4);
  const LeaveOneOut none = leave_out_smooth(t, values, of_length(0)),
                    little = leave_out_smooth(t, values, of_length(0.006));
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(none.predicted[i]))
      largest = std::max(largest, std::abs(none.predicted[i] - little.predicted[i]));
  EXPECT_LT(largest, 0.005);
  EXPECT_GT(error_report(none.residual).rms, 0.3);
}

TEST(LeaveOneOutSmoothing, HasTheRootMeanSquareThatCrossValidationPredicts) {
  const PlanePoints points = support::uniform_points(400, 3);
  auto values = support::sampled(points, support::franke);
  const std::vector<double> noise = random_values(400, 5);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.1 * noise[i];
  const auto t = triangulated(points);
  SmoothOptions options;
  options.outside = Outside::linear;
  const LeaveOneOut found = leave_out_smooth(t, values, options);
  EXPECT_EQ(found.num_missing, 0);
  const double predicted = PlaneSmooth(t, values).fit().predicted_rms;
  EXPECT_NEAR(error_report(found.residual).rms, predicted, 0.05 * predicted);
}

TEST(LeaveOneOutSmoothing, WeighsByErrors) {
  const PlanePoints points = support::uniform_points(80, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(80, 4);
  std::vector<double> errors(80, 0.1);
  SmoothOptions options = of_length(0.5);
  for (std::size_t i = 0; i < 40; ++i) errors[i] = 10;
  options.errors = errors;
  const LeaveOneOut found = leave_out_smooth(t, values, options);
  // A datum that counts for little is missed by as much whether it counts or not.
  const std::vector<double> smoothed = PlaneSmooth(t, values, options).smoothed_values();
  for (std::size_t i = 0; i < 40; ++i)
    if (!std::isnan(found.predicted[i])) {
      EXPECT_NEAR(found.predicted[i], smoothed[i], 0.01) << i;
    }
}

TEST(LeaveOneOutSmoothing, DoesNotKnowTheDatum) {
  for (const auto& family : support::plane_families()) {
    const PlanePoints points = family.make(40, 3);
    const auto t = triangulated(points);
    std::vector<double> values = random_values(points.size(), 4);
    const double length =
        0.2 * std::sqrt(support::region_of(*t).east - support::region_of(*t).west);
    const double before = leave_out_smooth(t, values, of_length(length)).predicted[13];
    for (std::size_t i = 0; i < values.size(); ++i)
      if (t->sites()[i] == t->sites()[13]) values[i] += 0.5;
    const double after = leave_out_smooth(t, values, of_length(length)).predicted[13];
    ASSERT_EQ(std::isnan(before), std::isnan(after)) << family.name;
    if (!std::isnan(before)) {
      EXPECT_NEAR(before, after, 1e-5) << family.name;
    }
  }
}

TEST(LeaveOneOutSmoothing, LeavesRepeatedRowsOutTogether) {
  PlanePoints points = support::uniform_points(30, 3);
  points.push_back({0.5, 0.5}), points.push_back({0.5, 0.5});
  std::vector<double> values = random_values(32, 4);
  const auto t = triangulated(points);
  const LeaveOneOut found = leave_out_smooth(t, values, of_length(0.5));
  EXPECT_EQ(found.predicted[30], found.predicted[31]);
  values[30] += 1, values[31] -= 2;
  EXPECT_NEAR(leave_out_smooth(t, values, of_length(0.5)).predicted[30],
              found.predicted[30], 1e-12);
}

TEST(LeaveOneOutSmoothing, OfUpToThreePointsIsThatOfTheLinearSurface) {
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{1, 2}}, PlanePoints{{1, 2}, {3, 4}},
        PlanePoints{{0, 0}, {1, 1}, {3, 3}}, PlanePoints{{0, 0}, {1, 0}, {0, 1}}}) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 1);
    for (const Outside outside : {Outside::missing, Outside::nearest}) {
      SmoothOptions options;
      options.outside = outside;
      EXPECT_EQ(first_difference(leave_out_smooth(t, values, options).predicted,
                                 leave_out_linear(t, values, options).predicted),
                points.size());
    }
  }
}

TEST(LeaveOneOutSmoothing, OfAChainIsThatOfItsInnerNodes) {
  PlanePoints points;
  for (int i = 0; i < 20; ++i) points.push_back({1.0 * i, 2.0 * i});
  const auto values =
      support::sampled(points, [](tripack::Point2 p) { return 3 * p.x + 1; });
  const LeaveOneOut found = leave_out_smooth(triangulated(points), values, of_length(5));
  EXPECT_EQ(found.num_missing, 2);
  EXPECT_LT(error_report(found.residual).largest, 1e-9);
}

TEST(LeaveOneOutSmoothing, OfConstantsIsNought) {
  const auto t = triangulated(support::clustered_points(100, 3));
  const std::vector<double> values(100, 0.1);
  for (const double r : leave_out_smooth(t, values).residual)
    EXPECT_TRUE(r == 0 || std::isnan(r)) << r;
}

TEST(LeaveOneOutSmoothing, RefusesWhatTheSurfacesRefuse) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  const auto s = triangulated(SpherePoints{at_lonlat(0, 0), at_lonlat(9, 0)});
  const std::vector<double> values{1, 2, 3, 4}, few{1, 2}, bad{1, 2, NAN, 4};
  SmoothOptions linear;
  linear.outside = Outside::linear;
  SmoothOptions by_errors;
  by_errors.by = SmoothBy::errors;
  EXPECT_THROW((void)leave_out_smooth(t, few), Error);
  EXPECT_THROW((void)leave_out_smooth(t, bad), Error);
  EXPECT_THROW((void)leave_out_smooth(t, values, of_length(-1)), Error);
  EXPECT_THROW((void)leave_out_smooth(t, values, by_errors), Error);
  EXPECT_THROW((void)leave_out_smooth(s, few, linear), Error);
}

}  // namespace
}  // namespace delone::interp
