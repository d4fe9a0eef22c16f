#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/axis_table.hpp"
#include "interp/cursor.hpp"
#include "interp/node_batch.hpp"
#include "interp/plane_reach.hpp"
#include "interp/surface_options.hpp"
#include "interp/triangle_nodes.hpp"

namespace delone::interp {

/// A surface of the plane on a regular grid, triangle by triangle along rows.
///
/// `Cells` has facet(arc), the surface in the triangle on the left of an arc that leaves
/// its smallest site: a function of the scaled point that can fill a row or
/// a batch of nodes; and
/// edge_value(from, to, point) for points on edges.
//
// Whether a node is in a triangle is read off the crossings of its row with the edges
// where these are clear, and decided by the exact predicate where a crossing falls on a
// node up to rounding.
template <class Cells>
class PlaneScan {
 public:
  PlaneScan(const Cells& cells, const Grid& grid, std::vector<double>& out)
      : cells_(cells),
        adjacency_(cells.triangulation().adjacency()),
        x_(grid.x),
        y_(grid.y),
        scaled_x_(grid.x, cells.scale()),
        scaled_y_(grid.y, cells.scale()),
        out_(out) {}

  void scan_triangles(Site first, Site last) {
    for_each_triangle(adjacency_, first, last, [this](Arc a) { scan_triangle(a); });
  }

  void write_sites(Site first, Site last) {
    for (Site s = first; s < last; ++s) {
      const Point2 p = point(s);
      const IndexRange rows{y_.first_from(p.y), y_.first_after(p.y)};
      if (rows.is_empty()) continue;
      const IndexRange columns{x_.first_from(p.x), x_.first_after(p.x)};
      for (std::int64_t j = rows.begin; j < rows.end; ++j) {
        for (std::int64_t i = columns.begin; i < columns.end; ++i)
          node(i, j) = cells_.site_value(s);
      }
    }
  }

  // Nodes outside the triangles, by walking along rows.
  void continue_outside(std::int64_t first_row, std::int64_t last_row) {
    Cursor cursor;
    for (std::int64_t j = first_row; j < last_row; ++j) {
      for (std::int64_t i = 0; i < x_.size(); ++i) {
        if (std::isnan(node(i, j))) node(i, j) = cells_.value({x_[i], y_[j]}, cursor);
      }
    }
  }

 private:
  // Where a row meets the line through an edge, in columns: start + (y - y_start) *
  // slope, y scaled.
  struct Crossing {
    double start = 0, y_start = 0, slope = 0;
    [[nodiscard]] double at_row(double y) const noexcept {
      return start + (y - y_start) * slope;
    }
  };
  struct Triangle {
    Arc arc;
    std::array<Site, 3> corners;
    typename Cells::Facet facet;
    // The row's nodes in the triangle lie between the larger of `low` and the smaller of
    // `high`.
    std::array<Crossing, 2> low{}, high{};
    double flat_y = missing;    // of a horizontal edge: its row is decided node by node
    bool is_uncertain = false;  // crossings beyond floating point: the same for all rows
    IndexRange columns;
    double tolerance = 0;  // bound on the error of a crossing, in columns
    bool is_reached = true;
    NodeBatch* batch = nullptr;
  };

  Point2 point(Site s) const { return cells_.triangulation().points()[at(s)]; }
  double& node(std::int64_t i, std::int64_t j) { return out_[at(j * x_.size() + i)]; }

