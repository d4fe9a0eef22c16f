// Input that cannot be used (exit code 3) and output that cannot be written (exit code
// 4).

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string header = "x,y,value\n";

struct BadFile {
  std::string name;  ///< of the test
  std::string text;
  std::vector<std::string> words;  ///< besides the file's name
};

class BadTable : public testing::TestWithParam<BadFile> {};

TEST_P(BadTable, EndsWithCode3AndNamesFileAndPlace) {
  const Folder folder;
  const std::string points = folder.write("obs.csv", GetParam().text);
  std::vector<std::string> words = GetParam().words;
  words.push_back("obs.csv");
  expect_failure(run({"grid", points, "-o", folder / "out.nc"}), 3, words);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"obs.csv"});
}

std::string binary_garbage() {
  std::string text;
  for (int i = 0; i < 4096; ++i) text += static_cast<char>(i * 7919 % 251);
  return text;
}

const std::vector<BadFile> bad_files{
    {"Empty", "", {}},
    {"HeaderOnly", header, {}},
    {"CommentsOnly", "# a comment\n\n", {}},
    {"ValuesAllMissing", header + "1,2,nan\n3,4,\n", {}},
    {"NoValueColumn", "x,y\n1,2\n4,5\n7,1\n", {}},
    {"NamesThatSayNothing", "a,b,c\n1,2,3\n4,5,6\n", {"--x"}},
    {"OnePoint", header + "1,2,3\n", {"one position", "--extrapolate nearest"}},
    {"TwoPoints", header + "1,2,3\n4,5,6\n", {"one line", "--extrapolate nearest"}},
    {"Collinear",
     header + "0,0,1\n1,1,2\n2,2,3\n3,3,4\n",
     {"one line", "--extrapolate nearest"}},
    {"OneGreatCircle",
     "lon,lat,value\n0,0,1\n10,0,2\n20,0,3\n",
     {"great circle", "--extrapolate nearest"}},
    {"AllTheSamePoint", header + "1,2,3\n1,2,4\n1,2,5\n", {"one position"}},
    {"NanCoordinate", header + "0,0,1\n1,0,2\nnan,1,3\n1,1,4\n", {"line 4"}},
    {"InfiniteCoordinate", header + "0,0,1\n1,0,2\n0,inf,3\n1,1,4\n", {"line 4"}},
    {"EmptyCoordinate", header + "0,0,1\n1,0,2\n,1,3\n1,1,4\n", {"line 4"}},
    {"LatitudeBeyondThePole",
     "lon,lat,value\n0,0,1\n10,0,2\n20,91,3\n10,10,3\n",
     {"line 4", "91"}},
    {"LatitudeBeyondThePoleAfterComments",
     "lon,lat,value\n0,0,1\n# note\n\n10,0,2\n20,-90.5,3\n10,10,3\n",
     {"line 6", "-90.5"}},
    {"TextInANumberColumn",
     header + "0,0,1\n1,0,two\n0,1,3\n",
     {"line 3", "column 3", "two"}},
    {"RowTooShort", header + "0,0,1\n1,0\n0,1,3\n", {"line 3"}},
    {"RowTooLong", header + "0,0,1\n1,0,2,9\n0,1,3\n", {"line 3"}},
    {"LongRow", header + "0,0,1\n1,0," + std::string(10'000'000, '7') + "x\n", {}},
    {"LongFirstLine", std::string(10'000'000, 'a'), {}},
    {"BinaryGarbage", binary_garbage(), {}}};

INSTANTIATE_TEST_SUITE_P(All, BadTable, testing::ValuesIn(bad_files),
                         [](const auto& bad) { return bad.param.name; });

TEST(BadInput, MissingFileIsNamed) {
  const Folder folder;
  expect_failure(run({"grid", folder / "none.csv", "-o", folder / "out.nc"}), 3,
                 {"none.csv"});
  expect_failure(run({"plot", folder / "none.nc", "-o", folder / "out.png"}), 3,
                 {"none.nc"});
  EXPECT_TRUE(folder.names().empty());
}

TEST(BadInput, FolderInPlaceOfAFileIsNamed) {
  const Folder folder;
  std::filesystem::create_directory(folder / "dir.csv");
  expect_failure(run({"grid", folder / "dir.csv", "-o", folder / "out.nc"}), 3,
                 {"dir.csv"});
}

TEST(BadInput, ChosenColumnThatIsNotThereIsNamed) {
  const Folder folder;
  const std::string points = folder.write("obs.csv", scattered_csv(9));
  expect_failure(run({"grid", points, "--value", "depth", "-o", folder / "out.nc"}), 3,
                 {"obs.csv", "depth"});
}

