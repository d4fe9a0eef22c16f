// check of triangulations with segments.

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/process.hpp"

namespace delone::test {
namespace {

/// A square of side 4 with a square hole of side 2; vertices count from 1.
const std::string frame =
    "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n"
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n";

TEST(CheckConstrained, PolyFileAndItsElements) {
  const Folder folder;
  const std::string poly = folder.write("f.poly", frame);
  expect_success(run({"triangulate", poly, "-o", folder / "f.ele"}));
  const Outcome outcome = run({"check", poly, folder / "f.ele", "--timings"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("\"points\":8,"), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with(
      "constrained Delaunay: 8 triangles with 8 constrained edges over 8 points\nhash: "))
      << outcome.out;
  // The same triangles are not those of the hull, nor Delaunay.
  expect_failure(run({"check", poly, folder / "f.ele", "--keep-outside"}), 1, {"f.ele"});
}

TEST(CheckConstrained, NamesTheFirstDefect) {
  const Folder folder;
  const std::string poly =
      folder.write("q.poly", "4 2 0 0\n0 0 0\n1 4 -1\n2 8 0\n3 4 1\n1 0\n0 0 2\n0\n");
  const std::string crossed = folder.write("crossed.tri", "0 1 3\n1 2 3\n");
  const Outcome outcome = run({"check", poly, crossed, "--keep-outside"});
  expect_failure(outcome, 1, {"crossed.tri", "constrained", "(2, 0)", "segment"});
  EXPECT_TRUE(outcome.out.starts_with("not constrained Delaunay: ")) << outcome.out;
  const std::string right = folder.write("right.tri", "0 1 2\n0 2 3\n");
  expect_success(run({"check", poly, right, "--keep-outside"}));
}

TEST(CheckConstrained, TableOfPointsWithRingsNumbersVerticesAfterDataRows) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0.5,0.75\nbad,1\n9,9\n2,2\n");
  const std::string rings = folder.write(
      "r.csv", "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,4\n2,1,1\n2,3,1\n2,3,3\n2,1,3\n");
  for (const char* name : {"t.tri", "t.ele", "t.off"}) {
    std::vector<std::string> arguments{"triangulate",    points,          "-o",
                                       folder / name,    "--constraints", rings,
                                       "--skip-bad-rows"};
    expect_success(run(arguments));
    expect_success(
        run({"check", points, folder / name, "--constraints", rings, "--skip-bad-rows"}));
  }
  const std::string bad = folder.write("bad.tri", "0 1 4\n");
  expect_failure(run({"check", points, bad, "--constraints", rings, "--skip-bad-rows"}),
                 1, {"bad.tri", "row 1", "no position"});
}

TEST(CheckConstrained, CrossingsThatWereSplitAreThoseOfTheSameOption) {
  const Folder folder;
  const std::string poly = folder.write(
      "c.poly", "4 2 0 0\n1 0 0\n2 2 2\n3 2 0\n4 0 2\n2 0\n1 1 2\n2 3 4\n0\n");
  expect_success(run({"triangulate", poly, "-o", folder / "c.tri",
                      "--split-intersections", "--keep-outside"}));
  expect_success(
      run({"check", poly, folder / "c.tri", "--split-intersections", "--keep-outside"}));
  expect_failure(run({"check", poly, folder / "c.tri", "--keep-outside"}), 3,
                 {"c.poly", "--split-intersections"});
}

TEST(CheckConstrained, WorksOnTheGlobe) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat\n0,90\n0,-90\n0,0\n90,0\n180,0\n-90,0\n");
  const std::string rings =
      folder.write("r.csv", "ring,lon,lat\n1,0,60\n1,90,60\n1,180,60\n1,-90,60\n");
  expect_success(
      run({"triangulate", points, "-o", folder / "t.tri", "--constraints", rings}));
  expect_success(run({"check", points, folder / "t.tri", "--constraints", rings}));
  expect_failure(
      run({"check", points, folder / "t.tri", "--constraints", rings, "--outside=10/85"}),
      1, {"t.tri"});
}

TEST(CheckConstrained, RefinedMeshIsThatOfItsPolyFile) {
  const Folder folder;
  // Sides of no simple slope, so that added points are rounded off them.
  const std::string poly = folder.write(
      "k.poly",
      "6 2 0 0\n1 0 0\n2 3.1 0.7\n3 1.3 3.3\n4 1.1 0.9\n5 1.7 1.1\n6 1.3 1.6\n"
      "6 0\n1 1 2\n2 2 3\n3 3 1\n4 4 5\n5 5 6\n6 6 4\n1\n1 1.35 1.2\n");
  for (const char* name : {"k.1.ele", "k.1.poly"})
    expect_success(run({"triangulate", poly, "-o", folder / name, "--min-angle", "25",
                        "--max-area", "0.05"}));
  EXPECT_EQ(lines(folder.read("k.1.poly"))[1].substr(0, 2), "1 ");
  expect_success(run({"check", folder / "k.1.poly", folder / "k.1.ele"}));
  expect_failure(run({"triangulate", folder / "k.1.node", "-o", folder / "x.poly"}), 2,
                 {".poly", "--constraints"});
}

TEST(CheckConstrained, OptionsOfSegmentsNeedSegments) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n1,0\n0,1\n");
  const std::string triangles = folder.write("t.tri", "0 1 2\n");
  expect_failure(run({"check", points, triangles, "--keep-outside"}), 2,
                 {"--constraints"});
}

TEST(CheckConstrained, PolygonsOfOtherProgramsPass) {
  const std::string folder_name = DELONE_SHARED_DATA_DIR "/pslg/";
  if (!std::filesystem::exists(folder_name)) GTEST_SKIP() << "no " << folder_name;
  const Folder folder;
  for (const char* name : {"guitar", "blobs", "lakes_michigan_huron", "africa_lakes"}) {
    const std::string poly = folder_name + name + ".poly";
    expect_success(run({"triangulate", poly, "-o", folder / "t.ele"}));
    expect_success(run({"check", poly, folder / "t.ele"}));
    expect_success(run({"triangulate", poly, "-o", folder / "h.ele", "--keep-outside"}));
    expect_success(run({"check", poly, folder / "h.ele", "--keep-outside"}));
    expect_failure(run({"check", poly, folder / "t.ele", "--keep-outside"}), 1,
                   {"t.ele"});
  }
}

}  // namespace
}  // namespace delone::test
