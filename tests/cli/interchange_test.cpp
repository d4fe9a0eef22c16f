// Formats of other programs in and out, and pictures of points and triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string square_node =
    "# counted from 1\n5 2 1 1\n1 0 0 10 1\n2 2 0 11 1\n3 2 1 12 1\n4 0 1 13 1\n5 1 0.6 "
    "14 "
    "0\n";

class TriangleFormat : public testing::TestWithParam<const char*> {};

TEST_P(TriangleFormat, IsAcceptedByCheck) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(60, 3));
  const std::string triangles = folder / ("t." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", triangles}));
  expect_success(run({"check", points, triangles}));
}

TEST_P(TriangleFormat, IsAcceptedByCheckOnTheSphere) {
  const Folder folder;
  const std::string points = folder.write(
      "p.csv", "lon,lat\n0,0\n90,0\n180,0\n-90,0\n0,90\n0,-90\n30,40\n-100,-20\n");
  const std::string triangles = folder / ("t." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", triangles}));
  expect_success(run({"check", points, triangles}));
}

TEST_P(TriangleFormat, IsRefusedByCheckOverOtherPoints) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(60, 3));
  const std::string others = folder.write("o.csv", scattered_csv(60, 4));
  const std::string triangles = folder / ("t." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", triangles}));
  EXPECT_EQ(run({"check", others, triangles}).exit_code, 1);
}

INSTANTIATE_TEST_SUITE_P(All, TriangleFormat,
                         testing::Values("tri", "ele", "adj", "renka", "off", "ply",
                                         "vtu", "nc"),
                         [](const auto& format) { return std::string(format.param); });

TEST(Check, TakesTrianglesOfMixedOrientation) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n2,0\n2,1\n0,1\n1,0.6\n");
  const std::string triangles = folder.write("t.tri", "0 1 4\n4 2 1\n2 3 4\n0 4 3\n");
  expect_success(run({"check", points, triangles}));
}

TEST(Check, NamesANeighborThatDoesNotAnswer) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n1,0\n0,1\n");
  const std::string lists = folder.write("t.adj", "0 1 2\n1 2 0\n2 0\n");
  const Outcome outcome = run({"check", points, lists});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out.substr(0, 14), "not Delaunay: ") << outcome.out;
}

TEST(Check, TakesListsAroundAHullOfThree) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n3,0\n0,3\n1,1\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.adj"}));
  expect_success(run({"check", points, folder / "t.adj"}));
}

TEST(NodeFiles, KeepTheirBaseInTheirCompanions) {
  const Folder folder;
  const std::string points = folder.write("s.node", square_node);
  expect_success(run({"triangulate", points, "-o", folder / "s.ele", "--neighbors"}));
  EXPECT_EQ(lines(folder.read("s.ele"))[1], "1 1 2 5");
  EXPECT_EQ(lines(folder.read("s.neigh"))[1].substr(0, 2), "1 ");
  expect_success(run({"triangulate", points, "-o", folder / "s.edge"}));
  EXPECT_EQ(lines(folder.read("s.edge"))[1], "1 1 2 1");
  expect_success(run({"triangulate", points, "-o", folder / "t.node"}));
  EXPECT_EQ(lines(folder.read("t.node"))[1], "1 0 0");
  // Elsewhere --base is 0.
  expect_success(run({"triangulate", points, "-o", folder / "s.tri"}));
  EXPECT_EQ(lines(folder.read("s.tri"))[0], "0 1 4");
  expect_success(run({"check", points, folder / "s.ele"}));
}

TEST(NodeFiles, AreReadByOtherSubcommandsWithAttributesAsValues) {
  const Folder folder;
  const std::string points = folder.write("s.node", square_node);
  expect_success(run(
      {"grid", points, "-o", folder / "g.csv", "--region", "0/2/0/1", "--spacing", "1"}));
  EXPECT_EQ(lines(folder.read("g.csv"))[1], "0,0,10");
  expect_success(run({"info", points}));
  expect_success(run({"hull", points}));
  expect_failure(
      run({"grid", folder.write("n.node", "1 2 0 0\n1 0 0\n"), "-o", folder / "n.csv"}),
      3, {"n.node", "no attributes"});
}

