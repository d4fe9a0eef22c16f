#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "delaunay/parallel.hpp"
#include "tripack/circumcenter.hpp"
#include "tripack/voronoi.hpp"
#include "tripack/voronoi_cell.hpp"

namespace delone::tripack {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Twice the area of the triangles from the origin to the sides.
struct AreaSum {
  double area2 = 0;
  void add(Point2 p, Point2 q) noexcept { area2 += p.x * q.y - p.y * q.x; }
  [[nodiscard]] double result(Point2) const noexcept { return area2 / 2; }
  [[nodiscard]] static double none() noexcept { return 0; }
  [[nodiscard]] static double unbounded() noexcept { return infinity; }
};

struct MomentSum {
  double area2 = 0, x6 = 0, y6 = 0;
  void add(Point2 p, Point2 q) noexcept {
    const double cross = p.x * q.y - p.y * q.x;
    area2 += cross;
    x6 += cross * (p.x + q.x);
    y6 += cross * (p.y + q.y);
  }
  [[nodiscard]] CellMeasure result(Point2 origin) const noexcept {
    if (area2 == 0) return none();
    return {area2 / 2, {origin.x + x6 / (3 * area2), origin.y + y6 / (3 * area2)}};
  }
  [[nodiscard]] static CellMeasure none() noexcept { return {0, {nan, nan}}; }
  [[nodiscard]] static CellMeasure unbounded() noexcept { return {infinity, {nan, nan}}; }
};

/// The box around a cell, from the site.
struct Extent {
  Point2 low, high;
  void add(Point2 p) noexcept {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

// The cell of an inner site round its circumcentres.
template <class Sum>
Extent add_whole_cell(const Triangulation& t, Site s, Sum& sum) {
  const auto points = t.points();
  const auto neighbors = t.adjacency().neighbors(s);
  const Point2 p = points[at(s)];
  const Point2 first = points[at(neighbors.front())];
  const Spoke to_first = spoke(p, first);
  Point2 b = points[at(neighbors.back())];
  Spoke to_b = spoke(p, b);
  const Point2 last_corner = circumcenter_offset(p, b, first, to_b, to_first);
  Point2 corner = last_corner;
  Extent extent{corner, corner};
  b = first;
  to_b = to_first;
  for (std::size_t k = 1; k < neighbors.size(); ++k) {
    const Point2 c = points[at(neighbors[k])];
    const Spoke to_c = spoke(p, c);
    const Point2 next = circumcenter_offset(p, b, c, to_b, to_c);
    sum.add(corner, next);
    extent.add(next);
    corner = next;
    b = c;
    to_b = to_c;
  }
  sum.add(corner, last_corner);
  return extent;
}

// Is the cell the one whose corners were found, or has the region or an overflow a say?
Region::Relation relation_of(const Region& region, Point2 p, const Extent& extent,
                             double area2) {
  if (!std::isfinite(area2)) return Region::Relation::crossing;
  if (region.is_plane()) return Region::Relation::inside;
  return region.relation({p.x + extent.low.x, p.y + extent.low.y},
                         {p.x + extent.high.x, p.y + extent.high.y});
}

template <class Sum>
auto measure_cut_cell(const Triangulation& t, Site s, const Region& region) {
  Sum sum;
  for (const Polygon& part : cut_cell(t, s, region)) {
    for (std::size_t i = 0; i < part.size(); ++i)
      sum.add(part[i], part[i + 1 == part.size() ? 0 : i + 1]);
  }
  return sum.result(t.points()[at(s)]);
}

template <class Sum>
auto measure_cell(const Triangulation& t, Site s, const Region& region) {
  const bool is_bounded = t.dimension() == 2 && !t.adjacency().is_boundary(s);
  if (is_bounded) {
    Sum sum;
    const Extent extent = add_whole_cell(t, s, sum);
    const auto relation = relation_of(region, t.points()[at(s)], extent, sum.area2);
    if (relation == Region::Relation::inside) return sum.result(t.points()[at(s)]);
    if (relation == Region::Relation::outside) return Sum::none();
  }
  if (region.is_plane()) return Sum::unbounded();
  return measure_cut_cell<Sum>(t, s, region);
}

template <class Sum, class Result>
std::vector<Result> measure_cells(const Triangulation& t, const Region& region,
                                  const RunOptions& options) {
  constexpr std::int64_t chunk = 4096;
  std::vector<Result> result(at(t.num_sites()));
  delaunay::parallel_chunks(
      t.num_sites(), chunk, options, [&](std::int64_t first, std::int64_t last) {
        for (auto s = static_cast<Site>(first); s < static_cast<Site>(last); ++s)
          result[at(s)] = measure_cell<Sum>(t, s, region);
      });
  return result;
}

}  // namespace

std::vector<double> voronoi_areas(const Triangulation& t, const Region& region,
                                  const RunOptions& options) {
  return measure_cells<AreaSum, double>(t, region, options);
}

std::vector<CellMeasure> voronoi_measures(const Triangulation& t, const Region& region,
                                          const RunOptions& options) {
  return measure_cells<MomentSum, CellMeasure>(t, region, options);
}

}  // namespace delone::tripack
