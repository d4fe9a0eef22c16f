#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/circle_gaps.hpp"
#include "interp/cursor.hpp"
#include "interp/fresh_values.hpp"
#include "interp/globe_table.hpp"
#include "interp/grid_lanes.hpp"
#include "interp/node_batch.hpp"
#include "interp/sphere_edge.hpp"
#include "interp/sphere_reach.hpp"
#include "interp/sphere_scan_places.hpp"
#include "interp/surface_options.hpp"
#include "interp/triangle_nodes.hpp"
#include "stripack/great_circle.hpp"

namespace delone::interp {

/// A surface of the sphere on a longitude-latitude grid, triangle by triangle along rows.
/// What `Cells` has, PlaneScan tells.
//
// Along a row of latitude the side of an edge's plane, n . p, is a cosine of longitude
// plus a constant: each edge leaves out an arc of the row around the meridian opposite to
// its normal, and the triangle holds the gaps between these arcs: up to three, round the
// date line or the pole, as it comes. Nodes near the end of a gap, where rounding could
// tell the wrong side, are decided by the exact predicate. Triangles of few rows and
// columns: grid_lanes.hpp.
template <class Cells>
class SphereScan {
 public:
  SphereScan(const Cells& cells, const Grid& grid, const RunOptions& run,
             std::vector<double>& out)
      : cells_(cells),
        points_(cells.triangulation().points()),
        adjacency_(cells.triangulation().adjacency()),
        table_(grid),
        columns_per_radian_(table_.turn() / (2 * std::numbers::pi)),
        first_lon_(std::fmod(table_.lon().position(0), table_.turn())),
        padded_cos_(padded(table_.cos_lon(), table_.columns())),
        padded_sin_(padded(table_.sin_lon(), table_.columns())),
        places_(points_, table_, run),
        out_(out) {}

  void scan_triangles(Site first, Site last) {
    for_each_triangle(adjacency_, first, last, [this](Arc a) { scan_triangle(a); });
  }

  void write_sites(Site first, Site last) {
    for (Site s = first; s < last; ++s) {
      const double z = points_[at(s)].z();
      const IndexRange rows = table_.rows_between(z, z);
      for (std::int64_t j = rows.begin; j < rows.end; ++j) write_site_in_row(s, j);
    }
  }

  // Nodes outside the triangles, by walking along rows.
  void continue_outside(std::int64_t first_row, std::int64_t last_row) {
    Cursor cursor;
    for (std::int64_t j = first_row; j < last_row; ++j) {
      for (std::int64_t i = 0; i < table_.columns(); ++i) {
        if (std::isnan(node(i, j))) node(i, j) = cells_.value(table_.node(i, j), cursor);
      }
    }
  }

  void write_poles() {
    for (std::int64_t j = 0; j < table_.rows(); ++j) {
      if (!table_.is_pole(j)) continue;
      Cursor cursor;
      const double value = cells_.value(table_.node(0, j), cursor);
      for (std::int64_t i = 0; i < table_.columns(); ++i) node(i, j) = value;
    }
  }

 private:
  using Facet = typename Cells::Facet;
  using Edges = std::array<SphereEdge, 3>;
  using Corners = std::array<Vector3, 3>;
  struct Named {
    Arc arc;
    std::array<Site, 3> corners;
  };
  struct Triangle {
    const Named* named;
    Facet facet;
    bool is_reached;
    NodeBatch* batch;
  };
  // A span of positions in columns.
  struct Span {
    double low, high;
  };

  double& node(std::int64_t i, std::int64_t j) {
    return out_[at(j * table_.columns() + i)];
  }

  void scan_triangle(Arc arc) {
    const Named named{arc, adjacency_.left(arc)};
    const auto point = [&](std::size_t k) {
      return vector(points_[at(named.corners[k])]);
    };
    const Corners p{point(0), point(1), point(2)};
    const std::optional<SphereScanPlaces::Box> box = places_.box(named.corners, p);
    if (!box || !scan_box(named, p, *box)) scan_outline(named, p);
  }

