#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/xml_scanner.hpp"

namespace delone::io {

/// How a file of VTK's XML formats packs the numbers that it does not write as text.
struct VtkPacking {
  std::endian byte_order = std::endian::little;
  std::size_t word_bytes = 4;  ///< of a number in a header: 4 or 8
  bool is_compressed = false;  ///< in blocks, each a zlib stream (RFC 1950)
};

/// From the attributes byte_order, header_type and compressor of the tag VTKFile; as VTK
/// does, without them: LittleEndian, UInt32, not compressed. `name` is how messages call
/// the file. Throws ReadError for other values, other compressors among them.
[[nodiscard]] VtkPacking vtk_packing(const XmlTag& file_tag, const std::string& name);

/// The bytes of an array. Others may follow them in `text`.
struct PackedArray {
  enum class Encoding : std::uint8_t { base64, raw };
  std::string name;  ///< how messages call it
  std::string_view text;
  Encoding encoding = Encoding::base64;
};

/// The `count` numbers of VTK's type `type` (Float64, UInt8, ...) that an array holds.
///
/// The array begins with a header: the number of bytes, or, if compressed, the number of
/// blocks, the bytes of a block and of the last one (0: it is full), and the compressed
/// bytes of each. `count` is known from elsewhere in the file. Nothing is taken from the
/// memory for a header that does not promise just that many bytes, or promises more than
/// the text left can hold, at most 1032 times as many where compressed (what zlib can
/// do). Throws ReadError: that, a type that there is not, an array cut short, a zlib
/// stream that is damaged or has another length than promised.
/// Source: "VTK XML Formats", Kitware.
[[nodiscard]] std::vector<double> unpacked_numbers(const PackedArray& array,
                                                   const VtkPacking& packing,
                                                   std::string_view type,
                                                   std::size_t count);

}  // namespace delone::io
