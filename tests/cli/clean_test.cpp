// Nearest lists, near repeats, blocks, hashes.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// The value of a fact of `info --json`.
std::string fact(const std::string& json, const std::string& key) {
  const std::size_t at = json.find("\"" + key + "\":");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + key.size() + 3;
  return json.substr(begin, json.find_first_of(",}", begin) - begin);
}

std::string info(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"info"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.emplace_back("--json");
  const Outcome outcome = run(all);
  expect_success(outcome);
  return outcome.out;
}

TEST(NearestList, HasALineForEachNodeWithItsRank) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n3,0\n0,4\n9,9\n");
  const std::string queries = folder.write("q.csv", "x,y,name\n0,0,a\n9,8,b\n");
  const Outcome outcome = run({"nearest", points, queries, "-k", "2"});
  expect_success(outcome);
  EXPECT_EQ(outcome.out,
            "x,y,name,rank,node,distance\n0,0,a,1,0,0\n0,0,a,2,1,3\n"
            "9,8,b,1,3,1\n9,8,b,2,2,9.848857801796104\n");
  // More than there are: all.
  EXPECT_EQ(lines(run({"nearest", points, queries, "-k", "99"}).out).size(), 9U);
}

TEST(NearestList, WithinIsClosedAndSaysWhereNothingIs) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n3,0\n0,4\n9,9\n");
  const std::string queries = folder.write("q.csv", "x,y\n0,0\n50,50\n");
  const Outcome outcome = run({"nearest", points, queries, "--within", "4"});
  expect_success(outcome);
  EXPECT_EQ(outcome.out,
            "x,y,rank,node,distance\n0,0,1,0,0\n0,0,2,1,3\n0,0,3,2,4\n50,50,,,\n");
  EXPECT_NE(outcome.err.find("1 of 2 query points have no node within 4"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(run({"nearest", points, queries, "--within", "4", "-k", "1"}).out,
            "x,y,rank,node,distance\n0,0,1,0,0\n50,50,,,\n");
}

// Geodesics have an order of their own.
TEST(NearestList, OnTheEllipsoidIsInTheOrderOfGeodesics) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat\n10,0\n0,10.01\n-20,0\n0,-60\n");
  const std::string queries = folder.write("q.csv", "lon,lat\n0,0\n");
  const auto first_node = [&](const std::string& domain) {
    const Outcome outcome = run({"nearest", points, queries, "--on", domain, "-k", "2"});
    expect_success(outcome);
    return lines(outcome.out).at(1).substr(0, 7);
  };
  EXPECT_EQ(first_node("sphere"), "0,0,1,0");
  EXPECT_EQ(first_node("ellipsoid"), "0,0,1,1");
}

TEST(NearestList, DoesNotDependOnThreads) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(3000));
  const std::string queries = folder.write("q.csv", scattered_csv(9000, 2));
  const auto out = [&](const std::string& threads) {
    return run({"nearest", points, queries, "-k", "5", "--threads", threads}).out;
  };
  EXPECT_EQ(out("1"), out("3"));
  EXPECT_EQ(lines(out("2")).size(), 45001U);
}

TEST(NearestList, RefusesNumbersThatCannotBe) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(9));
  expect_failure(run({"nearest", points, points, "-k", "0"}), 2, {"-k"});
  expect_failure(run({"nearest", points, points, "--within", "-1"}), 2, {"--within"});
}

TEST(Queries, WithoutCoordinatesNameTheirOwnOptions) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(9));
  const std::string queries = folder.write("q.csv", "p,q\n1,2\n");
  for (const std::string command : {"nearest", "locate"})
    expect_failure(run({command, points, queries}), 3, {"--query-x and --query-y"});
  expect_success(run({"nearest", points, queries, "--query-x", "p", "--query-y", "q"}));
  expect_failure(run({"info", queries}), 3, {"--x and --y"});
}

TEST(MergeWithin, MovesNearPointsTogetherAndSaysSo) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "x,y,z\n0,0,1\n0.1,0,3\n5,0,2\n0,5,2\n5.05,0,4\n");
  const Outcome outcome =
      run({"info", points, "--merge-within", "0.1", "--json", "--value", "z"});
  expect_success(outcome);
  EXPECT_EQ(fact(outcome.out, "positions"), "3");
  EXPECT_EQ(fact(outcome.out, "repeats"), "2");
  EXPECT_NE(outcome.err.find("2 points moved"), std::string::npos) << outcome.err;
  EXPECT_EQ(fact(info({points, "--merge-within", "0.01"}), "positions"), "5");
  expect_failure(run({"info", points, "--merge-within", "-3"}), 2, {"--merge-within"});
}