  // False: not for blocks, nothing is written.
  bool scan_box(const Named& named, const Corners& p, const SphereScanPlaces::Box& box) {
    if (box.rows.is_empty()) return true;
    const SphereSides sides = sides_of(p);
    if (!(box.high - box.low < NodeBlock::most - 2) ||
        box.rows.end - box.rows.begin > NodeBlock::most || !(sides.error > 0x1p-400))
      return false;
    NodeBatch batch;
    const Triangle t = triangle(named, &batch);
    const auto for_each_block = [&](auto f) {
      table_.for_each_turn(box.low, box.high, 0, [&](double shift) {
        const NodeBlock block{columns_between(box.low + shift, box.high + shift),
                              box.rows};
        if (!block.is_empty()) f(block);
      });
    };
    if constexpr (FillsBatches<Facet>) {
      for_each_block([&](const NodeBlock& block) { gather_block(t, sides, block); });
      t.facet.fill(batch);
    } else {
      const auto formula = t.facet.formula();
      if (!formula || !t.is_reached) return false;
      for_each_block([&](const NodeBlock& block) {
        decide(
            t, block,
            fill_block(sides, *formula, axes(), block, {out_.data(), table_.columns()}));
      });
    }
    return true;
  }

  GlobeAxes axes() const {
    return {padded_cos_.data(), padded_sin_.data(), table_.cos_lat(), table_.sin_lat()};
  }

  void gather_block(const Triangle& t, const SphereSides& sides, const NodeBlock& block) {
    const Cover c = cover(sides, axes(), block);
    for_each_node(c.inside, block, [&](std::int64_t i, std::int64_t j) {
      gather(t, {i, i + 1}, j);
    });
    decide(t, block, c.doubtful);
  }

  void decide(const Triangle& t, const NodeBlock& block, const NodeMask& doubtful) {
    for_each_node(doubtful, block,
                  [&](std::int64_t i, std::int64_t j) { decide_node(t, i, j); });
  }

  // Normals are off by some roundings of the side, which may be much larger than the
  // part of it that is across the corner's direction.
  static SphereSides sides_of(const Corners& p) {
    SphereSides s;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 side = p[(k + 1) % 3] - p[k];
      s.normals[k] = cross(p[k], side);
      longest = std::max(longest, dot(side, side));
    }
    s.error = 0x1p-47 * std::sqrt(longest);
    return s;
  }

  Triangle triangle(const Named& named, NodeBatch* batch) const {
    return {&named, cells_.facet(named.arc),
            cells_.reach().covers_triangle(named.corners), batch};
  }

  void scan_outline(const Named& named, const Corners& p) {
    Edges edges{sphere_edge(p[0], p[1]), sphere_edge(p[1], p[2]),
                sphere_edge(p[2], p[0])};
    const IndexRange rows = rows_of(edges);
    if (rows.is_empty()) return;
    for (SphereEdge& e : edges) {
      e.opposite =
          first_lon_ + std::atan2(-e.y_normal, -e.x_normal) * columns_per_radian_;
    }
    NodeBatch batch;
    const Triangle t = triangle(named, &batch);
    if (const std::optional<Span> span = narrow_span(p, edges)) {
      scan_narrow(t, edges, *span, rows);
    } else {
      for (std::int64_t j = rows.begin; j < rows.end; ++j) scan_row(t, edges, j);
    }
    if constexpr (FillsBatches<Facet>) t.facet.fill(batch);
  }

  IndexRange rows_of(const Edges& edges) const {
    const bool is_northern = may_hold_pole(edges, 1),
               is_southern = may_hold_pole(edges, -1);
    return table_.rows_between(
        is_southern ? -1 : std::min({edges[0].bottom, edges[1].bottom, edges[2].bottom}),
        is_northern ? 1 : std::max({edges[0].top, edges[1].top, edges[2].top}));
  }

