#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "campaign/judge.hpp"
#include "campaign/judge_predicates.hpp"
#include "campaign/surface_check.hpp"
#include "support/random.hpp"

namespace delone::campaign {

namespace {

using stripack::Direction;

std::tuple<double, double, double> triple(const Direction& d) {
  return {d.x(), d.y(), d.z()};
}

// Rounded quotients: triples of one ray have them in common, whatever their length.
std::array<double, 3> quotients(const Direction& d) {
  const double largest = std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
  return {d.x() / largest, d.y() / largest, d.z() / largest};
}

struct KeyedRow {
  std::array<double, 3> key;
  Row row;
  friend auto operator<=>(const KeyedRow&, const KeyedRow&) = default;
};

// Rows that are one ray, in groups. Among equal quotients every two are compared.
std::vector<std::vector<Row>> groups_of(std::span<const Direction> rows) {
  std::vector<KeyedRow> keyed;
  for (std::size_t i = 0; i < rows.size(); ++i)
    keyed.push_back({quotients(rows[i]), static_cast<Row>(i)});
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::vector<Row>> groups;
  std::size_t first_of_key = 0;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].key != keyed[i - 1].key) first_of_key = groups.size();
    const auto same = std::find_if(
        groups.begin() + static_cast<std::ptrdiff_t>(first_of_key), groups.end(),
        [&](const std::vector<Row>& group) {
          const Direction &a = rows[at(group[0])], &b = rows[at(keyed[i].row)];
          return a == b || is_same_ray(a, b);
        });
    if (same == groups.end()) {
      groups.push_back({keyed[i].row});
    } else {
      same->push_back(keyed[i].row);
    }
  }
  return groups;
}

Ranking<Direction> ranking_of(std::span<const Direction> rows) {
  struct Position {
    Direction place;
    std::vector<Row> rows;
  };
  std::vector<Position> positions;
  for (std::vector<Row>& group : groups_of(rows)) {
    const Row lowest = *std::min_element(group.begin(), group.end(), [&](Row i, Row j) {
      return triple(rows[at(i)]) < triple(rows[at(j)]);
    });
    positions.push_back({rows[at(lowest)], std::move(group)});
  }
  std::sort(positions.begin(), positions.end(), [](const Position& a, const Position& b) {
    return triple(a.place) < triple(b.place);
  });
  Ranking<Direction> ranking;
  ranking.rank.resize(rows.size());
  for (const Position& p : positions) {
    for (const Row row : p.rows)
      ranking.rank[at(row)] = static_cast<Rank>(ranking.positions.size());
    ranking.positions.push_back(p.place);
    ranking.first_row.push_back(*std::min_element(p.rows.begin(), p.rows.end()));
  }
  return ranking;
}

bool is_on_one_great_circle(const std::vector<Direction>& position) {
  const auto other =
      std::find_if(position.begin(), position.end(),
                   [&](const Direction& d) { return !is_parallel(position[0], d); });
  return other == position.end() ||
         std::all_of(position.begin(), position.end(), [&](const Direction& d) {
           return orientation(position[0], *other, d) == 0;
         });
}

std::optional<std::string> chain_defect(const Ranking<Direction>& ranking,
                                        const Answer& answer) {
  const std::size_t n = ranking.positions.size();
  if (!answer.triangles.empty()) return "triangles of points on one great circle";
  if (answer.dimension != (n == 0 ? -1 : n == 1 ? 0 : 1)) return "wrong dimension";
  if (std::set<Row>(answer.boundary.begin(), answer.boundary.end()) !=
      std::set<Row>(ranking.first_row.begin(), ranking.first_row.end()))
    return "the chain of a great circle lacks points";
  return std::nullopt;
}

// How many triangles hold q; nothing if q is on a side.
std::optional<int> num_holding(const std::vector<Direction>& position, const Sides& sides,
                               const Direction& q) {
  int num = 0;
  for (const Side& s : sides.all()) {
    if (s.from > s.to || s.from > s.apex) continue;
    const Direction &a = position[at(s.from)], &b = position[at(s.to)],
                    &c = position[at(s.apex)];
    const int ab = orientation(a, b, q), bc = orientation(b, c, q),
              ca = orientation(c, a, q);
    if (ab < 0 || bc < 0 || ca < 0) continue;
    if (ab == 0 || bc == 0 || ca == 0) return std::nullopt;
    ++num;
  }
  return num;
}

// Triangles without gaps between them cover everything equally often, but for the
// outside. Closed: a direction and its opposite are in one triangle each; otherwise one
// of them at least is outside.
std::optional<std::string> cover_defect(const std::vector<Direction>& position,
                                        const Sides& sides, bool is_closed) {
  for (support::SplitMix64 random(position.size());;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1),
                 z = random.between(-1, 1);
    const auto here = num_holding(position, sides, Direction::from(x, y, z));
    const auto there = num_holding(position, sides, Direction::from(-x, -y, -z));
    if (!here || !there) continue;
    const int least = std::min(*here, *there), most = std::max(*here, *there);
    if (most > 1 || least != (is_closed ? 1 : 0))
      return "a direction is not covered as often as it should be";
    return std::nullopt;
  }
}

// The boundary sides in order, each one's end the next one's beginning; nothing if they
// are not one cycle.
std::vector<Rank> cycle_of(const std::vector<Side>& boundary) {
  std::vector<Rank> cycle;
  if (boundary.empty()) return cycle;
  Rank v = boundary[0].from;
  do {
    cycle.push_back(v);
    const auto next = std::lower_bound(boundary.begin(), boundary.end(), Side{v, -1, -1});
    if (next == boundary.end() || next->from != v) return {};
    v = next->to;
  } while (v != boundary[0].from && cycle.size() <= boundary.size());
  return cycle.size() == boundary.size() ? cycle : std::vector<Rank>();
}

std::optional<std::string> boundary_defect(const Ranking<Direction>& ranking,
                                           const std::vector<Side>& boundary,
                                           const Answer& answer) {
  for (const Side& s : boundary) {
    for (const Direction& p : ranking.positions) {
      if (orientation(ranking.positions[at(s.from)], ranking.positions[at(s.to)], p) < 0)
        return show(s.from, s.to) + "cuts points off";
    }
  }
  const std::vector<Rank> cycle = cycle_of(boundary);
  if (cycle.size() != boundary.size()) return "the boundary is not one cycle";
  if (answer.boundary != rows_of_cycle(ranking, cycle))
    return "the list of the boundary is not the boundary";
  return std::nullopt;
}

}  // namespace

Verdict judge(std::span<const Direction> rows, const Answer& answer) {
  const Ranking<Direction> ranking = ranking_of(rows);
  if (ranking.positions.empty() || is_on_one_great_circle(ranking.positions))
    return {chain_defect(ranking, answer), 0};
  if (answer.dimension != 2) return {"wrong dimension", 0};
  if (auto defect = form_defect(ranking, answer.triangles)) return {defect, 0};
  const Sides sides(answer.triangles, ranking.rank);
  const std::vector<Side> boundary = sides.boundary();
  const std::size_t expected =
      2 * ranking.positions.size() - (boundary.empty() ? 4 : 2 + boundary.size());
  if (answer.triangles.size() != expected) return {"wrong number of triangles", 0};
  if (auto defect = boundary_defect(ranking, boundary, answer)) return {defect, 0};
  // Before the cover: in a triangle that is none, directions may be on a side for ever.
  Verdict verdict = local_verdict(ranking.positions, sides);
  if (!verdict.defect)
    verdict.defect = cover_defect(ranking.positions, sides, boundary.empty());
  return verdict;
}

}  // namespace delone::campaign