  void scan_triangle(Arc arc) {
    const std::array<Site, 3> corners = adjacency_.left(arc);
    const std::array<Point2, 3> p{point(corners[0]), point(corners[1]),
                                  point(corners[2])};
    const IndexRange rows{y_.first_from(std::min({p[0].y, p[1].y, p[2].y})),
                          y_.first_after(std::max({p[0].y, p[1].y, p[2].y}))};
    if (rows.is_empty()) return;
    const double tolerance = crossing_tolerance(p);
    const IndexRange columns = columns_between(
        scaled_x_.position(std::min({p[0].x, p[1].x, p[2].x}) * cells_.scale()) -
            tolerance,
        scaled_x_.position(std::max({p[0].x, p[1].x, p[2].x}) * cells_.scale()) +
            tolerance);
    if (columns.is_empty()) return;
    NodeBatch inner;
    Triangle t{.arc = arc,
               .corners = corners,
               .facet = cells_.facet(arc),
               .columns = columns,
               .tolerance = tolerance,
               .is_reached = cells_.reach().covers_triangle(corners),
               .batch = &inner};
    set_crossings(t, p);
    for (std::int64_t j = rows.begin; j < rows.end; ++j) scan_row(t, j);
    if constexpr (FillsBatches<typename Cells::Facet>) t.facet.fill(inner);
  }

  // A crossing is off by some roundings of the coordinates of corners and nodes.
  double crossing_tolerance(const std::array<Point2, 3>& p) const {
    const double corner =
        std::max({std::abs(p[0].x), std::abs(p[1].x), std::abs(p[2].x)}) * cells_.scale();
    return 0x1p-30 + scaled_x_.unevenness() +
           0x1p-46 * (corner + scaled_x_.largest()) / scaled_x_.spacing();
  }

  IndexRange columns_between(double low, double high) const {
    return {x_.first_at(low), x_.first_above(high)};
  }

  // Counter-clockwise, edges that lead down bound the triangle on the left, those that
  // lead up on the right.
  void set_crossings(Triangle& t, const std::array<Point2, 3>& p) const {
    int num_low = 0, num_high = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 from = p[k], to = p[(k + 1) % 3], a = cells_.scaled(from),
                   b = cells_.scaled(to);
      if (from.y == to.y) {
        t.flat_y = a.y;
        continue;
      }
      const Crossing c{scaled_x_.position(a.x), a.y,
                       (b.x - a.x) / (b.y - a.y) / scaled_x_.spacing()};
      if (!(std::abs(c.slope) < 0x1p1000))
        t.is_uncertain = true;  // also NaN, where the difference underflowed
      auto& side = from.y > to.y ? t.low : t.high;
      int& count = from.y > to.y ? num_low : num_high;
      if (count == 0) side[1] = c;
      side[static_cast<std::size_t>(count++)] = c;
    }
  }

  void scan_row(const Triangle& t, std::int64_t j) {
    const double y = scaled_y_[j];
    if (t.is_uncertain || y == t.flat_y) return decide(t, t.columns, j);
    const double low = std::max(t.low[0].at_row(y), t.low[1].at_row(y));
    const double high = std::min(t.high[0].at_row(y), t.high[1].at_row(y));
    const std::int64_t begin = first_column(t, low + t.tolerance),
                       end = first_column(t, high - t.tolerance);
    const bool is_doubtful_left =
        static_cast<double>(begin - 1) >= low - t.tolerance && begin > t.columns.begin;
    const bool is_doubtful_right =
        static_cast<double>(end) <= high + t.tolerance && end < t.columns.end;
    if (is_doubtful_left || is_doubtful_right) return scan_doubtful_row(t, low, high, j);
    if (begin < end) fill(t, {begin, end}, j);
  }

  // The first of the triangle's columns that is not below a position.
  static std::int64_t first_column(const Triangle& t, double position) {
    // In this order NaN becomes a bound.
    const double clamped =
        std::min(static_cast<double>(t.columns.end),
                 std::max(static_cast<double>(t.columns.begin), position));
    const auto down = static_cast<std::int64_t>(clamped);
    return down + (static_cast<double>(down) < clamped ? 1 : 0);
  }

