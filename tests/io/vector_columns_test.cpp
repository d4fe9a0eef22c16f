// Two columns of values in a table, and several variables on a grid.

#include <gtest/gtest.h>

#include <string>

#include "io/grid_file.hpp"
#include "io/grid_samples.hpp"
#include "io/table.hpp"
#include "io/table_samples.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::Doubles;
using test::expect_same_values;
using test::small_grid;
using test::TemporaryFolder;

TableOptions columns(const std::string& value, const std::string& second_value) {
  TableOptions options;
  options.value = value;
  options.second_value = second_value;
  return options;
}

TEST(SecondValue, IsReadFromAnyColumnByNameOrNumber) {
  for (const auto& [first, second] :
       {std::pair("u", "v_m_s"), std::pair("5", "3"), std::pair("5", "v_m_s")}) {
    const PointTable table = test::read("lon,lat,v_m_s,note,u\n1,2,3,a,5\n6,7,8,b,10\n",
                                        columns(first, second));
    EXPECT_EQ(table.value, (Doubles{5, 10}));
    EXPECT_EQ(table.second_value, (Doubles{3, 8}));
    EXPECT_EQ(table.second_value_name, "v_m_s");
    EXPECT_EQ(table.second_value_units, "m s-1");
  }
}

TEST(SecondValue, MayBeTheSameColumn) {
  const PointTable table = test::read("x,y,u\n1,2,3\n", columns("u", "u"));
  EXPECT_EQ(table.value, table.second_value);
}

TEST(SecondValue, RowsThatLackItAreDropped) {
  const PointTable table =
      test::read("x,y,u,v\n1,2,3,4\n1,3,NA,4\n1,4,3,\n5,6,7,8\n", columns("u", "v"));
  EXPECT_EQ(table.second_value, (Doubles{4, 8}));
  EXPECT_EQ(table.num_missing, 2);
  EXPECT_EQ(table.row_of(1), 3);
}

TEST(SecondValue, ThatIsNoNumberIsAnErrorNamingItsColumn) {
  try {
    static_cast<void>(test::read("x,y,u,v\n1,2,3,fast\n", columns("u", "v")));
    FAIL();
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("column 4 (v): 'fast'"), std::string::npos);
  }
  EXPECT_THROW(static_cast<void>(test::read("x,y,u\n1,2,3\n", columns("u", "v"))),
               ReadError);
}

TEST(SecondValue, IsAbsentUnlessAskedFor) {
  EXPECT_TRUE(test::read("x,y,u,v\n1,2,3,4\n", columns("u", "")).second_value.empty());
}

GridFile with_two_more() {
  GridFile grid = small_grid();
  Doubles values = grid.field.values;
  for (double& v : values) v = -v;
  grid.more = {{"other", "m s-1", values}, {grid.info.name, "", values}};
  return grid;
}

TEST(MoreVariables, AreReadBackFromNetcdfUnderNamesOfTheirOwn) {
  const TemporaryFolder folder;
  const GridFile grid = with_two_more();
  write_grid(folder.path("a.nc"), grid);
  const GridFile other = read_grid(folder.path("a.nc"), "other"),
                 same_name = read_grid(folder.path("a.nc"), grid.info.name + "_2");
  expect_same_values(other.field.values, grid.more[0].values);
  EXPECT_EQ(other.info.units, "m s-1");
  expect_same_values(same_name.field.values, grid.more[1].values);
  expect_same_values(read_grid(folder.path("a.nc")).field.values, grid.field.values);
}

TEST(MoreVariables, AreColumnsOfACsv) {
  const TemporaryFolder folder;
  GridFile grid = with_two_more();
  write_grid(folder.path("a.csv"), grid);
  const PointTable table = read_table(folder.path("a.csv"), columns("3", "4"));
  ASSERT_FALSE(table.value.empty());
  for (std::size_t i = 0; i < table.value.size(); ++i)
    EXPECT_EQ(table.second_value[i], -table.value[i]);
}

TEST(MoreVariables, DoNotFitAnEsriGrid) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_grid(folder.path("a.asc"), with_two_more()), WriteError);
}

TEST(MoreVariables, MustBeOfTheSizeOfTheGrid) {
  const TemporaryFolder folder;
  GridFile grid = with_two_more();
  grid.more[1].values.pop_back();
  EXPECT_THROW(write_grid(folder.path("a.nc"), grid), Error);
}

}  // namespace
}  // namespace delone::io
