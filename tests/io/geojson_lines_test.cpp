#include "io/geojson_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "io/mesh.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using Rings = std::vector<PlaneRing>;

GeoJsonLines read(std::string_view content) {
  const TemporaryFolder folder;
  return read_geojson_lines(folder.put("a.geojson", content));
}

std::string complaint(std::string_view content) {
  const std::string message = message_of<ReadError>([&] { return read(content); });
  const std::size_t at = message.find("a.geojson");
  return at == std::string::npos ? message : message.substr(at);
}

void expect_complaint(std::string_view content, std::string_view words) {
  const std::string message = complaint(content);
  EXPECT_NE(message.find("a.geojson: line "), std::string::npos) << message;
  EXPECT_NE(message.find(words), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(message.size(), 400U);
}

const PlaneRing square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const PlaneRing hole = {{1, 1}, {1, 3}, {3, 3}, {3, 1}};  // clockwise
const std::string square_text = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
const std::string hole_text = "[[1,1],[1,3],[3,3],[3,1],[1,1]]";

std::string geometry(const std::string& type, const std::string& coordinates) {
  return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
}

TEST(ReadGeoJson, ReadsEveryGeometryWithLines) {
  const PlaneRing line = {{1.5, 2}, {-3e2, 4}};
  EXPECT_EQ(read(geometry("LineString", "[[1.5,2],[-3e2,4]]")).lines, (Rings{line}));
  EXPECT_EQ(
      read(geometry("MultiLineString", "[[[1.5,2],[-3e2,4]],[[1.5,2],[-3e2,4]]]")).lines,
      (Rings{line, line}));
  EXPECT_EQ(read(geometry("Polygon", "[" + square_text + "," + hole_text + "]")).rings,
            (Rings{square, hole}));
  EXPECT_EQ(read(geometry("MultiPolygon", "[[" + square_text + "," + hole_text + "],[" +
                                              square_text + "]]"))
                .rings,
            (Rings{square, hole, square}));
  EXPECT_EQ(read(geometry("MultiPoint", "[[1,2],[3,4]]")).num_points, 2);
  EXPECT_EQ(read(geometry("Point", "[1,2]")).num_points, 1);
}

TEST(ReadGeoJson, ReadsFeaturesAndCollectionsOfAnyNesting) {
  const std::string line = geometry("LineString", "[[0,0],[1,1]]");
  const std::string collection =
      R"({"type":"GeometryCollection","geometries":[)" + line + "," + line + "]}";
  const std::string feature =
      R"({"type":"Feature","id":7,"properties":null,"geometry":)" + collection + "}";
  const auto file =
      read(R"({"type":"FeatureCollection","bbox":[0,0,1,1],"features":[)" + feature +
           R"(,{"type":"Feature","properties":{},"geometry":null},)" + feature + "]}");
  EXPECT_EQ(file.lines.size(), 4U);
  EXPECT_TRUE(file.rings.empty());
}

TEST(ReadGeoJson, TakesMembersInAnyOrderAndPassesOverForeignOnes) {
  const auto file = read(
      R"({"properties":{"type":"Polygon","coordinates":[[["x",{}]]],"features":7,
          "geometry":[1,[2,[3,[4,[5,[6]]]]]]},
          "geometry":{"coordinates":[[0,0,17,18],[1,1,-5]],"x":[{}],"type":"LineString"},
          "type":"Feature"})");
  EXPECT_EQ(file.lines, (Rings{{{0, 0}, {1, 1}}}));
}

TEST(ReadGeoJson, TurnsOutlinesCounterClockwiseAndHolesClockwise) {
  const std::string clockwise = "[[0,0],[0,4],[4,4],[4,0],[0,0]]";
  const std::string left_hole = "[[1,1],[3,1],[3,3],[1,3],[1,1]]";
  const auto file = read(geometry(
      "MultiPolygon", "[[" + clockwise + "," + left_hole + "],[" + clockwise + "]]"));
  const PlaneRing turned = {{4, 0}, {4, 4}, {0, 4}, {0, 0}};
  EXPECT_EQ(file.rings, (Rings{turned, {{1, 3}, {3, 3}, {3, 1}, {1, 1}}, turned}));
}

TEST(ReadGeoJson, ReadsWhatWriteMeshWrites) {
  const TemporaryFolder folder;
  const Mesh mesh = triangle_mesh(Mesh::Space::plane, std::vector{0.0, 1.0, 0.1},
                                  std::vector{0.0, 0.3, 1.0},
                                  std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}});
  write_mesh(folder.path("m.geojson"), mesh);
  const PlaneRing triangle = {{0, 0}, {1, 0.3}, {0.1, 1}};
  EXPECT_EQ(read_geojson_lines(folder.path("m.geojson")).rings,
            (Rings{triangle, triangle}));
}

