// VTU files as other programs write them: base64 or raw, inline or appended, compressed
// or not, of both byte orders and both lengths of headers.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "io/memory_file.hpp"
#include "io/mesh.hpp"
#include "io/read_or_refuse.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"
#include "io/vtu_writer.hpp"

namespace delone::io {
namespace {

using test::encoded;
using test::MemoryFile;
using test::Packed;
using test::packed;
using test::square_arrays;
using test::TemporaryFolder;
using test::vtu_file;
using test::VtuArrays;
using test::VtuStyle;
using Place = VtuStyle::Place;

const std::vector<double> square_x = {0, 1, 1, 0}, square_y = {0, 0, 1, 1};
const std::vector<std::int32_t> square_corners = {0, 1, 2, 0, 2, 3};

bool is_square(const Mesh& mesh) {
  return mesh.x == square_x && mesh.y == square_y && mesh.corners == square_corners &&
         mesh.offsets == std::vector<std::int64_t>{0, 3, 6};
}

template <class Content>
std::optional<Mesh> read_or_refuse(const Content& content) {
  return test::read_or_refuse(content, "vtu");
}
std::string complaint(const std::string& content) {
  return test::complaint(content, "vtu");
}

std::vector<VtuStyle> all_styles() {
  std::vector<VtuStyle> styles;
  for (const Place place :
       {Place::inline_text, Place::appended_base64, Place::appended_raw})
    for (const std::endian order : {std::endian::little, std::endian::big})
      for (const std::size_t word_bytes : {4U, 8U}) {
        // 48 bytes of points and of corners, 8 of offsets, 2 of types.
        for (const std::size_t block_bytes : {0U, 32768U, 20U, 16U})
          styles.push_back({place, order, word_bytes, block_bytes});
        styles.push_back({place, order, word_bytes, 16, true});
      }
  return styles;
}

class VtuData : public testing::TestWithParam<VtuStyle> {
 protected:
  [[nodiscard]] std::string whole() const {
    return vtu_file(GetParam(), square_arrays(GetParam()));
  }
};

TEST_P(VtuData, GivesTheMesh) {
  const auto mesh = read_or_refuse(whole());
  ASSERT_TRUE(mesh);
  EXPECT_TRUE(is_square(*mesh));
}

TEST_P(VtuData, IsRefusedWhereverTheFileIsCutShort) {
  const std::string text = whole();
  const MemoryFile file;
  file.put(text);
  // The last byte is a line end.
  for (std::size_t length = text.size() - 1; length-- > 0;) {
    file.cut(length);
    EXPECT_FALSE(read_or_refuse(file)) << length;
  }
}

TEST_P(VtuData, IsRefusedWhereverAnArrayIsCutShort) {
  const bool is_text = GetParam().place != Place::appended_raw;
  const VtuArrays arrays = square_arrays(GetParam());
  // What is cut from an appended array that is not the last, the next one fills up.
  const bool is_inline = GetParam().place == Place::inline_text;
  for (std::string VtuArrays::*array : {&VtuArrays::points, &VtuArrays::connectivity,
                                        &VtuArrays::offsets, &VtuArrays::types}) {
    if (!is_inline && array != &VtuArrays::types) continue;
    for (std::size_t length = 0; length < (arrays.*array).size(); ++length) {
      VtuArrays cut = arrays;
      (cut.*array).resize(length);
      const auto mesh = read_or_refuse(vtu_file(GetParam(), cut));
      // Nobody misses padding.
      const bool is_padding =
          is_text && (arrays.*array).find_first_not_of('=', length) == std::string::npos;
      EXPECT_EQ(mesh.has_value(), is_padding) << length;
    }
  }
}

bool is_sound(const Mesh& mesh) {
  if (mesh.offsets.front() != 0 || mesh.offsets.back() != std::ssize(mesh.corners))
    return false;
  for (std::size_t i = 1; i < mesh.offsets.size(); ++i)
    if (mesh.offsets[i] < mesh.offsets[i - 1]) return false;
  for (const std::int32_t corner : mesh.corners)
    if (corner < 0 || corner >= mesh.num_nodes()) return false;
  return mesh.x.size() == mesh.y.size();
}

TEST_P(VtuData, IsRefusedOrSoundAfterRandomDamage) {
  const std::string text = whole();
  std::mt19937 random(20261122);
  int num_refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = text;
    for (auto k = random() % 3 + 1; k > 0; --k) {
      const std::size_t at = random() % damaged.size();
      if (random() % 4 == 0) {
        damaged.erase(at, random() % 9);
      } else {
        damaged[at] = static_cast<char>(random());
      }
    }
    const auto mesh = read_or_refuse(damaged);
    if (!mesh)
      ++num_refused;
    else
      EXPECT_TRUE(is_sound(*mesh)) << i;
  }
  EXPECT_GT(num_refused, 50);
}

INSTANTIATE_TEST_SUITE_P(All, VtuData, testing::ValuesIn(all_styles()),
                         [](const auto& style) { return style.param.name(); });

constexpr VtuStyle raw_zlib{.place = Place::appended_raw, .block_bytes = 20};

TEST(VtuZlib, NoFlippedBitOfTheBlocksChangesTheMesh) {
  const std::string text = vtu_file(raw_zlib, square_arrays(raw_zlib));
  const std::size_t begin = text.find("  _") + 3, end = text.rfind("\n</AppendedData");
  int num_refused = 0, num_flips = 0;
  for (std::size_t at = begin; at < end; ++at)
    for (int bit = 0; bit < 8; ++bit, ++num_flips) {
      std::string damaged = text;
      damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit);
      const auto mesh = read_or_refuse(damaged);
      if (!mesh)
        ++num_refused;
      else
        EXPECT_TRUE(is_square(*mesh)) << at - begin << ' ' << bit;
    }
  // The few others: bits that fill up the last byte of a deflate stream, and the size of
  // full blocks where there is none.
  EXPECT_GT(num_refused, num_flips * 9 / 10);
}

