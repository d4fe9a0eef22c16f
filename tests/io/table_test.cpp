// What stands in tables, and how.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "io/table.hpp"
#include "io/table_samples.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::Doubles;
using test::expect_two_rows;
using test::Integers;
using test::read;
using test::TemporaryFolder;

TEST(ReadTable, ReadsCommas) {
  const PointTable table = read("lon,lat,temp_c\n1.5,2,3\n-4,5e-1,6\n");
  expect_two_rows(table);
  EXPECT_EQ(table.delimiter, ',');
  EXPECT_EQ(table.x_name, "lon");
  EXPECT_EQ(table.y_name, "lat");
  EXPECT_EQ(table.value_name, "temp_c");
  EXPECT_EQ(table.value_units, "degC");
  EXPECT_TRUE(table.is_lonlat);
}

TEST(ReadTable, ReadsTabsSemicolonsAndBlanks) {
  EXPECT_EQ(read("x\ty\tz\n1.5\t2\t3\n-4\t5e-1\t6\n").delimiter, '\t');
  EXPECT_EQ(read("x;y;z\n1.5;2;3\n-4;5e-1;6\n").delimiter, ';');
  EXPECT_EQ(read("x y z\n1.5 2 3\n-4 5e-1 6\n").delimiter, ' ');
  expect_two_rows(read("x\ty\tz\n1.5\t2\t3\n-4\t5e-1\t6\n"));
  expect_two_rows(read("x;y;z\n1.5;2;3\n-4;5e-1;6\n"));
  expect_two_rows(read("x y z\n1.5 2 3\n-4 5e-1 6\n"));
}

TEST(ReadTable, TakesAnyNumberOfBlanksAndTabsAsOneSeparator) {
  expect_two_rows(read("   1.5   2\t 3  \n  -4 \t 5e-1 6\n"));
  expect_two_rows(read("1.5 2\t3\n-4\t5e-1 6\n"));
}

TEST(ReadTable, AllowsBlanksAroundFields) {
  expect_two_rows(read("x , y , z\n 1.5 , 2 ,3 \n-4, 5e-1,\t6\n"));
}

TEST(ReadTable, NeedsNoHeader) {
  const PointTable table = read("1.5,2,3\n-4,5e-1,6\n");
  expect_two_rows(table);
  EXPECT_EQ(table.x_name, "column 1");
  EXPECT_EQ(table.value_name, "column 3");
  EXPECT_EQ(table.value_units, "");
  EXPECT_FALSE(table.is_lonlat);
  EXPECT_EQ(table.first_line, 1);
}

TEST(ReadTable, NeedsNoFinalNewline) { expect_two_rows(read("1.5,2,3\n-4,5e-1,6")); }

TEST(ReadTable, ReadsCarriageReturnLineFeed) {
  expect_two_rows(read("x,y,z\r\n1.5,2,3\r\n-4,5e-1,6\r\n"));
  EXPECT_EQ(read("x,y,z\r\n1,2,3\r\n").value_name, "z");
}

TEST(ReadTable, ReadsCarriageReturnAlone) {
  expect_two_rows(read("x,y,z\r1.5,2,3\r-4,5e-1,6\r"));
}

TEST(ReadTable, LeavesOutAByteOrderMark) {
  const PointTable table = read("\xEF\xBB\xBFx,y,z\n1.5,2,3\n-4,5e-1,6\n");
  expect_two_rows(table);
  EXPECT_EQ(table.x_name, "x");
  expect_two_rows(
      read("\xEF\xBB\xBF"
           "1.5,2,3\n-4,5e-1,6\n"));
}

TEST(ReadTable, LeavesOutCommentsAndBlankLines) {
  const PointTable table =
      read("# made by hand\n\nx,y,z\n# first\n1.5,2,3\n   \n  # second\n-4,5e-1,6\n#\n");
  expect_two_rows(table);
  EXPECT_EQ(table.first_line, 5);
  EXPECT_EQ(table.line, (Integers{5, 8}));
  EXPECT_TRUE(table.row.empty());
}

TEST(ReadTable, ReadsQuotedFields) {
  const PointTable table = read(
      "\"Station, name\",\"lon\",\"lat\",\"he said \"\"t\"\"\"\n"
      "\"Oslo; \"\"north\"\", N\",\"1.5\",2,\"3\"\nx , -4 ,\"5e-1\" ,6\n");
  expect_two_rows(table);
  EXPECT_EQ(table.value_name, "he said \"t\"");
}

TEST(ReadTable, ReadsQuotedFieldsBetweenBlanks) {
  expect_two_rows(read("\"the name\" lon lat t\n\"New York\" 1.5 2 3\nOslo -4 0.5 6\n"));
}

