#include <gtest/gtest.h>

#include <filesystem>
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
using test::nan;
using test::NetcdfMaker;
using test::small_grid;
using test::TemporaryFolder;

/// data(y, x) with the given coordinates and values.
std::string make_plain(const TemporaryFolder& folder, const Doubles& y_values,
                       const Doubles& x_values, const Doubles& values,
                       int mode = NC_CLOBBER, nc_type type = NC_DOUBLE) {
  const std::string path = folder.path("in.nc");
  NetcdfMaker file(path, mode);
  const int y = file.dimension("y", y_values.size()),
            x = file.dimension("x", x_values.size());
  const int y_variable = file.variable("y", {y}, type),
            x_variable = file.variable("x", {x}, type);
  const int data = file.variable("data", {y, x});
  file.put(y_variable, y_values);
  file.put(x_variable, x_values);
  file.put(data, values);
  return path;
}

std::string complaint(const std::string& path, const std::string& variable = "") {
  return message_of<ReadError>([&] { return read_grid(path, variable); });
}

TEST(ReadGrid, TurnsDescendingCoordinatesRound) {
  const TemporaryFolder folder;
  const GridFile grid =
      read_grid(make_plain(folder, {1, 0}, {5, 4, 3}, {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(coordinates(grid.field.grid.y), (Doubles{0, 1}));
  EXPECT_EQ(coordinates(grid.field.grid.x), (Doubles{3, 4, 5}));
  EXPECT_EQ(grid.field.values, (Doubles{6, 5, 4, 3, 2, 1}));
}

TEST(ReadGrid, ReadsNetcdf4) {
  const TemporaryFolder folder;
  const GridFile grid =
      read_grid(make_plain(folder, {0, 1}, {3, 4, 5}, {1, 2, 3, 4, 5, 6}, NC_NETCDF4));
  EXPECT_EQ(grid.field.values, (Doubles{1, 2, 3, 4, 5, 6}));
}

TEST(ReadGrid, ExchangesDimensionsInTheOrderXThenY) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int x = file.dimension("x", 3), y = file.dimension("y", 2);
    const int x_variable = file.variable("x", {x}), y_variable = file.variable("y", {y});
    const int data = file.variable("data", {x, y});
    file.put(x_variable, {0, 1, 2});
    file.put(y_variable, {0, 1});
    file.put(data, {1, 4, 2, 5, 3, 6});
  }
  const GridFile grid = read_grid(folder.path("in.nc"));
  EXPECT_EQ(grid.field.grid.x.size, 3);
  EXPECT_EQ(grid.field.values, (Doubles{1, 2, 3, 4, 5, 6}));
}

TEST(ReadGrid, ContinuesLongitudesAcrossTheirJump) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int y = file.dimension("lat", 2), x = file.dimension("lon", 4);
    const int lat = file.variable("lat", {y}), lon = file.variable("lon", {x});
    const int data = file.variable("data", {y, x});
    file.put(lat, {0, 1});
    file.put(lon, {178, 179, -180, -179});
    file.put(data, {1, 2, 3, 4, 5, 6, 7, 8});
  }
  const GridFile grid = read_grid(folder.path("in.nc"));
  EXPECT_EQ(coordinates(grid.field.grid.x), (Doubles{178, 179, 180, 181}));
  EXPECT_TRUE(grid.info.is_lonlat);
}

TEST(ReadGrid, MakesFillValuesMissingAndUnpacks) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int time = file.dimension("time", 1), y = file.dimension("y", 2),
              x = file.dimension("x", 2);
    const int y_variable = file.variable("y", {y}), x_variable = file.variable("x", {x});
    const int data = file.variable("data", {time, y, x}, NC_SHORT);
    file.number(data, "_FillValue", -1, NC_SHORT);
    file.number(data, "missing_value", -2, NC_SHORT);
    file.number(data, "scale_factor", 0.5);
    file.number(data, "add_offset", 100);
    file.put(y_variable, {0, 1});
    file.put(x_variable, {0, 1});
    file.put(data, {-1, -2, 0, 7});
  }
  expect_same_values(read_grid(folder.path("in.nc")).field.values,
                     {nan, nan, 100, 103.5});
}

