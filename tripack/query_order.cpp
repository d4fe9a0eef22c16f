#include "tripack/query_order.hpp"

#include <cmath>
#include <string>

#include "delaunay/error.hpp"

namespace delone::tripack {

namespace {

void check_queries(std::span<const Point2> queries) {
  delaunay::check_num_queries(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (std::isfinite(queries[i].x) && std::isfinite(queries[i].y)) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("query " + std::to_string(row) +
                    ": a coordinate is not a finite number; remove the query",
                {row});
  }
}

}  // namespace

delaunay::Buffer<delaunay::KeyedRow> order_along_curve(std::span<const Point2> queries) {
  check_queries(queries);
  const auto chart = [&](std::size_t i) {
    return delaunay::QueryChart{queries[i].x, queries[i].y};
  };
  const auto [low, high] = delaunay::bounding_box(queries.size(), chart);
  return delaunay::order_along_curve(queries.size(), low, high, chart);
}

}  // namespace delone::tripack
