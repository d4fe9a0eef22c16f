#include "delaunay/segment_list.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "delaunay/curve_order.hpp"
#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

using Pair = SegmentReport::Pair;
using Segment = SegmentList::Segment;

void check_num_segments(std::size_t num_segments) {
  constexpr std::size_t limit = std::size_t{1} << 31;
  if (num_segments <= limit) return;
  throw Error(std::to_string(num_segments) + " segments are more than the limit of " +
              std::to_string(limit) + "; divide the set");
}

void check_row(std::int64_t segment, Node row, std::size_t num_rows) {
  if (row >= 0 && std::cmp_less(row, num_rows)) return;
  throw Error("segment " + std::to_string(segment) + " ends at row " +
                  std::to_string(row) + ", but there are " + std::to_string(num_rows) +
                  " points; correct its ends",
              {segment});
}

// Something that a segment passes: a piece or a site.
struct Passage {
  std::uint64_t key;
  std::int64_t segment;
  friend auto operator<=>(const Passage&, const Passage&) = default;
};

std::uint64_t key(Site a, Site b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t{static_cast<std::uint32_t>(low)} << 32 |
         static_cast<std::uint32_t>(high);
}

// By sites, then by number. There are few segments at most sites.
void sort(std::vector<Segment>& segments) {
  const std::vector<Segment> unsorted = segments;
  const Buffer<KeyedRow> order = sorted_by_key(
      unsorted.size(),
      [&](std::size_t i) { return static_cast<std::uint32_t>(unsorted[i].sites[0]); },
      {.num_threads = 1, .progress = {}});
  std::transform(order.begin(), order.end(), segments.begin(),
                 [&](KeyedRow item) { return unsorted[item & 0xFFFFFFFFu]; });
  for (auto begin = segments.begin(), end = begin; begin != segments.end(); begin = end) {
    while (end != segments.end() && end->sites[0] == begin->sites[0]) ++end;
    if (end - begin == 1) continue;
    std::sort(begin, end, [](const Segment& s, const Segment& t) {
      return std::pair(s.sites[1], s.number) < std::pair(t.sites[1], t.number);
    });
  }
}

// All pairs of segments with a passage in common, without repeats.
std::vector<Pair> find_pairs(std::vector<Passage>& passages, bool& is_complete) {
  std::sort(passages.begin(), passages.end());
  std::vector<Pair> pairs;
  for (std::size_t i = 0, end = 0; i < passages.size(); ++i) {
    if (i >= end) {
      while (end < passages.size() && passages[end].key == passages[i].key) ++end;
    }
    for (std::size_t j = i + 1; j < end; ++j) {
      if (pairs.size() == SegmentReport::max_listed) {
        is_complete = false;
        break;
      }
      pairs.push_back({passages[i].segment, passages[j].segment});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

SegmentList clean_segments(std::span<const std::array<Node, 2>> segments,
                           std::span<const Site> sites) {
  check_num_segments(segments.size());
  SegmentList list;
  list.segments.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto number = static_cast<std::int64_t>(i);
    for (const Node row : segments[i]) check_row(number, row, sites.size());
    const Site a = sites[static_cast<std::size_t>(segments[i][0])];
    const Site b = sites[static_cast<std::size_t>(segments[i][1])];
    if (a == b) {
      list.zero_length.push_back(number);
    } else {
      list.segments.push_back({{std::min(a, b), std::max(a, b)}, number});
    }
  }
  sort(list.segments);
  std::size_t kept = 0;
  for (const Segment& segment : list.segments) {
    if (kept > 0 && list.segments[kept - 1].sites == segment.sites) {
      list.repeated.push_back({list.segments[kept - 1].number, segment.number});
    } else {
      list.segments[kept++] = segment;
    }
  }
  list.segments.resize(kept);
  std::sort(list.repeated.begin(), list.repeated.end());
  return list;
}

SegmentReport report_segments(SegmentList list, const SegmentPaths& paths,
                              std::span<const Node> rows, Node num_rows) {
  SegmentReport report;
  for (const Site at : paths.meetings())
    report.meeting.push_back(rows[static_cast<std::size_t>(at)]);
  std::sort(report.meeting.begin(), report.meeting.end());
  report.meeting.erase(std::unique(report.meeting.begin(), report.meeting.end()),
                       report.meeting.end());
  std::vector<Passage> pieces, meetings;
  for (const Segment& segment : list.segments) {
    const std::vector<Site> path = paths.path(segment.sites[0], segment.sites[1]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      pieces.push_back({key(path[i - 1], path[i]), segment.number});
      if (i + 1 == path.size()) continue;
      const Node row = rows[static_cast<std::size_t>(path[i])];
      if (std::binary_search(report.meeting.begin(), report.meeting.end(), row)) {
        meetings.push_back({key(path[i], path[i]), segment.number});
      } else if (row < num_rows) {
        report.on_segment.push_back({segment.number, row});
      }
    }
  }
  std::sort(report.on_segment.begin(), report.on_segment.end());
  report.overlapping = find_pairs(pieces, report.is_complete);
  const std::vector<Pair> met = find_pairs(meetings, report.is_complete);
  // Two that overlap meet at every vertex that was added to the piece in common.
  std::set_difference(met.begin(), met.end(), report.overlapping.begin(),
                      report.overlapping.end(), std::back_inserter(report.crossing));
  report.zero_length = std::move(list.zero_length);
  report.repeated = std::move(list.repeated);
  return report;
}

std::int64_t find_owner(const SegmentList& list, const SegmentPaths& paths,
                        std::array<Site, 2> piece) {
  const std::uint64_t wanted = key(piece[0], piece[1]);
  for (const Segment& segment : list.segments) {
    const std::vector<Site> path = paths.path(segment.sites[0], segment.sites[1]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (key(path[i - 1], path[i]) == wanted) return segment.number;
    }
  }
  return none;
}

}  // namespace delone::delaunay
