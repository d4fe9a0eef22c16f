// A weight file: any bytes, or a sound file with some of its bytes replaced. Either an
// operator with sound indices, which is applied, or a ReadError of one line.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/table.hpp"
#include "io/weights_file.hpp"

namespace {

using namespace delone;

const std::string path = (std::filesystem::temp_directory_path() /
                          ("fuzz_weights_" + std::to_string(getpid())))
                             .string();

void require(bool holds) {
  if (!holds) std::abort();
}

void put(const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string sound_file() {
  interp::Operator::Matrix matrix(6, 4);
  for (int i = 0; i < 5; ++i) {
    matrix.insert(i, i % 3) = 0.25;
    matrix.insert(i, 3) = 0.75;
  }
  const interp::Grid grid = interp::globe_grid({0, 20, 0, 10}, interp::NodeCounts{3, 2});
  io::WeightsFile file{.weights = interp::Operator(matrix)};
  file.source = {
      .space = io::Mesh::Space::globe, .x = {0, 20, 0, 20}, .y = {0, 0, 10, 10}};
  file.target = io::weights_side(grid, io::Mesh::Space::globe);
  io::write_weights(path, file);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Three bytes each: where (two bytes) and what.
std::string damaged(std::string bytes, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + 3 <= size; i += 3) {
    const std::size_t place = (data[i] * std::size_t{256} + data[i + 1]) % bytes.size();
    bytes[place] = static_cast<char>(data[i + 2]);
  }
  return bytes;
}

void check(const io::WeightsFile& file) {
  const auto& matrix = file.weights.matrix();
  for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k)
    require(matrix.innerIndexPtr()[k] >= 0 && matrix.innerIndexPtr()[k] < matrix.cols());
  for (const io::WeightsSide* side : {&file.source, &file.target})
    require(side->x.size() == side->y.size());
  const std::vector<double> ones(static_cast<std::size_t>(matrix.cols()), 1.0);
  require(std::ssize(file.weights.apply(ones, {}, {.num_threads = 1, .progress = {}})) ==
          matrix.rows());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = sound_file();
  if (size == 0) return 0;
  put(data[0] % 4 == 0 ? std::string(data + 1, data + size)
                       : damaged(sound, data + 1, size - 1));
  try {
    check(io::read_weights(path));
  } catch (const io::ReadError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos);
  }
  std::filesystem::remove(path);
  return 0;
}
