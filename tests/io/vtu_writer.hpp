#pragma once

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace delone::test {

/// How a VTU file is laid out.
struct VtuStyle {
  enum class Place : std::uint8_t { inline_text, appended_base64, appended_raw };
  Place place = Place::inline_text;
  std::endian order = std::endian::little;
  std::size_t word_bytes = 4;
  std::size_t block_bytes = 0;       ///< 0: not compressed
  bool names_full_blocks_0 = false;  ///< as the size of the last block

  [[nodiscard]] std::string name() const {
    return std::string(place == Place::inline_text       ? "Inline"
                       : place == Place::appended_base64 ? "Base64"
                                                         : "Raw") +
           (order == std::endian::little ? "Little" : "Big") +
           std::to_string(8 * word_bytes) + (block_bytes == 0 ? "Plain" : "Blocks") +
           (block_bytes == 0 ? "" : std::to_string(block_bytes)) +
           (names_full_blocks_0 ? "LastIs0" : "");
  }
};

/// `value` as a file of that byte order holds it.
template <class T>
std::string ordered_bytes(T value, std::endian order) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

inline std::string word(std::uint64_t value, const VtuStyle& style) {
  return style.word_bytes == 8
             ? ordered_bytes(value, style.order)
             : ordered_bytes(static_cast<std::uint32_t>(value), style.order);
}

template <class T>
std::string array_bytes(const std::vector<T>& numbers, const VtuStyle& style) {
  std::string bytes;
  for (const T number : numbers) bytes += ordered_bytes(number, style.order);
  return bytes;
}

inline std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= group.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

inline std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
  if (status != Z_OK) throw std::runtime_error("zlib does not compress");
  result.resize(size);
  return result;
}

/// A header and what follows it; VTK encodes the two one by one.
struct Packed {
  std::string header, data;
};

inline Packed packed(std::string_view bytes, const VtuStyle& style) {
  if (style.block_bytes == 0) return {word(bytes.size(), style), std::string(bytes)};
  Packed result;
  const std::size_t num_blocks =
      (bytes.size() + style.block_bytes - 1) / style.block_bytes;
  const std::size_t rest = bytes.size() % style.block_bytes;
  const std::size_t last = rest > 0 || style.names_full_blocks_0 ? rest
                           : bytes.empty()                       ? 0
                                                                 : style.block_bytes;
  result.header =
      word(num_blocks, style) + word(style.block_bytes, style) + word(last, style);
  for (std::size_t i = 0; i < num_blocks; ++i) {
    const std::string block =
        deflated(bytes.substr(i * style.block_bytes, style.block_bytes));
    result.header += word(block.size(), style);
    result.data += block;
  }
  return result;
}

/// The text or bytes of an array in a file.
inline std::string encoded(const Packed& array, const VtuStyle& style) {
  if (style.place == VtuStyle::Place::appended_raw) return array.header + array.data;
  if (style.block_bytes == 0) return encode_base64(array.header + array.data);
  return encode_base64(array.header) + encode_base64(array.data);
}

/// The four arrays of a grid as they stand in a file.
struct VtuArrays {
  std::string points, connectivity, offsets, types;
};

struct VtuCounts {
  std::uint64_t num_points = 4, num_cells = 2;
};

/// Two triangles in a square: Float32, Int64, Int32 and UInt8.
inline VtuArrays square_arrays(const VtuStyle& style) {
  const auto array = [&](const auto& numbers) {
    return encoded(packed(array_bytes(numbers, style), style), style);
  };
  return {array(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}),
          array(std::vector<std::int64_t>{0, 1, 2, 0, 2, 3}),
          array(std::vector<std::int32_t>{3, 6}), array(std::vector<std::uint8_t>{5, 5})};
}

inline std::string vtu_head(const VtuStyle& style) {
  return std::string(
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
             "version=\"1.0\" byte_order=\"") +
         (style.order == std::endian::little ? "LittleEndian" : "BigEndian") +
         "\" header_type=\"" + (style.word_bytes == 8 ? "UInt64" : "UInt32") + '"' +
         (style.block_bytes > 0 ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n";
}

/// A whole file. In the appended parts the arrays stand one behind the other.
inline std::string vtu_file(const VtuStyle& style, const VtuArrays& arrays,
                            VtuCounts counts = {}) {
  const bool is_inline = style.place == VtuStyle::Place::inline_text;
  std::string appended;
  const auto tag = [&](const std::string& attributes, const std::string& data) {
    const std::string open = "<DataArray " + attributes + " format=\"";
    if (is_inline)
      return open + "binary\">\n" + data +
             "\n<InformationKey name=\"L2_NORM_RANGE\"/></DataArray>\n";
    appended += data;
    return open + "appended\" offset=\"" + std::to_string(appended.size() - data.size()) +
           "\"/>\n";
  };
  const std::string body =
      "<UnstructuredGrid><Piece NumberOfPoints=\"" + std::to_string(counts.num_points) +
      "\" NumberOfCells=\"" + std::to_string(counts.num_cells) + "\">\n<Points>" +
      tag(R"(type="Float32" Name="Points" NumberOfComponents="3")", arrays.points) +
      "</Points><Cells>" +
      tag(R"(type="Int64" Name="connectivity")", arrays.connectivity) +
      tag(R"(type="Int32" Name="offsets")", arrays.offsets) +
      tag(R"(type="UInt8" Name="types")", arrays.types) +
      "</Cells></Piece></UnstructuredGrid>\n";
  const char* encoding = style.place == VtuStyle::Place::appended_raw ? "raw" : "base64";
  if (!is_inline)
    appended = std::string("<AppendedData encoding=\"") + encoding + "\">\n  _" +
               appended + "\n</AppendedData>\n";
  return vtu_head(style) + body + appended + "</VTKFile>\n";
}

}  // namespace delone::test
