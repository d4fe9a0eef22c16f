#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/neighbor_table.hpp"
#include "delaunay/query_order.hpp"

namespace delone::delaunay {

/// A site and its distance from the query.
struct SiteDistance {
  Site site = none;
  double distance = 0;
};

/// Makes room for `count` entries for each of `num_queries` queries. Throws Error if that
/// is more than memory can address.
[[nodiscard]] NeighborTable even_table(std::size_t num_queries, std::size_t count);

/// Throws Error unless k is at least 1.
void check_num_neighbors(std::int32_t k);
/// Throws Error unless the radius is a number that is not negative.
void check_radius(double radius);

/// Answers every query with the same number `count` of sites.
///
/// `make_search()` gives each piece of work an object of its own; `ask(search, i, near)`
/// returns the span of SiteDistance for query i, `near` a site to walk from. Queries are
/// visited in `order`.
template <class MakeSearch, class Ask>
[[nodiscard]] NeighborTable answer_evenly(std::span<const KeyedRow> order,
                                          std::span<const Node> rows, std::size_t count,
                                          const RunOptions& run, MakeSearch make_search,
                                          Ask ask) {
  NeighborTable table = even_table(order.size(), count);
  const auto size = static_cast<std::int64_t>(order.size());
  const auto answer_chunk = [&](std::int64_t first, std::int64_t last) {
    auto search = make_search();
    Site near = site_along_curve(static_cast<Site>(rows.size()),
                                 static_cast<double>(first) / static_cast<double>(size));
    for (std::int64_t j = first; j < last; ++j) {
      const std::size_t i = index_of(order[static_cast<std::size_t>(j)]);
      std::size_t slot = i * count;
      // Answers are written in random order: ask for their lines in time.
      const auto ahead = static_cast<std::size_t>(std::min(j + 4, last - 1));
      __builtin_prefetch(&table.rows[index_of(order[ahead]) * count], 1);
      __builtin_prefetch(&table.distances[index_of(order[ahead]) * count], 1);
      const std::span<const SiteDistance> found = ask(search, i, near);
      for (const SiteDistance& f : found) {
        table.rows[slot] = rows[static_cast<std::size_t>(f.site)];
        table.distances[slot++] = f.distance;
      }
      near = found.front().site;
    }
  };
  if (count > 0) parallel_chunks(size, query_chunk, run, answer_chunk);
  return table;
}

/// The answers of one piece of work, in the order in which its queries were visited.
struct ChunkAnswers {
  std::vector<std::int64_t> counts;
  std::vector<Node> rows;
  std::vector<double> distances;
};

/// The answers of all pieces of query_chunk queries put into the order of the queries.
[[nodiscard]] NeighborTable assemble(std::span<const KeyedRow> order,
                                     std::span<const ChunkAnswers> chunks);

/// Answers every query with as many sites as it has: `ask(search, i, near)` returns a
/// struct of `found` (a span of SiteDistance) and `nearest` (where the next walk begins).
template <class MakeSearch, class Ask>
[[nodiscard]] NeighborTable answer_unevenly(std::span<const KeyedRow> order,
                                            std::span<const Node> rows,
                                            const RunOptions& run, MakeSearch make_search,
                                            Ask ask) {
  const auto size = static_cast<std::int64_t>(order.size());
  std::vector<ChunkAnswers> chunks(
      static_cast<std::size_t>((size + query_chunk - 1) / query_chunk));
  const auto answer_chunk = [&](std::int64_t first, std::int64_t last) {
    ChunkAnswers& answers = chunks[static_cast<std::size_t>(first / query_chunk)];
    auto search = make_search();
    Site near = site_along_curve(static_cast<Site>(rows.size()),
                                 static_cast<double>(first) / static_cast<double>(size));
    for (std::int64_t j = first; j < last; ++j) {
      const auto answer = ask(search, index_of(order[static_cast<std::size_t>(j)]), near);
      for (const SiteDistance& f : answer.found) {
        answers.rows.push_back(rows[static_cast<std::size_t>(f.site)]);
        answers.distances.push_back(f.distance);
      }
      answers.counts.push_back(static_cast<std::int64_t>(answer.found.size()));
      near = answer.nearest;
    }
  };
  if (rows.empty()) return even_table(order.size(), 0);
  parallel_chunks(size, query_chunk, run, answer_chunk);
  return assemble(order, chunks);
}

/// Copies to every row the entries of the first row at its position.
void repeat_rows(NeighborTable& table, std::span<const Node> rows,
                 std::span<const Site> sites, std::size_t count);

/// The same number `count` of sites for every row: `ask(search, s)` returns their span
/// for site s.
template <class MakeSearch, class Ask>
[[nodiscard]] NeighborTable answer_for_rows(std::span<const Node> rows,
                                            std::span<const Site> sites,
                                            std::size_t count, const RunOptions& run,
                                            MakeSearch make_search, Ask ask) {
  NeighborTable table = even_table(sites.size(), count);
  const auto answer_chunk = [&](std::int64_t first, std::int64_t last) {
    auto search = make_search();
    for (std::int64_t s = first; s < last; ++s) {
      auto slot = static_cast<std::size_t>(rows[static_cast<std::size_t>(s)]) * count;
      for (const SiteDistance& f : ask(search, static_cast<Site>(s))) {
        table.rows[slot] = rows[static_cast<std::size_t>(f.site)];
        table.distances[slot++] = f.distance;
      }
    }
  };
  if (count > 0)
    parallel_chunks(static_cast<std::int64_t>(rows.size()), query_chunk, run,
                    answer_chunk);
  repeat_rows(table, rows, sites, count);
  return table;
}

}  // namespace delone::delaunay
