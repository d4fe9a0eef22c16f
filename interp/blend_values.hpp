#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "interp/blend_cells.hpp"
#include "interp/cursor.hpp"
#include "interp/fresh_values.hpp"
#include "interp/node_batch.hpp"

namespace delone::interp {

/// Queries of one chunk by the triangle that holds them: each triangle's are linked, in
/// the order in which they were added, backwards.
class QueriesByTriangle {
 public:
  static constexpr std::int32_t none = -1;
  struct Group {
    Arc arc;
    std::int32_t last;
  };

  QueriesByTriangle() : before_(at(CurveChunk::most)), slots_(num_slots, none) {}

  /// Query k, 0 .. CurveChunk::most - 1, lies in the triangle on the left of `arc`, which
  /// leaves its smallest site.
  void add(Arc arc, std::int32_t k) {
    std::size_t slot = (static_cast<std::uint32_t>(arc.index) * 2654435769u) >> shift;
    while (slots_[slot] != none && groups_[at(slots_[slot])].arc.index != arc.index)
      slot = (slot + 1) % num_slots;
    if (slots_[slot] == none) {
      slots_[slot] = static_cast<std::int32_t>(groups_.size());
      groups_.push_back({arc, none});
    }
    Group& group = groups_[at(slots_[slot])];
    before_[at(k)] = group.last;
    group.last = k;
  }
  [[nodiscard]] std::span<const Group> groups() const noexcept { return groups_; }
  /// The query of the same triangle that was added before query k; none: there is none.
  [[nodiscard]] std::int32_t before(std::int32_t k) const noexcept {
    return before_[at(k)];
  }

 private:
  static constexpr std::size_t num_slots = 2 * at(CurveChunk::most);
  static constexpr int shift = 32 - 13;
  static_assert(num_slots == std::size_t{1} << (32 - shift));

  std::vector<std::int32_t> before_, slots_;
  std::vector<Group> groups_;
};

/// A blended surface at points in any order: the points of a chunk of the curve are
/// located one after the other, then evaluated triangle by triangle, several at a time,
/// while the data of the next triangles are on their way. The same bits as one by one.
template <BlendSpace Space, int Degree>
class BlendValues {
 public:
  using Cells = BlendCells<Space, Degree>;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;

  BlendValues(const Cells& cells, std::span<const Point> points,
              std::vector<double>& results)
      : cells_(cells), points_(points), results_(results) {}

  void evaluate(const CurveChunk& chunk) {
    QueriesByTriangle queries;
    std::vector<Vector> vectors(at(chunk.size()));
    locate(chunk, queries, vectors);
    const auto groups = queries.groups();
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (g + 2 * ahead < groups.size()) cells_.fetch_places(groups[g + 2 * ahead].arc);
      if (g + ahead < groups.size()) cells_.fetch_parts(groups[g + ahead].arc);
      evaluate_group(chunk, queries, vectors, groups[g]);
    }
  }

 private:
  static constexpr std::int64_t ahead = 8;

  // Points that no triangle holds in its interior are evaluated at once.
  void locate(const CurveChunk& chunk, QueriesByTriangle& queries,
              std::vector<Vector>& vectors) {
    Cursor cursor = cursor_along_curve(cells_.triangulation().adjacency(), chunk.place());
    for (std::int64_t k = 0; k < chunk.size(); ++k) {
      if (k + ahead < chunk.size()) {
        __builtin_prefetch(&points_[chunk[k + ahead]]);
        __builtin_prefetch(&results_[chunk[k + ahead]], 1);
      }
      const Point& p = points_[chunk[k]];
      if (const std::optional<Arc> arc = cells_.triangle_at(p, cursor)) {
        vectors[at(k)] = cells_.scaled(p);
        queries.add(*arc, static_cast<std::int32_t>(k));
      } else {
        results_[chunk[k]] = cells_.value(p, cursor);
      }
    }
  }

  void evaluate_group(const CurveChunk& chunk, const QueriesByTriangle& queries,
                      const std::vector<Vector>& vectors,
                      const QueriesByTriangle::Group& group) {
    const typename Cells::Facet facet = cells_.facet(group.arc);
    NodeBatch batch;
    for (std::int32_t k = group.last; k != QueriesByTriangle::none;
         k = queries.before(k)) {
      if (batch.is_full()) facet.fill(batch);
      add(batch, &results_[chunk[k]], vectors[at(k)]);
    }
    facet.fill(batch);
  }

  static void add(NodeBatch& batch, double* value, Point2 p) {
    batch.add(value, p.x, p.y);
  }
  static void add(NodeBatch& batch, double* value, Vector3 p) {
    batch.add(value, p.x, p.y, p.z);
  }

  const Cells& cells_;
  std::span<const Point> points_;
  std::vector<double>& results_;
};

/// The values at points, in their order.
template <BlendSpace Space, int Degree>
[[nodiscard]] std::vector<double> blend_values(
    const BlendCells<Space, Degree>& cells, std::span<const typename Space::Point> points,
    const RunOptions& run) {
  std::vector<double> results = fresh_values<double>(points.size());
  BlendValues<Space, Degree> work(cells, points, results);
  visit_along_curve(points, run, {},
                    [&](const CurveChunk& chunk) { work.evaluate(chunk); });
  return results;
}

}  // namespace delone::interp
