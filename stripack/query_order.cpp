#include "stripack/query_order.hpp"

#include <cmath>

namespace delone::stripack {

namespace {

// The sphere cut open from the south pole along four meridians and laid flat on a square,
// which keeps neighbours together well enough for walking.
delaunay::QueryChart unfolded(const Direction& p) {
  const double scale = 1 / (std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()));
  const double u = p.x() * scale, v = p.y() * scale;
  if (p.z() >= 0) return {u, v};
  return {std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v)};
}

}  // namespace

delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const Direction> queries) {
  delaunay::check_num_queries(queries.size());
  const auto chart = [&](std::size_t i) { return unfolded(queries[i]); };
  const auto [low, high] = delaunay::bounding_box(queries.size(), chart);
  return delaunay::order_along_curve(queries.size(), low, high, chart);
}

}  // namespace delone::stripack