  // Positions between which the triangle lies, if they are few and no pole is near. A
  // point as far as d from another whose distance from the axis is r differs from it in
  // longitude by at most asin(d / r) <= pi / 2 d / r.
  std::optional<Span> narrow_span(const Corners& p, const Edges& edges) const {
    if (may_hold_pole(edges, 1) || may_hold_pole(edges, -1)) return {};
    const Vector3 a = p[0], u = p[1] - a, w = p[2] - a;
    const double reach = std::max(dot(u, u), dot(w, w)) / (a.x * a.x + a.y * a.y);
    if (!(reach < 0.04)) return {};
    const double column = first_lon_ + std::atan2(a.y, a.x) * columns_per_radian_;
    const double width =
        std::numbers::pi / 2 * std::sqrt(reach) * columns_per_radian_ + 1;
    return Span{column - width, column + width};
  }

  void scan_narrow(const Triangle& t, Edges edges, Span span, IndexRange rows) {
    const double turn = table_.turn();
    table_.for_each_turn(span.low, span.high, 0, [&](double shift) {
      const Span shifted{span.low + shift, span.high + shift};
      for (SphereEdge& e : edges) {  // the copy that is nearest to the triangle
        while (e.opposite < shifted.low - turn / 2) e.opposite += turn;
        while (e.opposite > shifted.low + turn / 2) e.opposite -= turn;
      }
      for (std::int64_t j = rows.begin; j < rows.end; ++j)
        scan_narrow_row(t, edges, shifted, j);
    });
  }

  // Near a narrow triangle only one end of the arc that an edge leaves out matters (or
  // none), so that the row's nodes are those between the largest low end and the smallest
  // high one. Where an edge bulges across the row and where nodes are in doubt, scan_row
  // sorts it out.
  void scan_narrow_row(const Triangle& t, const Edges& edges, Span span, std::int64_t j) {
    double slack = table_.tolerance(), low = span.low, high = span.high;
    for (const SphereEdge& e : edges) {
      const LeftOut out = left_out(e, table_.cos_lat(j), table_.sin_lat(j));
      if (out.kind == LeftOut::Kind::everything) return;
      if (out.kind == LeftOut::Kind::unknown) return scan_row(t, edges, j);
      if (out.kind == LeftOut::Kind::nothing) continue;
      const double half_width = out.half_width * columns_per_radian_;
      const double begin = e.opposite - half_width, end = e.opposite + half_width;
      if (begin > span.low && end < span.high) return scan_row(t, edges, j);
      // The arc's next copies lie a turn away.
      low = std::max(low, begin <= span.low ? end : end - table_.turn());
      high = std::min(high, begin <= span.low ? begin + table_.turn() : begin);
      slack = std::max(slack, out.slack * columns_per_radian_ + table_.tolerance());
    }
    const AxisTable& lon = table_.lon();
    const std::int64_t begin = lon.first_at(low + slack),
                       end = lon.first_at(high - slack);
    const bool is_doubtful_left =
        begin > 0 && static_cast<double>(begin - 1) >= low - slack;
    const bool is_doubtful_right =
        end < lon.size() && static_cast<double>(end) <= high + slack;
    if (is_doubtful_left || is_doubtful_right || slack > 0.25)
      return scan_row(t, edges, j);
    if (begin < end) fill(t, {begin, end}, j);
  }

  void scan_row(const Triangle& t, const Edges& edges, std::int64_t j) {
    CircleGaps gaps(table_.turn());
    double slack = 0;
    bool is_clear = true;
    for (const SphereEdge& e : edges) {
      const LeftOut out = left_out(e, table_.cos_lat(j), table_.sin_lat(j));
      if (out.kind == LeftOut::Kind::everything) return;
      if (out.kind == LeftOut::Kind::unknown) is_clear = false;
      if (out.kind != LeftOut::Kind::arc) continue;
      gaps.exclude(e.opposite, out.half_width * columns_per_radian_);
      slack = std::max(slack, out.slack * columns_per_radian_ + table_.tolerance());
    }
    // Where the row runs along an edge (the equator, nodes around a pole) every node is
    // doubtful.
    const auto scan_columns = [&](IndexRange doubtful_left, IndexRange doubtful_right) {
      if (!is_clear || doubtful_right.begin <= doubtful_left.end) {
        return decide(t, {doubtful_left.begin, doubtful_right.end}, j);
      }
      decide(t, doubtful_left, j);
      fill(t, {doubtful_left.end, doubtful_right.begin}, j);
      decide(t, doubtful_right, j);
    };
    if (gaps.is_whole_circle())
      return scan_columns({0, 0}, {table_.columns(), table_.columns()});
    gaps.for_each_gap(2 * slack, [&](double begin, double end) {
      table_.for_each_turn(begin, end, slack, [&](double shift) {
        scan_columns(columns_between(begin + shift - slack, begin + shift + slack),
                     columns_between(end + shift - slack, end + shift + slack));
      });
    });
  }

