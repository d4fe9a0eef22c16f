// Any list of triangles over a few points: find_defect accepts exactly what exact
// arithmetic does.

#include <algorithm>
#include <array>
#include <vector>

#include "fuzz/fuzz_points.hpp"
#include "support/exact.hpp"
#include "tripack/defect.hpp"

namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;
using delone::tripack::Point2;

bool is_different(const std::vector<Point2>& points,
                  const std::array<std::int32_t, 3>& t) {
  const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
  return !(at(0) == at(1)) && !(at(1) == at(2)) && !(at(2) == at(0));
}

// The judge takes counter-clockwise lists of rows that exist; find_defect must refuse the
// others.
bool is_right(const std::vector<Point2>& points, Triangles triangles) {
  const auto n = static_cast<std::int32_t>(points.size());
  for (auto& t : triangles) {
    if (*std::max_element(t.begin(), t.end()) >= n ||
        *std::min_element(t.begin(), t.end()) < 0)
      return false;
    if (!is_different(points, t)) return false;
  }
  if (!delone::support::exact_defect(points, triangles)) return true;
  for (auto& t : triangles) std::swap(t[1], t[2]);
  return !delone::support::exact_defect(points, triangles);
}

}  // namespace

// First byte: number of points; then x and y of each, a byte; then corners of triangles.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t num_points = std::min<std::size_t>(data[0] % 12, (size - 1) / 2);
  std::vector<Point2> points;
  std::size_t at = 1;
  for (; points.size() < num_points; at += 2) {
    points.push_back(
        {static_cast<double>(data[at] % 8), static_cast<double>(data[at + 1] % 8)});
  }
  Triangles triangles;
  for (; at + 2 < size; at += 3) {
    const auto corner = [&](std::size_t k) {
      return static_cast<std::int32_t>(data[at + k] % 16) - 1;
    };
    triangles.push_back({corner(0), corner(1), corner(2)});
  }
  const bool is_accepted = !delone::tripack::find_defect(points, triangles);
  if (is_accepted != is_right(points, triangles))
    delone::fuzz::fail("find_defect is mistaken");
  return 0;
}
