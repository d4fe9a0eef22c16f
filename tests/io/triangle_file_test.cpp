#include "io/triangle_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::message_of;
using test::TemporaryFolder;
using Triangles = std::vector<Triangle>;

const Triangles square = {{0, 1, 2}, {0, 2, 3}};

TriangleFile read(const std::string& name, std::string_view content,
                  std::int64_t num_nodes) {
  const TemporaryFolder folder;
  return read_triangles(folder.put(name, content), num_nodes);
}

std::string complaint(const std::string& name, std::string_view content,
                      std::int64_t num_nodes) {
  const std::string message =
      message_of<ReadError>([&] { return read(name, content, num_nodes); });
  const std::size_t at = message.find(name);
  return at == std::string::npos ? message : message.substr(at);
}

TEST(WriteTriangles, WritesIndexTriples) {
  const TemporaryFolder folder;
  write_tri(folder.path("a.tri"), square, 0);
  EXPECT_EQ(content_of(folder.path("a.tri")), "0 1 2\n0 2 3\n");
  write_tri(folder.path("a.tri"), square, 1);
  EXPECT_EQ(content_of(folder.path("a.tri")), "1 2 3\n1 3 4\n");
}

TEST(WriteTriangles, WritesTheElementsOfTriangle) {
  const TemporaryFolder folder;
  write_ele(folder.path("a.ele"), square, 0);
  EXPECT_EQ(content_of(folder.path("a.ele")), "2 3 0\n0 0 1 2\n1 0 2 3\n");
  write_ele(folder.path("a.ele"), square, 1);
  EXPECT_EQ(content_of(folder.path("a.ele")), "2 3 0\n1 1 2 3\n2 1 3 4\n");
}

TEST(WriteTriangles, WritesNeighboursOppositeTheCorners) {
  const TemporaryFolder folder;
  // A fan around node 0: corner 0's opposite side is the boundary.
  const Triangles fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  write_neigh(folder.path("a.neigh"), fan, 0);
  EXPECT_EQ(content_of(folder.path("a.neigh")), "3 3\n0 -1 1 2\n1 -1 2 0\n2 -1 0 1\n");
  write_neigh(folder.path("a.neigh"), square, 1);
  EXPECT_EQ(content_of(folder.path("a.neigh")), "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
}

TEST(WriteTriangles, WritesAdjacencyLists) {
  const TemporaryFolder folder;
  const std::vector<std::int32_t> nodes = {0, 4};
  write_adj(folder.path("a.adj"), nodes, {{1, 2, 3}, {}}, 1);
  EXPECT_EQ(content_of(folder.path("a.adj")), "1 2 3 4\n5\n");
  EXPECT_THROW(write_adj(folder.path("b.adj"), nodes, {{1}}, 0), Error);
}

TEST(WriteTriangles, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(write_tri("/dev/full", square, 0), WriteError);
}

TEST(ReadTriangles, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const int base : {0, 1}) {
    write_tri(folder.path("a.tri"), square, base);
    write_ele(folder.path("a.ele"), square, base);
    for (const char* const name : {"a.tri", "a.ele"}) {
      const TriangleFile file = read_triangles(folder.path(name), 4);
      EXPECT_EQ(file.triangles, square) << name << ' ' << base;
      EXPECT_EQ(file.base, base) << name;
    }
  }
}

TEST(ReadTriangles, TakesAnySeparatorHeaderAndComments) {
  for (const char* const content :
       {"0,1,2\n0,2,3\n", "0\t1\t2\r\n0\t2\t3\r\n", "v1,v2,v3\n0,1,2\n0,2,3",
        "# all\n 0 1 2 # first\n\n0; 2; 3\n"})
    EXPECT_EQ(read("a.tri", content, 4).triangles, square) << content;
}

TEST(ReadTriangles, CountsFromZeroWhereBothWouldDo) {
  EXPECT_EQ(read("a.tri", "1 2 3\n", 5).base, 0);
  EXPECT_EQ(read("a.tri", "1 2 3\n", 5).triangles, (Triangles{{1, 2, 3}}));
}

TEST(ReadTriangles, AllowsNoTriangles) {
  EXPECT_TRUE(read("a.tri", "", 5).triangles.empty());
  EXPECT_TRUE(read("a.ele", "0 3 0\n", 5).triangles.empty());
}

TEST(ReadTriangles, TakesTheBaseOfAnEleFileFromItsFirstNumber) {
  const TriangleFile file = read("a.ele", "1 3 0\n1 1 2 3\n", 9);
  EXPECT_EQ(file.base, 1);
  EXPECT_EQ(file.triangles, (Triangles{{0, 1, 2}}));
}

TEST(ReadTriangles, LeavesOutAttributesAndMidsideNodes) {
  EXPECT_EQ(
      read("a.ele", "# made by Triangle\n1  3  2\n  0  0 1 2  0.25 -1e3\n", 3).triangles,
      (Triangles{{0, 1, 2}}));
  EXPECT_EQ(read("a.ele", "1 6 0\n0 0 1 2 3 4 5\n", 6).triangles, (Triangles{{0, 1, 2}}));
}

