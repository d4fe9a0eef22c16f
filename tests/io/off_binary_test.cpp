// Binary OFF.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/byte_order.hpp"
#include "io/memory_file.hpp"
#include "io/mesh.hpp"
#include "io/read_or_refuse.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::MemoryFile;

std::string word(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(bits >> shift & 0xff);
  return bytes;
}

std::string number(float value) { return word(std::bit_cast<std::int32_t>(value)); }

std::string words(const std::vector<std::int32_t>& values) {
  std::string bytes;
  for (const std::int32_t value : values) bytes += word(value);
  return bytes;
}

std::string numbers(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) bytes += number(value);
  return bytes;
}

/// Two triangles and a quadrilateral over a square, the second one red. `extra` follows
/// the coordinates of each node.
std::string square(std::string_view first_line = "OFF BINARY\n",
                   const std::vector<float>& extra = {}) {
  std::string text = std::string(first_line) + words({4, 3, 0});
  for (const auto& [x, y] : {std::pair(0.F, 0.F), {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}})
    text += numbers({x, y, 0}) + numbers(extra);
  return text + words({3, 0, 1, 2, 0}) + words({3, 0, 2, 3, 4}) + numbers({1, 0, 0, 1}) +
         words({4, 0, 1, 2, 3, 0});
}

template <class Content>
std::optional<Mesh> read_or_refuse(const Content& content) {
  return test::read_or_refuse(content, "off");
}
std::string complaint(const std::string& content) {
  return test::complaint(content, "off");
}

void expect_square(const std::optional<Mesh>& mesh) {
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->space, Mesh::Space::plane);
  EXPECT_EQ(mesh->x, (std::vector<double>{0, 1, 1, 0}));
  EXPECT_EQ(mesh->y, (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(mesh->offsets, (std::vector<std::int64_t>{0, 3, 6, 10}));
  EXPECT_EQ(mesh->corners, (std::vector<std::int32_t>{0, 1, 2, 0, 2, 3, 0, 1, 2, 3}));
}

TEST(BinaryOff, GivesNodesAndCellsAndPassesColours) {
  expect_square(read_or_refuse(square()));
}

TEST(BinaryOff, BeginsBehindTheLineOfTheKeyword) {
  expect_square(read_or_refuse(square("OFF BINARY # nodes and cells follow\n")));
  expect_square(read_or_refuse(square("# made by hand\n OFF  BINARY \n")));
  expect_square(read_or_refuse(square("OFF BINARY\r\n")));
}

TEST(BinaryOff, PassesNormalsColoursAndTexturesOfNodes) {
  expect_square(read_or_refuse(square("NOFF BINARY\n", {0, 0, 1})));
  expect_square(read_or_refuse(square("COFF BINARY\n", {1, 0, 0, 1})));
  expect_square(read_or_refuse(square("STOFF BINARY\n", {0.5F, 0.5F})));
  expect_square(
      read_or_refuse(square("STCNOFF BINARY\n", {0, 0, 1, 1, 0, 0, 1, 0.5F, 0.5F})));
}

TEST(BinaryOff, TakesUnitVectorsForTheGlobe) {
  const float half = std::sqrt(0.5F);
  const auto mesh =
      read_or_refuse("OFF BINARY\n" + words({3, 1, 3}) +
                     numbers({1, 0, 0, 0, 1, 0, half, 0, half}) + words({3, 0, 1, 2, 0}));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->space, Mesh::Space::globe);
  EXPECT_NEAR(mesh->y[2], 45, 1e-5);
}

TEST(BinaryOff, IsRefusedWhereverItIsCutShort) {
  const std::string text = square("CNOFF BINARY\n", {0, 0, 1, 1, 0, 0, 1});
  const MemoryFile file;
  file.put(text);
  expect_square(read_or_refuse(file));
  for (std::size_t length = text.size(); length-- > 0;) {
    file.cut(length);
    EXPECT_FALSE(read_or_refuse(file)) << length;
  }
}

TEST(BinaryOff, HoldsCountsAgainstTheBytesLeft) {
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(complaint("OFF BINARY\n" + words({most, 1, 0}) + std::string(100, '\0')),
            "binary OFF, byte 0 behind its first line: the file is too short: the number "
            "of nodes is 2147483647, and only 108 bytes follow");
  EXPECT_NE(complaint("OFF BINARY\n" + words({1, most, 0, 0, 0, 0}))
                .find("the number of cells is 2147483647"),
            std::string::npos);
  EXPECT_NE(complaint("OFF BINARY\n" + words({1, 1, 0, 0, 0, 0, most, 0}))
                .find("the number of corners is 2147483647"),
            std::string::npos);
  EXPECT_NE(complaint("OFF BINARY\n" + words({1, 1, 0, 0, 0, 0, 0, most}))
                .find("the number of parts of a colour is 2147483647"),
            std::string::npos);
  for (const std::string& negative :
       {words({-1, 1, 0}), words({1, -1, 0, 0, 0, 0}), words({1, 1, 0, 0, 0, 0, -3, 0}),
        words({1, 1, 0, 0, 0, 0, 0, -1})})
    EXPECT_NE(complaint("OFF BINARY\n" + negative).find("cannot be -"),
              std::string::npos);
}

TEST(BinaryOff, NamesTheByteOfWhatIsWrong) {
  std::string text = square();
  text.replace(11 + 12, 4, number(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(complaint(text),
            "binary OFF, byte 12 behind its first line: a coordinate is not finite");
  text = square();
  text.replace(11 + 12 + 48 + 4, 4, word(4));
  EXPECT_EQ(complaint(text),
            "binary OFF, byte 64 behind its first line: a corner is 4, outside 0..3");
  EXPECT_NE(complaint(square() + "x").find("more than the 4 nodes and 3 cells"),
            std::string::npos);
  EXPECT_NE(complaint("OFF BINARY\n" + words({1, 1, 0, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0}))
                .find("at most 4 parts, not 5"),
            std::string::npos);
  EXPECT_NE(complaint("4OFF BINARY\n").find("write OFF"), std::string::npos);
}

TEST(BinaryOff, IsRefusedOrSoundAfterRandomDamage) {
  std::mt19937 random(20261122);
  const std::string text = square();
  const MemoryFile file;
  int num_refused = 0, num_read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    if (random() % 4 == 0) damaged.erase(random() % damaged.size(), random() % 5);
    file.put(damaged);
    const auto mesh = read_or_refuse(file);
    if (!mesh) {
      ++num_refused;
      continue;
    }
    ++num_read;
    EXPECT_EQ(mesh->offsets.back(), std::ssize(mesh->corners));
    for (const std::int32_t corner : mesh->corners)
      EXPECT_TRUE(corner >= 0 && corner < mesh->num_nodes());
  }
  EXPECT_GT(num_refused, 300);
  EXPECT_GT(num_read, 300);
}

TEST(NumberAt, ReadsBothByteOrders) {
  const char bytes[] = "\x01\x02\x03\x04\x05\x06\x07\x08";
  EXPECT_EQ(number_at<std::uint32_t>(bytes, std::endian::big), 0x01020304U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, std::endian::little), 0x04030201U);
  EXPECT_EQ(number_at<std::uint64_t>(bytes, std::endian::big), 0x0102030405060708U);
  EXPECT_EQ(number_at<std::int16_t>(bytes, std::endian::little), 0x0201);
  EXPECT_EQ(number_at<std::uint8_t>(bytes, std::endian::big), 1);
  EXPECT_EQ(number_at<float>("\x3f\x80\0", std::endian::big), 1);
}

}  // namespace
}  // namespace delone::io