TEST(ReadGeoJson, EmptyGeometriesHoldNothing) {
  for (const char* type : {"LineString", "MultiLineString", "Polygon", "MultiPolygon"}) {
    for (const char* coordinates : {"[]", "[[]]"}) {
      const auto file = read(geometry(type, coordinates));
      EXPECT_TRUE(file.lines.empty() && file.rings.empty()) << type;
    }
  }
  EXPECT_TRUE(read(R"({"type":"FeatureCollection","features":[]})").lines.empty());
}

TEST(ReadGeoJson, NamesLineAndColumnOfWhatIsNoJson) {
  expect_complaint("", "line 1, column 1");
  expect_complaint("{\n\"type\":\n  nan}", "line 3, column 4");
  expect_complaint(geometry("LineString", "[[0,0],[1,1]"), "no valid JSON");
  expect_complaint(geometry("LineString", "[[0,0],[1,1e999]]"), "no valid JSON");
  expect_complaint(geometry("LineString", "[[0,0],[1,NaN]]"), "no valid JSON");
  expect_complaint(geometry("LineString", "[[0,0],[1,1]]") + "x", "no valid JSON");
  expect_complaint("{\"type\":\"" + std::string(100000, 'x'), "no valid JSON");
  expect_complaint(std::string("\0\x01\xff{}", 5), "no valid JSON");
  expect_complaint("x,y\n1,2\n", "no valid JSON");
}

TEST(ReadGeoJson, NamesWhatIsNoGeoJson) {
  expect_complaint("[]", "an object");
  expect_complaint("7", "an object");
  expect_complaint("{}", "without a type");
  expect_complaint(R"({"type":"Topology","arcs":[]})", "'Topology'");
  expect_complaint(R"({"type":7})", "the type is a word");
  expect_complaint(R"({"type":"Polygon"})", "without coordinates");
  expect_complaint(R"({"type":"FeatureCollection","features":[[]]})", "are objects");
  expect_complaint(R"({"type":"FeatureCollection","features":{}})", "cannot be");
  expect_complaint(R"({"type":"Feature","geometry":[1]})", "cannot be");
}

TEST(ReadGeoJson, NamesCoordinatesThatDoNotSuitTheirType) {
  expect_complaint(geometry("LineString", "[0,0]"), "2 arrays deep");
  expect_complaint(geometry("Polygon", "[[0,0],[4,0],[4,4],[0,0]]"), "3 arrays deep");
  expect_complaint(geometry("LineString", "[[0,0],[1]]"), "two numbers");
  expect_complaint(geometry("LineString", "[[0,0],[1,\"2\"]]"), "not text");
  expect_complaint(geometry("LineString", "[[0,0],[1,null]]"), "not null");
  expect_complaint(geometry("LineString", "[[0,0],[1,{}]]"), "not an object");
  expect_complaint(geometry("LineString", "[[0,0],[1,2,[3]]]"), "mixed");
  expect_complaint(geometry("LineString", "[[0,0],1]"), "mixed");
  expect_complaint(geometry("LineString", "[[[[[0]]]]]"), "four arrays deep");
  expect_complaint(geometry("LineString", "[[7,8]]"), "(7, 8)");
  expect_complaint(geometry("LineString", "7"), "cannot be");
  expect_complaint(geometry("Polygon", "[[[0,0],[1,0],[0,1]]]"), "repeat its first");
  expect_complaint(geometry("Polygon", "[[[0,0],[1,0],[0,0]]]"), "four or more");
}

TEST(ReadGeoJson, DepthCostsNoStackAndHasALimitWhereItMatters) {
  constexpr std::size_t depth = 1000000;
  std::string deep = R"({"x":)" + std::string(depth, '[') + std::string(depth, ']') +
                     R"(,"type":"LineString","coordinates":[[0,0],[1,1]]})";
  EXPECT_EQ(read(deep).lines.size(), 1U);
  deep.clear();
  for (std::size_t i = 0; i < depth; ++i)
    deep += R"({"type":"GeometryCollection","geometries":[)";
  expect_complaint(deep, "100 deep");
  expect_complaint(std::string(depth, '['), "an object");
  expect_complaint(R"({"type":"Polygon","coordinates":)" + std::string(depth, '['),
                   "four arrays deep");
}

TEST(ReadGeoJson, EveryFileCutShortIsAnError) {
  const std::string whole = geometry("Polygon", "[" + square_text + "]");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(complaint(whole.substr(0, size)), "nothing thrown") << size;
}

TEST(ReadGeoJson, NamesTheFileThatIsNotThere) {
  EXPECT_NE(message_of<ReadError>([] {
              static_cast<void>(read_geojson_lines("/nowhere/a.geojson"));
            }).find("/nowhere/a.geojson"),
            std::string::npos);
}

}  // namespace
}  // namespace delone::io
