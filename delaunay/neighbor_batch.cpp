#include "delaunay/neighbor_batch.hpp"

#include <string>

#include "delaunay/error.hpp"

namespace delone::delaunay {

NeighborTable even_table(std::size_t num_queries, std::size_t count) {
  if (count > 0 && num_queries > (std::size_t{1} << 46) / count) {
    throw Error(std::to_string(count) + " neighbours for each of " +
                std::to_string(num_queries) +
                " points are more than memory holds; divide the points");
  }
  NeighborTable table;
  table.offsets.resize(num_queries + 1);
  for (std::size_t i = 0; i <= num_queries; ++i)
    table.offsets[i] = static_cast<std::int64_t>(i * count);
  table.rows.resize(num_queries * count);
  table.distances.resize(num_queries * count);
  return table;
}

void check_num_neighbors(std::int32_t k) {
  if (k >= 1) return;
  throw Error(std::to_string(k) + " nearest nodes cannot be; ask for 1 or more");
}

void check_radius(double radius) {
  if (radius >= 0) return;
  throw Error("a radius of " + std::to_string(radius) +
              " cannot be; give a number that is not negative");
}

NeighborTable assemble(std::span<const KeyedRow> order,
                       std::span<const ChunkAnswers> chunks) {
  NeighborTable table;
  table.offsets.assign(order.size() + 1, 0);
  std::size_t j = 0;
  for (const ChunkAnswers& chunk : chunks) {
    for (const std::int64_t count : chunk.counts)
      table.offsets[index_of(order[j++]) + 1] = count;
  }
  for (std::size_t i = 0; i < order.size(); ++i) table.offsets[i + 1] += table.offsets[i];
  table.rows.resize(static_cast<std::size_t>(table.offsets.back()));
  table.distances.resize(table.rows.size());
  j = 0;
  for (const ChunkAnswers& chunk : chunks) {
    std::ptrdiff_t begin = 0;
    for (const std::int64_t count : chunk.counts) {
      const std::ptrdiff_t to = table.offsets[index_of(order[j++])];
      std::copy_n(chunk.rows.begin() + begin, count, table.rows.begin() + to);
      std::copy_n(chunk.distances.begin() + begin, count, table.distances.begin() + to);
      begin += count;
    }
  }
  return table;
}

void repeat_rows(NeighborTable& table, std::span<const Node> rows,
                 std::span<const Site> sites, std::size_t count) {
  const auto entry = [count](std::size_t row) {
    return static_cast<std::ptrdiff_t>(row * count);
  };
  for (std::size_t r = 0; r < sites.size(); ++r) {
    const auto first = static_cast<std::size_t>(rows[static_cast<std::size_t>(sites[r])]);
    if (first == r) continue;
    std::copy_n(table.rows.begin() + entry(first), count, table.rows.begin() + entry(r));
    std::copy_n(table.distances.begin() + entry(first), count,
                table.distances.begin() + entry(r));
  }
}

}  // namespace delone::delaunay