  IndexRange columns_between(double low, double high) const {
    return {table_.lon().first_at(low), table_.lon().first_above(high)};
  }

  void fill(const Triangle& t, IndexRange columns, std::int64_t j) {
    if constexpr (FillsBatches<Facet>) {
      gather(t, columns, j);
    } else {
      t.facet.fill_row(&node(0, j), table_, columns, j);
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
      const Vector3 p = table_.vector(i, j);
      batch.add(&node(i, j), p.x, p.y, p.z);
    }
  }

  bool is_reached(const Triangle& t, std::int64_t i, std::int64_t j) const {
    return t.is_reached || cells_.reach().covers(table_.node(i, j), t.named->corners[0]);
  }

  void decide(const Triangle& t, IndexRange columns, std::int64_t j) {
    for (std::int64_t i = columns.begin; i < columns.end; ++i) decide_node(t, i, j);
  }

  void decide_node(const Triangle& t, std::int64_t i, std::int64_t j) {
    const Direction p = table_.node(i, j);
    const Holding held = holding(points_, t.named->corners, p);
    if (held.kind == Holding::Kind::interior) {
      node(i, j) = t.facet(vector(p));
    } else if (held.kind == Holding::Kind::edge &&
               owns_edge(adjacency_, t.named->arc, held.edge)) {
      const Spot s =
          edge_spot(t.named->corners[held.edge], t.named->corners[(held.edge + 1) % 3]);
      node(i, j) = cells_.edge_value(s.sites[0], s.sites[1], p);
    } else {
      return;
    }
    if (!is_reached(t, i, j)) node(i, j) = missing;
  }

  void write_site_in_row(Site s, std::int64_t j) {
    const double position =
        table_.lon().position(stripack::lonlat(points_[at(s)]).lon_deg);
    // Longitudes lose their digits towards the poles; the comparison of directions
    // decides.
    const double slack =
        table_.tolerance() + 0x1p-48 / table_.cos_lat(j) * columns_per_radian_;
    table_.for_each_turn(position, position, slack, [&](double shift) {
      const IndexRange columns =
          columns_between(position + shift - slack, position + shift + slack);
      for (std::int64_t i = columns.begin; i < columns.end; ++i) {
        if (stripack::is_same_direction(table_.node(i, j), points_[at(s)]))
          node(i, j) = cells_.site_value(s);
      }
    });
  }

  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  const Cells& cells_;
  std::span<const Direction> points_;
  const Adjacency& adjacency_;
  GlobeTable table_;
  double columns_per_radian_, first_lon_;
  std::vector<double> padded_cos_, padded_sin_;
  SphereScanPlaces places_;
  std::vector<double>& out_;
};

template <class Cells>
[[nodiscard]] std::vector<double> scan_sphere(const Cells& cells, const Grid& grid,
                                              const RunOptions& run) {
  check_globe(grid);
  constexpr std::int64_t site_chunk = 1024, row_chunk = 16;
  std::vector<double> out =
      fresh_values(at(grid.size()), std::numeric_limits<double>::quiet_NaN());
  SphereScan<Cells> scan(cells, grid, run, out);
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
  scan.write_poles();
  if (!has_triangles || cells.options().outside != Outside::missing) {
    delaunay::parallel_chunks(grid.y.size, row_chunk, run,
                              [&](std::int64_t first, std::int64_t last) {
                                scan.continue_outside(first, last);
                              },
                              {0.8, 1});
  }
  return out;
}

}  // namespace delone::interp
