#include "io/axis_fit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/grid_samples.hpp"

namespace delone::io {
namespace {

using test::coordinates;
using test::Doubles;
using test::nan;

TEST(FitAxis, FindsTheDecimalSpacing) {
  Doubles tenths;
  for (int i = 0; i <= 3600; ++i) tenths.push_back((i - 1800) / 10.0);
  const FittedAxis fitted = fit_axis(tenths);
  EXPECT_EQ(coordinates(fitted.axis), tenths);
  EXPECT_EQ(fitted.largest_deviation, 0);
}

TEST(FitAxis, MendsCoordinatesThatWereSummedUp) {
  Doubles sums;
  double sum = 0;
  for (int i = 0; i < 1000; ++i, sum += 0.1) sums.push_back(sum);
  EXPECT_NE(sums[999], 99.9);
  EXPECT_EQ(fit_axis(sums).axis.coordinate(999), 99.9);
}

TEST(FitAxis, FindsThirdsAndCellCentres) {
  Doubles thirds, centres;
  for (int i = 0; i < 1080; ++i) thirds.push_back((i - 540) / 3.0);
  for (int i = 0; i < 360; ++i) centres.push_back(i + 0.5);
  EXPECT_EQ(coordinates(fit_axis(thirds).axis), thirds);
  EXPECT_EQ(coordinates(fit_axis(centres).axis), centres);
}

TEST(FitAxis, KeepsFarOffsets) {
  const Doubles easting = {178460, 178500, 178540};
  EXPECT_EQ(coordinates(fit_axis(easting).axis), easting);
  const Doubles odd = {1e15 + 1, 1e15 + 3, 1e15 + 5};
  EXPECT_EQ(coordinates(fit_axis(odd).axis), odd);
}

TEST(FitAxis, TakesOneCoordinate) {
  const FittedAxis fitted = fit_axis(Doubles{7.25});
  EXPECT_EQ(fitted.axis.size, 1);
  EXPECT_EQ(fitted.axis.coordinate(0), 7.25);
}

TEST(FitAxis, RefusesWhatIsNoAxis) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fit_axis(Doubles{0, nan, 2}).largest_deviation, infinite);
  EXPECT_EQ(fit_axis(Doubles{0, 1, infinite}).largest_deviation, infinite);
  EXPECT_EQ(fit_axis(Doubles{1, 2, 1}).largest_deviation, infinite);
  EXPECT_EQ(fit_axis(Doubles{-1e308, 0, 1.7e308}).largest_deviation, infinite);
}

}  // namespace
}  // namespace delone::io
