#include "fuzz/fuzz_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string_view>

#include "support/corpus.hpp"

namespace delone::fuzz {

namespace {

using stripack::Direction;

std::vector<double> doubles(std::span<const std::uint8_t> bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  if (!values.empty())
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

// The second byte scales by 2^(8 * byte - 1024): down to denormals, up to overflow.
std::vector<double> small_integers(std::span<const std::uint8_t> bytes) {
  std::vector<double> values;
  const int exponent = bytes.empty() ? 0 : std::clamp(8 * bytes[0] - 1024, -1074, 1015);
  for (const std::uint8_t b : bytes.subspan(bytes.empty() ? 0 : 1)) {
    values.push_back(std::ldexp(static_cast<double>(b % 16) - 8, exponent));
  }
  return values;
}

std::vector<double> values_of(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  const auto rest = bytes.subspan(1);
  return bytes[0] % 2 == 0 ? doubles(rest) : small_integers(rest);
}

bool is_text(std::span<const std::uint8_t> bytes) {
  return !bytes.empty() && bytes[0] == '#';
}

support::CorpusCase case_of(std::span<const std::uint8_t> bytes) {
  try {
    return support::parse_corpus_case(
        std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  } catch (const std::exception&) {
    return {};  // not a case: no points
  }
}

}  // namespace

std::vector<tripack::Point2> plane_points(std::span<const std::uint8_t> bytes) {
  std::vector<tripack::Point2> points;
  if (is_text(bytes)) {
    points = case_of(bytes).plane;
  } else {
    const auto values = values_of(bytes);
    for (std::size_t i = 0; i + 1 < values.size(); i += 2)
      points.push_back({values[i], values[i + 1]});
  }
  points.resize(std::min(points.size(), max_points));
  return points;
}

std::vector<Direction> sphere_points(std::span<const std::uint8_t> bytes) {
  std::vector<Direction> points;
  if (is_text(bytes)) {
    points = case_of(bytes).sphere;
  } else {
    const auto values = values_of(bytes);
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      const double x = values[i], y = values[i + 1], z = values[i + 2];
      const bool is_zero = x == 0 && y == 0 && z == 0;
      if (is_zero || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        continue;
      points.push_back(Direction::from(x, y, z));
    }
  }
  points.resize(std::min(points.size(), max_points));
  return points;
}

void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace delone::fuzz