TEST(Triangulate, WritesQhullsAndMathematicasFormats) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "2\n3\n0 0\n1 0\n0 1\n");
  const auto written = [&](const char* format) {
    expect_success(
        run({"triangulate", points, "-o", folder / "out", "--format", format}));
    return folder.read("out");
  };
  EXPECT_EQ(written("i"), "1\n0 1 2\n");
  EXPECT_EQ(written("Fv"), "1\n3 0 1 2\n");
  EXPECT_EQ(written("FN"), "3\n1 0\n1 0\n1 0\n");
  EXPECT_EQ(written("o"), "3\n3 1 3\n0 0 0\n1 0 1\n0 1 1\n3 0 1 2\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.o"}));
  expect_success(run({"check", points, folder / "t.o"}));
  EXPECT_EQ(written("mathematica"), "{{1, {2, 3}},\n {2, {3, 1}},\n {3, {1, 2}}}\n");
  EXPECT_EQ(written("xy"), "0 0\n1 0\n0 1\n");
}

TEST(Triangulate, NumbersNodesOfMeshesByDataRows) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n,5\n1,0\n0,1\n0,0\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.off", "--skip-bad-rows"}));
  const auto text = lines(folder.read("t.off"));
  ASSERT_EQ(text.size(), 8U);
  EXPECT_EQ(text[1], "5 1 3");
  EXPECT_EQ(text[7], "3 0 2 3");
}

TEST(Triangulate, RefusesListsOfTripackForRepeatedRows) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n0,0\n1,0\n0,1\n");
  expect_failure(run({"triangulate", points, "-o", folder / "t.renka"}), 3, {"row 1"});
  EXPECT_FALSE(std::filesystem::exists(folder / "t.renka"));
}

class PictureFormat : public testing::TestWithParam<const char*> {};

TEST_P(PictureFormat, ShowsTrianglesVoronoiAndLabels) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(30, 5));
  const std::string picture = folder / ("p." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", picture, "--show",
                      "points,triangles,voronoi,circles", "--labels", "all", "--title",
                      "thirty points", "--window", "0/1/0/1"}));
  const std::string once = read_file(picture);
  EXPECT_GT(once.size(), 1000U);
  expect_success(run({"triangulate", points, "-o", picture, "--show",
                      "points,triangles,voronoi,circles", "--labels", "all", "--title",
                      "thirty points", "--window", "0/1/0/1"}));
  EXPECT_EQ(read_file(picture), once);
}

INSTANTIATE_TEST_SUITE_P(All, PictureFormat, testing::Values("svg", "png", "pdf", "eps"),
                         [](const auto& format) { return std::string(format.param); });

TEST(Plot, DrawsPointsMeshesAndElements) {
  const Folder folder;
  const std::string points = folder.write("p.node", square_node);
  for (const char* file : {"p.off", "p.ply", "p.vtu", "p.nc", "p.ele"}) {
    expect_success(run({"triangulate", points, "-o", folder / file}));
    expect_success(run({"plot", folder / file, "-o", folder / "picture.svg"}));
  }
  expect_success(run({"plot", points, "-o", folder / "picture.svg"}));
  expect_success(
      run({"plot", points, "-o", folder / "picture.svg", "--show", "voronoi"}));
}

TEST(Plot, LooksAtTheGlobeFromAnyPlace) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat\n0,0\n90,0\n180,0\n-90,0\n0,90\n0,-90\n");
  expect_success(run({"plot", points, "-o", folder / "g.svg", "--show",
                      "points,triangles,voronoi", "--view", "20/30"}));
  expect_failure(run({"plot", points, "-o", folder / "g.svg", "--view", "20/100"}), 2,
                 {"--view", "-90..90"});
  expect_failure(
      run({"plot", points, "-o", folder / "g.svg", "--view", "20/10", "--on", "plane"}),
      2, {"--view", "plane"});
}

TEST(Plot, RefusesOptionsOfMeshesForGrids) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(30, 5));
  expect_success(run({"grid", points, "-o", folder / "g.nc"}));
  expect_failure(
      run({"plot", folder / "g.nc", "-o", folder / "g.svg", "--show", "points"}), 2,
      {"--show", "grid"});
  expect_failure(run({"plot", points, "-o", folder / "g.svg", "--show", "pints"}), 2,
                 {"--show", "pints"});
}

}  // namespace
}  // namespace delone::test