TEST(ReadGrid, MatchesFillValuesInTheVariablesOwnType) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int y = file.dimension("y", 1), x = file.dimension("x", 3);
    const int y_variable = file.variable("y", {y}), x_variable = file.variable("x", {x});
    const int data = file.variable("data", {y, x}, NC_FLOAT);
    file.number(data, "missing_value", -1e34, NC_DOUBLE);  // not a float
    file.put(y_variable, {0});
    file.put(x_variable, {0, 1, 2});
    file.put(data, {-1e34, static_cast<double>(NC_FILL_FLOAT), 0.25});
  }
  expect_same_values(read_grid(folder.path("in.nc")).field.values, {nan, nan, 0.25});
}

TEST(ReadGrid, TakesFloatCoordinatesForTheDecimalsTheyStandFor) {
  const TemporaryFolder folder;
  const GridFile grid =
      read_grid(make_plain(folder, {0.1, 0.2, 0.3}, {359.7, 359.8, 359.9}, Doubles(9, 1),
                           NC_CLOBBER, NC_FLOAT));
  EXPECT_EQ(coordinates(grid.field.grid.y), (Doubles{0.1, 0.2, 0.3}));
  EXPECT_EQ(coordinates(grid.field.grid.x), (Doubles{359.7, 359.8, 359.9}));
}

TEST(ReadGrid, RefusesUnequalSpacing) {
  const TemporaryFolder folder;
  const std::string message =
      complaint(make_plain(folder, {0, 1, 2.01}, {0, 1}, Doubles(6, 0)));
  EXPECT_NE(message.find("coordinates 'y' are not equally spaced"), std::string::npos)
      << message;
  EXPECT_THROW(
      static_cast<void>(read_grid(make_plain(folder, {0, 1, 0}, {0, 1}, Doubles(6, 0)))),
      ReadError);
  EXPECT_THROW(static_cast<void>(
                   read_grid(make_plain(folder, {0, nan, 2}, {0, 1}, Doubles(6, 0)))),
               ReadError);
}

TEST(ReadGrid, ChoosesAVariableByName) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int y = file.dimension("y", 1), x = file.dimension("x", 2),
              layers = file.dimension("layer", 2);
    const int y_variable = file.variable("y", {y}), x_variable = file.variable("x", {x});
    const int first = file.variable("first", {y, x}),
              second = file.variable("second", {y, x});
    const int deep = file.variable("deep", {layers, y, x});
    const int label = file.variable("label", {y, x}, NC_CHAR);
    const int bare = file.variable("bare", {layers, x});
    static_cast<void>(label);
    file.put(y_variable, {0});
    file.put(x_variable, {0, 1});
    file.put(first, {1, 2});
    file.put(second, {3, 4});
    file.put(deep, {1, 2, 3, 4});
    file.put(bare, {1, 2, 3, 4});
  }
  const std::string path = folder.path("in.nc");
  EXPECT_EQ(read_grid(path).info.name, "first");
  EXPECT_EQ(read_grid(path, "second").field.values, (Doubles{3, 4}));
  EXPECT_NE(complaint(path, "third").find("no variable 'third'"), std::string::npos);
  EXPECT_NE(complaint(path, "deep").find("'deep' has 2 layers along 'layer'"),
            std::string::npos);
  EXPECT_NE(complaint(path, "label").find("'label' holds no numbers"), std::string::npos);
  EXPECT_NE(
      complaint(path, "bare").find("no coordinate variable for its dimension 'layer'"),
      std::string::npos);
  EXPECT_NE(complaint(path, "x").find("fewer than two dimensions"), std::string::npos);
}

TEST(ReadGrid, SaysWhyNothingInTheFileIsAGrid) {
  const TemporaryFolder folder;
  {
    NetcdfMaker file(folder.path("in.nc"));
    const int y = file.dimension("y", 1), x = file.dimension("x", 2);
    file.put(file.variable("data", {y, x}), {1, 2});
  }
  EXPECT_NE(complaint(folder.path("in.nc"))
                .find("'data' has no coordinate variable for its dimension 'y'"),
            std::string::npos);
}

