#include "io/map.hpp"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include "io/map_raster.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr Color ink{38, 38, 38};

constexpr PictureFormat all_formats[] = {PictureFormat::png, PictureFormat::svg,
                                         PictureFormat::pdf, PictureFormat::eps};

/// A PNG as its reader sees it.
Raster decode(const std::string& png) {
  struct Source {
    const std::string& bytes;
    std::size_t position = 0;
  } source{png};
  const auto read = [](void* closure, unsigned char* data, unsigned int length) {
    auto& from = *static_cast<Source*>(closure);
    if (from.position + length > from.bytes.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, from.bytes.data() + from.position, length);
    from.position += length;
    return CAIRO_STATUS_SUCCESS;
  };
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_from_png_stream(read, &source), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return {};
  Raster raster{cairo_image_surface_get_width(surface.get()),
                cairo_image_surface_get_height(surface.get()),
                {}};
  const auto stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < raster.height; ++row)
    for (int column = 0; column < raster.width; ++column) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel,
                  cairo_image_surface_get_data(surface.get()) + row * stride + 4 * column,
                  4);
      raster.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16),
                               static_cast<std::uint8_t>(pixel >> 8),
                               static_cast<std::uint8_t>(pixel)});
    }
  return raster;
}

/// The part of a picture inside the frame around its middle.
struct Plot {
  Raster picture;
  int left = 0, top = 0, width = 0, height = 0;
  /// At fractions of the plot from the left and from the bottom.
  [[nodiscard]] Color at(double right, double up) const {
    return picture.at(left + static_cast<int>(right * width),
                      top + static_cast<int>((1 - up) * height));
  }
};

/// `row` must cross the plot away from what is drawn in ink.
Plot find_plot(Raster picture, int column, int row) {
  Plot plot{std::move(picture)};
  const auto is_ink = [&plot](int x, int y) { return plot.picture.at(x, y) == ink; };
  int right = column, bottom = row;
  plot.left = column;
  plot.top = row;
  while (!is_ink(plot.left - 1, row)) --plot.left;
  while (!is_ink(right, row)) ++right;
  while (!is_ink(column, plot.top - 1)) --plot.top;
  while (!is_ink(column, bottom)) ++bottom;
  plot.width = right - plot.left;
  plot.height = bottom - plot.top;
  return plot;
}

GridFile plane_grid(std::int64_t columns, std::int64_t rows, std::vector<double> values) {
  GridFile grid;
  grid.field = {{{1, 0, columns, 0}, {1, 0, rows, 0}}, std::move(values)};
  grid.info.name = "height_m";
  grid.info.units = "m";
  return grid;
}

GridFile globe_grid(interp::Axis lon, interp::Axis lat) {
  GridFile grid;
  grid.field.grid = {lon, lat};
  for (std::int64_t j = 0; j < lat.size; ++j)
    for (std::int64_t i = 0; i < lon.size; ++i)
      grid.field.values.push_back(lon.coordinate(i) + lat.coordinate(j));
  grid.info.is_lonlat = true;
  return grid;
}

Raster render_png(const GridFile& grid, const MapOptions& options = {}) {
  return decode(render_map(grid, options, PictureFormat::png));
}

std::string temporary_file(const std::string& name) {
  return (std::filesystem::temp_directory_path() / ("delone_map_test_" + name)).string();
}

TEST(RenderMap, IsAsWideAsAsked) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  for (const int width : {200, 333, 1200, 2000}) {
    MapOptions options;
    options.width_px = width;
    EXPECT_EQ(render_png(grid, options).width, width);
  }
}

TEST(RenderMap, ShowsKnownNodesInTheirColors) {
  const auto grid = plane_grid(4, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  Raster picture = render_png(grid);
  const int column = picture.width / 3, row = picture.height / 3;
  const Plot plot = find_plot(std::move(picture), column, row);
  EXPECT_NEAR(plot.width / 4.0, plot.height / 3.0, 1) << "true to scale";
  const ColorScale scale = ColorScale::choose(0, 11);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) {
      const Color seen = plot.at((i + 0.5) / 4, (j + 0.5) / 3);
      const Color expected = scale.color(4 * j + i);
      EXPECT_NEAR(seen.red, expected.red, 4) << i << ' ' << j;
      EXPECT_NEAR(seen.green, expected.green, 4) << i << ' ' << j;
      EXPECT_NEAR(seen.blue, expected.blue, 4) << i << ' ' << j;
    }
}