TEST(ReadTable, AllowsPlusSignsAndBarePoints) {
  const PointTable table = read("+1,.5,5.\n-.25,+1e+2,1E-2\n");
  EXPECT_EQ(table.x, (Doubles{1, -0.25}));
  EXPECT_EQ(table.y, (Doubles{0.5, 100}));
  EXPECT_EQ(table.value, (Doubles{5, 0.01}));
}

TEST(ReadTable, RoundsCorrectly) {
  const PointTable table = read(
      "0.1,9007199254740993,2.2250738585072011e-308\n"
      "123456789.123456789123456789,1e23,5e-324\n");
  EXPECT_EQ(table.x, (Doubles{0.1, 123456789.123456789123456789}));
  EXPECT_EQ(table.y, (Doubles{9007199254740992.0, 1e23}));
  EXPECT_EQ(table.value, (Doubles{2.2250738585072011e-308, 5e-324}));
}

TEST(ReadTable, DoesNotDependOnTheLocale) {
  const std::string old_locale = std::setlocale(LC_ALL, nullptr);
  for (const char* const name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    std::setlocale(LC_ALL, name);
  expect_two_rows(read("1.5,2,3\n-4,0.5,6\n"));
  std::setlocale(LC_ALL, old_locale.c_str());
}

TEST(ReadTable, ReadsTheSameFromAPipeInPieces) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream out(pipe);
    for (const char* const piece : {"x,", "y,z", "\n1.", "5,2,3\n-4,5e", "-1,6"})
      out << piece << std::flush;
  });
  expect_two_rows(read_table(pipe));
  writer.join();
}

TEST(ReadTable, ReadsStandardInput) {
  const TemporaryFolder folder;
  const std::string path = folder.put("stdin", "x,y,z\n1.5,2,3\n-4,5e-1,6\n");
  const int old_input = dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(path.c_str(), "r", stdin), nullptr);
  const PointTable table = read_table("-");
  dup2(old_input, STDIN_FILENO);
  close(old_input);
  expect_two_rows(table);
}

TEST(ReadTable, ReadsTablesOfManyBlocks) {
  std::string content = "x,y,z\n";
  constexpr int num_rows = 100000;
  for (int i = 0; i < num_rows; ++i)
    content += std::to_string(i) + ".25," + std::to_string(-i) + "," +
               std::to_string(i % 7) + "\n";
  const PointTable table = read(content);
  ASSERT_EQ(table.x.size(), static_cast<std::size_t>(num_rows));
  for (std::size_t i = 0; i < table.x.size(); ++i) {
    ASSERT_EQ(table.x[i], static_cast<double>(i) + 0.25);
    ASSERT_EQ(table.y[i], -static_cast<double>(i));
    ASSERT_EQ(table.value[i], static_cast<double>(i % 7));
  }
  EXPECT_TRUE(table.row.empty());
  EXPECT_TRUE(table.line.empty());
}

// Real files

struct RealFile {
  std::string name;
  std::size_t num_kept;
  std::int64_t num_missing;
  std::string value_name, value_units;
  bool is_lonlat;
};

class ReadRealTable : public testing::TestWithParam<RealFile> {};

TEST_P(ReadRealTable, FindsItsColumnsAndRows) {
  const RealFile& file = GetParam();
  const std::string path = std::string(DELONE_SHARED_DATA_DIR) + "/" + file.name;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const PointTable table = read_table(path);
  EXPECT_EQ(table.x.size(), file.num_kept);
  EXPECT_EQ(table.num_missing, file.num_missing);
  EXPECT_EQ(table.value_name, file.value_name);
  EXPECT_EQ(table.value_units, file.value_units);
  EXPECT_EQ(table.is_lonlat, file.is_lonlat);
}

INSTANTIATE_TEST_SUITE_P(
    SharedData, ReadRealTable,
    testing::Values(
        RealFile{"truth/geoid_samples_uniform.csv", 5000, 0, "geoid_m", "m", true},
        RealFile{"sphere/winter_temperature_1981.csv", 690, 0, "temp_c", "degC", true},
        RealFile{"sphere/jason3_wind_speed.csv", 18973, 0, "time_s", "s", true},
        RealFile{"sphere/mars_radius_370.csv", 370, 0, "radius_m", "m", true},
        RealFile{"ocean/coads_sst_january.csv", 16200 - 6694, 6694, "sst_c", "degC",
                 true},
        RealFile{"plane/meuse.csv", 155, 0, "cadmium_ppm", "ppm", false},
        RealFile{"plane/davis_topo.csv", 52, 0, "z_ft", "ft", false}));

}  // namespace
}  // namespace delone::io
