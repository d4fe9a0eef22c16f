#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/axis_table.hpp"
#include "interp/cursor.hpp"
#include "interp/fresh_values.hpp"
#include "interp/grid_lanes.hpp"
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
// node up to rounding. Triangles of few rows and columns: grid_lanes.hpp.
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
        padded_x_(padded(scaled_x_.data(), scaled_x_.size())),
        slack_(position_errors()),
        has_blocks_(slack_.x < 0.25 && slack_.y < 0.25),
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
  using Facet = typename Cells::Facet;
  struct Named {
    Arc arc;
    std::array<Site, 3> corners;
  };
  struct Triangle {
    const Named* named;
    Facet facet;
    bool is_reached = true;
    NodeBatch* batch = nullptr;
  };
  struct Outline {
    // The row's nodes in the triangle lie between the larger of `low` and the smaller of
    // `high`.
    std::array<Crossing, 2> low{}, high{};
    double flat_y = missing;    // of a horizontal edge: its row is decided node by node
    bool is_uncertain = false;  // crossings beyond floating point: the same for all rows
    IndexRange columns;
    double tolerance = 0;  // bound on the error of a crossing, in columns
  };

  Point2 point(Site s) const { return cells_.triangulation().points()[at(s)]; }
  double& node(std::int64_t i, std::int64_t j) { return out_[at(j * x_.size() + i)]; }

  void scan_triangle(Arc arc) {
    const Named named{arc, adjacency_.left(arc)};
    const std::array<Point2, 3> p{point(named.corners[0]), point(named.corners[1]),
                                  point(named.corners[2])};
    if (has_blocks_) {
      const NodeBlock block = block_around(p);
      if (block.is_empty() || (block.is_small() && scan_block(named, p, block))) return;
    }
    scan_outline(named, p);
  }

  NodeBlock block_around(const std::array<Point2, 3>& p) const {
    const auto range = [&](const AxisTable& axis, double a, double b, double c,
                           double slack) {
      return IndexRange{
          axis.first_at(axis.position(least(a, b, c) * cells_.scale()) - slack),
          axis.first_above(axis.position(largest(a, b, c) * cells_.scale()) + slack)};
    };
    return {range(scaled_x_, p[0].x, p[1].x, p[2].x, slack_.x),
            range(scaled_y_, p[0].y, p[1].y, p[2].y, slack_.y)};
  }

  // False: not for blocks, nothing is written.
  bool scan_block(const Named& named, const std::array<Point2, 3>& p,
                  const NodeBlock& block) {
    NodeBatch batch;
    const Triangle t = triangle(named, &batch);
    const PlaneAxes axes{padded_x_.data(), scaled_y_.data()};
    const auto decide_doubtful = [&](const NodeMask& doubtful) {
      for_each_node(doubtful, block,
                    [&](std::int64_t i, std::int64_t j) { decide_node(t, i, j); });
    };
    if constexpr (FillsBatches<Facet>) {
      const Cover c = cover(sides_of(p), axes, block);
      for_each_node(c.inside, block, [&](std::int64_t i, std::int64_t j) {
        gather(t, {i, i + 1}, j);
      });
      t.facet.fill(batch);
      decide_doubtful(c.doubtful);
    } else {
      const auto formula = t.facet.formula();
      if (!formula || !t.is_reached) return false;
      decide_doubtful(
          fill_block(sides_of(p), *formula, axes, block, {out_.data(), x_.size()}));
    }
    return true;
  }

  void scan_outline(const Named& named, const std::array<Point2, 3>& p) {
    const IndexRange rows{y_.first_from(least(p[0].y, p[1].y, p[2].y)),
                          y_.first_after(largest(p[0].y, p[1].y, p[2].y))};
    if (rows.is_empty()) return;
    Outline outline{.tolerance = crossing_tolerance(p)};
    outline.columns = columns_between(
        scaled_x_.position(least(p[0].x, p[1].x, p[2].x) * cells_.scale()) -
            outline.tolerance,
        scaled_x_.position(largest(p[0].x, p[1].x, p[2].x) * cells_.scale()) +
            outline.tolerance);
    if (outline.columns.is_empty()) return;
    set_crossings(outline, p);
    NodeBatch batch;
    const Triangle t = triangle(named, &batch);
    for (std::int64_t j = rows.begin; j < rows.end; ++j) scan_row(t, outline, j);
    if constexpr (FillsBatches<Facet>) t.facet.fill(batch);
  }

  Triangle triangle(const Named& named, NodeBatch* batch) const {
    return {&named, cells_.facet(named.arc),
            cells_.reach().covers_triangle(named.corners), batch};
  }

  PlaneSides sides_of(const std::array<Point2, 3>& p) const {
    PlaneSides s;
    double width = 0, height = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 from = cells_.scaled(p[k]), to = cells_.scaled(p[(k + 1) % 3]);
      s.x[k] = from.x, s.y[k] = from.y;
      s.dx[k] = to.x - from.x, s.dy[k] = to.y - from.y;
      width = std::max(width, std::abs(s.dx[k]));
      height = std::max(height, std::abs(s.dy[k]));
    }
    // Rows and columns of the block reach a spacing beyond the triangle, the columns of
    // the last group seven more.
    s.error = 0x1p-50 * (width * (height + scaled_y_.spacing()) +
                         height * (width + 16 * scaled_x_.spacing())) +
              0x1p-1000;
    return s;
  }

  // A crossing is off by some roundings of the coordinates of corners and nodes.
  double crossing_tolerance(const std::array<Point2, 3>& p) const {
    return position_error(scaled_x_,
                          largest(std::abs(p[0].x), std::abs(p[1].x), std::abs(p[2].x)));
  }

  double position_error(const AxisTable& scaled_axis, double largest_coordinate) const {
    return 0x1p-30 + scaled_axis.unevenness() +
           0x1p-46 * (largest_coordinate * cells_.scale() + scaled_axis.largest()) /
               scaled_axis.spacing();
  }

  // Of all corners.
  Point2 position_errors() const {
    Point2 far{0, 0};
    for (const Point2 p : cells_.triangulation().points())
      far = {std::max(far.x, std::abs(p.x)), std::max(far.y, std::abs(p.y))};
    return {position_error(scaled_x_, far.x), position_error(scaled_y_, far.y)};
  }

  static double least(double a, double b, double c) {
    return std::min(std::min(a, b), c);
  }
  static double largest(double a, double b, double c) {
    return std::max(std::max(a, b), c);
  }

  IndexRange columns_between(double low, double high) const {
    return {x_.first_at(low), x_.first_above(high)};
  }

  // Counter-clockwise, edges that lead down bound the triangle on the left, those that
  // lead up on the right.
  void set_crossings(Outline& t, const std::array<Point2, 3>& p) const {
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

  void scan_row(const Triangle& t, const Outline& o, std::int64_t j) {
    const double y = scaled_y_[j];
    if (o.is_uncertain || y == o.flat_y) return decide(t, o.columns, j);
    const double low = std::max(o.low[0].at_row(y), o.low[1].at_row(y));
    const double high = std::min(o.high[0].at_row(y), o.high[1].at_row(y));
    const std::int64_t begin = first_column(o, low + o.tolerance),
                       end = first_column(o, high - o.tolerance);
    const bool is_doubtful_left =
        static_cast<double>(begin - 1) >= low - o.tolerance && begin > o.columns.begin;
    const bool is_doubtful_right =
        static_cast<double>(end) <= high + o.tolerance && end < o.columns.end;
    if (is_doubtful_left || is_doubtful_right)
      return scan_doubtful_row(t, o, low, high, j);
    if (begin < end) fill(t, {begin, end}, j);
  }

  // The first of the triangle's columns that is not below a position.
  static std::int64_t first_column(const Outline& o, double position) {
    // In this order NaN becomes a bound.
    const double clamped =
        std::min(static_cast<double>(o.columns.end),
                 std::max(static_cast<double>(o.columns.begin), position));
    const auto down = static_cast<std::int64_t>(clamped);
    return down + (static_cast<double>(down) < clamped ? 1 : 0);
  }

  void scan_doubtful_row(const Triangle& t, const Outline& o, double low, double high,
                         std::int64_t j) {
    const IndexRange left{first_column(o, low - o.tolerance),
                          first_column(o, low + o.tolerance)};
    const IndexRange right{first_column(o, high - o.tolerance),
                           first_column(o, std::floor(high + o.tolerance) + 1)};
    if (right.begin <= left.end) return decide(t, {left.begin, right.end}, j);
    decide(t, left, j);
    fill(t, {left.end, right.begin}, j);
    decide(t, right, j);
  }

  void fill(const Triangle& t, IndexRange columns, std::int64_t j) {
    if constexpr (FillsBatches<Facet>) {
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
    return t.is_reached || cells_.reach().covers({x_[i], y_[j]}, t.named->corners[0]);
  }

  void decide(const Triangle& t, IndexRange columns, std::int64_t j) {
    for (std::int64_t i = columns.begin; i < columns.end; ++i) decide_node(t, i, j);
  }

  void decide_node(const Triangle& t, std::int64_t i, std::int64_t j) {
    const Point2 scaled{scaled_x_[i], scaled_y_[j]};
    const Holding held =
        holding(cells_.triangulation().points(), t.named->corners, Point2{x_[i], y_[j]});
    if (held.kind == Holding::Kind::interior) {
      node(i, j) = t.facet(scaled);
    } else if (held.kind == Holding::Kind::edge &&
               owns_edge(adjacency_, t.named->arc, held.edge)) {
      const Spot s =
          edge_spot(t.named->corners[held.edge], t.named->corners[(held.edge + 1) % 3]);
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
  std::vector<double> padded_x_;
  Point2 slack_;  // bound on the error of corners' positions, in columns and rows
  bool has_blocks_;
  std::vector<double>& out_;
};

template <class Cells>
[[nodiscard]] std::vector<double> scan_plane(const Cells& cells, const Grid& grid,
                                             const RunOptions& run) {
  check(grid);
  constexpr std::int64_t site_chunk = 1024;
  std::vector<double> out =
      fresh_values(at(grid.size()), std::numeric_limits<double>::quiet_NaN());
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
