// Any bytes as a table: either columns of equal length and finite coordinates, or a
// ReadError.

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "io/table.hpp"

namespace {

const std::string path =
    (std::filesystem::temp_directory_path() / ("fuzz_table_" + std::to_string(getpid())))
        .string();

void write(const std::uint8_t* data, std::size_t size) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) std::abort();
  if (std::fwrite(data, 1, size, file) != size) std::abort();
  std::fclose(file);
}

}  // namespace

// The first byte chooses the options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  write(data + 1, size - 1);
  delone::io::TableOptions options;
  options.needs_value = (data[0] & 1u) != 0;
  options.skip_bad_rows = (data[0] & 2u) != 0;
  options.keep_text = (data[0] & 4u) != 0;
  if (data[0] & 8u) options.x = "2";
  try {
    const auto table = read_table(path, options);
    if (table.x.size() != table.y.size()) std::abort();
    if (!table.value.empty() && table.value.size() != table.x.size()) std::abort();
    if (!table.row.empty() && table.row.size() != table.x.size()) std::abort();
    if (!table.line.empty() && table.line.size() != table.x.size()) std::abort();
    if (options.keep_text && table.text.size() != table.x.size()) std::abort();
  } catch (const delone::io::ReadError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  std::filesystem::remove(path);
  return 0;
}