TEST(RenderMap, LeavesMissingNodesBlankAndNothingElse) {
  const auto grid = plane_grid(2, 2, {1, missing, 2, 3});
  Raster picture = render_png(grid);
  const int column = picture.width / 4, row = picture.height / 4;
  const Plot plot = find_plot(std::move(picture), column, row);
  int num_blank = 0;
  for (int y = 0; y < plot.height; ++y)
    for (int x = 0; x < plot.width; ++x)
      num_blank += plot.picture.at(plot.left + x, plot.top + y) == blank_color ? 1 : 0;
  EXPECT_EQ(plot.at(0.75, 0.25), blank_color);
  EXPECT_NEAR(num_blank, plot.width * plot.height / 4.0, plot.width + plot.height);
}

TEST(RenderMap, DrawsObservationsWhereTheyAre) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  Raster plain = render_png(grid);
  const int column = plain.width / 4, row = plain.height / 3;
  const Plot plot = find_plot(std::move(plain), column, row);
  const std::vector<double> x{1}, y{0.25};
  Raster dotted = render_png(grid, {.draw_points = true, .point_x = x, .point_y = y});
  const Plot with_point{std::move(dotted), plot.left, plot.top, plot.width, plot.height};
  EXPECT_EQ(with_point.at(0.75, 0.375), ink);
  EXPECT_NE(plot.at(0.75, 0.375), ink);
}

TEST(RenderMap, DrawsAnyNumberOfObservations) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  const std::vector<double> x(50000, 1.0), y(50000, 0.25);
  const MapOptions options{.draw_points = true, .point_x = x, .point_y = y};
  Raster plain = render_png(grid);
  const int column = plain.width / 4, row = plain.height / 3;
  const Plot plot = find_plot(std::move(plain), column, row);
  const Plot dotted{render_png(grid, options), plot.left, plot.top, plot.width,
                    plot.height};
  EXPECT_EQ(dotted.at(0.75, 0.375), ink);
  EXPECT_LT(render_map(grid, options, PictureFormat::pdf).size(), 1000000u);
}

TEST(RenderMap, TakesObservationsInAnyWrapAndIgnoresNaN) {
  const auto grid = globe_grid({1, 160, 41, 0}, {1, -20, 21, 0});
  const std::vector<double> east{170.0, 185.0, missing}, west{-190.0, -175.0, missing};
  const std::vector<double> lat{-10.0, -15.0, -5.0};
  const auto draw = [&](const std::vector<double>& lon) {
    return render_map(grid, {.draw_points = true, .point_x = lon, .point_y = lat},
                      PictureFormat::png);
  };
  EXPECT_EQ(draw(east), draw(west));
  EXPECT_NE(draw(east), render_map(grid, {}, PictureFormat::png));
}

TEST(RenderMap, DrawsTheCoastOnGeographicDataOnly) {
  // A box around New Zealand without round degrees, so that no graticule passes.
  auto grid = globe_grid({0.25, 664, 49, 0}, {0.25, -192, 57, 0});
  std::fill(grid.field.values.begin(), grid.field.values.end(), 1.0);
  const auto dark = [](const Raster& picture) {
    return std::count_if(picture.pixels.begin(), picture.pixels.end(), [](Color c) {
      return c.red < 90 && c.green < 90 && c.blue < 90;
    });
  };
  const auto with_coast = dark(render_png(grid));
  grid.info.is_lonlat = false;
  EXPECT_GT(with_coast, dark(render_png(grid)) + 500);
}

TEST(RenderMap, SaysTheSameTwice) {
  const auto grid = globe_grid({10, -18, 36, 0}, {10, -9, 19, 0});
  for (const PictureFormat format : all_formats)
    EXPECT_EQ(render_map(grid, {}, format), render_map(grid, {}, format));
}

TEST(RenderMap, BearsNoDate) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  for (const PictureFormat format : all_formats) {
    const std::string bytes = render_map(grid, {}, format);
    EXPECT_EQ(bytes.find("CreationDate"), std::string::npos);
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
  }
}

TEST(RenderMap, IsOfTheKindAskedFor) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  EXPECT_TRUE(render_map(grid, {}, PictureFormat::png).starts_with("\x89PNG"));
  EXPECT_TRUE(render_map(grid, {}, PictureFormat::pdf).starts_with("%PDF"));
  EXPECT_TRUE(
      render_map(grid, {}, PictureFormat::eps).starts_with("%!PS-Adobe-3.0 EPSF"));
  const std::string svg = render_map(grid, {}, PictureFormat::svg);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("width=\"900pt\""), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST(RenderMap, DrawsAwkwardFields) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<const char*, std::vector<double>>> cases{
      {"all missing", {missing, missing, missing, missing}},
      {"constant", {5, 5, 5, 5}},
      {"zero", {0, 0, 0, 0}},
      {"huge", {1e300, -1e300, 0, 1}},
      {"the largest", {largest, -largest, largest, -largest}},
      {"denormal", {tiny, 0, tiny, 2 * tiny}},
      {"next to each other", {1, std::nextafter(1.0, 2.0), 1, 1}},
      {"infinite", {infinite, -infinite, 1, 2}}};
  for (const auto& [name, values] : cases)
    for (const auto& [columns, rows] : {std::pair{2, 2}, {4, 1}, {1, 4}})
      for (const PictureFormat format : all_formats) {
        const auto grid = plane_grid(columns, rows, values);
        EXPECT_FALSE(render_map(grid, {.width_px = 200}, format).empty()) << name;
      }
  EXPECT_EQ(render_png(plane_grid(1, 1, {3})).width, 1200);
}

