#include "io/table.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

PointTable read(std::string_view content, const TableOptions& options = {}) {
  const TemporaryFolder folder;
  return read_table(folder.put("obs.csv", content), options);
}

/// The message for a bad table, the folder's name cut off.
std::string complaint(std::string_view content, const TableOptions& options = {}) {
  const std::string message =
      message_of<ReadError>([&] { return read(content, options); });
  const std::size_t name = message.find("obs.csv");
  return name == std::string::npos ? message : message.substr(name);
}

TableOptions columns(const std::string& x, const std::string& y,
                     const std::string& value = "") {
  TableOptions options;
  options.x = x;
  options.y = y;
  options.value = value;
  return options;
}

TableOptions skipping() {
  TableOptions options;
  options.skip_bad_rows = true;
  return options;
}

TableOptions positions_only() {
  TableOptions options;
  options.needs_value = false;
  return options;
}

/// Two rows (1.5, 2, 3) and (-4, 5e-1, 6).
void expect_two_rows(const PointTable& table) {
  EXPECT_EQ(table.x, (Doubles{1.5, -4}));
  EXPECT_EQ(table.y, (Doubles{2, 0.5}));
  EXPECT_EQ(table.value, (Doubles{3, 6}));
  EXPECT_EQ(table.num_rows, 2);
}

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

// Columns

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

// Missing values and bad rows

TEST(ReadTable, DropsAndCountsMissingValues) {
  const PointTable table = read(
      "lon,lat,t\n1,2,3\n1,2,\n1,2,nan\n1,2,NaN\n1,2,NA\n1,2, "
      "\n1,2,null\n1,2,-nan\n1,2,\"\"\n7,8,9\n");
  EXPECT_EQ(table.value, (Doubles{3, 9}));
  EXPECT_EQ(table.num_missing, 8);
  EXPECT_EQ(table.num_bad, 0);
  EXPECT_EQ(table.num_rows, 10);
  EXPECT_EQ(table.row, (Integers{0, 9}));
  EXPECT_TRUE(table.line.empty());
  EXPECT_EQ(table.row_of(1), 9);
  EXPECT_EQ(table.line_of(1), 11);
}

TEST(ReadTable, DropsAndCountsInfiniteValues) {
  const PointTable table = read("1,2,inf\n1,2,-Infinity\n1,2,1e999\n1,2,4\n");
  EXPECT_EQ(table.value, Doubles{4});
  EXPECT_EQ(table.num_missing, 3);
}

TEST(ReadTable, NumbersRowsAndLinesAcrossCommentsAndDroppedRows) {
  const PointTable table = read("x y z\n1 1 nan\n2 2 2\n# comment\n3 3 nan\n4 4 4\n");
  EXPECT_EQ(table.row, (Integers{1, 3}));
  EXPECT_EQ(table.line, (Integers{3, 6}));
  EXPECT_EQ(table.row_of(0), 1);
  EXPECT_EQ(table.line_of(1), 6);
}

TEST(ReadTable, NamesTheLineOfABadNumber) {
  const std::string content = "lon,lat,temp_c\n1,2,3\n# comment\n1,2,abc\n";
  EXPECT_EQ(
      complaint(content),
      "obs.csv: line 4, column 3 (temp_c): 'abc' is not a number; mend the row or use "
      "--skip-bad-rows");
  EXPECT_EQ(complaint("1,2,3\n1,2x,3\n"),
            "obs.csv: line 2, column 2: '2x' is not a number; mend the row or use "
            "--skip-bad-rows");
  const TemporaryFolder folder;
  try {
    static_cast<void>(read_table(folder.put("obs.csv", content)));
    FAIL() << "nothing thrown";
  } catch (const ReadError& error) {
    ASSERT_EQ(error.rows().size(), 1u);
    EXPECT_EQ(error.rows()[0], 1);
  }
}

