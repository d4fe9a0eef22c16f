#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/curve_order.hpp"
#include "delaunay/parallel.hpp"
#include "interp/index.hpp"
#include "stripack/direction.hpp"
#include "tripack/point.hpp"

namespace delone::interp {

/// Where the last query of a series ended, and so where the next one starts. Never
/// changes an answer.
struct Cursor {
  delaunay::Arc arc;
  delaunay::Site site = 0;
};

/// A cursor at the given part (0..1) of the sites' space-filling curve.
[[nodiscard]] inline Cursor cursor_along_curve(const delaunay::Adjacency& t,
                                               double fraction) {
  if (t.num_sites() == 0) return {};
  const auto last = static_cast<double>(t.num_sites() - 1);
  const auto site = static_cast<delaunay::Site>(fraction * last);
  if (t.degree(site) == 0) return {{}, site};
  return {t.first_arc(site), site};
}

/// Indices of the points (at most 2^31) with keys along a space-filling curve of the
/// plane or the sphere, sorted.
[[nodiscard]] delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const tripack::Point2> points);
[[nodiscard]] delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const stripack::Direction> points);

/// `evaluate(point, cursor)` for every point, in the caller's order.
///
/// The points are visited along a curve, so each walk is a few steps from the last:
/// unsorted queries cost 2 to 10 times the sorting otherwise. Blocks of 2^24 keep the
/// extra memory at 256 MB.
template <class Result, class Point, class Evaluate>
[[nodiscard]] std::vector<Result> evaluate_along_curve(std::span<const Point> points,
                                                       const delaunay::Adjacency& t,
                                                       const RunOptions& run,
                                                       Evaluate evaluate) {
  constexpr std::size_t block = std::size_t{1} << 24;
  constexpr std::int64_t chunk = 4096;
  constexpr std::int64_t ahead =
      8;  // queries are read in random order: ask for them in time
  std::vector<Result> results(points.size());
  const auto total = static_cast<double>(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += block) {
    const auto part = points.subspan(begin, std::min(block, points.size() - begin));
    const delaunay::Buffer<delaunay::KeyedRow> order = order_along_curve(part);
    const auto size = static_cast<std::int64_t>(part.size());
    const auto evaluate_chunk = [&](std::int64_t first, std::int64_t last) {
      Cursor cursor =
          cursor_along_curve(t, static_cast<double>(first) / static_cast<double>(size));
      const auto index = [&](std::int64_t k) {
        return static_cast<std::size_t>(order[at(k)] & 0xffffffffu);
      };
      for (std::int64_t k = first; k < last; ++k) {
        if (k + ahead < last) {
          __builtin_prefetch(&part[index(k + ahead)]);
          __builtin_prefetch(&results[begin + index(k + ahead)], 1);
        }
        results[begin + index(k)] = evaluate(part[index(k)], cursor);
      }
    };
    delaunay::parallel_chunks(size, chunk, run, evaluate_chunk,
                              {static_cast<double>(begin) / total,
                               static_cast<double>(begin + part.size()) / total});
  }
  return results;
}

}  // namespace delone::interp
