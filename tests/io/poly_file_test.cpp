#include "io/poly_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using Segments = std::vector<std::array<std::int32_t, 2>>;

const std::string square = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";

PolyFile read(std::string_view content) {
  const TemporaryFolder folder;
  return read_poly(folder.put("a.poly", content));
}

std::string complaint(std::string_view content) {
  const std::string message = message_of<ReadError>([&] { return read(content); });
  const std::size_t at = message.find("a.poly");
  return at == std::string::npos ? message : message.substr(at);
}

TEST(ReadPoly, ReadsPointsSegmentsHolesAndRegions) {
  const PolyFile file = read(square +
                             "3 1\n1 1 2 7\n2 2 3 -7\n3 3 1 0\n1\n1 0.5 0.25\n"
                             "2\n1 0.1 0.2 5 0.01\n2 0.3 0.4 6\n");
  EXPECT_EQ(file.graph.points.size(), 4U);
  EXPECT_EQ(file.graph.points[2], (tripack::Point2{1, 1}));
  EXPECT_EQ(file.graph.segments, (Segments{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(file.segment_markers, (std::vector<std::int32_t>{7, -7, 0}));
  EXPECT_EQ(file.segment_lines, (std::vector<std::int64_t>{7, 8, 9}));
  ASSERT_EQ(file.graph.holes.size(), 1U);
  EXPECT_EQ(file.graph.holes[0], (tripack::Point2{0.5, 0.25}));
  ASSERT_EQ(file.graph.regions.size(), 2U);
  EXPECT_EQ(file.graph.regions[0].attribute, 5);
  EXPECT_EQ(file.graph.regions[0].max_area, 0.01);
  EXPECT_EQ(file.graph.regions[1].attribute, 6);
  EXPECT_EQ(file.graph.regions[1].max_area, 0);
  EXPECT_EQ(file.nodes.base, 1);
  EXPECT_EQ(file.node_path, "");
}

TEST(ReadPoly, TakesPointsFromTheNodeFileOfTheSameName) {
  const TemporaryFolder folder;
  folder.put("b.node", "# nodes\n3 2 1 1\n0 0 0 5 1\n1 1 0 6 1\n2 0 1 7 1\n");
  const std::string path =
      folder.put("b.poly", "# of b.node\n0 2 1 1\n1 0\n0 0 2 # one\n0\n");
  const PolyFile file = read_poly(path);
  EXPECT_EQ(file.graph.points.size(), 3U);
  EXPECT_EQ(file.graph.segments, (Segments{{0, 2}}));
  EXPECT_EQ(file.nodes.attributes.at(0), (std::vector<double>{5, 6, 7}));
  EXPECT_EQ(file.node_path, folder.path("b.node"));
}

TEST(ReadPoly, NamesTheNodeFileThatIsNotThere) {
  EXPECT_NE(
      message_of<ReadError>([] { return read("0 2 0 0\n0 0\n0\n"); }).find("a.node"),
      std::string::npos);
}

TEST(ReadPoly, PartsAfterTheSegmentsMayBeMissing) {
  EXPECT_EQ(read(square + "1 0\n1 1 3\n").graph.segments.size(), 1U);
  EXPECT_EQ(read(square + "0 0\n0\n").graph.segments.size(), 0U);
}

TEST(ReadPoly, CountsSegmentsHolesAndRegionsFromZeroOrOne) {
  EXPECT_EQ(read(square + "1 0\n0 1 3\n1\n0 9 9\n").graph.holes.size(), 1U);
}

TEST(ReadPoly, NamesTheLineOfWhatIsWrong) {
  EXPECT_NE(complaint(square + "1 0\n1 1 5\n0\n").find("line 7"), std::string::npos);
  EXPECT_NE(complaint(square + "1 0\n1 0 2\n0\n").find("line 7"), std::string::npos);
  EXPECT_NE(complaint(square + "1 0\n2 1 2\n0\n").find("segment number 2 where 1"),
            std::string::npos);
  EXPECT_NE(complaint(square + "2 0\n1 1 2\n1 1 3\n").find("segment number 1 where 2"),
            std::string::npos);
  EXPECT_NE(complaint(square + "1 3\n1 1 2\n").find("line 6"), std::string::npos);
  EXPECT_NE(complaint(square + "1 0\n1 1 x\n").find("line 7"), std::string::npos);
  EXPECT_NE(complaint(square + "0 0\n1\n1 nan 2\n").find("line 8"), std::string::npos);
  EXPECT_NE(complaint(square + "0 0\n0\n1\n1 0 0 1 inf\n").find("line 9"),
            std::string::npos);
  EXPECT_NE(complaint(square + "0 0\n0\n0\n7\n").find("line 9"), std::string::npos);
}

TEST(ReadPoly, BelievesNoCountThatTheFileCannotHold) {
  EXPECT_NE(complaint("99999999999 2 0 0\n1 0 0\n").find("line 1"), std::string::npos);
  EXPECT_NE(complaint(square + "999999999 0\n1 1 2\n").find("line 6"), std::string::npos);
  EXPECT_NE(complaint(square + "0 0\n999999999\n").find("line 7"), std::string::npos);
  EXPECT_NE(complaint(square + "0 0\n0\n999999999\n").find("line 8"), std::string::npos);
  EXPECT_NE(complaint(square + "-1 0\n").find("line 6"), std::string::npos);
}

TEST(ReadPoly, FileThatEndsTooSoonIsAnError) {
  const std::string whole = square + "1 1\n1 1 2 7\n1\n1 0.5 0.25\n1\n1 0.1 0.2 5 0.25\n";
  EXPECT_EQ(complaint(whole), "nothing thrown");
  EXPECT_NE(complaint(square), "nothing thrown");
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, square.size() - 3}) {
    EXPECT_NE(complaint(whole.substr(0, size)), "nothing thrown") << size;
  }
}

TEST(WritePoly, IsReadBackAsItWas) {
  const TemporaryFolder folder;
  for (const std::string markers : {"", " 7"}) {
    for (const int base : {0, 1}) {
      PolyFile file = read("3 2 1 1\n1 0 0.1 5 -1\n2 1e-300 0 6 0\n3 0 1 7 2\n2 " +
                           std::string(markers.empty() ? "0" : "1") + "\n1 1 2" +
                           markers + "\n2 3 1" + markers +
                           "\n1\n1 0.5 0.25\n2\n1 0.1 0.2 5 0.01\n2 0.3 0.4 6\n");
      file.nodes.base = base;
      write_poly(folder.path("w.poly"), file);
      const PolyFile again = read_poly(folder.path("w.poly"));
      EXPECT_EQ(again.nodes.base, base);
      EXPECT_EQ(again.nodes.x, file.nodes.x);
      EXPECT_EQ(again.nodes.attributes, file.nodes.attributes);
      EXPECT_EQ(again.nodes.markers, file.nodes.markers);
      EXPECT_EQ(again.graph.points, file.graph.points);
      EXPECT_EQ(again.graph.segments, file.graph.segments);
      EXPECT_EQ(again.segment_markers, file.segment_markers);
      EXPECT_EQ(again.graph.holes, file.graph.holes);
      ASSERT_EQ(again.graph.regions.size(), 2U);
      EXPECT_EQ(again.graph.regions[0].max_area, 0.01);
      EXPECT_EQ(again.graph.regions[1].attribute, 6);
    }
  }
}

TEST(WritePoly, RefusesSegmentsWithoutTheirNode) {
  const TemporaryFolder folder;
  PolyFile file = read(square + "1 0\n1 1 2\n0\n");
  file.graph.segments.push_back({0, 4});
  EXPECT_NE(message_of<Error>([&] {
              write_poly(folder.path("w.poly"), file);
            }).find("segment 1 ends at row 4"),
            std::string::npos);
  file.graph.segments.pop_back();
  file.segment_markers = {1, 2};
  EXPECT_NE(
      message_of<Error>([&] { write_poly(folder.path("w.poly"), file); }).find("marker"),
      std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace delone::io
