#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "io/grid_file.hpp"
#include "io/grid_samples.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::coordinates;
using test::Doubles;
using test::expect_same_values;
using test::message_of;
using test::NetcdfMaker;
using test::small_grid;
using test::TemporaryFolder;

TEST(WriteGrid, IsReadBackBitForBit) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.info.long_name = "height of the geoid";
  grid.info.title = "a test";
  write_grid(folder.path("a.nc"), grid);
  const GridFile back = read_grid(folder.path("a.nc"));
  expect_same_values(back.field.values, grid.field.values);
  EXPECT_EQ(coordinates(back.field.grid.x), coordinates(grid.field.grid.x));
  EXPECT_EQ(coordinates(back.field.grid.y), coordinates(grid.field.grid.y));
  EXPECT_EQ(back.info.name, "geoid_m");
  EXPECT_EQ(back.info.long_name, "height of the geoid");
  EXPECT_EQ(back.info.units, "m");
  EXPECT_EQ(back.info.title, "a test");
  EXPECT_TRUE(back.info.is_lonlat);
}

TEST(WriteGrid, KeepsThePlanesNamesAndUnits) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.info.is_lonlat = false;
  grid.info.x_name = "x_m";
  grid.info.x_units = "m";
  write_grid(folder.path("a.nc"), grid);
  const GridInfo info = read_grid(folder.path("a.nc")).info;
  EXPECT_FALSE(info.is_lonlat);
  EXPECT_EQ(info.x_name, "x_m");
  EXPECT_EQ(info.x_units, "m");
  EXPECT_EQ(info.y_name, "y");
  EXPECT_EQ(info.y_units, "");
}

TEST(WriteGrid, GivesTheSameBytesForTheSameField) {
  const TemporaryFolder folder;
  write_grid(folder.path("a.nc"), small_grid());
  write_grid(folder.path("b.nc"), small_grid());
  EXPECT_EQ(content_of(folder.path("a.nc")), content_of(folder.path("b.nc")));
}

TEST(WriteGrid, GivesTheBytesThatTheLibraryWouldGive) {
  const TemporaryFolder folder;
  const GridFile grid = small_grid();
  write_grid(folder.path("ours.nc"), grid);
  {
    NetcdfMaker file(folder.path("theirs.nc"), NC_CLOBBER | NC_64BIT_OFFSET);
    const int y = file.dimension("lat", 2), x = file.dimension("lon", 3);
    const int lat = file.variable("lat", {y});
    file.text(lat, "standard_name", "latitude");
    file.text(lat, "long_name", "latitude");
    file.text(lat, "units", "degrees_north");
    file.text(lat, "axis", "Y");
    const int lon = file.variable("lon", {x});
    file.text(lon, "standard_name", "longitude");
    file.text(lon, "long_name", "longitude");
    file.text(lon, "units", "degrees_east");
    file.text(lon, "axis", "X");
    const int data = file.variable("geoid_m", {y, x});
    file.text(data, "long_name", "geoid_m");
    file.text(data, "units", "m");
    file.number(data, "_FillValue", NC_FILL_DOUBLE);
    file.text(NC_GLOBAL, "Conventions", "CF-1.8");
    file.put(lat, coordinates(grid.field.grid.y));
    file.put(lon, coordinates(grid.field.grid.x));
    Doubles values = grid.field.values;
    for (double& value : values)
      if (std::isnan(value)) value = NC_FILL_DOUBLE;
    file.put(data, values);
  }
  EXPECT_EQ(content_of(folder.path("ours.nc")), content_of(folder.path("theirs.nc")));
}

TEST(WriteGrid, MakesNamesValid) {
  EXPECT_EQ(valid_variable_name("geoid_m"), "geoid_m");
  EXPECT_EQ(valid_variable_name("temp (deg C)"), "temp_deg_C");
  EXPECT_EQ(valid_variable_name("2t"), "v_2t");
  EXPECT_EQ(valid_variable_name("a/b\xC3\xA9"), "a_b");
  EXPECT_EQ(valid_variable_name(" \xC3\xA9 "), "value");
  EXPECT_EQ(valid_variable_name(""), "value");
  EXPECT_EQ(valid_variable_name(std::string(1000, 'n')).size(), 128u);
}

