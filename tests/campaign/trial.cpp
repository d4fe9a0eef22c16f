#include "campaign/trial.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <limits>
#include <span>
#include <vector>

#include "campaign/judge.hpp"
#include "campaign/judge_predicates.hpp"
#include "delaunay/error.hpp"
#include "stripack/triangulation.hpp"
#include "support/random.hpp"
#include "tripack/triangulation.hpp"

namespace delone::campaign {

namespace {

using Defect = std::optional<std::string>;
using delaunay::Location;
using stripack::Direction;
using support::SplitMix64;
using tripack::Point2;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

template <class Triangulation>
Answer answer_of(const Triangulation& t) {
  return {t.dimension(), t.triangles(), t.boundary()};
}

// The lists that others read say what the triangles say.
template <class Triangulation>
Defect lists_defect(const Triangulation& t) {
  const auto num_triangles = static_cast<std::int64_t>(t.triangles().size());
  if (t.num_triangles() != num_triangles) return "num_triangles() is not the list's";
  if (t.dimension() < 2) return std::nullopt;
  std::int64_t num_sides = 0, num_boundary = 0;
  for (std::int32_t v = 0; v < t.num_sites(); ++v) {
    const std::int32_t degree = t.adjacency().degree(v);
    num_boundary += t.adjacency().is_boundary(v) ? 1 : 0;
    num_sides += t.adjacency().is_boundary(v) ? degree - 1 : degree;
  }
  if (num_sides != 3 * num_triangles) return "the neighbour lists are not the triangles'";
  if (num_boundary != static_cast<std::int64_t>(t.boundary().size()))
    return "the boundary flags are not the boundary's";
  return std::nullopt;
}

template <class Triangulation>
Defect difference(const Triangulation& t, const Triangulation& u) {
  const bool same_points = std::equal(t.points().begin(), t.points().end(),
                                      u.points().begin(), u.points().end());
  if (same_points && t.adjacency() == u.adjacency()) return std::nullopt;
  return "differs from the same set";
}

template <class Triangulation, class Points>
Defect repetition_defect(const Triangulation& t, const Points& points,
                         const Family& family, std::uint64_t seed) {
  if (seed % 8 == 0) {
    const auto other = support::shuffled(points, seed);
    if (auto defect =
            difference(t, Triangulation(other, {.num_threads = 1, .progress = {}})))
      return *defect + " shuffled";
  }
  if (family.extra == Extra::threads || seed % 64 == 1) {
    const int num_threads = 2 + static_cast<int>(seed / 64 % 3);
    if (auto defect = difference(
            t, Triangulation(points, {.num_threads = num_threads, .progress = {}})))
      return *defect + " built by " + std::to_string(num_threads) + " threads";
  }
  return std::nullopt;
}

// Does `found` hold p, by orientations? Sites of a chain are taken as they come.
Defect location_defect(std::span<const Point2> points, Point2 p, const Location& found) {
  const auto corner = [&](std::size_t k) { return points[at(found.nodes[k])]; };
  switch (found.kind) {
    case Location::Kind::node:
      if (corner(0) == p) return std::nullopt;
      return "a node was found that is elsewhere";
    case Location::Kind::edge: {
      const Point2 a = corner(0), b = corner(1);
      const auto [low, high] = std::minmax(a, b, [](Point2 s, Point2 t) {
        return s.x < t.x || (s.x == t.x && s.y < t.y);
      });
      const bool is_between = low.x <= p.x && p.x <= high.x &&
                              (low.x != high.x || (low.y <= p.y && p.y <= high.y));
      if (orientation(a, b, p) == 0 && is_between && !(p == a) && !(p == b))
        return std::nullopt;
      return "an edge was found that does not hold the point";
    }
    case Location::Kind::triangle:
      for (std::size_t k = 0; k < 3; ++k) {
        if (orientation(corner(k), corner((k + 1) % 3), p) <= 0)
          return "a triangle was found that does not hold the point";
      }
      return std::nullopt;
    case Location::Kind::outside:
      break;
  }
  return "outside";
}

// Every row is found as a node; points on and beside edges where they are. Points made
// from two nodes lie in the hull but for rounding, so "outside" must be beyond a hull
// edge.
Defect query_defect(const tripack::Triangulation& t, std::span<const Point2> points,
                    std::uint64_t seed) {
  SplitMix64 random(seed);
  const std::vector<Row> hull = t.dimension() == 2 ? t.boundary() : std::vector<Row>();
  const auto is_beyond_hull = [&](Point2 p) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point2 a = points[at(hull[i])], b = points[at(hull[(i + 1) % hull.size()])];
      if (orientation(a, b, p) < 0) return true;
    }
    return hull.empty();
  };
  for (const Point2 p : points) {
    const Location node = t.locate(p);
    if (node.kind != Location::Kind::node) return "a row is not found as a node";
    if (auto defect = location_defect(points, p, node)) return defect;
    const Point2 other = points[random.below(points.size())];
    const double s = static_cast<double>(random.below(11)) / 10;
    const Point2 q{p.x + s * (other.x - p.x), p.y + s * (other.y - p.y)};
    const Location found = t.locate(q, static_cast<Row>(random.below(points.size())));
    if (found.kind == Location::Kind::outside && is_beyond_hull(q)) continue;
    if (auto defect = location_defect(points, q, found)) return defect;
  }
  return std::nullopt;
}

