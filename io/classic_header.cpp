#include "io/classic_header.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "io/line_reader.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

double padded(double num_bytes) { return 4 * std::ceil(num_bytes / 4); }

/// What the header says of one variable. Sizes in bytes, as double: their products may be
/// anything.
struct Extent {
  std::string name;
  double begin = 0;
  double size = 0;  // of one record, if it is a record variable
  bool is_record = false;
};

class HeaderWalk {
 public:
  explicit HeaderWalk(const std::string& path)
      : path_(path),
        file_(path, std::ios::binary),
        file_size_(static_cast<double>(std::filesystem::file_size(path))) {}

  [[nodiscard]] bool is_classic() {
    std::array<char, 4> magic{};
    if (!file_.read(magic.data(), magic.size())) return false;
    const char version = magic[3];
    count_bytes_ = version == 5 ? 8 : 4;
    offset_bytes_ = version == 1 ? 4 : 8;
    return std::string_view(magic.data(), 3) == "CDF" &&
           (version == 1 || version == 2 || version == 5);
  }

  void check() {
    num_records_ = static_cast<double>(number(count_bytes_));
    const double open_end = count_bytes_ == 8 ? 0x1p64 : 0xFFFFFFFFp0;
    if (num_records_ >= open_end) num_records_ = 0;  // "find out yourself"
    read_dimensions();
    skip_attributes();
    read_variables();
    check_extents();
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(path_ + ": damaged or cut short: " + why);
  }

  /// A big-endian number.
  std::uint64_t number(std::size_t num_bytes) {
    std::array<unsigned char, 8> bytes{};
    if (!file_.read(reinterpret_cast<char*>(bytes.data()),
                    static_cast<std::streamsize>(num_bytes)))
      fail("the file ends within its header");
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < num_bytes; ++i) result = result << 8 | bytes[i];
    return result;
  }

  /// A count of things that take `least_bytes` each in what is left of the file.
  std::uint64_t count(double least_bytes) {
    const std::uint64_t result = number(count_bytes_);
    const double left = file_size_ - static_cast<double>(file_.tellg());
    if (static_cast<double>(result) * least_bytes > left)
      fail("its header claims more at byte " +
           std::to_string(static_cast<std::int64_t>(file_.tellg())) +
           " than the file holds");
    return result;
  }

  void skip(double num_bytes) {
    file_.seekg(static_cast<std::streamoff>(num_bytes), std::ios::cur);
  }

  std::string name() {
    std::string result(count(1), '\0');
    file_.read(result.data(), std::ssize(result));
    skip(static_cast<double>((4 - result.size() % 4) % 4));
    return result;
  }

  double type_bytes() {
    constexpr std::array<double, 12> sizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    const std::uint64_t type = number(4);
    if (type < 1 || type >= sizes.size())
      fail("type " + std::to_string(type) + " does not exist");
    return sizes[type];
  }

  /// The count of a list whose items take `least_bytes` each; its tag is the library's
  /// business.
  std::uint64_t list(double least_bytes) {
    number(4);
    return count(least_bytes);
  }

  void read_dimensions() {
    dimensions_.resize(list(8));
    for (double& size : dimensions_) {
      static_cast<void>(name());
      size = static_cast<double>(number(count_bytes_));
    }
  }

  void skip_attributes() {
    for (std::uint64_t left = list(12); left > 0; --left) {
      static_cast<void>(name());
      const double bytes = type_bytes();
      skip(padded(bytes * static_cast<double>(count(bytes))));
    }
  }

  void read_variables() {
    for (std::uint64_t left = list(24); left > 0; --left)
      variables_.push_back(read_variable());
  }

  Extent read_variable() {
    Extent result{.name = name()};
    result.size = 1;
    for (std::uint64_t d = 0, rank = count(4); d < rank; ++d) {
      const std::uint64_t id = number(count_bytes_);
      if (id >= dimensions_.size())
        fail("dimension " + std::to_string(id) + " does not exist");
      if (d == 0 && dimensions_[id] == 0)
        result.is_record = true;
      else
        result.size *= dimensions_[id];
    }
    skip_attributes();
    result.size *= type_bytes();
    number(count_bytes_);  // the size again, which need not be right above 4 GiB
    result.begin = static_cast<double>(number(offset_bytes_));
    return result;
  }

  /// The bytes from one record to the next. Values are padded to four bytes unless they
  /// stand alone.
  [[nodiscard]] double record_bytes() const {
    double sum = 0, single = 0;
    int count = 0;
    for (const Extent& variable : variables_) {
      if (!variable.is_record) continue;
      sum += padded(variable.size);
      single = variable.size;
      ++count;
    }
    return count == 1 ? single : sum;
  }

  void check_extents() const {
    const double stride = record_bytes();
    for (const Extent& variable : variables_) {
      if (variable.is_record && num_records_ == 0) continue;
      const double before = variable.is_record ? stride * (num_records_ - 1) : 0;
      if (!(variable.begin + before + variable.size <= file_size_))
        fail("the values of variable '" + excerpt(variable.name) +
             "' reach beyond the file's end");
    }
  }

  const std::string& path_;
  std::ifstream file_;
  double file_size_;
  std::size_t count_bytes_ = 4, offset_bytes_ = 4;
  double num_records_ = 0;
  std::vector<double> dimensions_;  // sizes; 0 is the record dimension
  std::vector<Extent> variables_;
};

}  // namespace

void check_classic_header(const std::string& path) {
  HeaderWalk walk(path);
  if (walk.is_classic()) walk.check();
}

}  // namespace delone::io
