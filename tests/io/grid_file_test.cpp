#include "io/grid_file.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/axis_fit.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using interp::Axis;
using test::content_of;
using test::message_of;
using test::TemporaryFolder;
using Doubles = std::vector<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// 3 x 2 nodes at x 10, 10.5, 11 and y -1, 0; one is missing.
GridFile small_grid() {
  GridFile grid;
  grid.field.grid.x = {.spacing = 0.5, .first_step = 20, .size = 3};
  grid.field.grid.y = {.spacing = 1, .first_step = -1, .size = 2};
  grid.field.values = {1, 2.5, -3, 0.1, nan, 1e10};
  grid.info.name = "geoid_m";
  grid.info.units = "m";
  grid.info.is_lonlat = true;
  return grid;
}

void expect_same_values(const Doubles& a, const Doubles& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]))
      EXPECT_TRUE(std::isnan(b[i])) << i;
    else
      EXPECT_EQ(a[i], b[i]) << i;
  }
}

Doubles coordinates(const Axis& axis) {
  Doubles result;
  for (std::int64_t i = 0; i < axis.size; ++i) result.push_back(axis.coordinate(i));
  return result;
}

/// A NetCDF file made with the library, step by step, as strange as need be.
class NetcdfMaker {
 public:
  explicit NetcdfMaker(const std::string& path, int mode = NC_CLOBBER) {
    ok(nc_create(path.c_str(), mode, &id_));
  }
  ~NetcdfMaker() { EXPECT_EQ(nc_close(id_), NC_NOERR); }
  NetcdfMaker(const NetcdfMaker&) = delete;
  NetcdfMaker& operator=(const NetcdfMaker&) = delete;

  int dimension(const char* name, std::size_t size) {
    int result = 0;
    ok(nc_def_dim(id_, name, size, &result));
    return result;
  }
  int variable(const char* name, const std::vector<int>& dims, nc_type type = NC_DOUBLE) {
    int result = 0;
    ok(nc_def_var(id_, name, type, static_cast<int>(dims.size()), dims.data(), &result));
    return result;
  }
  void text(int variable, const char* name, const std::string& value) {
    ok(nc_put_att_text(id_, variable, name, value.size(), value.data()));
  }
  void number(int variable, const char* name, double value, nc_type type = NC_DOUBLE) {
    ok(nc_put_att_double(id_, variable, name, type, 1, &value));
  }
  /// Fills a variable; the first call ends the definitions.
  void put(int variable, const Doubles& values) {
    if (!is_defined_) ok(nc_enddef(id_));
    is_defined_ = true;
    ok(nc_put_var_double(id_, variable, values.data()));
  }

 private:
  static void ok(int status) { ASSERT_EQ(status, NC_NOERR) << nc_strerror(status); }
  int id_ = 0;
  bool is_defined_ = false;
};

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

// Writing

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

// Reading

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

// The axis through coordinates

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
