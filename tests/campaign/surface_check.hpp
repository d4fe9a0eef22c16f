#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/judge.hpp"

/// What the judges of the plane and of the sphere have in common: ranks, sides, and the
/// test of every edge.
namespace delone::campaign {

/// The number of a position in the order that decides ties.
using Rank = std::int32_t;

inline std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The different positions in order.
template <class Position>
struct Ranking {
  std::vector<Position> positions;  ///< by rank
  std::vector<Row> first_row;       ///< by rank
  std::vector<Rank> rank;           ///< by row
};

/// A side of a triangle, counter-clockwise, and the corner opposite to it.
struct Side {
  Rank from, to, apex;
  friend auto operator<=>(const Side&, const Side&) = default;
};

class Sides {
 public:
  Sides(std::span<const Triangle> triangles, const std::vector<Rank>& rank) {
    all_.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
      const Rank a = rank[at(t[0])], b = rank[at(t[1])], c = rank[at(t[2])];
      all_.insert(all_.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
    }
    std::sort(all_.begin(), all_.end());
  }
  [[nodiscard]] std::span<const Side> all() const { return all_; }
  [[nodiscard]] const Side* find(Rank from, Rank to) const {
    const auto found = std::lower_bound(all_.begin(), all_.end(), Side{from, to, -1});
    const bool is_there = found != all_.end() && found->from == from && found->to == to;
    return is_there ? &*found : nullptr;
  }
  /// Sides that no triangle has the other way round.
  [[nodiscard]] std::vector<Side> boundary() const {
    std::vector<Side> result;
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(result),
                 [&](const Side& s) { return !find(s.to, s.from); });
    return result;
  }

 private:
  std::vector<Side> all_;
};

inline std::string show(Rank a, Rank b) {
  return "side of ranks " + std::to_string(a) + " -> " + std::to_string(b) + " ";
}

/// Rows in range, first of their position, smallest first, sorted.
template <class Position>
std::optional<std::string> form_defect(const Ranking<Position>& ranking,
                                       std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    for (const Row row : t) {
      if (row < 0 || at(row) >= ranking.rank.size()) return "a row is out of range";
      if (ranking.first_row[at(ranking.rank[at(row)])] != row)
        return "row " + std::to_string(row) + " is not the first of its position";
    }
    if (t[0] > t[1] || t[0] > t[2]) return "a triangle does not begin with its smallest";
  }
  if (!std::is_sorted(triangles.begin(), triangles.end())) return "not sorted";
  return std::nullopt;
}

/// Which diagonal a tie has: the lowest of the four corners is not on it.
inline bool is_canonical(const Side& side, Rank opposite) {
  return std::min(side.apex, opposite) < std::min(side.from, side.to);
}

/// Turns, doubled sides, unused positions, circles, ties. Uses orientation and in_circle
/// of the positions.
template <class Position>
Verdict local_verdict(const std::vector<Position>& position, const Sides& sides) {
  Verdict verdict;
  std::vector<bool> is_used(position.size(), false);
  const Side* previous = nullptr;
  for (const Side& s : sides.all()) {
    const Position &a = position[at(s.from)], &b = position[at(s.to)],
                   &c = position[at(s.apex)];
    is_used[at(s.from)] = true;
    if (previous && previous->from == s.from && previous->to == s.to)
      return {show(s.from, s.to) + "has two triangles", 0};
    previous = &s;
    const bool is_named_first = s.from < s.to && s.from < s.apex;
    if (is_named_first && orientation(a, b, c) <= 0)
      return {show(s.from, s.to) + "has a triangle that is not counter-clockwise", 0};
    const Side* other = s.from < s.to ? sides.find(s.to, s.from) : nullptr;
    if (!other) continue;
    const int inside = in_circle(a, b, c, position[at(other->apex)]);
    if (inside > 0) return {show(s.from, s.to) + "is not Delaunay", 0};
    verdict.num_ties += inside == 0 ? 1 : 0;
    if (inside == 0 && !is_canonical(s, other->apex))
      return {show(s.from, s.to) + "is not the canonical diagonal of a tie", 0};
  }
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end())
    verdict.defect = "a position is in no triangle";
  return verdict;
}

/// The rows of a cycle of ranks, beginning at the smallest row.
template <class Position>
std::vector<Row> rows_of_cycle(const Ranking<Position>& ranking,
                               const std::vector<Rank>& cycle) {
  std::vector<Row> rows;
  for (const Rank r : cycle) rows.push_back(ranking.first_row[at(r)]);
  std::rotate(rows.begin(), std::min_element(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace delone::campaign
