// Which columns of a table are taken.

#include <gtest/gtest.h>

#include <string>

#include "io/table.hpp"
#include "io/table_samples.hpp"

namespace delone::io {
namespace {

using test::columns;
using test::complaint;
using test::Doubles;
using test::expect_two_rows;
using test::positions_only;
using test::read;

TEST(ReadTable, FindsColumnsByTheirUsualNames) {
  const PointTable table =
      read("id,when,Latitude,depth,LONGITUDE\n7,monday,2,3,1.5\n8,friday,0.5,6,-4\n");
  EXPECT_EQ(table.x, (Doubles{1.5, -4}));
  EXPECT_EQ(table.y, (Doubles{2, 0.5}));
  EXPECT_EQ(table.value_name, "id");
  EXPECT_TRUE(table.is_lonlat);
}

TEST(ReadTable, FindsColumnsWhoseNamesHaveUnits) {
  EXPECT_EQ(read("x_m,y_m,z\n1,2,3\n").x_name, "x_m");
  EXPECT_FALSE(read("x_m,y_m,z\n1,2,3\n").is_lonlat);
  EXPECT_TRUE(read("Lon (deg),Lat [degrees],z\n1,2,3\n").is_lonlat);
  EXPECT_TRUE(read("lon_deg;lat_deg;z\n1;2;3\n").is_lonlat);
}

TEST(ReadTable, PrefersLongitudeAndLatitudeToXAndY) {
  EXPECT_EQ(read("x,y,lon,lat\n1,2,3,4\n").x, Doubles{3});
}

TEST(ReadTable, TakesTheFirstOtherColumnOfNumbersAsValue) {
  EXPECT_EQ(read("lon,lat,name,temp\n1,2,Oslo,3\n").value_name, "temp");
  // A column whose first fields are empty shows what it is further down.
  EXPECT_EQ(read("lon,lat,name,temp\n1,2,,3\n1,2,Oslo,3\n").value_name, "temp");
  EXPECT_EQ(read("lon,lat,sst\n1,2,\n1,2,3\n").value_name, "sst");
}

TEST(ReadTable, TakesColumnsByNumberOrName) {
  const std::string content = "a,b,c,d\n1,2,3,4\n";
  const PointTable by_number = read(content, columns("4", "1", "2"));
  EXPECT_EQ(by_number.x, Doubles{4});
  EXPECT_EQ(by_number.y, Doubles{1});
  EXPECT_EQ(by_number.value, Doubles{2});
  const PointTable by_name = read(content, columns("d", "A", "b"));
  EXPECT_EQ(by_name.x, Doubles{4});
  EXPECT_EQ(by_name.y, Doubles{1});
  EXPECT_EQ(by_name.value_name, "b");
}

TEST(ReadTable, TakesANameThatLooksLikeANumberBeyondTheColumns) {
  EXPECT_EQ(read("lon,lat,2016\n1,2,3\n", columns("", "", "2016")).value, Doubles{3});
}

TEST(ReadTable, AllowsACoordinateAsValue) {
  const PointTable table = read("lon,lat\n1,2\n", columns("", "", "lat"));
  EXPECT_EQ(table.value, Doubles{2});
}

TEST(ReadTable, CompletesOneChosenCoordinate) {
  EXPECT_EQ(read("lon,lat,x,y\n1,2,3,4\n", columns("x", "")).y, Doubles{4});
  EXPECT_EQ(read("far,lat,z\n1,2,3\n", columns("far", "")).y, Doubles{2});
}

TEST(ReadTable, KeepsTheFirstRowOfATableWithDatesAndNoHeader) {
  const PointTable table =
      read("2016-01-01,1.5,2,3\n2016-01-02,-4,0.5,6\n", columns("2", "3", "4"));
  expect_two_rows(table);
}

TEST(ReadTable, KnowsAHeaderAlsoWhenColumnsAreGivenByNumber) {
  expect_two_rows(read("a,b,c\n1.5,2,3\n-4,0.5,6\n", columns("1", "2", "3")));
}

TEST(ReadTable, SaysWhichColumnsThereAre) {
  EXPECT_EQ(complaint("lon,lat,temp\n1,2,3\n", columns("", "", "salt")),
            "obs.csv: no column 'salt'; the columns are lon, lat, temp");
  EXPECT_EQ(complaint("lon,lat,temp\n1,2,3\n", columns("", "", "4")),
            "obs.csv: no column '4'; the columns are lon, lat, temp");
  EXPECT_EQ(complaint("1,2,3\n", columns("0", "")),
            "obs.csv: no column '0'; the table has 3 columns and no header");
}

TEST(ReadTable, RefusesAHeaderWithoutCoordinates) {
  EXPECT_EQ(
      complaint("a,b,c\n1,2,3\n"),
      "obs.csv: no columns called lon and lat, or x and y; choose with --x and --y: "
      "the columns are a, b, c");
}

TEST(ReadTable, RefusesATableWithoutValues) {
  EXPECT_EQ(complaint("lon,lat,name\n1,2,Oslo\n"),
            "obs.csv: no column of numbers besides lon and lat to take values from; the "
            "columns are "
            "lon, lat, name");
  EXPECT_NE(complaint("1,2\n3,4\n").find("no column of numbers besides"),
            std::string::npos);
}

TEST(ReadTable, RefusesOneColumn) {
  EXPECT_NE(complaint("1\n2\n3\n").find("one column only"), std::string::npos);
}

TEST(ReadTable, RefusesTheSameColumnTwice) {
  EXPECT_EQ(complaint("1,2,3\n", columns("2", "2")),
            "obs.csv: x and y are both column 2; choose two columns");
}

TEST(ReadTable, RefusesANameThatSeveralColumnsHave) {
  EXPECT_NE(
      complaint("lon,lat,t,t\n1,2,3,4\n", columns("", "", "t")).find("several columns"),
      std::string::npos);
  EXPECT_EQ(read("lon,lat,t,T\n1,2,3,4\n", columns("", "", "T")).value, Doubles{4});
}

TEST(ReadTable, ReadsPositionsWithoutValues) {
  const PointTable table = read("lon,lat\n1,2\n3,4\n", positions_only());
  EXPECT_EQ(table.x, (Doubles{1, 3}));
  EXPECT_TRUE(table.value.empty());
  EXPECT_EQ(table.value_name, "");
}

TEST(ReadTable, DropsNothingForValuesThatNobodyAskedFor) {
  const PointTable table = read("lon,lat,t\n1,2,\n3,4,nan\n5,6,abc\n", positions_only());
  EXPECT_EQ(table.x.size(), 3u);
  EXPECT_EQ(table.num_missing, 0);
}

TEST(ReadTable, ReadsANamedValueThatIsNotNeeded) {
  TableOptions options = positions_only();
  options.value = "t";
  EXPECT_EQ(read("lon,lat,t\n1,2,7\n", options).value, Doubles{7});
}

TEST(ReadTable, GuessesUnits) {
  const auto units_of = [](const std::string& name) {
    return read("x,y," + name + "\n1,2,3\n").value_units;
  };
  EXPECT_EQ(units_of("geoid_m"), "m");
  EXPECT_EQ(units_of("depth_km"), "km");
  EXPECT_EQ(units_of("gravity_mgal"), "mGal");
  EXPECT_EQ(units_of("wind_speed_m_s"), "m s-1");
  EXPECT_EQ(units_of("heat_flow_mw_m2"), "mW m-2");
  EXPECT_EQ(units_of("TEMP_C"), "degC");
  EXPECT_EQ(units_of("up_mm_yr"), "mm year-1");
  EXPECT_EQ(units_of("pressure [hPa]"), "hPa");
  EXPECT_EQ(units_of("speed (m/s)"), "m/s");
  EXPECT_EQ(units_of("m"), "");
  EXPECT_EQ(units_of("temperature"), "");
}

}  // namespace
}  // namespace delone::io
