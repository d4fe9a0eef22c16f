#include "tripack/query_order.hpp"

#include "tripack/finite.hpp"

namespace delone::tripack {

delaunay::Buffer<delaunay::KeyedRow> order_along_curve(std::span<const Point2> queries) {
  delaunay::check_num_queries(queries.size());
  check_finite(queries, "query");
  const auto chart = [&](std::size_t i) {
    return delaunay::QueryChart{queries[i].x, queries[i].y};
  };
  const auto [low, high] = delaunay::bounding_box(queries.size(), chart);
  return delaunay::order_along_curve(queries.size(), low, high, chart);
}

}  // namespace delone::tripack