/// A square whose points have the given header in front of the given blocks.
std::string with_points(const VtuStyle& style, const Packed& points) {
  VtuArrays arrays = square_arrays(style);
  arrays.points = encoded(points, style);
  return vtu_file(style, arrays);
}

constexpr std::uint64_t huge = std::uint64_t{1} << 60;

Packed square_points(const VtuStyle& style) {
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  return packed(test::array_bytes(points, style), style);
}

TEST(VtuZlib, HoldsWhatAHeaderPromisesAgainstTheBytesThatAreThere) {
  for (const Place place : {Place::inline_text, Place::appended_raw}) {
    const VtuStyle style{.place = place, .word_bytes = 8, .block_bytes = 20};
    const Packed points = square_points(style);
    for (const std::uint64_t value : {huge, ~std::uint64_t{0}, std::uint64_t{1} << 31})
      for (std::size_t i = 0; i < 6; ++i) {
        Packed lie = points;
        lie.header.replace(8 * i, 8, test::word(value, style));
        EXPECT_NE(complaint(with_points(style, lie)).find("the array of points: it"),
                  std::string::npos)
            << i << ' ' << complaint(with_points(style, lie));
      }
  }
}

TEST(VtuPlain, HoldsWhatAHeaderPromisesAgainstTheBytesThatAreDue) {
  const VtuStyle style{.word_bytes = 8};
  Packed points = square_points(style);
  points.header = test::word(huge, style);
  EXPECT_EQ(complaint(with_points(style, points)),
            "the array of points: it announces 1152921504606846976 bytes, and 48 "
            "are due");
}

TEST(VtuPlain, HoldsTheNumberOfPointsAgainstTheBytesThatAreThere) {
  const VtuStyle style{.word_bytes = 8};
  Packed points = square_points(style);
  points.header = test::word(24000000000, style);
  VtuArrays arrays = square_arrays(style);
  arrays.points = encoded(points, style);
  EXPECT_NE(complaint(vtu_file(style, arrays, {.num_points = 2000000000})).find("most"),
            std::string::npos);
}

TEST(VtuZlib, InflatesNoMoreThanTheNumberOfPointsNeeds) {
  // 64 MiB of zeros in 64 KiB, announced as the 48 bytes of the four points.
  const VtuStyle style{.block_bytes = 48};
  Packed bomb = square_points(style);
  bomb.data = test::deflated(std::string(std::size_t{1} << 26, '\0'));
  bomb.header.replace(12, 4, test::word(bomb.data.size(), style));
  EXPECT_EQ(complaint(with_points(style, bomb)),
            "the array of points: block 0 has another length than announced: it is "
            "damaged");
}

TEST(VtuZlib, TakesNoMemoryForMoreThanZlibCanPack) {
  const VtuStyle style{.word_bytes = 8, .block_bytes = 48};
  VtuArrays arrays = square_arrays(style);
  const Packed points = square_points(style);
  Packed lie = points;
  lie.header.replace(8, 8, test::word(24000000000, style));
  lie.header.replace(16, 8, test::word(24000000000, style));
  arrays.points = encoded(lie, style);
  EXPECT_NE(complaint(vtu_file(style, arrays, {.num_points = 2000000000}))
                .find("more than zlib packs into"),
            std::string::npos);
}

TEST(VtuZlib, NoticesAWrongChecksum) {
  Packed points = square_points(raw_zlib);
  points.data.back() = static_cast<char>(points.data.back() ^ 1);
  EXPECT_EQ(complaint(with_points(raw_zlib, points)),
            "the array of points: block 2 is no whole zlib stream: it is damaged or "
            "cut short");
}