TEST(ReadTriangles, NamesTheLineOfAnIndexThatDoesNotExist) {
  EXPECT_EQ(
      complaint("a.tri", "0 1 2\n0 2 9\n", 4),
      "a.tri: line 2: index 9 with 4 nodes; are these the triangles of these points?");
  EXPECT_NE(complaint("a.tri", "0 1 2\n0 2 -1\n", 4).find("line 2: index -1"),
            std::string::npos);
  EXPECT_NE(complaint("a.tri", "0 1 2\n\n0 2 4\n", 4)
                .find("line 3: index 4 in a file that counts from 0"),
            std::string::npos);
  EXPECT_NE(complaint("a.tri", "0 2 99999999999999999999\n", 4).find("line 1"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 3 0\n1 0 1 2\n", 4)
                .find("line 2: index 0 in a file that counts from 1"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 3 0\n0 4 1 2\n", 4)
                .find("line 2: index 4 in a file that counts from 0"),
            std::string::npos);
}

TEST(ReadTriangles, NamesTheLineThatIsNoTriangle) {
  EXPECT_NE(complaint("a.tri", "0 1 2\n0 abc 2\n", 4)
                .find("line 2: '0 abc 2' is not three whole numbers"),
            std::string::npos);
  EXPECT_NE(complaint("a.tri", "0 1 2\n0 1.5 2\n", 4).find("line 2"), std::string::npos);
  EXPECT_NE(complaint("a.tri", "0 1 2\n0 1\n", 4).find("line 2: 2 numbers"),
            std::string::npos);
  EXPECT_NE(complaint("a.tri", "0 1 2\n0 1 2 3\n", 4).find("line 2: 4 numbers"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 3 0\n0 0 1\n", 4).find("line 2: a triangle needs"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 3 0\n0 0 x 1\n", 4).find("line 2: 'x' is not"),
            std::string::npos);
}

TEST(ReadTriangles, HoldsTheFileAgainstTheCountOfItsHeader) {
  EXPECT_EQ(complaint("a.ele", "3 3 0\n0 0 1 2\n1 0 2 3\n", 4),
            "a.ele: line 3: the file ends after 2 of 3 triangles");
  EXPECT_NE(complaint("a.ele", "1 3 0\n0 0 1 2\n1 0 2 3\n", 4)
                .find("line 3: there are more than the 1"),
            std::string::npos);
  // A header that claims 10^18 triangles takes no memory for them.
  EXPECT_NE(
      complaint("a.ele", "1000000000000000000 3 0\n0 0 1 2\n", 4).find("ends after 1 of"),
      std::string::npos);
}

TEST(ReadTriangles, RefusesABadHeaderOrNumbering) {
  EXPECT_NE(complaint("a.ele", "", 4).find("the first line must be"), std::string::npos);
  EXPECT_NE(complaint("a.ele", "two 3 0\n", 4).find("line 1: the first line must be"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 4 0\n0 0 1 2 3\n", 4).find("no header of triangles"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "-1 3 0\n", 4).find("no header of triangles"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "2 3 0\n0 0 1 2\n5 0 2 3\n", 4)
                .find("line 3: triangle number 5 where 1 is due"),
            std::string::npos);
  EXPECT_NE(complaint("a.ele", "1 3 0\n7 0 1 2\n", 4).find("triangle number 7"),
            std::string::npos);
}

TEST(ReadTriangles, RefusesFilesThatAreNotText) {
  EXPECT_NE(complaint("a.tri", std::string_view("0 1 2\n\0\n", 8), 4)
                .find("is not a text file"),
            std::string::npos);
  EXPECT_THROW(static_cast<void>(read_triangles("nowhere.tri", 4)), ReadError);
}

TEST(ReadTriangles, RefusesMoreNodesThanNumbers) {
  EXPECT_THROW(static_cast<void>(read("a.tri", "", std::int64_t{1} << 31)), Error);
  EXPECT_THROW(static_cast<void>(read("a.tri", "", -1)), Error);
}

TEST(ReadTriangles, ReadsTheSeedsDiamond) {
  const std::string path =
      std::string(DELONE_SHARED_DATA_DIR) + "/seed/diamond_02_00009_triangles.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const TriangleFile file = read_triangles(path, 9);
  EXPECT_EQ(file.triangles.size(), 12u);
  EXPECT_EQ(file.base, 1);
}

TEST(ReadTriangles, ReadsARealEleFile) {
  const std::string path = std::string(DELONE_SHARED_DATA_DIR) + "/pslg/ell.ele";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  EXPECT_EQ(read_triangles(path, 65).triangles.size(), 96u);
}

}  // namespace
}  // namespace delone::io
