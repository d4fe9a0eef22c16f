#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"
#include "stripack/triangulation.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack::oracle {

using support::SpherePoints;
using Pair = std::array<Node, 2>;

inline constexpr double never = std::numeric_limits<double>::infinity();
inline constexpr double pi = std::numbers::pi;

inline std::size_t index(Node v) { return static_cast<std::size_t>(v); }

/// Shortest paths by the definition, over all pairs of points that see each other: states
/// are such pairs and the side on which the path runs, pushed off its line by nothing.
///
/// Arcs of pi are made of two: half circles between opposite points go through the points
/// halfway between any two of the others, if these see both. Such points are added, but
/// none on a wall; they make no path shorter, for a path may turn anywhere.
class PathOracle {
 public:
  PathOracle(SpherePoints points, std::vector<Pair> walls)
      : points_(std::move(points)), walls_(std::move(walls)) {
    if (has_opposite_points()) add_midpoints();
    const std::size_t n = points_.size();
    sees_.resize(n * n);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) sees_[a * n + b] = is_free(a, b);
    }
  }

  [[nodiscard]] std::vector<double> distances(Node from) const {
    const std::size_t n = points_.size();
    std::vector<double> best(2 * n * n, never);
    const auto state = [&](std::size_t a, std::size_t b, std::size_t side) {
      return 2 * (a * n + b) + side;
    };
    for (std::size_t b = 0; b < n; ++b) {
      if (!sees(index(from), b)) continue;
      for (const std::size_t side : {0UL, 1UL})
        best[state(index(from), b, side)] = length(index(from), b);
    }
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      const auto improve = [&](std::size_t i, double v) {
        if (v >= best[i] - 1e-9) return;
        best[i] = v;
        has_changed = true;
      };
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
          for (const std::size_t side : {0UL, 1UL}) {
            const double v = best[state(a, b, side)];
            if (v == never) continue;
            if (!is_wall(a, b)) improve(state(a, b, 1 - side), v);
            for (std::size_t c = 0; c < n; ++c) {
              if (!sees(b, c) || v + length(b, c) >= best[state(b, c, side)] - 1e-9)
                continue;
              if (turns(a, b, c, side)) improve(state(b, c, side), v + length(b, c));
            }
          }
        }
      }
    }
    std::vector<double> result(n, never);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b)
        result[b] = std::min({result[b], best[state(a, b, 0)], best[state(a, b, 1)]});
    }
    result[index(from)] = 0;
    return result;
  }

 private:
  [[nodiscard]] double length(std::size_t a, std::size_t b) const {
    return angle(points_[a], points_[b]);
  }
  [[nodiscard]] int side(std::size_t a, std::size_t b, std::size_t c) const {
    return orientation(points_[a], points_[b], points_[c]);
  }
  [[nodiscard]] static Direction opposite(const Direction& p) {
    return Direction::from(-p.x(), -p.y(), -p.z());
  }
  [[nodiscard]] bool is_opposite(std::size_t a, std::size_t b) const {
    return is_same_direction(opposite(points_[a]), points_[b]);
  }
  [[nodiscard]] bool has_opposite_points() const {
    for (std::size_t a = 0; a < points_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (is_opposite(a, b)) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_on_wall(const Direction& p) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      return is_inside_arc(points_[index(w[0])], points_[index(w[1])], p);
    });
  }
  [[nodiscard]] bool is_point(const Direction& p) const {
    return std::any_of(points_.begin(), points_.end(),
                       [&](const Direction& v) { return is_same_direction(v, p); });
  }
  void add_midpoints() {
    const SpherePoints given = points_;
    for (std::size_t a = 0; a < given.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (is_opposite(a, b)) continue;
        const Direction &p = given[a], &q = given[b];
        const Direction m = Direction::from(p.x() + q.x(), p.y() + q.y(), p.z() + q.z());
        if (!is_on_wall(m) && !is_point(m)) points_.push_back(m);
      }
    }
  }
  [[nodiscard]] bool is_inside(std::size_t a, std::size_t b, std::size_t v) const {
    return is_inside_arc(points_[a], points_[b], points_[v]);
  }
  [[nodiscard]] bool is_wall(std::size_t a, std::size_t b) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      return (index(w[0]) == a && index(w[1]) == b) ||
             (index(w[0]) == b && index(w[1]) == a);
    });
  }
  [[nodiscard]] bool sees(std::size_t a, std::size_t b) const {
    return sees_[a * points_.size() + b];
  }
  [[nodiscard]] bool is_free(std::size_t a, std::size_t b) const {
    if (a == b || is_opposite(a, b)) return false;
    return std::none_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      const std::size_t c = index(w[0]), d = index(w[1]);
      if (is_inside(a, b, c) || is_inside(a, b, d)) return true;  // in two pieces
      // On the same side of the sphere: not where the great circles meet again.
      return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 &&
             side(a, b, c) == side(c, d, b);
    });
  }
  // Of the directions from b: 0 the same, 1 to the left, 2 opposite, 3 to the right.
  [[nodiscard]] int sector(std::size_t b, std::size_t from, std::size_t to) const {
    const int left = side(b, from, to);
    if (left != 0) return left > 0 ? 1 : 3;
    return from == to || is_inside(b, from, to) || is_inside(b, to, from) ? 0 : 2;
  }
  // Strictly between, counter-clockwise; all round if they are the same.
  [[nodiscard]] bool is_between(std::size_t b, std::size_t from, std::size_t to,
                                std::size_t v) const {
    const int of_v = sector(b, from, v), of_to = sector(b, from, to);
    if (of_to == 0) return of_v != 0;
    if (of_v != of_to) return of_v != 0 && of_v < of_to;
    return side(b, v, to) > 0;
  }
  // May a path a-b-c pass b on that side (0: b is on its right; 1: on its left)?
  [[nodiscard]] bool turns(std::size_t a, std::size_t b, std::size_t c,
                           std::size_t side) const {
    const std::size_t from = side == 0 ? c : a, to = side == 0 ? a : c;
    return std::none_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      if (index(w[0]) != b && index(w[1]) != b) return false;
      return is_between(b, from, to, index(index(w[0]) == b ? w[1] : w[0]));
    });
  }

  SpherePoints points_;
  std::vector<Pair> walls_;
  std::vector<bool> sees_;
};

}  // namespace delone::stripack::oracle