// With a row that is not finite.
Defect refusal_defect(std::vector<Point2> points, std::uint64_t seed) {
  using Limits = std::numeric_limits<double>;
  const std::array<double, 3> values{Limits::quiet_NaN(), Limits::infinity(),
                                     -Limits::infinity()};
  SplitMix64 random(seed);
  const std::size_t row = random.below(points.size() + 1);
  const double bad = values[random.below(3)];
  const Point2 p = random.below(2) == 0 ? Point2{bad, 0} : Point2{1, bad};
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(row), p);
  try {
    const tripack::Triangulation t(points);
  } catch (const Error& error) {
    const auto rows = error.rows();
    const bool is_named = std::find(rows.begin(), rows.end(), row) != rows.end();
    return is_named ? Defect() : "the row that is not finite is not named";
  }
  return "a row that is not finite was taken";
}

template <class Triangulation, class Points>
Outcome judged(const Triangulation& t, const Points& points) {
  const Answer answer = answer_of(t);
  const Verdict verdict = judge(points, answer);
  Outcome outcome;
  outcome.defect = verdict.defect ? verdict.defect : lists_defect(t);
  outcome.num_points = static_cast<std::int64_t>(points.size());
  outcome.num_triangles = static_cast<std::int64_t>(answer.triangles.size());
  outcome.num_ties = verdict.num_ties;
  return outcome;
}

Outcome plane_trial(const Family& family, TrialKey key) {
  const PlaneSet set = make_plane_set(family, key.seed, key.size);
  const tripack::Triangulation t(set.points, {.num_threads = 1, .progress = {}});
  Outcome outcome = judged(t, set.points);
  outcome.variant = set.variant;
  const auto check = [&](auto defect) {
    if (!outcome.defect) outcome.defect = defect();
  };
  check([&] { return repetition_defect(t, set.points, family, key.seed); });
  if (family.extra == Extra::queries && !set.points.empty())
    check([&] { return query_defect(t, set.points, key.seed); });
  if (family.extra == Extra::refusals)
    check([&] { return refusal_defect(set.points, key.seed); });
  return outcome;
}

Outcome sphere_trial(const Family& family, TrialKey key) {
  const SphereSet set = make_sphere_set(family, key.seed, key.size);
  const stripack::Triangulation t(set.points, {.num_threads = 1, .progress = {}});
  Outcome outcome = judged(t, set.points);
  outcome.variant = set.variant;
  if (!outcome.defect)
    outcome.defect = repetition_defect(t, set.points, family, key.seed);
  return outcome;
}

std::string line(std::initializer_list<double> values) {
  std::string text;
  for (const double v : values) {
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), "%a", v);
    text += (text.empty() ? "" : " ") + std::string(digits.data());
  }
  return text + "\n";
}

}  // namespace

Outcome run_trial(const Family& family, TrialKey key) {
  try {
    return family.plane.empty() ? sphere_trial(family, key) : plane_trial(family, key);
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.defect = std::string("threw: ") + error.what();
    return outcome;
  }
}

std::string corpus_text(const Family& family, TrialKey key) {
  const std::string title = std::string(family.id) + " " + family.title + ", seed " +
                            std::to_string(key.seed) + ", size " +
                            std::to_string(key.size) + "\n";
  if (family.plane.empty()) {
    std::string text = "# xyz: " + title;
    for (const Direction& d : make_sphere_set(family, key.seed, key.size).points)
      text += line({d.x(), d.y(), d.z()});
    return text;
  }
  std::string text = "# plane: " + title;
  for (const Point2 p : make_plane_set(family, key.seed, key.size).points)
    text += line({p.x, p.y});
  return text;
}

}  // namespace delone::campaign
