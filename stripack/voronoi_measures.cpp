#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "delaunay/parallel.hpp"
#include "stripack/fan.hpp"
#include "stripack/voronoi.hpp"
#include "stripack/voronoi_cell.hpp"

namespace delone::stripack {

namespace {

using std::numbers::pi;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

struct AreaSum {
  HalfAreas halves;
  void add(const Corner& p, const Corner& q) noexcept {
    halves.turn(1, tan_half_excess(p, q));
  }
  void add(const Bisector&, Bisector::Place, Bisector::Place) noexcept {}
  [[nodiscard]] double result(const LocalFrame&) const { return halves.convex_area(); }
  [[nodiscard]] static double whole(const Direction&) { return 4 * pi; }
};

struct MomentSum {
  HalfAreas halves;
  LocalVector moment;

  void add(const Corner& p, const Corner& q) noexcept {
    const LocalVector part = fan_moment(p, q);
    halves.turn(1, tan_half_excess(p, q));
    moment.up += part.up;
    moment.x += part.x;
    moment.y += part.y;
  }
  void add(const Bisector& bisector, Bisector::Place from, Bisector::Place to) noexcept {
    const LocalVector normal = bisector.inward();
    const double half = length_between(from, to) / 2;
    moment.up += half * normal.up;
    moment.x += half * normal.x;
    moment.y += half * normal.y;
  }
  [[nodiscard]] CellMeasure result(const LocalFrame& frame) const {
    const bool has_moment = moment.up != 0 || moment.x != 0 || moment.y != 0;
    return {halves.convex_area(),
            frame.direction(has_moment ? moment : LocalVector{1, 0, 0})};
  }
  [[nodiscard]] static CellMeasure whole(const Direction& site) { return {4 * pi, site}; }
};

template <class Sum>
class CellMeasurer {
 public:
  CellMeasurer(const Triangulation& t, const CellNeighbors& neighbors)
      : points_(t.points()), neighbors_(neighbors) {}

  [[nodiscard]] auto operator()(Site s) const {
    const auto around = neighbors_(s);
    const LocalFrame frame(point(s));
    if (around.empty()) return Sum::whole(point(s));
    if (around.size() > 2) {
      if (const auto sum = near_cell(frame, around)) return sum->result(frame);
    }
    return around.size() == 1 ? hemisphere(frame, around[0]) : far_cell(frame, around);
  }

 private:
  [[nodiscard]] const Direction& point(Site s) const { return points_[at(s)]; }

  // The fan of the site over its corners; nothing if one is far away.
  [[nodiscard]] std::optional<Sum> near_cell(const LocalFrame& frame,
                                             std::span<const Site> around) const {
    Site b = around.back();
    Spoke to_b = frame.spoke(point(b));
    const Spoke to_first = frame.spoke(point(around.front()));
    const auto last =
        project(frame.circumcenter(point(b), point(around.front()), to_b, to_first));
    if (!last) return std::nullopt;
    Sum sum;
    Corner corner = *last;
    b = around.front();
    to_b = to_first;
    for (std::size_t k = 1; k < around.size(); ++k) {
      const Site c = around[k];
      const Spoke to_c = frame.spoke(point(c));
      const auto next = project(frame.circumcenter(point(b), point(c), to_b, to_c));
      if (!next) return std::nullopt;
      sum.add(corner, *next);
      corner = *next;
      b = c;
      to_b = to_c;
    }
    sum.add(corner, *last);
    return sum;
  }

  // Right triangles between the site, the foot of each bisector and the ends of the edge.
  [[nodiscard]] auto far_cell(const LocalFrame& frame,
                              std::span<const Site> around) const {
    Sum sum;
    const std::size_t n = around.size();
    const auto corner_after = [&](std::size_t k) {
      const Direction &b = point(around[k]), &c = point(around[(k + 1) % n]);
      return frame.circumcenter(b, c, frame.spoke(b), frame.spoke(c));
    };
    LocalVector corner = corner_after(n - 1);
    for (std::size_t k = 0; k < n; ++k) {
      const LocalVector next = corner_after(k);
      const Bisector bisector(frame.spoke(point(around[k])));
      const Bisector::Place from = bisector.place(corner), to = bisector.place(next);
      const auto begin = bisector.half_excess(from), end = bisector.half_excess(to);
      const double sign = passes_the_far_side(from, to) ? -1 : 1;
      sum.halves.turn_and_scale(begin.re, -begin.im);
      sum.halves.turn_and_scale(sign * end.re, sign * end.im);
      sum.add(bisector, from, to);
      corner = next;
    }
    return sum.result(frame);
  }

  [[nodiscard]] auto hemisphere(const LocalFrame& frame, Site other) const {
    Sum sum;
    sum.halves.turn(-1, 0);
    const Bisector bisector(frame.spoke(point(other)));
    const Bisector::Place here{1, 0}, there{-1, 0};
    sum.add(bisector, here, there);
    return sum.result(frame);
  }

  std::span<const Direction> points_;
  const CellNeighbors& neighbors_;
};

template <class Sum, class Result>
std::vector<Result> measure_cells(const Triangulation& t, const RunOptions& options) {
  constexpr std::int64_t chunk = 4096;
  const BackFaces back(t);
  const CellNeighbors neighbors(t, back);
  const CellMeasurer<Sum> measure(t, neighbors);
  std::vector<Result> result(at(t.num_sites()));
  delaunay::parallel_chunks(
      t.num_sites(), chunk, options, [&](std::int64_t first, std::int64_t last) {
        for (auto s = static_cast<Site>(first); s < static_cast<Site>(last); ++s)
          result[at(s)] = measure(s);
      });
  return result;
}

}  // namespace

std::vector<double> voronoi_areas(const Triangulation& t, const RunOptions& options) {
  return measure_cells<AreaSum, double>(t, options);
}

std::vector<CellMeasure> voronoi_measures(const Triangulation& t,
                                          const RunOptions& options) {
  return measure_cells<MomentSum, CellMeasure>(t, options);
}

}  // namespace delone::stripack