TEST(ReadTable, NamesTheLineOfACoordinateThatIsNotFinite) {
  EXPECT_EQ(complaint("lon,lat,t\n1,2,3\n1,NaN,3\n"),
            "obs.csv: line 3, column 2 (lat): the coordinate 'NaN' is not finite; mend "
            "the row or use "
            "--skip-bad-rows");
  EXPECT_NE(
      complaint("1,2,3\n-inf,2,3\n").find("line 2, column 1: the coordinate '-inf'"),
      std::string::npos);
  EXPECT_NE(complaint("1,2,3\n,2,3\n").find("line 2, column 1: the coordinate is empty"),
            std::string::npos);
  // A missing value does not excuse a bad coordinate.
  EXPECT_NE(complaint("1,2,3\n1,inf,nan\n").find("line 2, column 2"), std::string::npos);
}

TEST(ReadTable, NamesTheLineOfARaggedRow) {
  EXPECT_NE(complaint("a,lon,lat,t\n1,2,3,4\n1,2,3\n")
                .find("line 3: 3 fields where the first line has 4"),
            std::string::npos);
  EXPECT_NE(
      complaint("1 2 3\n4 5 6 7\n").find("line 2: 4 fields where the first line has 3"),
      std::string::npos);
  EXPECT_NE(complaint("lon,lat,t\n1,2,3,\n").find("line 2: 4 fields"), std::string::npos);
}

TEST(ReadTable, NamesTheLineOfAQuoteThatDoesNotClose) {
  EXPECT_NE(
      complaint("x,y,z\n1,2,3\n1,2,\"3\n").find("line 3: a quoted field does not end"),
      std::string::npos);
  EXPECT_NE(complaint("x,y,z\n1,2,\"3\"4\n").find("line 2: a quoted field"),
            std::string::npos);
  EXPECT_NE(complaint("\"x,y,z\n1,2,3\n").find("quote that does not close"),
            std::string::npos);
}

TEST(ReadTable, DoesNotTakeDecimalCommas) {
  EXPECT_NE(complaint("x;y;z\n1,5;2;3\n").find("'1,5' is not a number"),
            std::string::npos);
}

TEST(ReadTable, SkipsAndCountsBadRows) {
  const PointTable table = read(
      "x,y,z\n1.5,2,3\nabc,2,3\n1,2\n1,2,3,4\nnan,2,3\n1,inf,3\n,2,3\n1,2,\"3\n1,2,\n-4,"
      "5e-1,6\n",
      skipping());
  EXPECT_EQ(table.x, (Doubles{1.5, -4}));
  EXPECT_EQ(table.num_bad, 7);
  EXPECT_EQ(table.num_missing, 1);
  EXPECT_EQ(table.row, (Integers{0, 9}));
  EXPECT_EQ(table.line_of(1), 11);
}

TEST(ReadTable, CutsLongTextInMessages) {
  const std::string message = complaint("1,2,3\n1,2," + std::string(100000, 'z') + "\n");
  EXPECT_NE(message.find("zzz...' is not a number"), std::string::npos);
  EXPECT_LT(message.size(), 200u);
}

TEST(ReadTable, KeepsMessagesPrintable) {
  const std::string message = complaint("1,2,3\n1,2,a\x1B[2Jb\x07\n");
  EXPECT_NE(message.find("'a?[2Jb?' is not a number"), std::string::npos) << message;
  // The cut does not leave half a character: 39 letters, then one of two bytes.
  const std::string accented =
      complaint("1,2,3\n1,2," + std::string(39, 'a') + "\xC3\xA9\xC3\xA9\n");
  EXPECT_NE(accented.find(std::string(39, 'a') + "...'"), std::string::npos) << accented;
}

TEST(ReadTable, KeepsTheTextOfTheRowsItKeeps) {
  TableOptions options = skipping();
  options.keep_text = true;
  const PointTable table =
      read("name,x,y,z\r\n\"a,b\",1.5,2,3\r\n# no\r\nbad\r\nc ,-4,0.5,6\r\n", options);
  EXPECT_EQ(table.header, "name,x,y,z");
  EXPECT_EQ(table.text, (std::vector<std::string>{"\"a,b\",1.5,2,3", "c ,-4,0.5,6"}));
}

// Files that are no tables

TEST(ReadTable, RefusesAMissingFile) {
  EXPECT_EQ(message_of<ReadError>([] { return read_table("nowhere/obs.csv"); }),
            "nowhere/obs.csv: cannot be read: No such file or directory");
}