TEST(RenderMap, SaysThatThereAreNoValues) {
  const auto empty = render_png(plane_grid(2, 2, std::vector<double>(4, missing)));
  const auto color_count = [&](Color color) {
    return std::count(empty.pixels.begin(), empty.pixels.end(), color);
  };
  EXPECT_GT(color_count(blank_color), empty.width * empty.height / 4);
  EXPECT_EQ(color_count(sequential_colormap().back()), 0) << "no colour bar";
}

TEST(RenderMap, TitlesAColumnWithItsUnitInBrackets) {
  auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  grid.info.name = grid.info.long_name = "geoid_m";
  grid.info.units = "m";
  EXPECT_EQ(render_map(grid, {}, PictureFormat::svg),
            render_map(grid, {.title = "geoid (m)"}, PictureFormat::svg));
  grid.info.long_name = "height of the geoid";
  EXPECT_EQ(render_map(grid, {}, PictureFormat::svg),
            render_map(grid, {.title = "height of the geoid"}, PictureFormat::svg));
}

TEST(RenderMap, DrawsAnyText) {
  auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  grid.info.units = "H\xf6he";
  grid.info.x_name = std::string(5000, 'x');
  grid.info.long_name = "line\nbreak";
  for (const std::string& title : {std::string("\xff\xfe"), std::string(100000, 'W')})
    EXPECT_EQ(render_png(grid, {.title = title}).width, 1200);
}

TEST(RenderMap, DrawsRegionsAtPolesAndDateLine) {
  for (const auto& [lon, lat] :
       {std::pair{interp::Axis{1, -180, 360, 0}, interp::Axis{1, 60, 31, 0}},
        {{1, 0, 361, 0}, {1, -90, 181, 0}},
        {{1, 170, 30, 0}, {1, -30, 20, 0}},
        {{1, 0, 1, 0}, {1, 90, 1, 0}},
        {{0.001, 10000, 3, 0}, {0.001, 50000, 3, 0}},
        {{1, -720, 360, 0}, {1, -90, 181, 0}}})
    EXPECT_EQ(render_png(globe_grid(lon, lat)).width, 1200) << lon.first_step;
}

TEST(RenderMap, RejectsGridsThatAreNone) {
  const auto fails = [](const GridFile& grid, const MapOptions& options) {
    EXPECT_THROW(static_cast<void>(render_map(grid, options, PictureFormat::png)), Error);
  };
  auto good = plane_grid(2, 2, {1, 2, 3, 4});
  fails(plane_grid(2, 2, {1, 2, 3}), {});
  fails(plane_grid(0, 2, {}), {});
  fails(good, {.width_px = 199});
  fails(good, {.width_px = 10001});
  const std::vector<double> one{1};
  fails(good, {.draw_points = true, .point_x = one});
  for (const double spacing : {0.0, -1.0, missing, 1e308}) {
    auto bad = good;
    bad.field.grid.x.spacing = spacing;
    fails(bad, {});
  }
}

TEST(WriteMap, WritesTheBytesOfRenderMap) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  const std::string path = temporary_file("map.SVG");
  write_map(path, grid);
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  EXPECT_EQ(content.str(), render_map(grid, {}, PictureFormat::svg));
}

TEST(WriteMap, NamesTheFormatsThereAre) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  for (const std::string name : {"map.jpg", "map", "png", "folder.png/map"}) {
    try {
      write_map(temporary_file(name), grid);
      ADD_FAILURE() << name;
    } catch (const WriteError& error) {
      EXPECT_NE(std::string(error.what()).find("png, svg, pdf or eps"),
                std::string::npos);
    }
  }
}

TEST(WriteMap, FailsOnAFullDiskAndInAFolderThatIsNotThere) {
  const auto grid = plane_grid(2, 2, {1, 2, 3, 4});
  for (const char* format : {"png", "svg", "pdf", "eps"}) {
    EXPECT_THROW(write_map("/dev/full", grid, {}, format), WriteError) << format;
    EXPECT_THROW(write_map("/no/such/folder/map.png", grid, {}, format), WriteError)
        << format;
  }
}

}  // namespace
}  // namespace delone::io
