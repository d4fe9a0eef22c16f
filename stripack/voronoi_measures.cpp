#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "delaunay/instruction_set.hpp"
#include "delaunay/parallel.hpp"
#include "stripack/cell_corners.hpp"
#include "stripack/fan.hpp"
#include "stripack/voronoi.hpp"
#include "stripack/voronoi_cell.hpp"

namespace delone::stripack {

namespace {

using std::numbers::pi;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

using Corners = CellCorners<delaunay::Portable>;

struct AreaSum {
  void add(const Bisector&, Bisector::Place, Bisector::Place) noexcept {}
  [[nodiscard]] double result(double area, const LocalFrame&) const { return area; }
  [[nodiscard]] static double whole(const Direction&) { return 4 * pi; }
};

struct MomentSum {
  LocalVector moment;

  void add(const Corners& corners) noexcept {
    Corner p = corners[corners.size() - 1];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner q = corners[k];
      const LocalVector part = fan_moment(p, q);
      moment.up += part.up;
      moment.x += part.x;
      moment.y += part.y;
      p = q;
    }
  }
  void add(const Bisector& bisector, Bisector::Place from, Bisector::Place to) noexcept {
    const LocalVector normal = bisector.inward();
    const double half = length_between(from, to) / 2;
    moment.up += half * normal.up;
    moment.x += half * normal.x;
    moment.y += half * normal.y;
  }
  [[nodiscard]] CellMeasure result(double area, const LocalFrame& frame) const {
    const bool has_moment = moment.up != 0 || moment.x != 0 || moment.y != 0;
    return {area, frame.direction(has_moment ? moment : LocalVector{1, 0, 0})};
  }
  [[nodiscard]] static CellMeasure whole(const Direction& site) { return {4 * pi, site}; }
};

/// Cells that have few corners or reach far.
template <class Sum>
class LargeCells {
 public:
  LargeCells(std::span<const Direction> points, const CellNeighbors& neighbors)
      : points_(points), neighbors_(neighbors) {}

  [[nodiscard]] auto operator()(Site s) const {
    const auto around = neighbors_(s);
    const LocalFrame frame(point(s));
    if (around.empty()) return Sum::whole(point(s));
    return around.size() == 1 ? hemisphere(frame, around[0]) : far_cell(frame, around);
  }

 private:
  [[nodiscard]] const Direction& point(Site s) const { return points_[at(s)]; }

  // Right triangles between the site, the foot of each bisector and the ends of the edge.
  [[nodiscard]] auto far_cell(const LocalFrame& frame,
                              std::span<const Site> around) const {
    Sum sum;
    HalfAreas halves;
    bool is_behind = false;
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
      halves.turn_and_scale(begin.re, -begin.im);
      halves.turn_and_scale(sign * end.re, sign * end.im);
      is_behind = is_behind || next.up < -0.5 * std::hypot(next.x, next.y);
      sum.add(bisector, from, to);
      corner = next;
    }
    const double area = is_behind ? area_by_angles(frame, around) : halves.convex_area();
    return sum.result(area, frame);
  }

  // Edges that run from the site's side of the sphere to the other may be longer than pi
  // by rounding, and then no longer tell on which side of the site they pass. The poles
  // of the edges tell: they are the directions from the site to its neighbours in space,
  // the angle between two in a row is the turn at the corner, and 2 pi less all turns is
  // the area.
  [[nodiscard]] double area_by_angles(const LocalFrame& frame,
                                      std::span<const Site> around) const {
    LocalVector before = Bisector(frame.spoke(point(around.back()))).inward();
    double area = 2 * pi;
    for (const Site w : around) {
      const LocalVector p = Bisector(frame.spoke(point(w))).inward();
      const double up = before.x * p.y - before.y * p.x,
                   x = before.y * p.up - before.up * p.y,
                   y = before.up * p.x - before.x * p.up;
      area -= std::atan2(std::hypot(up, x, y),
                         before.up * p.up + before.x * p.x + before.y * p.y);
      before = p;
    }
    return std::max(area, 0.0);
  }

  [[nodiscard]] auto hemisphere(const LocalFrame& frame, Site other) const {
    Sum sum;
    const Bisector bisector(frame.spoke(point(other)));
    const Bisector::Place here{1, 0}, there{-1, 0};
    sum.add(bisector, here, there);
    return sum.result(2 * pi, frame);
  }

  std::span<const Direction> points_;
  const CellNeighbors& neighbors_;
};

HalfAreaFunction half_areas() noexcept {
#ifdef DELONE_AVX2
  if (__builtin_cpu_supports("avx2") != 0) return half_areas_avx2();
#endif
  return HalfAreaWork<delaunay::Portable>::work;
}

void measure(std::span<const Direction> points, const CellNeighbors& neighbors,
             Site first, std::span<double> result) {
  constexpr std::size_t num_halves = 256;
  const HalfAreaFunction work = half_areas();
  const LargeCells<AreaSum> large(points, neighbors);
  std::array<HalfAreas, num_halves> halves;
  while (!result.empty()) {
    const std::size_t n = std::min(result.size(), num_halves);
    work(points, neighbors, first, std::span(halves).first(n));
    for (std::size_t i = 0; i < n; ++i, ++first) {
      const bool is_found = halves[i].re != 0 || halves[i].im != 0;
      result[i] = is_found ? halves[i].convex_area() : large(first);
    }
    result = result.subspan(n);
  }
}

void measure(std::span<const Direction> points, const CellNeighbors& neighbors,
             Site first, std::span<CellMeasure> result) {
  const LargeCells<MomentSum> large(points, neighbors);
  Corners corners;
  for (CellMeasure& cell : result) {
    const auto around = neighbors(first);
    const LocalFrame frame(points[at(first)]);
    if (around.size() > 2 && corners.place(frame, points, around)) {
      MomentSum sum;
      sum.add(corners);
      cell = sum.result(corners.half_area().convex_area(), frame);
    } else {
      cell = large(first);
    }
    ++first;
  }
}

template <class Result>
std::vector<Result> measure_cells(const Triangulation& t, const RunOptions& options) {
  constexpr std::int64_t chunk = 4096;
  const BackFaces back(t);
  const CellNeighbors neighbors(t, back);
  std::vector<Result> result(at(t.num_sites()));
  delaunay::parallel_chunks(
      t.num_sites(), chunk, options, [&](std::int64_t first, std::int64_t last) {
        measure(t.points(), neighbors, static_cast<Site>(first),
                std::span(result).subspan(static_cast<std::size_t>(first),
                                          static_cast<std::size_t>(last - first)));
      });
  return result;
}

}  // namespace

std::vector<double> voronoi_areas(const Triangulation& t, const RunOptions& options) {
  return measure_cells<double>(t, options);
}

std::vector<CellMeasure> voronoi_measures(const Triangulation& t,
                                          const RunOptions& options) {
  return measure_cells<CellMeasure>(t, options);
}

}  // namespace delone::stripack