TEST(ReadTable, RefusesAFolder) {
  const TemporaryFolder folder;
  const std::string message =
      message_of<ReadError>([&] { return read_table(folder.path("")); });
  EXPECT_NE(message.find("it is a folder"), std::string::npos) << message;
}

TEST(ReadTable, RefusesAnEmptyFile) {
  EXPECT_EQ(complaint(""), "obs.csv: no data rows, the file is empty");
  EXPECT_EQ(complaint("\n# nothing\n  \n"), "obs.csv: no data rows, the file is empty");
  EXPECT_EQ(complaint("\xEF\xBB\xBF"), "obs.csv: no data rows, the file is empty");
}

TEST(ReadTable, RefusesAHeaderWithoutRows) {
  EXPECT_EQ(complaint("lon,lat,temp\n"), "obs.csv: no data rows, only a header");
  EXPECT_EQ(complaint("lon,lat,temp"), "obs.csv: no data rows, only a header");
}

TEST(ReadTable, RefusesATableOfWhichNothingIsLeft) {
  EXPECT_EQ(complaint("x,y,z\n1,2,nan\nabc,2,3\n1,2,\n", skipping()),
            "obs.csv: no usable rows: of 3, 2 have no value and 1 are bad");
}

TEST(ReadTable, RefusesBinaryFilesInOneSentence) {
  EXPECT_EQ(complaint(std::string_view("CDF\x01\0\0\0\0\n", 9)),
            "obs.csv: is not a text file (byte 4 is NUL); give a table in plain UTF-8 or "
            "ASCII text");
  const std::string utf16("\xFF\xFEx\0,\0y\0\n\0", 10);
  EXPECT_NE(complaint(utf16).find("is not a text file"), std::string::npos);
  // Also beyond the first block that is read.
  std::string late = "x,y,z\n";
  while (late.size() < 1000000) late += "1,2,3\n";
  late += '\0';
  EXPECT_NE(complaint(late).find("is not a text file"), std::string::npos);
}

TEST(ReadTable, RefusesGarbageWithoutNulBytes) {
  std::string garbage;
  std::uint32_t state = 12345;
  for (int i = 0; i < 100000; ++i) {
    state = state * 1664525u + 1013904223u;
    garbage += static_cast<char>(1 + (state >> 24) % 255);
  }
  const std::string message = complaint(garbage);
  EXPECT_TRUE(message.starts_with("obs.csv: ")) << message;
  EXPECT_LT(message.size(), 2000u);
}

TEST(ReadTable, RefusesALineOfTenMegabytes) {
  const std::string digits(10000000, '7');
  EXPECT_NE(complaint("x,y,z\n1,2,3\n" + digits + "\n").find("line 3: 1 fields"),
            std::string::npos);
  EXPECT_NE(complaint(digits).find("one column only"), std::string::npos);
  std::string many_fields;
  while (many_fields.size() < 10000000) many_fields += "a,";
  EXPECT_EQ(complaint(many_fields),
            "obs.csv: the first line has 5000001 fields; this is not a table of points");
}

TEST(ReadTable, ListsOnlySomeOfManyColumns) {
  std::string header = "c0";
  for (int i = 1; i < 1000; ++i) header += ",c" + std::to_string(i);
  const std::string message = complaint(header + "\n");
  EXPECT_NE(message.find("c0, c1, "), std::string::npos);
  EXPECT_NE(message.find("c19, ... (1000 in all)"), std::string::npos);
  EXPECT_EQ(message.find("c20"), std::string::npos);
}

TEST(ReadTable, ReadsALineOfTenMegabytesThatIsSound) {
  const PointTable table =
      read("name,x,y,z\nn,1.5,2,3\n" + std::string(10000000, 'n') + ",-4,0.5,6\n");
  expect_two_rows(table);
}

TEST(ReadTable, RefusesALineBeyondTheLimit) {
  const std::string message =
      complaint("x,y,z\n" + std::string((std::size_t{1} << 26) + 1, ' '));
  EXPECT_NE(message.find("line 2 is longer than 64 MiB"), std::string::npos) << message;
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