TEST(VtuZlib, NoticesThatTheLastBlockIsMissing) {
  const VtuStyle style{.block_bytes = 20};
  Packed points = square_points(style);
  points.header.replace(0, 4, test::word(2, style));
  points.header.resize(20);
  EXPECT_NE(complaint(with_points(style, points))
                .find("its 2 compressed blocks are not announced to hold the 48 bytes"),
            std::string::npos);
}

TEST(VtuZlib, NoticesABlockThatHoldsLessThanAnnounced) {
  const VtuStyle style{.block_bytes = 48};
  Packed points = square_points(style);
  points.data = test::deflated(std::string(47, '\0'));
  points.header.replace(12, 4, test::word(points.data.size(), style));
  EXPECT_NE(complaint(with_points(style, points)).find("another length than announced"),
            std::string::npos);
}

TEST(VtuZlib, ReadsArraysOfNothing) {
  // VTK announces no block of 32768 bytes; others write one word, or no text at all.
  const VtuStyle style{.block_bytes = 32768};
  VtuArrays arrays = square_arrays(style);
  for (const char* nothing : {"AAAAAACAAAAAAAAA", "AAAAAA==", ""}) {
    arrays.connectivity = arrays.offsets = arrays.types = nothing;
    const auto mesh = read_or_refuse(vtu_file(style, arrays, {.num_cells = 0}));
    ASSERT_TRUE(mesh) << nothing;
    EXPECT_EQ(mesh->x, square_x);
    EXPECT_EQ(mesh->num_cells(), 0);
  }
}

TEST(VtuZlib, ReadsTheSeedOfTheFuzzTarget) {
  EXPECT_TRUE(is_square(read_mesh(DELONE_CORPUS_DIR "/mesh_zlib_blocks.vtu")));
}

TEST(VtuPlain, TakesAHeaderThatIsEncodedByItself) {
  const VtuStyle style;
  VtuArrays arrays = square_arrays(style);
  const Packed points = square_points(style);
  arrays.points = test::encode_base64(points.header) + test::encode_base64(points.data);
  EXPECT_TRUE(read_or_refuse(vtu_file(style, arrays)));
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  text.replace(text.find(what), what.size(), with);
  return text;
}

TEST(VtuData, NamesWhatItDoesNotRead) {
  const VtuStyle style{.block_bytes = 48};
  const std::string text = vtu_file(style, square_arrays(style));
  for (const char* other : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"})
    EXPECT_EQ(complaint(replaced(text, "vtkZLibDataCompressor", other)),
              std::string("its data are compressed by ") + other +
                  "; write them with vtkZLibDataCompressor or without compression");
  EXPECT_EQ(complaint(replaced(text, "UInt32", "UInt16")),
            "the header type 'UInt16' is neither UInt32 nor UInt64");
  EXPECT_EQ(complaint(replaced(text, "LittleEndian", "Middle")),
            "the byte order 'Middle' is neither LittleEndian nor BigEndian");
  EXPECT_EQ(complaint(replaced(text, "Float32", "Float8")),
            "the array of points: 'Float8' is no type of numbers");
  EXPECT_EQ(complaint(replaced(text, "\"binary\"", "\"hex\"")),
            "'hex' is no format of an array");
  EXPECT_NE(complaint(replaced(text, "NumberOfPoints=\"4\"", "")).find("NumberOfPoints"),
            std::string::npos);
  const std::string appended = vtu_file(raw_zlib, square_arrays(raw_zlib));
  EXPECT_NE(complaint(replaced(appended, "\"raw\"", "\"hex\"")).find("neither raw nor"),
            std::string::npos);
  EXPECT_EQ(complaint(replaced(appended, "  _", "  ")),
            "its appended data do not begin with _");
}

TEST(VtuAscii, HoldsAsManyNumbersAsThePieceAnnounces) {
  const TemporaryFolder folder;
  const std::string path = folder.path("m.vtu");
  write_mesh(path, triangle_mesh(Mesh::Space::plane, square_x, square_y,
                                 std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  const std::string text = test::content_of(path);
  EXPECT_EQ(complaint(replaced(text, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")),
            "the array of points holds 12 numbers, and 15 are due");
  EXPECT_EQ(complaint(replaced(text, "NumberOfCells=\"2\"", "NumberOfCells=\"1\"")),
            "the array of offsets holds 2 numbers, and 1 are due");
  EXPECT_EQ(complaint(replaced(text, "0 1 2", "0 1 2 3")),
            "the array of connectivity holds 7 numbers, and 6 are due");
  // Numbers that are cut short are still numbers, so the end of the file tells.
  EXPECT_EQ(complaint(text.substr(0, text.size() - 4)),
            "the file is cut short: it does not end with </VTKFile>");
}

}  // namespace
}  // namespace delone::io