TEST(ReadGrid, RefusesFilesThatAreNotNetcdf) {
  const TemporaryFolder folder;
  EXPECT_NE(complaint(folder.put("a.nc", "lon,lat,value\n1,2,3\n"))
                .find("cannot be read as NetCDF"),
            std::string::npos);
  EXPECT_NE(complaint(folder.put("b.nc", "")).find("cannot be read"), std::string::npos);
  EXPECT_NE(complaint(folder.path("missing.nc")).find("No such file or directory"),
            std::string::npos);
  EXPECT_NE(complaint(folder.path("")).find("it is a folder"), std::string::npos);
  EXPECT_NE(complaint("/dev/null").find("NetCDF needs a file"), std::string::npos);
}

TEST(ReadGrid, RefusesAFileCutAtAnyByte) {
  const TemporaryFolder folder;
  write_grid(folder.path("whole.nc"), small_grid());
  const std::string whole = content_of(folder.path("whole.nc"));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(
        static_cast<void>(read_grid(folder.put("cut.nc", whole.substr(0, size)))),
        ReadError)
        << size;
  EXPECT_NO_THROW(static_cast<void>(read_grid(folder.put("cut.nc", whole))));
}

TEST(ReadGrid, TakesNoMemoryForSizesThatTheFileCannotHold) {
  const TemporaryFolder folder;
  write_grid(folder.path("a.nc"), small_grid());
  std::string bytes = content_of(folder.path("a.nc"));
  // The length of dimension lat follows its name: 2 becomes 2^31 - 1.
  const std::size_t length = bytes.find("lat") + 4;
  ASSERT_EQ(bytes.substr(length, 4), std::string("\0\0\0\2", 4));
  bytes.replace(length, 4, "\x7F\xFF\xFF\xFF");
  EXPECT_THROW(static_cast<void>(read_grid(folder.put("huge.nc", bytes))), ReadError);
  // A NetCDF-4 file whose values were never written is small whatever its dimensions.
  {
    NetcdfMaker file(folder.path("hollow.nc"), NC_NETCDF4);
    const int y = file.dimension("y", 1), x = file.dimension("x", 2000000000);
    const int y_variable = file.variable("y", {y});
    file.variable("x", {x});
    file.variable("data", {y, x});
    file.put(y_variable, {0});
  }
  EXPECT_NE(complaint(folder.path("hollow.nc")).find("more than the file can hold"),
            std::string::npos);
}

TEST(ReadGrid, ReadsTheGeoid) {
  const std::string path =
      std::string(DELONE_SHARED_DATA_DIR) + "/truth/geoid_egm96_30min.nc";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const GridFile grid = read_grid(path);
  EXPECT_EQ(grid.field.grid.x.size, 720);
  EXPECT_EQ(grid.field.grid.y.size, 361);
  EXPECT_EQ(grid.field.grid.y.coordinate(0), -90);
  EXPECT_EQ(grid.field.grid.y.coordinate(360), 90);
  EXPECT_EQ(grid.info.units, "m");
  EXPECT_TRUE(grid.info.is_lonlat);
  // The north pole's 13.606 m is one of EGM96's published checks.
  EXPECT_NEAR(grid.field.values.back(), 13.606, 0.001);
}

TEST(ReadGrid, ReadsTheReliefOfTheEarth) {
  const std::string path = std::string(DELONE_SHARED_DATA_DIR) + "/truth/etopo60.nc";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const GridFile grid = read_grid(path);
  EXPECT_EQ(grid.field.grid.x.coordinate(0), 20.5);
  EXPECT_EQ(grid.field.grid.x.coordinate(359), 379.5);
  EXPECT_EQ(grid.field.grid.y.coordinate(0), -89.5);
  EXPECT_EQ(grid.info.name, "ROSE");
  EXPECT_TRUE(grid.info.is_lonlat);
  // 90.5 E 29.5 N lies in Tibet, 150.5 E 0.5 N in the Pacific.
  EXPECT_GT(grid.field.values[119 * 360 + 70], 3000);
  EXPECT_LT(grid.field.values[90 * 360 + 130], -2000);
}

}  // namespace
}  // namespace delone::io