TEST(BadInput, LatitudeOutsideTheGlobeInTheQueriesNamesTheirFile) {
  const Folder folder;
  const std::string points =
      folder.write("obs.csv", scattered_csv(9, 1, "lon,lat,value"));
  const std::string queries = folder.write("q.csv", "lon,lat\n0,0\n0,95\n");
  expect_failure(run({"sample", points, queries, "-o", folder / "out.csv"}), 3,
                 {"q.csv", "line 3", "95"});
}

TEST(BadInput, RepeatsWithDuplicatesErrorNameTheLine) {
  const Folder folder;
  const std::string points =
      folder.write("obs.csv", header + "0,0,1\n1,0,2\n0,1,3\n1,0,4\n");
  const std::string out = folder / "out.nc";
  expect_failure(run({"grid", points, "-o", out, "--duplicates", "error"}), 3,
                 {"obs.csv", "line"});
  expect_failure(
      run({"triangulate", points, "-o", folder / "out.tri", "--duplicates", "error"}), 3,
      {"obs.csv", "line 5", "row 1"});
}

TEST(BadInput, TrianglesThatAreNotTrianglesNameTheirFile) {
  const Folder folder;
  const std::string points = folder.write("obs.csv", scattered_csv(9));
  expect_failure(run({"check", points, folder.write("t.tri", "0 1 99\n")}), 3, {"t.tri"});
  expect_failure(run({"check", points, folder.write("t.tri", "0 one 2\n")}), 3,
                 {"t.tri", "line 1"});
}

TEST(BadInput, GridFileThatIsNoneIsNamed) {
  const Folder folder;
  const std::string grid = folder.write("g.nc", "no grid at all\n");
  expect_failure(run({"plot", grid, "-o", folder / "out.png"}), 3, {"g.nc"});
}

TEST(BadInput, GridBeyondMemoryIsRefusedBeforeAnyWork) {
  const Folder folder;
  const std::string points = folder.write("obs.csv", scattered_csv(9));
  const Outcome outcome =
      run({"grid", points, "-o", folder / "o.nc", "--size", "1000000/1000000"});
  expect_failure(outcome, 2, {"memory"});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"obs.csv"});
}

struct Writer {
  std::vector<std::string> arguments;  ///< in front of -o
  std::string extension;
};

class BadOutput : public testing::TestWithParam<Writer> {
 protected:
  Outcome run_to(const std::string& output,
                 const std::vector<std::string>& more = {}) const {
    const Folder& folder = folder_;
    folder.write("p.csv", scattered_csv(50));
    folder.write("q.csv", "x,y\n0.5,0.5\n");
    std::vector<std::string> arguments = GetParam().arguments;
    arguments.insert(arguments.end(), {"-o", output});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, {.working_folder = folder / ""});
  }
  Folder folder_;
};

TEST_P(BadOutput, FolderThatDoesNotExistEndsWithCode4) {
  const std::string output = "nowhere/out." + GetParam().extension;
  expect_failure(run_to(output), 4, {output});
}

TEST_P(BadOutput, FolderInPlaceOfAFileEndsWithCode4) {
  const std::string output = "out." + GetParam().extension;
  std::filesystem::create_directory(folder_ / output);
  expect_failure(run_to(output), 4, {output});
}

TEST_P(BadOutput, FullDiskEndsWithCode4) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  expect_failure(run_to("/dev/full", {"--format", GetParam().extension}), 4,
                 {"/dev/full"});
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"p.csv", "q.csv"}));
}

INSTANTIATE_TEST_SUITE_P(All, BadOutput,
                         testing::Values(Writer{{"grid", "p.csv"}, "nc"},
                                         Writer{{"grid", "p.csv"}, "csv"},
                                         Writer{{"grid", "p.csv"}, "asc"},
                                         Writer{{"grid", "p.csv"}, "png"},
                                         Writer{{"sample", "p.csv", "q.csv"}, "csv"},
                                         Writer{{"triangulate", "p.csv"}, "tri"},
                                         Writer{{"triangulate", "p.csv"}, "ele"},
                                         Writer{{"triangulate", "p.csv"}, "adj"}));

TEST(FullDisk, OnStandardOutputEndsWithCode4) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(50));
  for (const std::string command : {"hull", "info"}) {
    expect_failure(run({command, points}, {.out_path = "/dev/full"}), 4, {"/dev/stdout"});
  }
  expect_failure(run({"--version"}, {.out_path = "/dev/full"}), 4, {"/dev/stdout"});
}

}  // namespace
}  // namespace delone::test
