// Messages that lead a new user on: what was wrong, and what to write instead.

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string triangle = "x,y\n0,0\n1,0\n0,1\n";

TEST(Mend, ClockwiseRingOnTheGlobeNamesOutside) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat\n1,1\n2,1\n1,2\n");
  const std::string rings =
      folder.write("r.csv", "ring,lon,lat\n1,0,0\n1,0,5\n1,5,5\n1,5,0\n");
  std::vector<std::string> arguments{"triangulate",    points,          "-o",
                                     folder / "o.tri", "--constraints", rings};
  expect_failure(run(arguments), 3, {"r.csv", "clockwise", "--outside LON/LAT"});
  arguments.push_back("--outside=50/50");
  expect_success(run(arguments));
  EXPECT_EQ(lines(folder.read("o.tri")).size(), 8U);
}

TEST(Mend, SenseOfRingsOnTheGlobeIsSaid) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat\n1,1\n2,1\n1,2\n");
  const std::string rings =
      folder.write("r.csv", "ring,lon,lat\n1,0,0\n1,5,0\n1,5,5\n1,0,5\n");
  const Outcome outcome =
      run({"triangulate", points, "-o", folder / "o.tri", "--constraints", rings});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("left of the first ring"), std::string::npos);
  EXPECT_NE(outcome.err.find("--outside LON/LAT"), std::string::npos);
}

TEST(Mend, BadLatitudeOfThePointsIsNotBlamedOnTheRings) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat\n1,1\n2,91\n1,2\n");
  const std::string rings =
      folder.write("r.csv", "ring,lon,lat\n1,0,0\n1,5,0\n1,5,5\n1,0,5\n");
  const Outcome outcome =
      run({"triangulate", points, "-o", folder / "o.tri", "--constraints", rings});
  expect_failure(outcome, 3, {"p.csv", "line 3", "91"});
  EXPECT_EQ(lines(outcome.err).back().find("r.csv"), std::string::npos) << outcome.err;
  const std::string high = folder.write("h.csv", "ring,lon,lat\n1,0,0\n1,5,0\n1,5,95\n");
  expect_failure(run({"triangulate", rings, "-o", folder / "o.tri", "--constraints", high,
                      "--x", "lon", "--y", "lat"}),
                 3, {"h.csv", "95"});
}

TEST(Mend, StandardOutputWithoutAFormatNamesFormatsAndTheOption) {
  const Folder folder;
  const std::string points = folder.write("p.csv", triangle);
  for (const std::string out : {"-", "/dev/stdout"}) {
    expect_failure(run({"triangulate", points, "-o", out}), 2,
                   {"standard output", "--format", "tri, poly, ele"});
    expect_failure(run({"voronoi", points, "-o", out}), 2, {"--format", "v.node"});
  }
  EXPECT_EQ(run({"triangulate", points, "-o", "-", "--format", "tri"}).out, "0 1 2\n");
}

TEST(Mend, TheOnlyFormatNeedNotBeSaidForStandardOutput) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
  const std::string text = "x,y,z,count\n0,0,1,1\n1,0,2,1\n0,1,3,1\n";
  EXPECT_EQ(run({"block", points, "--spacing", "1", "-o", "-"}).out, text);
  const Outcome outcome = run({"block", points, "--spacing", "1"});
  expect_success(outcome);
  EXPECT_EQ(outcome.out, text);
}

class MixedSpaces : public testing::TestWithParam<const char*> {};

TEST_P(MixedSpaces, LonLatQueriesAmongPlanePointsAreAnError) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
  const std::string queries = folder.write("q.csv", "lon,lat\n0.1,0.2\n");
  std::vector<std::string> arguments{GetParam(), points, queries, "-o", folder / "o.csv"};
  expect_failure(run(arguments), 2, {"q.csv", "'lon'", "p.csv", "'x'", "--on sphere"});
  for (const char* domain : {"plane", "sphere"}) {
    std::vector<std::string> said = arguments;
    said.insert(said.end(), {"--on", domain});
    expect_success(run(said));
  }
}

