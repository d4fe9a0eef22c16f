// triangulate with segments: .poly files and --constraints.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

/// A square of side 4 with a square hole of side 2; vertices count from 1.
const std::string frame =
    "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n"
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n";
const std::string cross = "4 2 0 0\n1 0 0\n2 2 2\n3 2 0\n4 0 2\n2 0\n1 1 2\n2 3 4\n0\n";

std::vector<std::vector<int>> numbers(const std::string& text) {
  std::vector<std::vector<int>> rows;
  for (const std::string& line : lines(text)) {
    std::istringstream stream(line);
    auto& row = rows.emplace_back();
    for (int n = 0; stream >> n;) row.push_back(n);
  }
  return rows;
}

TEST(Constraints, PolyFileIsTriangulatedInsideItsOutlineWithoutItsHoles) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  expect_success(run({"triangulate", poly, "-o", folder / "frame.ele", "--neighbors"}));
  const auto elements = numbers(folder.read("frame.ele"));
  ASSERT_EQ(elements.size(), 9U);
  EXPECT_EQ(elements[1][0], 1);  // the base of the file
  EXPECT_EQ(numbers(folder.read("frame.neigh")).size(), 9U);
}

TEST(Constraints, KeepOutsideKeepsTheHullAndItsHoles) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  expect_success(
      run({"triangulate", poly, "-o", folder / "frame.tri", "--keep-outside"}));
  EXPECT_EQ(numbers(folder.read("frame.tri")).size(), 10U);
}

TEST(Constraints, CrossingSegmentsAreAnErrorThatNamesTheirLines) {
  const Folder folder;
  const std::string poly = folder.write("cross.poly", cross);
  expect_failure(run({"triangulate", poly, "-o", folder / "c.ele"}), 3,
                 {"cross.poly", "lines 7 and 8", "--split-intersections"});
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cross.poly"}));
}

TEST(Constraints, SplitIntersectionsAddsThePointWhereTheyMeet) {
  const Folder folder;
  const std::string poly = folder.write("cross.poly", cross);
  const Outcome outcome = run({"triangulate", poly, "-o", folder / "c.tri",
                               "--split-intersections", "--keep-outside"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("1 crossing split (1 added point)"), std::string::npos);
  const auto triangles = numbers(folder.read("c.tri"));
  ASSERT_EQ(triangles.size(), 4U);
  for (const auto& triangle : triangles) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 4), 1);
  }
}

TEST(Constraints, RingsOfATableEncloseWhatAnOddNumberOfThemHolds) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0.5,0.5\n9,9\n2,2\n");
  const std::string rings = folder.write(
      "r.csv",
      "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,4\n1,0,0\n2,1,1\n2,3,1\n2,3,3\n2,1,3\n");
  expect_success(
      run({"triangulate", points, "--constraints", rings, "-o", folder / "r.tri"}));
  const auto triangles = numbers(folder.read("r.tri"));
  // The frame and the point in it: 8 + 2 triangles, none with the other two points.
  EXPECT_EQ(triangles.size(), 10U);
  for (const auto& triangle : triangles) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 0);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 2), 0);
  }
}

TEST(Constraints, SegmentsOfAPolyFileConstrainATableOfPoints) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0.5,0.5\n9,9\n2,2\n");
  const std::string poly = folder.write("frame.poly", frame);
  expect_success(
      run({"triangulate", points, "--constraints", poly, "-o", folder / "r.tri"}));
  EXPECT_EQ(numbers(folder.read("r.tri")).size(), 10U);
}

TEST(Constraints, RingsOnTheGlobeHaveAnOutsideByAPointOrByTheirSense) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat\n0,90\n0,-90\n0,0\n90,0\n180,0\n-90,0\n");
  // Round the north pole, eastwards: the cap is on the left.
  const std::string rings =
      folder.write("r.csv", "ring,lon,lat\n1,0,60\n1,90,60\n1,180,60\n1,-90,60\n");
  const std::vector<std::string> command = {"triangulate",    points,          "-o",
                                            folder / "r.tri", "--constraints", rings};
  expect_success(run(command));
  EXPECT_EQ(numbers(folder.read("r.tri")).size(), 4U);
  auto south = command;
  south.push_back("--outside=10/85");
  expect_success(run(south));
  EXPECT_EQ(numbers(folder.read("r.tri")).size(), 12U);
  auto whole = command;
  whole.push_back("--keep-outside");
  expect_success(run(whole));
  EXPECT_EQ(numbers(folder.read("r.tri")).size(), 16U);
}

/// Angles and areas of the triangles of an .ele file over a .node file, both from 1.
struct Quality {
  double smallest_angle_deg = 180, largest_area = 0, area = 0;
};

