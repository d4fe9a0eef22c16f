#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/curve_order.hpp"
#include "delaunay/parallel.hpp"
#include "interp/fresh_values.hpp"
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
    std::span<const tripack::Point2> points, const RunOptions& run);
[[nodiscard]] delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const stripack::Direction> points, const RunOptions& run);

/// A piece of points in the order of a curve.
class CurveChunk {
 public:
  /// Points per chunk, and per block that is sorted at once: extra memory stays below 256
  /// MB. Chunks do not depend on the number of threads.
  static constexpr std::int64_t most = 4096;
  static constexpr std::size_t block = std::size_t{1} << 24;

  CurveChunk(std::span<const delaunay::KeyedRow> rows, std::size_t block_begin,
             std::int64_t number, double place)
      : rows_(rows), block_begin_(block_begin), number_(number), place_(place) {}

  [[nodiscard]] std::int64_t size() const noexcept { return std::ssize(rows_); }
  /// Index of the k-th point in the caller's order.
  [[nodiscard]] std::size_t operator[](std::int64_t k) const noexcept {
    return block_begin_ + static_cast<std::size_t>(rows_[at(k)] & 0xffffffffu);
  }
  /// Chunks before it.
  [[nodiscard]] std::int64_t number() const noexcept { return number_; }
  /// The part of the curve before it, 0..1.
  [[nodiscard]] double place() const noexcept { return place_; }

 private:
  std::span<const delaunay::KeyedRow> rows_;
  std::size_t block_begin_;
  std::int64_t number_;
  double place_;
};

/// `visit(chunk)` for all points, sorted along a curve and cut into chunks, on several
/// threads.
template <class Point, class Visit>
void visit_along_curve(std::span<const Point> points, const RunOptions& run,
                       delaunay::ProgressSpan progress, Visit visit) {
  const double scale =
      (progress.end - progress.begin) / static_cast<double>(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += CurveChunk::block) {
    const auto part =
        points.subspan(begin, std::min(CurveChunk::block, points.size() - begin));
    const delaunay::Buffer<delaunay::KeyedRow> order = order_along_curve(part, run);
    const auto size = static_cast<std::int64_t>(part.size());
    const auto visit_chunk = [&](std::int64_t first, std::int64_t last) {
      visit(CurveChunk(std::span(order.data() + first, at(last - first)), begin,
                       (static_cast<std::int64_t>(begin) + first) / CurveChunk::most,
                       static_cast<double>(first) / static_cast<double>(size)));
    };
    delaunay::parallel_chunks(
        size, CurveChunk::most, run, visit_chunk,
        {progress.begin + scale * static_cast<double>(begin),
         progress.begin + scale * static_cast<double>(begin + part.size())});
  }
}

/// `evaluate(point, cursor)` for every point, in the caller's order.
///
/// The points are visited along a curve, so each walk is a few steps from the last:
/// unsorted queries cost 2 to 10 times the sorting otherwise.
template <class Result, class Point, class Evaluate>
[[nodiscard]] std::vector<Result> evaluate_along_curve(std::span<const Point> points,
                                                       const delaunay::Adjacency& t,
                                                       const RunOptions& run,
                                                       Evaluate evaluate) {
  constexpr std::int64_t ahead =
      8;  // queries are read in random order: ask for them in time
  std::vector<Result> results = fresh_values<Result>(points.size());
  visit_along_curve(points, run, {}, [&](const CurveChunk& chunk) {
    Cursor cursor = cursor_along_curve(t, chunk.place());
    for (std::int64_t k = 0; k < chunk.size(); ++k) {
      if (k + ahead < chunk.size()) {
        __builtin_prefetch(&points[chunk[k + ahead]]);
        __builtin_prefetch(&results[chunk[k + ahead]], 1);
      }
      results[chunk[k]] = evaluate(points[chunk[k]], cursor);
    }
  });
  return results;
}

}  // namespace delone::interp
