// Missing values, bad rows, and files that are no tables.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/table.hpp"
#include "io/table_samples.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::complaint;
using test::Doubles;
using test::expect_two_rows;
using test::Integers;
using test::message_of;
using test::read;
using test::skipping;
using test::TemporaryFolder;

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

}  // namespace
}  // namespace delone::io