  void scan_doubtful_row(const Triangle& t, double low, double high, std::int64_t j) {
    const IndexRange left{first_column(t, low - t.tolerance),
                          first_column(t, low + t.tolerance)};
    const IndexRange right{first_column(t, high - t.tolerance),
                           first_column(t, std::floor(high + t.tolerance) + 1)};
    if (right.begin <= left.end) return decide(t, {left.begin, right.end}, j);
    decide(t, left, j);
    fill(t, {left.end, right.begin}, j);
    decide(t, right, j);
  }

  void fill(const Triangle& t, IndexRange columns, std::int64_t j) {
    if constexpr (FillsBatches<typename Cells::Facet>) {
      gather(t, columns, j);
    } else {
      t.facet.fill_row(&node(0, j), scaled_x_.data(), columns, scaled_y_[j]);
      if (t.is_reached) return;
      for (std::int64_t i = columns.begin; i < columns.end; ++i) {
        if (!is_reached(t, i, j)) node(i, j) = missing;
      }
    }
  }

  void gather(const Triangle& t, IndexRange columns, std::int64_t j) {
    NodeBatch& batch = *t.batch;
    for (std::int64_t i = columns.begin; i < columns.end; ++i) {
      if (!is_reached(t, i, j)) continue;  // stays missing
      if (batch.is_full()) t.facet.fill(batch);
      batch.add(&node(i, j), scaled_x_[i], scaled_y_[j]);
    }
  }

  bool is_reached(const Triangle& t, std::int64_t i, std::int64_t j) const {
    return t.is_reached || cells_.reach().covers({x_[i], y_[j]}, t.corners[0]);
  }

  void decide(const Triangle& t, IndexRange columns, std::int64_t j) {
    for (std::int64_t i = columns.begin; i < columns.end; ++i) decide_node(t, i, j);
  }

  void decide_node(const Triangle& t, std::int64_t i, std::int64_t j) {
    const Point2 scaled{scaled_x_[i], scaled_y_[j]};
    const Holding held =
        holding(cells_.triangulation().points(), t.corners, Point2{x_[i], y_[j]});
    if (held.kind == Holding::Kind::interior) {
      node(i, j) = t.facet(scaled);
    } else if (held.kind == Holding::Kind::edge &&
               owns_edge(adjacency_, t.arc, held.edge)) {
      const Spot s = edge_spot(t.corners[held.edge], t.corners[(held.edge + 1) % 3]);
      node(i, j) = cells_.edge_value(s.sites[0], s.sites[1], scaled);
    } else {
      return;
    }
    if (!is_reached(t, i, j)) node(i, j) = missing;
  }

  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  const Cells& cells_;
  const Adjacency& adjacency_;
  AxisTable x_, y_, scaled_x_, scaled_y_;
  std::vector<double>& out_;
};

template <class Cells>
[[nodiscard]] std::vector<double> scan_plane(const Cells& cells, const Grid& grid,
                                             const RunOptions& run) {
  check(grid);
  constexpr std::int64_t site_chunk = 1024;
  std::vector<double> out(at(grid.size()), std::numeric_limits<double>::quiet_NaN());
  PlaneScan<Cells> scan(cells, grid, out);
  const Site num_sites = cells.triangulation().num_sites();
  const bool has_triangles = cells.triangulation().dimension() == 2;
  if (has_triangles) {
    delaunay::parallel_chunks(num_sites, site_chunk, run,
                              [&](std::int64_t first, std::int64_t last) {
                                scan.scan_triangles(static_cast<Site>(first),
                                                    static_cast<Site>(last));
                              },
                              {0, 0.8});
    scan.write_sites(0, num_sites);
  }
  if (!has_triangles || cells.options().outside != Outside::missing) {
    constexpr std::int64_t row_chunk = 16;
    delaunay::parallel_chunks(grid.y.size, row_chunk, run,
                              [&](std::int64_t first, std::int64_t last) {
                                scan.continue_outside(first, last);
                              },
                              {0.8, 1});
  }
  return out;
}

}  // namespace delone::interp
