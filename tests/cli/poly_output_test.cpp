// triangulate -o X.poly: the domain as segments and holes, whatever gave it.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string points = "x,y\n0.5,0.5\n9,9\n2,2\n3.5,2\n";
const std::string nested =
    "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,4\n1,0,0\n2,1,1\n2,3,1\n2,3,3\n2,1,3\n";
const std::string globe =
    "lon,lat\n0,90\n0,-90\n0,0\n90,0\n180,0\n-90,0\n10,75\n50,-20\n";

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The lines behind the segments of a .poly file.
std::vector<std::string> holes_of(const std::string& poly) {
  const auto all = lines(poly);
  const auto count = [&](std::size_t i) { return std::stoul(all.at(i)); };
  const std::size_t segments = 1 + count(0);
  return {all.begin() + static_cast<long>(segments + 1 + count(segments)), all.end()};
}

/// Writes the domain as o.poly and as triangles, and expects o.poly to give the same
/// triangles and to be what the triangles are checked against.
void expect_same_domain(const Folder& folder, const Arguments& input,
                        const Arguments& read_options = {}) {
  for (const char* name : {"o.tri", "o.poly"})
    expect_success(run(Arguments{"triangulate", "-o", folder / name} + input));
  const std::string poly = folder / "o.poly";
  expect_success(
      run(Arguments{"triangulate", poly, "-o", folder / "again.tri"} + read_options));
  EXPECT_EQ(folder.read("again.tri"), folder.read("o.tri"));
  expect_success(run(Arguments{"check", poly, folder / "o.tri"} + read_options));
}

TEST(PolyOutput, OfRingsNamesTheirHolesByPoints) {
  const Folder folder;
  const std::string table = folder.write("p.csv", points);
  const std::string rings = folder.write("r.csv", nested);
  expect_same_domain(folder, {table, "--constraints", rings});
  const auto holes = holes_of(folder.read("o.poly"));
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0], "1");
  std::istringstream hole(holes[1]);
  double number = 0, x = 0, y = 0;
  hole >> number >> x >> y;
  EXPECT_EQ(number, 0);
  EXPECT_TRUE(x > 1 && x < 3 && y > 1 && y < 3) << holes[1];
}

TEST(PolyOutput, OfIslandsInLakesInIslandsKeepsThem) {
  const Folder folder;
  std::string rings = "ring,x,y\n";
  for (int i = 1; i <= 5; ++i)
    for (const char* corner : {"-1,-1", "1,-1", "1,1", "-1,1"}) {
      const std::string text = corner;
      const std::size_t comma = text.find(',');
      rings += std::to_string(i) + "," +
               std::to_string(2 + i * std::stoi(text.substr(0, comma))) + "," +
               std::to_string(2 + i * std::stoi(text.substr(comma + 1))) + "\n";
    }
  expect_same_domain(folder, {folder.write("p.csv", points), "--constraints",
                              folder.write("r.csv", rings)});
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "2");
}

TEST(PolyOutput, OfRefinedRingsIsTheirRefinedMesh) {
  const Folder folder;
  const std::string rings = folder.write(
      "r.csv",
      "ring,x,y\n1,0,0\n1,3.1,0.7\n1,1.3,3.3\n2,1.1,0.9\n2,1.7,1.1\n2,1.3,1.6\n");
  for (const char* name : {"m.ele", "m.poly"})
    expect_success(run({"triangulate", rings, "--constraints", rings, "-o", folder / name,
                        "--min-angle", "25", "--max-area", "0.05"}));
  expect_success(run({"check", folder / "m.poly", folder / "m.ele"}));
  EXPECT_EQ(holes_of(folder.read("m.poly"))[0], "1");
}

TEST(PolyOutput, OfRingsThatCrossHasTheirCrossings) {
  const Folder folder;
  const std::string rings = folder.write(
      "r.csv", "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,4\n2,2,2\n2,6,2.5\n2,6,6\n2,2,6\n");
  expect_same_domain(folder, {folder.write("p.csv", points), "--constraints", rings,
                              "--split-intersections"});
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "1");  // where both rings lie
}

