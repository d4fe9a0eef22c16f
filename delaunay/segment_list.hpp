#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/segment_paths.hpp"

namespace delone::delaunay {

/// What was not clean in a list of segments. Numbers of segments and rows are the
/// caller's; rows from the number of points on are added vertices. Nothing in it is an
/// error: the triangulation is right with all of it.
struct SegmentReport {
  /// No list grows beyond this; with many segments through one point there would be a
  /// square number of pairs.
  static constexpr std::size_t max_listed = std::size_t{1} << 20;

  struct OnSegment {
    std::int64_t segment;
    Node row;
    friend auto operator<=>(const OnSegment&, const OnSegment&) = default;
  };
  struct Pair {
    std::int64_t first, second;  ///< first < second
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  std::vector<std::int64_t> zero_length;  ///< both ends at one position
  std::vector<Pair> repeated;             ///< the second joins the positions of the first
  std::vector<Pair> overlapping;          ///< different, with a piece in common
  std::vector<Pair> crossing;             ///< divided where they crossed
  /// Points of the input between the ends of a segment, exactly on it.
  std::vector<OnSegment> on_segment;
  /// Rows of the vertices that crossing segments go through: added vertices, and points
  /// of the input where a crossing was rounded to one. Sorted.
  std::vector<Node> meeting;
  bool is_complete = true;  ///< false: a list was cut off

  [[nodiscard]] bool is_clean() const noexcept {
    return zero_length.empty() && repeated.empty() && overlapping.empty() &&
           crossing.empty() && meeting.empty() && on_segment.empty();
  }
};

/// Segments between sites in an order that depends on positions only: no two alike, each
/// with its lower site first.
struct SegmentList {
  struct Segment {
    std::array<Site, 2> sites;
    std::int64_t number;  ///< the first of the caller's that joins them
  };
  std::vector<Segment> segments;
  std::vector<std::int64_t> zero_length;
  std::vector<SegmentReport::Pair> repeated;
};

/// `segments`: pairs of rows; `sites`: the site of every row. Throws Error naming the
/// segment if there is no such row, or if there are too many segments (2^31). O(n) but
/// for sites with many segments: O(n log n).
[[nodiscard]] SegmentList clean_segments(std::span<const std::array<Node, 2>> segments,
                                         std::span<const Site> sites);

/// What the paths of the segments tell. `rows`: the row of every site; `num_rows`: how
/// many points the input had. O(pieces log pieces + pairs).
[[nodiscard]] SegmentReport report_segments(SegmentList list, const SegmentPaths& paths,
                                            std::span<const Node> rows, Node num_rows);

/// The first of `segments` that has the piece between two sites, or none.
[[nodiscard]] std::int64_t find_owner(const SegmentList& list, const SegmentPaths& paths,
                                      std::array<Site, 2> piece);

}  // namespace delone::delaunay