TEST(MergeWithin, MeasuresKilometresAcrossTheDateLine) {
  const Folder folder;
  const std::string points = folder.write(
      "p.csv", "lon,lat\n179.999,0\n-179.999,0\n0,89.999\n180,89.999\n9,9\n");
  EXPECT_EQ(fact(info({points, "--merge-within", "0.3"}), "positions"), "3");
  EXPECT_EQ(
      fact(info({points, "--merge-within", "0.3", "--on", "ellipsoid"}), "positions"),
      "3");
  EXPECT_EQ(fact(info({points, "--merge-within", "0.1"}), "positions"), "5");
}

// Values of what is merged follow --duplicates, whatever the order of rows.
TEST(MergeWithin, GridsTheSameFromRowsInAnyOrder) {
  const Folder folder;
  std::vector<std::string> rows = lines(scattered_csv(400));
  const auto grid = [&](const std::string& name) {
    std::string text;
    for (const std::string& row : rows) text += row + "\n";
    expect_success(run({"grid", folder.write(name + ".csv", text), "-o",
                        folder / (name + "_grid.csv"), "--spacing", "0.1",
                        "--merge-within", "0.05"}));
    return folder.read(name + "_grid.csv");
  };
  const std::string expected = grid("a");
  std::shuffle(rows.begin() + 1, rows.end(), std::mt19937(1));
  EXPECT_EQ(grid("b"), expected);
}

TEST(Block, WritesOnePointABlock) {
  const Folder folder;
  const std::string points = folder.write(
      "p.csv", "x,y,depth,w\n0.5,0.5,1,1\n0.7,0.5,5,3\n1.5,0.5,2,1\n0.5,1.5,7,0\n");
  const std::string out = folder / "b.csv";
  const auto block = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"block", points, "-o", out, "--spacing", "1"});
    expect_success(run(more));
    return folder.read("b.csv");
  };
  EXPECT_EQ(block({}), "x,y,depth,count\n0.6,0.5,3,2\n1.5,0.5,2,1\n0.5,1.5,7,1\n");
  EXPECT_EQ(block({"--weight", "w", "--position", "center"}),
            "x,y,depth,count,weight\n0.5,0.5,4,2,4\n1.5,0.5,2,1,1\n");
  EXPECT_EQ(block({"--weight", "w", "--statistic", "median", "--position", "center"}),
            "x,y,depth,count,weight\n0.5,0.5,5,2,4\n1.5,0.5,2,1,1\n");
  EXPECT_EQ(block({"--region", "0/1/0/1", "--statistic", "mode"}),
            "x,y,depth,count\n0.6,0.5,3,2\n");
}

TEST(Block, OnTheGlobeWrapsLongitudes) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat,t\n175,5,1\n-175,5,3\n545,5,5\n");
  const std::string out = folder / "b.csv";
  expect_success(run({"block", points, "-o", out, "--spacing", "20", "--region",
                      "170/-170/0/20", "--position", "center"}));
  EXPECT_EQ(folder.read("b.csv"), "lon,lat,t,count\n180,10,3,3\n");
}

TEST(Block, RefusesWhatMakesNoSense) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(9));
  const std::string out = folder / "b.csv";
  expect_failure(run({"block", points, "-o", out}), 2, {"--spacing"});
  expect_failure(run({"block", points, "-o", out, "--spacing", "0"}), 2, {"--spacing"});
  expect_failure(
      run({"block", points, "-o", out, "--spacing", "1", "--region", "0/1/1/0"}), 2,
      {"--region"});
  expect_failure(
      run({"block", points, "-o", out, "--spacing", "1", "--statistic", "max"}), 2,
      {"--statistic"});
  expect_failure(run({"block", points, "-o", out, "--spacing", "1", "--weight", "none"}),
                 3, {"none"});
  expect_failure(run({"block", points, "-o", out, "--spacing", "1e-300"}), 3, {"larger"});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"p.csv"});
}

TEST(Hash, IsTheSameForTheSamePositionsInAnyOrder) {
  const Folder folder;
  std::vector<std::string> rows = lines(scattered_csv(200));
  const auto hash = [&](const std::string& name) {
    std::string text;
    for (const std::string& row : rows) text += row + "\n";
    return fact(info({folder.write(name, text)}), "hash");
  };
  const std::string expected = hash("a.csv");
  EXPECT_EQ(expected.size(), 34U);
  std::shuffle(rows.begin() + 1, rows.end(), std::mt19937(1));
  rows.push_back(rows.back());
  EXPECT_EQ(hash("b.csv"), expected);
  rows.pop_back();
  rows.pop_back();
  EXPECT_NE(hash("c.csv"), expected);
}

TEST(Hash, OfACheckedFileIsThatOfThePoints) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(200));
  expect_success(run({"triangulate", points, "-o", folder / "t.tri"}));
  const Outcome outcome = run({"check", points, folder / "t.tri"});
  expect_success(outcome);
  const std::string hash = fact(info({points}), "hash");
  EXPECT_NE(outcome.out.find(hash.substr(1, 32)), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace delone::test