TEST(PolyOutput, OfGeoJsonLeavesOutWhatItsPolygonsLeaveOut) {
  const Folder folder;
  const std::string geojson = folder.write("c.geojson",
                                           R"({"type":"GeometryCollection","geometries":[
{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]],
                                 [[1,1],[1,3],[3,3],[3,1],[1,1]]]},
{"type":"Polygon","coordinates":[[[4,0],[6,0],[6,4],[4,4],[4,0]]]},
{"type":"LineString","coordinates":[[7,0],[8,0],[8,1],[7,0]]},
{"type":"LineString","coordinates":[[0.2,0.5],[0.2,3]]}]})");
  expect_same_domain(folder, {folder.write("p.csv", points), "--constraints", geojson});
  // The hole of the first polygon, and what the closed line encloses, which is outside.
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "2");
  const std::string lines_only = folder.write(
      "l.geojson",
      R"({"type":"LineString","coordinates":[[0,0],[4,0],[4,4],[0,4],[0,0]]})");
  expect_same_domain(folder,
                     {folder.write("p.csv", points), "--constraints", lines_only});
  EXPECT_EQ(holes_of(folder.read("o.poly")), std::vector<std::string>{"0"});
}

TEST(PolyOutput, OnTheGlobeHoldsWhatOutsideOrTheSenseOfRingsLeftOut) {
  const Folder folder;
  const std::string table = folder.write("p.csv", globe);
  const std::string rings = folder.write(
      "r.csv",
      "ring,lon,lat\n1,0,60\n1,90,60\n1,180,60\n1,-90,60\n2,0,70\n2,90,70\n2,180,70\n2,-"
      "90,70\n");
  const Arguments input = {table, "--constraints", rings};
  expect_same_domain(folder, input, {"--on", "sphere"});
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "2");  // the cap and all the south
  expect_same_domain(folder, input + Arguments{"--outside=100/64"}, {"--on", "sphere"});
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "1");
}

TEST(PolyOutput, OfAPolyFileWithOutsideNeedsNoneAnyMore) {
  const Folder folder;
  const std::string poly = folder.write(
      "g.poly",
      "8 2 0 0\n1 0 60\n2 90 60\n3 180 60\n4 -90 60\n5 0 90\n6 0 -90\n7 45 0\n8 -120 0\n"
      "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Arguments on_sphere = {"--on", "sphere"};
  for (const char* name : {"o.poly", "o.ele"})
    expect_success(
        run(Arguments{"triangulate", poly, "-o", folder / name, "--outside=10/80"} +
            on_sphere));
  expect_success(
      run(Arguments{"check", folder / "o.poly", folder / "o.ele"} + on_sphere));
  EXPECT_EQ(holes_of(folder.read("o.poly"))[0], "1");
}

TEST(PolyOutput, OfTheWholeHullHasNoHoles) {
  const Folder folder;
  const std::string table = folder.write("p.csv", points);
  const std::string rings = folder.write("r.csv", nested);
  expect_same_domain(folder, {table, "--constraints", rings, "--keep-outside"},
                     {"--keep-outside"});
  EXPECT_EQ(holes_of(folder.read("o.poly")), std::vector<std::string>{"0"});
}

TEST(PolyOutput, HoleWithoutRoomForAPointIsOneLine) {
  const Folder folder;
  const std::string rings =
      folder.write("r.csv",
                   "ring,x,y\n1,0,0\n1,4,0\n1,4,4\n1,0,4\n2,1,1\n2,1.0000000000000002,1\n"
                   "2,1,1.0000000000000002\n");
  const Arguments input = {folder.write("p.csv", points), "--constraints", rings};
  expect_failure(run(Arguments{"triangulate", "-o", folder / "o.poly"} + input), 3,
                 {"r.csv", "hole", "narrow"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o.poly"));
  expect_success(run(Arguments{"triangulate", "-o", folder / "o.ele"} + input));
}

}  // namespace
}  // namespace delone::test