TEST(WriteGrid, KeepsTheOriginalNameAsLongName) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.info.name = "temp (deg C)";
  write_grid(folder.path("a.nc"), grid);
  const GridInfo info = read_grid(folder.path("a.nc")).info;
  EXPECT_EQ(info.name, "temp_deg_C");
  EXPECT_EQ(info.long_name, "temp (deg C)");
}

TEST(WriteGrid, RenamesAVariableCalledLikeACoordinate) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.info.name = "lat";
  write_grid(folder.path("a.nc"), grid);
  EXPECT_EQ(read_grid(folder.path("a.nc")).info.name, "lat_value");
}

TEST(WriteGrid, WritesRowsOfText) {
  const TemporaryFolder folder;
  write_grid(folder.path("a.csv"), small_grid());
  EXPECT_EQ(content_of(folder.path("a.csv")),
            "lon,lat,geoid_m\n10,-1,1\n10.5,-1,2.5\n11,-1,-3\n10,0,0.1\n10.5,0,\n11,0,"
            "10000000000\n");
}

TEST(WriteGrid, QuotesANameWithACommaInTheHeaderOfText) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.info.name = "a, \"b\"";
  grid.info.is_lonlat = false;
  write_grid(folder.path("a.csv"), grid);
  EXPECT_TRUE(content_of(folder.path("a.csv")).starts_with("x,y,\"a, \"\"b\"\"\"\n"));
  EXPECT_EQ(read_table(folder.path("a.csv")).value_name, "a, \"b\"");
}

TEST(WriteGrid, WritesAnEsriGridFromTheNorth) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.field.grid.y.spacing = 0.5;
  write_grid(folder.path("a.asc"), grid);
  EXPECT_EQ(
      content_of(folder.path("a.asc")),
      "ncols 3\nnrows 2\nxllcenter 10\nyllcenter -0.5\ncellsize 0.5\nNODATA_value -9999\n"
      "0.1 -9999 10000000000\n1 2.5 -3\n");
}

TEST(WriteGrid, TakesAnotherNoDataValueWhereThatIsAValue) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.field.grid.y.spacing = 0.5;
  grid.field.values[0] = -9999;
  write_grid(folder.path("a.asc"), grid);
  EXPECT_NE(content_of(folder.path("a.asc"))
                .find("NODATA_value -99999\n0.1 -99999 10000000000\n-9999 "),
            std::string::npos);
}

TEST(WriteGrid, RefusesAnEsriGridOfOblongCells) {
  const TemporaryFolder folder;
  const std::string message =
      message_of<WriteError>([&] { write_grid(folder.path("a.asc"), small_grid()); });
  EXPECT_NE(message.find("needs the same spacing both ways"), std::string::npos)
      << message;
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteGrid, TakesTheFormatFromItsArgumentFirst) {
  const TemporaryFolder folder;
  write_grid(folder.path("a.nc"), small_grid(), "csv");
  EXPECT_TRUE(content_of(folder.path("a.nc")).starts_with("lon,lat"));
}

TEST(WriteGrid, SaysWhichFormatsThereAre) {
  const TemporaryFolder folder;
  for (const char* const name : {"a.xyz", "a.tif", "a"}) {
    const std::string message =
        message_of<WriteError>([&] { write_grid(folder.path(name), small_grid()); });
    EXPECT_NE(message.find("a grid is written as .nc, .csv or .asc"), std::string::npos)
        << message;
  }
}

TEST(WriteGrid, ReportsAFullDiskInEveryFormat) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  GridFile grid = small_grid();
  grid.field.grid.y.spacing = 0.5;
  for (const char* const format : {"nc", "csv", "asc"}) {
    const std::string message =
        message_of<WriteError>([&] { write_grid("/dev/full", grid, format); });
    EXPECT_EQ(message, "/dev/full: cannot be written: No space left on device") << format;
  }
}

TEST(WriteGrid, RefusesAFieldOfTheWrongSize) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.field.values.pop_back();
  EXPECT_THROW(write_grid(folder.path("a.nc"), grid), Error);
  EXPECT_THROW(write_grid(folder.path("a.nc"), GridFile{}), Error);
}

TEST(WriteGrid, MakesInfiniteValuesMissing) {
  const TemporaryFolder folder;
  GridFile grid = small_grid();
  grid.field.values[0] = std::numeric_limits<double>::infinity();
  write_grid(folder.path("a.nc"), grid);
  EXPECT_TRUE(std::isnan(read_grid(folder.path("a.nc")).field.values[0]));
}

}  // namespace
}  // namespace delone::io
