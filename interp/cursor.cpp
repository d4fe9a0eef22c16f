#include "interp/cursor.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace delone::interp {

namespace {

using delaunay::KeyedRow;

using delaunay::Buffer;
using delaunay::CellScale;

constexpr double cells = 65536;

bool is_finite(tripack::Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// The sphere cut open from the south pole along four meridians and laid flat on a square,
// which keeps neighbours together well enough for walking.
std::pair<double, double> unfolded(const stripack::Direction& p) {
  const double scale = 1 / (std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()));
  const double u = p.x() * scale, v = p.y() * scale;
  if (p.z() >= 0) return {u, v};
  return {std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v)};
}

}  // namespace

Buffer<KeyedRow> order_along_curve(std::span<const tripack::Point2> points,
                                   const RunOptions& run) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  double low_x = inf, low_y = inf, high_x = -inf, high_y = -inf;
  for (const tripack::Point2 p : points) {
    if (!is_finite(p)) continue;
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  }
  const double half = std::max(delaunay::half_extent(low_x, high_x),
                               delaunay::half_extent(low_y, high_y));
  const CellScale x(low_x, half, cells), y(low_y, half, cells);
  const auto key = [&](std::size_t i) {
    const tripack::Point2 p = points[i];
    return is_finite(p) ? delaunay::hilbert_key(x.cell(p.x), y.cell(p.y)) : 0;
  };
  return delaunay::sorted_by_key(points.size(), key, run);
}

Buffer<KeyedRow> order_along_curve(std::span<const stripack::Direction> points,
                                   const RunOptions& run) {
  const CellScale scale(-1, 1, cells);
  const auto key = [&](std::size_t i) {
    const auto [u, v] = unfolded(points[i]);
    return delaunay::hilbert_key(scale.cell(u), scale.cell(v));
  };
  return delaunay::sorted_by_key(points.size(), key, run);
}

}  // namespace delone::interp
