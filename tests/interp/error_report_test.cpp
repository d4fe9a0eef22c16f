#include "interp/error_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "delaunay/error.hpp"
#include "interp/index.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

TEST(ErrorReport, OfFiveResidualsIsWhatOneCountsByHand) {
  const ErrorReport r = error_report(std::vector<double>{1, NAN, -3, 2, 0, 5});
  EXPECT_EQ(r.count, 5);
  EXPECT_EQ(r.num_missing, 1);
  EXPECT_EQ(r.mean, 1);
  EXPECT_DOUBLE_EQ(r.rms, std::sqrt(39.0 / 5));
  EXPECT_DOUBLE_EQ(r.mean_abs, 11.0 / 5);
  EXPECT_EQ(r.largest, 5);
  EXPECT_EQ(r.largest_row, 5);
  EXPECT_EQ(r.median_abs, 2);
  EXPECT_DOUBLE_EQ(r.abs_90, 3 + 0.6 * 2);
  EXPECT_DOUBLE_EQ(r.robust_deviation, 1.4826);  // distances from 1: 0 1 1 4 4
}

TEST(ErrorReport, OfNothingIsNotANumber) {
  const ErrorReport r = error_report(std::vector<double>{NAN, NAN});
  EXPECT_EQ(r.count, 0);
  EXPECT_EQ(r.num_missing, 2);
  EXPECT_EQ(r.largest_row, -1);
  EXPECT_TRUE(std::isnan(r.rms) && std::isnan(r.mean) && std::isnan(r.abs_95) &&
              std::isnan(r.largest));
  EXPECT_EQ(error_report({}).count, 0);
}

TEST(ErrorReport, QuantilesAgreeWithSorting) {
  std::vector<double> values = random_values(1001, 3);
  const ErrorReport r = error_report(values);
  for (double& v : values) v = std::abs(v);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(r.median_abs, values[500]);
  EXPECT_DOUBLE_EQ(r.abs_90, values[900]);
  EXPECT_DOUBLE_EQ(r.abs_99, values[990]);
}

struct Sample {
  PlanePoints points;
  std::vector<double> values;
};
Sample smooth_sample(std::size_t n) {
  Sample s{support::uniform_points(n, 5), {}};
  s.values = support::sampled(
      s.points, [](tripack::Point2 p) { return std::sin(3 * p.x) + std::cos(4 * p.y); });
  return s;
}

std::vector<std::int64_t> rows_of(const std::vector<Outlier>& outliers) {
  std::vector<std::int64_t> rows;
  for (const Outlier& o : outliers) rows.push_back(o.row);
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(FindOutliers, FindsTheSpoiledRowsAndNotTheirNeighbours) {
  Sample s = smooth_sample(2000);
  const auto t = triangulated(s.points);
  const std::vector<std::int64_t> spoiled{17, 400, 801, 1500};
  const auto clean = find_outliers(*t, s.values, leave_out_linear(t, s.values));
  for (const std::int64_t row : spoiled) {
    ASSERT_FALSE(std::isnan(leave_out_linear(t, s.values).predicted[at(row)]));
    s.values[at(row)] += row % 2 == 0 ? 3 : -3;
  }
  const LeaveOneOut left_out = leave_out_linear(t, s.values);
  const auto outliers = find_outliers(*t, s.values, left_out);
  ASSERT_GE(outliers.size(), spoiled.size());
  const std::vector<Outlier> worst(outliers.begin(), outliers.begin() + 4);
  EXPECT_EQ(rows_of(worst), spoiled);
  EXPECT_LE(outliers.size(), spoiled.size() + clean.size());
  for (const Outlier& o : worst) {
    EXPECT_EQ(o.x, s.points[at(o.row)].x);
    EXPECT_EQ(o.value, s.values[at(o.row)]);
    EXPECT_EQ(o.residual, o.predicted - o.value);
    EXPECT_GT(o.score, 5);
  }
}

TEST(FindOutliers, OfConstantFieldsFindsTheOneRowThatDiffers) {
  const Sample s = smooth_sample(300);
  const auto t = triangulated(s.points);
  std::vector<double> values(300, 7.0);
  EXPECT_TRUE(find_outliers(*t, values, leave_out_linear(t, values)).empty());
  values[40] = 8;
  EXPECT_EQ(rows_of(find_outliers(*t, values, leave_out_linear(t, values))),
            std::vector<std::int64_t>{40});
}

TEST(FindOutliers, DoesNotTakeARoughPartForOutliers) {
  Sample s = smooth_sample(3000);
  const std::vector<double> noise = random_values(3000, 8);
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    if (s.points[i].x < 0.2) s.values[i] += noise[i];
  }
  const auto t = triangulated(s.points);
  const LeaveOneOut left_out = leave_out_linear(t, s.values);
  EXPECT_LT(find_outliers(*t, s.values, left_out).size(), 10u);
}

TEST(FindOutliers, OnTheGlobeNamesDegrees) {
  SpherePoints points;
  for (int lat = -60; lat <= 60; lat += 20)
    for (int lon = 0; lon < 360; lon += 20) points.push_back(at_lonlat(lon, lat));
  const auto t = triangulated(points);
  std::vector<double> values(points.size(), 1.0);
  values[60] = 2;
  const auto outliers = find_outliers(*t, values, leave_out_linear(t, values));
  ASSERT_EQ(rows_of(outliers), std::vector<std::int64_t>{60});
  EXPECT_NEAR(outliers[0].x, 120, 1e-12);
  EXPECT_NEAR(outliers[0].y, 0, 1e-12);
}

TEST(FindOutliers, RefusesWrongSizesAndThresholds) {
  const Sample s = smooth_sample(30);
  const auto t = triangulated(s.points);
  const LeaveOneOut left_out = leave_out_linear(t, s.values);
  EXPECT_THROW((void)find_outliers(*t, std::vector<double>{1}, left_out), Error);
  EXPECT_THROW((void)find_outliers(*t, s.values, LeaveOneOut{}), Error);
  EXPECT_THROW((void)find_outliers(*t, s.values, left_out, {.threshold = 0}), Error);
  EXPECT_THROW((void)find_outliers(*t, s.values, left_out, {.threshold = NAN}), Error);
}

TEST(LocalRms, IsThatOfARowAndItsNeighbours) {
  const PlanePoints points{{0, 0}, {2, 0}, {2, 2}, {0, 2.5}, {1, 1}, {1, 1}};
  const std::vector<double> residuals{3, NAN, NAN, NAN, 4, -2};
  const std::vector<double> rms = local_rms(*triangulated(points), residuals);
  EXPECT_DOUBLE_EQ(rms[0], std::sqrt(12.5));
  EXPECT_EQ(rms[4], rms[5]);
  EXPECT_DOUBLE_EQ(rms[2], 4);  // only the middle is a neighbour with a residual
  EXPECT_THROW((void)local_rms(*triangulated(points), std::vector<double>{1}), Error);
}

}  // namespace
}  // namespace delone::interp
