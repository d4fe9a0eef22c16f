#include "io/map_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delone::io {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

interp::Field field_of(std::int64_t columns, std::int64_t rows,
                       std::vector<double> values) {
  return {{{1, 0, columns, 0}, {1, 0, rows, 0}}, std::move(values)};
}

TEST(Rasterize, ShowsEachNodeInTheMiddleOfItsCell) {
  // Five pixels a cell, so that the third stands on the node.
  const auto field = field_of(3, 2, {0, 1, 2, 3, 4, 5});
  const ColorScale scale = ColorScale::choose(0, 5);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 15, 10);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(raster.at(5 * i + 2, 9 - (5 * j + 2)), scale.color(3 * j + i))
          << i << ' ' << j;
}

TEST(Rasterize, InterpolatesBetweenNodes) {
  const auto field = field_of(2, 1, {0, 10});
  const ColorScale scale = ColorScale::choose(0, 10);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 20, 1);
  // Pixel 10 has its centre at 10.5 / 20 * 2 - 0.5 = 0.55.
  EXPECT_EQ(raster.at(10, 0), scale.color(5.5));
  EXPECT_EQ(raster.at(0, 0), scale.color(0)) << "beyond the last node its value";
}

TEST(Rasterize, LeavesExactlyTheCellsOfMissingNodesBlank) {
  const auto field = field_of(3, 1, {1, missing, 2});
  const ColorScale scale = ColorScale::choose(1, 2);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 30, 1);
  for (int i = 0; i < 30; ++i) {
    const Color expected = i < 10   ? scale.color(1)
                           : i < 20 ? blank_color
                                    : scale.color(2);
    EXPECT_EQ(raster.at(i, 0), expected) << i;
  }
}

TEST(Rasterize, LeavesInfiniteValuesBlank) {
  const auto field = field_of(2, 1, {std::numeric_limits<double>::infinity(), 1});
  const ColorScale scale = ColorScale::choose(0, 1);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 2, 1);
  EXPECT_EQ(raster.at(0, 0), blank_color);
  EXPECT_EQ(raster.at(1, 0), scale.color(1));
}

TEST(Rasterize, AveragesNodesThatAreDenserThanPixels) {
  std::vector<double> stripes(1000);
  for (std::size_t i = 0; i < stripes.size(); ++i) stripes[i] = i % 2 == 0 ? 0 : 1;
  const auto field = field_of(1000, 1, stripes);
  const ColorScale scale = ColorScale::choose(0, 1);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 10, 1);
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(raster.at(i, 0).red, scale.color(0.5).red, 2) << i;
    EXPECT_NEAR(raster.at(i, 0).green, scale.color(0.5).green, 2) << i;
  }
}

TEST(Rasterize, JoinsTheGlobeAtItsSeam) {
  interp::Field field{{{90, 0, 4, 45}, {90, 0, 1, 0}}, {0, 5, 5, 10}};
  const ColorScale scale = ColorScale::choose(0, 10);
  const MapFrame frame = globe_frame(field.grid);
  ASSERT_TRUE(frame.is_closed);
  const Raster raster = rasterize(field, frame, scale, 361, 1);
  // Half-way between the last node (315) and the first (45) lies the middle of the seam.
  EXPECT_EQ(raster.at(0, 0), scale.color(5 - 10.0 * 0.5 * 360 / 361 / 90));
  EXPECT_EQ(raster.at(360, 0), scale.color(5 + 10.0 * 0.5 * 360 / 361 / 90));
}

TEST(Rasterize, DoesNotOverflowNearTheLargestDouble) {
  constexpr double largest = std::numeric_limits<double>::max();
  const auto field = field_of(2, 2, {largest, largest, largest, largest});
  const ColorScale scale = ColorScale::choose(largest, largest);
  const Raster raster = rasterize(field, plane_frame(field.grid), scale, 7, 7);
  for (const Color color : raster.pixels) EXPECT_EQ(color, scale.color(largest));
}

TEST(WithDots, MarksPlacesInsideOnly) {
  const Color ink{1, 2, 3};
  const Raster plain{4, 4, std::vector<Color>(16)};
  const Raster raster = with_dots(
      plain, {{0.1, 0.9, 1.5, missing, -1e300}, {0.1, 0.9, 0.5, 0.5, 0.5}, 1, ink});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const bool is_marked = (column == 0 && row == 3) || (column == 3 && row == 0);
      EXPECT_EQ(raster.at(column, row), is_marked ? ink : Color{})
          << column << ' ' << row;
    }
}

TEST(WithDots, CutsDotsAtTheSides) {
  const Color ink{1, 2, 3};
  const Raster raster =
      with_dots({2, 2, std::vector<Color>(4)}, {{0, 0.99}, {1, 0.01}, 3, ink});
  EXPECT_EQ(raster.at(0, 0), ink);
  EXPECT_EQ(raster.at(1, 1), ink);
}

}  // namespace
}  // namespace delone::io
