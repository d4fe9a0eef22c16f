// Time of reading a table of 1,000,000 rows of three numbers.
//
//   taskset -c 0 csv_bench [--json] [ROWS [REPEATS]]

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "io/table.hpp"
#include "support/random.hpp"

namespace delone::bench {
namespace {

// Longitudes and latitudes as data sets have them (5 decimals) and a value with 17
// digits.
void write_table(const std::filesystem::path& path, std::size_t num_rows) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) return;
  std::fputs("lon,lat,value\n", file);
  support::SplitMix64 random(1);
  for (std::size_t i = 0; i < num_rows; ++i) {
    const double lon = random.between(-180, 180), lat = random.between(-90, 90);
    std::fprintf(file, "%.5f,%.5f,%.17g\n", lon, lat, random.between(-100, 100));
  }
  std::fclose(file);
}

int run(std::size_t num_rows, int repeats, bool is_json) {
  const auto path = std::filesystem::temp_directory_path() / "delone_csv_bench.csv";
  write_table(path, num_rows);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::vector<double> times;
  std::size_t rows_read = 0;
  for (int i = 0; i < repeats; ++i) {
    times.push_back(
        seconds([&] { rows_read = io::read_table(path.string()).x.size(); }).wall);
  }
  std::filesystem::remove(path);
  const Spread s = spread(times);
  std::printf(is_json
                  ? "{\"rows\":%zu,\"megabytes\":%.1f,\"median_ms\":%.1f,\"min_ms\":%.1f,"
                    "\"max_ms\":%.1f}\n"
                  : "%zu rows, %.1f MB: median %.1f ms, min %.1f, max %.1f\n",
              rows_read, megabytes, 1e3 * s.median, 1e3 * s.min, 1e3 * s.max);
  return rows_read == num_rows ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace delone::bench

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool is_json = std::erase(words, "--json") > 0;
  const std::size_t num_rows =
      words.empty() ? 1000000 : std::strtoull(words[0].c_str(), nullptr, 10);
  const int repeats = words.size() < 2 ? 5 : std::atoi(words[1].c_str());
  return delone::bench::run(num_rows, repeats, is_json);
}
