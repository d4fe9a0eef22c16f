#include <numeric>

#include "campaign/judge.hpp"
#include "campaign/judge_predicates.hpp"
#include "campaign/surface_check.hpp"

namespace delone::campaign {

namespace {

using tripack::Point2;

bool is_before(Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

Ranking<Point2> ranking_of(std::span<const Point2> rows) {
  std::vector<Row> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Row i, Row j) {
    const Point2 a = rows[at(i)], b = rows[at(j)];
    return is_before(a, b) || (!is_before(b, a) && i < j);
  });
  Ranking<Point2> ranking;
  ranking.rank.resize(rows.size());
  for (const Row row : order) {
    const Point2 p = rows[at(row)];
    if (ranking.positions.empty() || is_before(ranking.positions.back(), p)) {
      ranking.positions.push_back(p);
      ranking.first_row.push_back(row);
    }
    ranking.rank[at(row)] = static_cast<Rank>(ranking.positions.size()) - 1;
  }
  return ranking;
}

// The convex hull, points on its edges included, counter-clockwise from the lowest
// position on (A. M. Andrew, Inf. Process. Lett. 9 (1979)). Empty for points on a line.
std::vector<Rank> hull_of(const std::vector<Point2>& position) {
  const auto n = static_cast<Rank>(position.size());
  const auto chain = [&](Rank first, Rank step) {
    std::vector<Rank> hull;
    for (Rank i = first; i >= 0 && i < n; i += step) {
      while (hull.size() > 1 &&
             orientation(position[at(hull[hull.size() - 2])], position[at(hull.back())],
                         position[at(i)]) < 0) {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    return hull;
  };
  std::vector<Rank> hull = chain(0, 1);
  const std::vector<Rank> upper = chain(n - 1, -1);
  if (hull.size() == position.size() && upper.size() == position.size()) return {};
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

// A boundary that ends where it began is named from either end.
std::optional<std::string> chain_defect(const Ranking<Point2>& ranking,
                                        const Answer& answer) {
  const std::size_t n = ranking.positions.size();
  if (!answer.triangles.empty()) return "triangles of points on one line";
  if (answer.dimension != (n == 0 ? -1 : n == 1 ? 0 : 1)) return "wrong dimension";
  const bool is_in_order =
      answer.boundary == ranking.first_row ||
      std::equal(ranking.first_row.rbegin(), ranking.first_row.rend(),
                 answer.boundary.begin(), answer.boundary.end());
  if (!is_in_order) return "the chain of collinear points is not in order";
  return std::nullopt;
}

std::optional<std::string> boundary_defect(const Ranking<Point2>& ranking,
                                           const Sides& sides,
                                           const std::vector<Rank>& hull,
                                           const Answer& answer) {
  if (sides.boundary().size() != hull.size()) return "the boundary is not the hull";
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Rank a = hull[i], b = hull[(i + 1) % hull.size()];
    if (!sides.find(a, b) || sides.find(b, a)) return show(a, b) + "is not on the hull";
  }
  if (answer.boundary != rows_of_cycle(ranking, hull))
    return "the list of the boundary is not the hull";
  return std::nullopt;
}

}  // namespace

Verdict judge(std::span<const Point2> rows, const Answer& answer) {
  const Ranking<Point2> ranking = ranking_of(rows);
  const std::vector<Rank> hull = hull_of(ranking.positions);
  if (hull.empty()) return {chain_defect(ranking, answer), 0};
  if (answer.dimension != 2) return {"wrong dimension", 0};
  if (answer.triangles.size() != 2 * ranking.positions.size() - 2 - hull.size())
    return {"wrong number of triangles", 0};
  if (auto defect = form_defect(ranking, answer.triangles)) return {defect, 0};
  const Sides sides(answer.triangles, ranking.rank);
  if (auto defect = boundary_defect(ranking, sides, hull, answer)) return {defect, 0};
  return local_verdict(ranking.positions, sides);
}

}  // namespace delone::campaign
