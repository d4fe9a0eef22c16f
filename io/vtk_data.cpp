#include "io/vtk_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "io/base64.hpp"
#include "io/byte_order.hpp"
#include "io/line_reader.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

/// A pair of codes for a match of 258 bytes takes two bits at least.
constexpr std::size_t largest_zlib_ratio = 1032;

template <class T>
std::vector<double> numbers_in(std::string_view bytes, std::endian order) {
  std::vector<double> numbers(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<double>(number_at<T>(bytes.data() + i * sizeof(T), order));
  return numbers;
}

struct NumberType {
  std::string_view name;
  std::size_t size;
  std::vector<double> (*numbers)(std::string_view bytes, std::endian order);
};

template <class T>
constexpr NumberType type_called(std::string_view name) {
  return {name, sizeof(T), numbers_in<T>};
}

constexpr std::array<NumberType, 10> number_types{{
    type_called<double>("Float64"),
    type_called<float>("Float32"),
    type_called<std::int64_t>("Int64"),
    type_called<std::int32_t>("Int32"),
    type_called<std::int16_t>("Int16"),
    type_called<std::int8_t>("Int8"),
    type_called<std::uint64_t>("UInt64"),
    type_called<std::uint32_t>("UInt32"),
    type_called<std::uint16_t>("UInt16"),
    type_called<std::uint8_t>("UInt8"),
}};

/// What the header of a compressed array says.
struct Blocks {
  std::uint64_t size = 0, last_size = 0;  ///< in bytes when inflated
  std::vector<std::size_t> packed_sizes;

  [[nodiscard]] std::uint64_t size_of(std::size_t block) const {
    return block + 1 == packed_sizes.size() ? last_size : size;
  }
};

class Unpacker {
 public:
  Unpacker(const PackedArray& array, const VtkPacking& packing)
      : array_(array), packing_(packing) {}

  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(array_.name + ": " + why);
  }

  [[nodiscard]] std::string bytes(std::size_t size) const {
    // Writers differ in what stands for nothing.
    if (size == 0) return {};
    return packing_.is_compressed ? inflated_bytes(size) : plain_bytes(size);
  }

 private:
  /// No more bytes than these can be there.
  [[nodiscard]] std::size_t most_bytes() const {
    const std::size_t size = array_.text.size();
    return array_.encoding == PackedArray::Encoding::raw ? size : size / 4 * 3 + 3;
  }

  /// The first `size` bytes.
  [[nodiscard]] std::string first(std::size_t size) const {
    std::string bytes;
    if (size <= most_bytes())
      bytes = array_.encoding == PackedArray::Encoding::raw
                  ? std::string(array_.text.substr(0, size))
                  : decode_base64(array_.text, size);
    if (bytes.size() < size) fail("it is cut short");
    return bytes;
  }

  /// Number `i` of a header.
  [[nodiscard]] std::uint64_t word(const std::string& header, std::size_t i) const {
    const char* at = header.data() + i * packing_.word_bytes;
    if (packing_.word_bytes == 8)
      return number_at<std::uint64_t>(at, packing_.byte_order);
    return number_at<std::uint32_t>(at, packing_.byte_order);
  }

  [[noreturn]] void fail_promising(const std::string& what, std::size_t most) const {
    fail("it announces " + what + "; at most " + std::to_string(most) +
         " bytes are there");
  }

  [[nodiscard]] std::string plain_bytes(std::size_t size) const {
    const std::uint64_t announced = word(first(packing_.word_bytes), 0);
    if (announced != size)
      fail("it announces " + std::to_string(announced) + " bytes, and " +
           std::to_string(size) + " are due");
    if (size > most_bytes())
      fail_promising(std::to_string(size) + " bytes", most_bytes());
    return first(packing_.word_bytes + size).substr(packing_.word_bytes);
  }

  [[nodiscard]] std::string read_header() const {
    const std::uint64_t num_blocks = word(first(packing_.word_bytes), 0);
    if (num_blocks > most_bytes() / packing_.word_bytes)
      fail_promising(std::to_string(num_blocks) + " compressed blocks", most_bytes());
    return first((3 + static_cast<std::size_t>(num_blocks)) * packing_.word_bytes);
  }

  [[nodiscard]] Blocks blocks_of(const std::string& header) const {
    Blocks blocks{.size = word(header, 1), .last_size = word(header, 2)};
    if (blocks.last_size == 0) blocks.last_size = blocks.size;
    std::size_t left = most_bytes() - header.size();
    for (std::size_t i = 3; i < header.size() / packing_.word_bytes; ++i) {
      const std::uint64_t packed_size = word(header, i);
      if (packed_size > left)
        fail_promising("a compressed block of " + std::to_string(packed_size) + " bytes",
                       left);
      left -= packed_size;
      blocks.packed_sizes.push_back(static_cast<std::size_t>(packed_size));
    }
    return blocks;
  }

  /// Throws unless the blocks hold `size` bytes.
  void check_sizes(const Blocks& blocks, std::size_t size) const {
    const std::uint64_t num_full = blocks.packed_sizes.size() - 1;
    if (blocks.packed_sizes.empty() || blocks.last_size > size ||
        (num_full > 0 && blocks.size > (size - blocks.last_size) / num_full) ||
        num_full * blocks.size + blocks.last_size != size)
      fail("its " + std::to_string(blocks.packed_sizes.size()) +
           " compressed blocks are not announced to hold the " + std::to_string(size) +
           " bytes that are due");
    for (std::size_t i = 0; i < blocks.packed_sizes.size(); ++i)
      if (blocks.size_of(i) / largest_zlib_ratio > blocks.packed_sizes[i])
        fail("block " + std::to_string(i) + " announces " +
             std::to_string(blocks.size_of(i)) + " bytes, more than zlib packs into " +
             std::to_string(blocks.packed_sizes[i]));
  }

  [[nodiscard]] std::string inflated_bytes(std::size_t size) const {
    const std::string header = read_header();
    const Blocks blocks = blocks_of(header);
    check_sizes(blocks, size);
    std::size_t packed_end = header.size();
    for (const std::size_t packed_size : blocks.packed_sizes) packed_end += packed_size;
    const std::string packed = first(packed_end);
    std::string bytes;
    bytes.reserve(size);
    std::size_t at = header.size();
    for (std::size_t i = 0; i < blocks.packed_sizes.size(); ++i) {
      const std::string_view stream(packed.data() + at, blocks.packed_sizes[i]);
      bytes += inflated(stream, static_cast<std::size_t>(blocks.size_of(i)), i);
      at += stream.size();
    }
    return bytes;
  }

  [[nodiscard]] std::string inflated(std::string_view stream, std::size_t size,
                                     std::size_t block) const {
    std::string bytes(size, '\0');
    uLongf written = size;
    uLong used = stream.size();
    const int status = uncompress2(reinterpret_cast<Bytef*>(bytes.data()), &written,
                                   reinterpret_cast<const Bytef*>(stream.data()), &used);
    const std::string name = "block " + std::to_string(block);
    if (status == Z_MEM_ERROR) fail("there is no memory to inflate " + name);
    if (status != Z_OK && status != Z_BUF_ERROR)
      fail(name + " is no whole zlib stream: it is damaged or cut short");
    if (status == Z_BUF_ERROR || written != size || used != stream.size())
      fail(name + " has another length than announced: it is damaged");
    return bytes;
  }

  const PackedArray& array_;
  const VtkPacking& packing_;
};