TEST_P(MixedSpaces, PlaneQueriesAmongLonLatPointsAreSaid) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat,z\n0,0,1\n1,0,2\n0,1,3\n");
  const std::string queries = folder.write("q.csv", "x,y\n0.1,0.2\n");
  const std::string bare = folder.write("bare.csv", "0.1,0.2\n");
  const Outcome outcome = run({GetParam(), points, queries, "-o", folder / "o.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("taken as longitude and latitude"), std::string::npos);
  EXPECT_EQ(run({GetParam(), points, bare, "-o", folder / "o.csv"})
                .err.find("taken as longitude"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, MixedSpaces,
                         testing::Values("nearest", "locate", "sample"));

TEST(Mend, TableThatHoldsNoRingsNamesItsColumns) {
  const Folder folder;
  const std::string points = folder.write("p.csv", triangle);
  const auto refused = [&](const std::string& table,
                           const std::vector<std::string>& words) {
    const std::string constraints = folder.write("c.csv", table);
    std::vector<std::string> all = words;
    all.push_back("c.csv");
    all.push_back("ring number, x, y");
    expect_failure(run({"triangulate", points, "-o", folder / "o.tri", "--constraints",
                        constraints}),
                   3, all);
  };
  refused("x,y\n0,0\n1,0\n", {"three columns", "--constraints"});
  refused("x,y,z\n0,0,7\n1,0,8\n0,1,9\n", {"line 2", "1 row", "'z', 'x', 'y'"});
  refused("a,b,c\n0.5,0,7\n0.5,0,8\n0.5,1,9\n", {"line 2", "'0.5'", "'a', 'b', 'c'"});
  refused("a,b,c\nisle,0,7\nisle,0,8\nisle,1,9\n", {"line 2", "isle"});
  refused("1,0\n1,5\n", {"three columns", "no header"});
  refused("ring,x,y\n1,0,0\n1,1,0\n1,0,1\n2,5,5\n2,6,6\n", {"line 5", "2 rows"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o.tri"));
}

TEST(Mend, RingTablesMayHaveOtherColumnsWhereNamesSayWhich) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat\n1,1\n2,1\n1,2\n");
  const std::string expected = "ring,lon,lat\n1,0,0\n1,5,0\n1,5,5\n1,0,5\n";
  const auto triangles = [&](const std::string& table) {
    const std::string rings = folder.write("r.csv", table);
    expect_success(
        run({"triangulate", points, "-o", folder / "o.tri", "--constraints", rings}));
    return folder.read("o.tri");
  };
  const std::string once = triangles(expected);
  EXPECT_EQ(triangles("polygon_id,level,parent_id,lon,lat\n1,1,-1,0,0\n1,1,-1,5,0\n"
                      "1,1,-1,5,5\n1,1,-1,0,5\n"),
            once);
  EXPECT_EQ(triangles("lat,lon,id\n0,0,7\n0,5,7\n5,5,7\n5,0,7\n"), once);
  EXPECT_EQ(triangles("a,b,c\n1,0,0\n1,5,0\n1,5,5\n1,0,5\n"), once);
  EXPECT_EQ(triangles("1 0 0\n1 5 0\n1 5 5\n1 0 5\n"), once);
}

TEST(Mend, SegmentsThatEncloseNothingAreAnErrorNotAnEmptyFile) {
  const Folder folder;
  const std::string poly =
      folder.write("open.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n1 1 2\n2 2 3\n0\n");
  expect_failure(run({"triangulate", poly, "-o", folder / "o.tri"}), 3,
                 {"open.poly", "2 segments enclose", "--keep-outside"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o.tri"));
  expect_success(run({"triangulate", poly, "-o", folder / "o.tri", "--keep-outside"}));
}

TEST(Plot, ReadsPolyFiles) {
  const Folder folder;
  const std::string poly = folder.write(
      "f.poly",
      "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n"
      "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n");
  const auto picture = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"plot", poly, "-o", folder / "f.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_success(run(arguments));
    return folder.read("f.svg");
  };
  const std::string domain = picture({});
  EXPECT_GT(picture({"--keep-outside"}).size(), domain.size());
  EXPECT_LT(picture({"--show", "points"}).size(), domain.size());
}

TEST(Plot, TakesTheOptionsOfTables) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "x,y\n0,0\n1,0\nbad,7\n0,1\n0.01,0\n1,0\n");
  const std::vector<std::string> command{"plot", points, "-o", folder / "p.svg"};
  expect_failure(run(command), 3, {"p.csv", "line 4", "bad"});
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--skip-bad-rows");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  expect_success(with({}));
  expect_failure(with({"--duplicates", "error"}), 3, {"p.csv", "line 7"});
  const Outcome outcome = with({"--merge-within", "0.1", "--show", "triangles"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("3 positions left"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace delone::test
