#include "stripack/locate_batch.hpp"

#include <cstddef>

#include "delaunay/locate_batch.hpp"
#include "delaunay/site_queries.hpp"
#include "stripack/predicates.hpp"
#include "stripack/query_order.hpp"

namespace delone::stripack {

namespace {

// On which side of an arc between two sites is p?
auto side_of(const Triangulation& t, const Direction& p) {
  return [&t, &p](Site u, Site v) {
    return orientation(t.points()[static_cast<std::size_t>(u)],
                       t.points()[static_cast<std::size_t>(v)], p);
  };
}

}  // namespace

std::vector<std::int32_t> locate_triangles(const Triangulation& t,
                                           std::span<const Direction> queries,
                                           const RunOptions& run) {
  const auto order = order_along_curve(queries);
  if (t.dimension() < 2) return std::vector<std::int32_t>(queries.size(), -1);
  const auto numbers = delaunay::triangle_numbers(t.adjacency(), t.rows(), t.sites());
  return delaunay::answer_walking<std::int32_t>(
      t.adjacency(), order, run, [&](std::size_t i, Arc& arc) {
        arc = t.find(queries[i], arc);
        if (!t.adjacency().has_left(arc)) return std::int32_t{-1};
        const Arc settled =
            delaunay::settle_triangle(t.adjacency(), arc, side_of(t, queries[i]));
        return numbers[static_cast<std::size_t>(settled.index)];
      });
}

std::vector<Location> locate_all(const Triangulation& t,
                                 std::span<const Direction> queries,
                                 const RunOptions& run) {
  const auto order = order_along_curve(queries);
  return delaunay::answer_walking<Location>(
      t.adjacency(), order, run, [&](std::size_t i, Arc& arc) {
        if (t.dimension() < 2) return delaunay::named_from_smallest(t.locate(queries[i]));
        arc = t.find(queries[i], arc);
        return delaunay::named_from_smallest(
            delaunay::describe(t.adjacency(), t.rows(), arc, side_of(t, queries[i])));
      });
}

}  // namespace delone::stripack