std::endian byte_order_of(const XmlTag& file_tag, const std::string& name) {
  const std::string_view order = file_tag.attribute("byte_order");
  if (order.empty() || order == "LittleEndian") return std::endian::little;
  if (order == "BigEndian") return std::endian::big;
  throw ReadError(name + ": the byte order '" + excerpt(order) +
                  "' is neither LittleEndian nor BigEndian");
}

std::size_t word_bytes_of(const XmlTag& file_tag, const std::string& name) {
  const std::string_view type = file_tag.attribute("header_type");
  if (type.empty() || type == "UInt32") return 4;
  if (type == "UInt64") return 8;
  throw ReadError(name + ": the header type '" + excerpt(type) +
                  "' is neither UInt32 nor UInt64");
}

bool is_compressed(const XmlTag& file_tag, const std::string& name) {
  const std::string_view compressor = file_tag.attribute("compressor");
  if (compressor.empty()) return false;
  if (compressor == "vtkZLibDataCompressor") return true;
  throw ReadError(name + ": its data are compressed by " + excerpt(compressor) +
                  "; write them with vtkZLibDataCompressor or without compression");
}

}  // namespace

VtkPacking vtk_packing(const XmlTag& file_tag, const std::string& name) {
  return {.byte_order = byte_order_of(file_tag, name),
          .word_bytes = word_bytes_of(file_tag, name),
          .is_compressed = is_compressed(file_tag, name)};
}

std::vector<double> unpacked_numbers(const PackedArray& array, const VtkPacking& packing,
                                     std::string_view type, std::size_t count) {
  const Unpacker unpacker(array, packing);
  const auto found = std::ranges::find(number_types, type, &NumberType::name);
  if (found == number_types.end())
    unpacker.fail("'" + excerpt(type) + "' is no type of numbers");
  return found->numbers(unpacker.bytes(count * found->size), packing.byte_order);
}

}  // namespace delone::io
