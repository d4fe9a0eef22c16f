#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/query_order.hpp"

namespace delone::delaunay {

/// For every arc the number of the triangle on its left in the list that
/// Triangulation::triangles() gives; none where there is no triangle. Four bytes an arc.
/// O(n).
[[nodiscard]] std::vector<std::int32_t> triangle_numbers(const Adjacency& t,
                                                         std::span<const Node> rows,
                                                         std::span<const Site> sites);

/// The arc whose left triangle stands for all that hold the query, given an arc whose
/// closed left triangle does: on an edge or at a corner the triangle with the smallest
/// sites, so that the answer does not depend on where a walk began. `side(u, v)`: exact.
template <class Side>
[[nodiscard]] Arc settle_triangle(const Adjacency& t, Arc a, Side side) {
  const std::array<Site, 3> corner = t.left(a);
  std::array<bool, 3> is_on{};  // is_on[k]: on the line from corner k to the next
  int num_on = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    is_on[k] = side(corner[k], corner[(k + 1) % 3]) == 0;
    num_on += is_on[k] ? 1 : 0;
  }
  if (num_on == 0) return a;
  const std::array<Arc, 3> arcs{a, t.previous(t.reverse(a)), t.reverse(t.next(a))};
  // From a corner: all triangles around it. From an edge: the two beside it.
  const auto name = [&t](Arc b) {
    std::array<Site, 3> sites = t.left(b);
    std::sort(sites.begin(), sites.end());
    return sites;
  };
  Arc best = a;
  const auto consider = [&](Arc b) {
    if (t.has_left(b) && name(b) < name(best)) best = b;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (num_on == 1 && is_on[k]) consider(t.reverse(arcs[k]));
    if (num_on != 2 || !is_on[k] || !is_on[(k + 2) % 3]) continue;
    Arc b = arcs[k];
    for (std::int32_t i = 0; i < t.degree(corner[k]); ++i, b = t.next(b)) consider(b);
  }
  return best;
}

/// The smallest node of an edge or a triangle first, the orientation kept: the same name
/// wherever a walk began.
[[nodiscard]] Location named_from_smallest(Location location);

/// `answer(i, arc)` for every query i in `order`, where `arc` is where the walk of the
/// one before ended and is to be left where this one's ends. Results in the order of the
/// queries.
template <class Result, class Answer>
[[nodiscard]] std::vector<Result> answer_walking(const Adjacency& t,
                                                 std::span<const KeyedRow> order,
                                                 const RunOptions& run, Answer answer) {
  std::vector<Result> results(order.size());
  const auto size = static_cast<std::int64_t>(order.size());
  const auto answer_chunk = [&](std::int64_t first, std::int64_t last) {
    const double fraction = static_cast<double>(first) / static_cast<double>(size);
    Arc arc = t.num_arcs() == 0 || t.is_chain()
                  ? Arc{}
                  : t.first_arc(site_along_curve(t.num_sites(), fraction));
    for (std::int64_t j = first; j < last; ++j) {
      const std::size_t i = index_of(order[static_cast<std::size_t>(j)]);
      results[i] = answer(i, arc);
    }
  };
  parallel_chunks(size, query_chunk, run, answer_chunk);
  return results;
}

}  // namespace delone::delaunay