Quality quality(const std::string& node_file, const std::string& ele_file) {
  std::istringstream nodes(node_file), elements(ele_file);
  std::size_t num_nodes = 0, num_elements = 0, number = 0, num_corners = 0;
  std::string rest;
  std::getline(nodes >> num_nodes, rest);
  std::vector<double> x(num_nodes + 1), y(num_nodes + 1);
  while (nodes >> number) std::getline(nodes >> x.at(number) >> y.at(number), rest);
  std::getline(elements >> num_elements >> num_corners, rest);
  Quality found;
  for (std::size_t a = 0, b = 0, c = 0; elements >> number >> a >> b >> c;) {
    const double area = ((x.at(b) - x.at(a)) * (y.at(c) - y.at(a)) -
                         (x.at(c) - x.at(a)) * (y.at(b) - y.at(a))) /
                        2;
    found.area += area;
    found.largest_area = std::max(found.largest_area, area);
    for (int k = 0; k < 3; ++k) {
      const double cosine_part =
          (x[b] - x[a]) * (x[c] - x[a]) + (y[b] - y[a]) * (y[c] - y[a]);
      found.smallest_angle_deg =
          std::min(found.smallest_angle_deg,
                   std::atan2(2 * area, cosine_part) * 180 / std::numbers::pi);
      std::swap(a, b);
      std::swap(b, c);
    }
  }
  return found;
}

TEST(Constraints, MinAngleAndMaxAreaHoldForEveryTriangleOfTheDomain) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  const Outcome outcome = run({"triangulate", poly, "-o", folder / "mesh.ele",
                               "--min-angle", "30", "--max-area", "0.1"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("0 triangles below 30 degrees"), std::string::npos)
      << outcome.err;
  const Quality found = quality(folder.read("mesh.node"), folder.read("mesh.ele"));
  EXPECT_GE(found.smallest_angle_deg, 30 - 1e-9);
  EXPECT_LE(found.largest_area, 0.1 + 1e-12);
  EXPECT_NEAR(found.area, 12, 1e-12);  // the hole stays one
}

TEST(Constraints, AnglesThatTheSegmentsHaveAreLeftAndCounted) {
  const Folder folder;
  const std::string poly = folder.write(
      "needle.poly", "3 2 0 0\n1 0 0\n2 9 0\n3 9 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const Outcome outcome =
      run({"triangulate", poly, "-o", folder / "n.off", "--min-angle", "25"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("3 triangles below 25 degrees (smallest angle 6.34"),
            std::string::npos)
      << outcome.err;
}

TEST(Constraints, RefinementWithoutSegmentsOrOnTheGlobeIsAnError) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n1,0\n0,1\n");
  const std::string globe = folder.write("g.csv", "lon,lat\n0,0\n1,0\n0,1\n");
  const std::string rings = folder.write("r.csv", "ring,x,y\n1,-1,-1\n1,2,-1\n1,0,3\n");
  const std::string out = folder / "o.tri";
  expect_failure(run({"triangulate", points, "-o", out, "--max-area", "1"}), 2,
                 {"--max-area", "--constraints"});
  expect_failure(
      run({"triangulate", globe, "--constraints", rings, "-o", out, "--min-angle", "20"}),
      2, {"--min-angle", "plane"});
  expect_failure(run({"triangulate", points, "--constraints", rings, "-o", out,
                      "--min-angle", "50"}),
                 2, {"--min-angle"});
  expect_failure(
      run({"triangulate", points, "--constraints", rings, "-o", out, "--max-area", "0"}),
      2, {"--max-area"});
}

TEST(Constraints, AddedPointsNeverOverwriteTheNodesOfThePolyFile) {
  const Folder folder;
  folder.write("sq.node", "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n");
  const std::string nodes = folder.read("sq.node");
  const std::string poly =
      folder.write("sq.poly", "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  expect_failure(run({"triangulate", poly, "-o", folder / "sq.ele", "--max-area", "1"}),
                 2, {"sq.node", "overwrite"});
  EXPECT_EQ(folder.read("sq.node"), nodes);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"sq.node", "sq.poly"}));
}

TEST(Constraints, WrongUseIsExplained) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n1,0\n0,1\n");
  const std::string poly = folder.write("frame.poly", frame);
  const std::string out = folder / "o.tri";
  expect_failure(run({"triangulate", points, "-o", out, "--keep-outside"}), 2,
                 {"--constraints"});
  expect_failure(run({"triangulate", poly, "--constraints", poly, "-o", out}), 2,
                 {".poly"});
  expect_failure(run({"triangulate", poly, "-o", folder / "o.adj"}), 2, {"neighbours"});
  expect_failure(run({"voronoi", poly, "-o", folder / "o.csv"}), 3,
                 {"frame.poly", "triangulate"});
}

TEST(Constraints, RingThatRepeatsItsFirstRowHasNoSegmentOfLengthZero) {
  const Folder folder;
  const std::string rings =
      folder.write("r.csv", "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,0\n");
  const Outcome outcome =
      run({"triangulate", rings, "--constraints", rings, "-o", folder / "r.tri"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("3 segments, 1 triangle in 1 region\n"), std::string::npos)
      << outcome.err;
}

TEST(Constraints, BadPolyFilesAreErrorsThatNameTheLine) {
  const Folder folder;
  const std::string out = folder / "o.tri";
  const std::string missing = folder.write("a.poly",
                                           "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n"
                                           "1 0\n1 1 9\n0\n");
  expect_failure(run({"triangulate", missing, "-o", out}), 3, {"a.poly", "line 6"});
  const std::string huge = folder.write("b.poly", "999999999999 2 0 0\n1 0 0\n");
  expect_failure(run({"triangulate", huge, "-o", out}), 3, {"b.poly", "line 1"});
  const std::string hole = folder.write(
      "c.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n1\n1 0.5 0\n");
  expect_failure(run({"triangulate", hole, "-o", out}), 3, {"c.poly", "hole 0"});
}

}  // namespace
}  // namespace delone::test
