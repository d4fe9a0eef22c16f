// Mesh files where points are asked for.

#include <gtest/gtest.h>

#include <string>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// A unit square and a point above it.
std::string house(const std::string& triangles) {
  return "OFF\n5 3 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 2 0\n" + triangles;
}

class MeshPoints : public testing::TestWithParam<const char*> {};

TEST_P(MeshPoints, AreCheckedWithTheirOwnTriangles) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(60, 3));
  const std::string mesh = folder / ("t." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", mesh}));
  const Outcome alone = run({"check", mesh}), with_points = run({"check", points, mesh});
  expect_success(alone);
  EXPECT_EQ(alone.out, with_points.out);
}

TEST_P(MeshPoints, GiveTheTrianglesOfTheirTable) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(60, 3));
  const std::string mesh = folder / ("t." + std::string(GetParam()));
  expect_success(run({"triangulate", points, "-o", mesh}));
  expect_success(run({"triangulate", points, "-o", folder / "a.tri"}));
  expect_success(run({"triangulate", mesh, "-o", folder / "b.tri"}));
  EXPECT_EQ(folder.read("a.tri"), folder.read("b.tri"));
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshPoints, testing::Values("off", "ply", "vtu", "nc"),
                         [](const auto& format) { return std::string(format.param); });

TEST(MeshAsPoints, OfUgridOnTheGlobeAreCheckedToo) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat\n0,0\n90,0\n180,0\n-90,0\n0,90\n0,-90\n30,40\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.nc"}));
  expect_success(run({"check", folder / "t.nc"}));
  expect_success(run({"triangulate", points, "-o", folder / "t.vtu"}));
  expect_failure(run({"check", folder / "t.vtu"}), 3, {"t.vtu", "unit vectors"});
}

TEST(MeshAsPoints, WithAnEdgeTheWrongWayAreNotDelaunay) {
  const Folder folder;
  const std::string right =
      folder.write("right.off", house("3 0 1 2\n3 0 2 3\n3 2 4 3\n"));
  const std::string wrong =
      folder.write("wrong.off", house("3 0 1 4\n3 1 2 4\n3 0 4 3\n"));
  expect_success(run({"check", right}));
  expect_failure(run({"check", wrong}), 1, {"wrong.off", "is not a Delaunay"});
}

TEST(MeshAsPoints, OfCellsWithFourCornersAreRefusedByCheck) {
  const Folder folder;
  const std::string mesh =
      folder.write("quad.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n");
  expect_failure(run({"check", mesh}), 3, {"quad.off"});
}

TEST(MeshAsPoints, HaveNoColumnsAndNoValues) {
  const Folder folder;
  const std::string mesh = folder.write("m.off", house("3 0 1 2\n3 0 2 3\n3 2 4 3\n"));
  expect_failure(run({"info", mesh, "--x", "1"}), 2, {"m.off", "mesh"});
  expect_failure(run({"grid", mesh, "-o", folder / "g.csv"}), 3, {"m.off", "no values"});
}

TEST(MeshAsPoints, AreNamedByNode) {
  const Folder folder;
  const std::string mesh =
      folder.write("m.off", "OFF\n4 2 0\n0 0 0\n2 0 0\n2 1 0\n0 0 0\n3 0 1 2\n3 3 1 2\n");
  expect_failure(
      run({"triangulate", mesh, "-o", folder / "t.tri", "--duplicates", "error"}), 3,
      {"m.off: node"});
}

TEST(Check, NeedsTrianglesForATable) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(6, 3));
  expect_failure(run({"check", points}), 2, {"TRIANGLES is required"});
}

}  // namespace
}  // namespace delone::test
