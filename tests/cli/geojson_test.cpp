// --constraints with GeoJSON.

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
const std::string hole = "[[1,1],[1,3],[3,3],[3,1],[1,1]]";
const std::string points = "x,y\n0.5,0.7\n9,9\n2,2\n";

std::string feature(const std::string& type, const std::string& coordinates) {
  return R"({"type":"Feature","properties":{},"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (const std::string& each : features)
    text += (text.ends_with('[') ? "" : ",") + each;
  return text + "]}";
}

std::size_t num_triangles(const Folder& folder) {
  return lines(folder.read("o.tri")).size();
}

Outcome triangulated(const Folder& folder, const std::string& geojson,
                     const std::vector<std::string>& more = {},
                     const std::string& table = points) {
  std::vector<std::string> arguments{
      "triangulate",   folder.write("p.csv", table),      "-o", folder / "o.tri",
      "--constraints", folder.write("c.geojson", geojson)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

TEST(GeoJson, PolygonIsTheDomainWithoutItsHoles) {
  const Folder folder;
  const Outcome outcome =
      triangulated(folder, feature("Polygon", "[" + square + "," + hole + "]"));
  expect_success(outcome);
  EXPECT_EQ(num_triangles(folder), 10U);  // the frame and the point in it
  EXPECT_NE(outcome.err.find("2 rings"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("8 segments, 10 triangles in 1 region"), std::string::npos);
}

TEST(GeoJson, PolygonsThatShareASideAreOneDomain) {
  const Folder folder;
  expect_success(triangulated(
      folder, collection({feature("Polygon", "[[[0,0],[2,0],[2,4],[0,4],[0,0]]]"),
                          feature("Polygon", "[[[2,0],[4,0],[4,4],[2,4],[2,0]]]")})));
  EXPECT_EQ(num_triangles(folder), 8U);  // six corners, one of the points on the side
}

TEST(GeoJson, IslandInALakeIsPartOfTheDomain) {
  const Folder folder;
  const std::string island = "[[1.5,1.5],[2.5,1.5],[2.5,2.5],[1.5,2.5],[1.5,1.5]]";
  const Outcome outcome = triangulated(
      folder,
      feature("MultiPolygon", "[[" + square + "," + hole + "],[" + island + "]]"));
  expect_success(outcome);
  EXPECT_EQ(num_triangles(folder), 14U);
  EXPECT_NE(outcome.err.find("in 2 regions"), std::string::npos) << outcome.err;
}

TEST(GeoJson, LinesAmongPolygonsAreKeptAndEncloseNothing) {
  const Folder folder;
  const std::string ring_line = "[[1,1],[1,3],[3,3],[3,1],[1,1]]";
  const Outcome outcome = triangulated(
      folder, collection({feature("Polygon", "[" + square + "]"),
                          feature("LineString", ring_line),
                          feature("MultiLineString", "[[[0.2,0.5],[0.8,0.5]]]"),
                          feature("Point", "[7,7]")}));
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("1 ring, 2 lines; 1 point left out"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("repeated"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("9 segments"), std::string::npos) << outcome.err;
  // 4 corners on the hull and 8 inside: 2 * 12 - 2 - 4.
  EXPECT_EQ(num_triangles(folder), 18U);
  expect_success(run({"check", folder / "p.csv", folder / "o.tri", "--constraints",
                      folder / "c.geojson"}));
}

TEST(GeoJson, LinesAloneEncloseTheDomain) {
  const Folder folder;
  expect_success(triangulated(folder, feature("LineString", square)));
  EXPECT_EQ(num_triangles(folder), 6U);
  expect_success(triangulated(
      folder, feature("MultiLineString", "[[[0,0],[4,0],[4,4]],[[4,4],[0,4],[0,0]]]")));
  EXPECT_EQ(num_triangles(folder), 6U);
  expect_failure(triangulated(folder, feature("LineString", "[[0,0],[4,4]]")), 3,
                 {"c.geojson", "1 segment encloses", "--keep-outside"});
  expect_success(
      triangulated(folder, feature("LineString", "[[0,0],[4,4]]"), {"--keep-outside"}));
}

TEST(GeoJson, ClockwiseCoastOnTheGlobeIsTurned) {
  const Folder folder;
  const std::string globe =
      "lon,lat\n0,90\n0,-90\n0,0\n90,0\n180,0\n-90,0\n10,10\n12,11\n";
  const std::string east = "[[[5,5],[20,5],[20,20],[5,20],[5,5]]]";
  const std::string west = "[[[5,5],[5,20],[20,20],[20,5],[5,5]]]";
  expect_success(triangulated(folder, feature("Polygon", east), {}, globe));
  EXPECT_EQ(num_triangles(folder), 6U);
  expect_success(triangulated(folder, feature("Polygon", west), {}, globe));
  EXPECT_EQ(num_triangles(folder), 6U);
}

TEST(GeoJson, PolygonCutAtTheDateLineIsOneRegion) {
  const Folder folder;
  const std::string globe = "lon,lat\n179,3\n-178,4\n0,90\n0,-90\n0,0\n";
  const Outcome outcome =
      triangulated(folder,
                   feature("MultiPolygon",
                           "[[[[170,0],[180,0],[180,10],[170,10],[170,0]]],"
                           "[[[-180,0],[-170,0],[-170,10],[-180,10],[-180,0]]]]"),
                   {}, globe);
  expect_success(outcome);
  EXPECT_EQ(num_triangles(folder), 8U);  // six corners and two points inside
}

TEST(GeoJson, CrossingSegmentsAreNamedByTheirEnds) {
  const Folder folder;
  expect_failure(
      triangulated(folder, feature("MultiLineString", "[[[0,0],[4,4]],[[4,0],[0,4.5]]]")),
      3, {"c.geojson", "(0, 0) - (4, 4)", "(4, 0) - (0, 4.5)", "--split-intersections"});
}

TEST(GeoJson, MalformedFilesAreOneLineThatNamesThePlace) {
  const Folder folder;
  expect_failure(triangulated(folder, "{\n\"type\":\"Polygon\",,}"), 3,
                 {"c.geojson", "line 2, column 18"});
  expect_failure(triangulated(folder, ""), 3, {"c.geojson", "line 1"});
  expect_failure(triangulated(folder, feature("Polygon", "[[[0,0],[1,0],[0,1]]]")), 3,
                 {"c.geojson", "repeat its first position"});
  expect_failure(triangulated(folder, feature("Point", "[1,2]")), 3,
                 {"c.geojson", "1 point", "LineStrings"});
  expect_failure(triangulated(folder, feature("Polygon", "[]")), 3, {"c.geojson"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o.tri"));
}

TEST(GeoJson, IsNoTableOfPoints) {
  const Folder folder;
  const std::string file = folder.write("c.geojson", feature("Point", "[1,2]"));
  expect_failure(run({"triangulate", file, "-o", folder / "o.tri"}), 3,
                 {"c.geojson", "--constraints"});
}

TEST(GeoJson, CoastsOfTheWorldAreTriangulatedAndChecked) {
  const std::string coast = DELONE_SHARED_DATA_DIR "/coast/gshhg_low.csv";
  if (!std::filesystem::exists(coast)) GTEST_SKIP() << "no " << coast;
  // Land and its lakes (levels 1 and 2) of some polygons as GeoJSON.
  std::string features;
  std::string id, ring, first;
  const auto flush = [&] {
    if (!ring.empty())
      features += (features.empty() ? "" : ",") +
                  feature("Polygon", "[[" + ring + "," + first + "]]");
    ring.clear();
  };
  for (const std::string& line : lines(read_file(coast))) {
    const std::size_t a = line.find(','), b = line.find(',', a + 1),
                      c = line.find(',', b + 1);
    const std::string number = line.substr(0, a);
    if (number == "polygon_id" || number == "4") continue;  // Antarctica is no ring
    const std::string level = line.substr(a + 1, b - a - 1);
    if (number != id) flush();
    id = number;
    if (level != "1" && level != "2") continue;
    const std::string position = "[" + line.substr(c + 1) + "]";
    if (ring.empty()) first = position;
    ring += (ring.empty() ? "" : ",") + position;
  }
  flush();
  const Folder folder;
  expect_success(triangulated(
      folder, R"({"type":"FeatureCollection","features":[)" + features + "]}", {},
      "lon,lat\n0,90\n0,-90\n0,0\n90,0\n180,0\n-90,0\n"));
  EXPECT_GT(num_triangles(folder), 30000U);
  expect_success(run({"check", folder / "p.csv", folder / "o.tri", "--constraints",
                      folder / "c.geojson"}));
}

}  // namespace
}  // namespace delone::test
