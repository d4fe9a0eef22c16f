#include "tripack/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "delaunay/curve_order.hpp"
#include "delaunay/edge_rings.hpp"
#include "delaunay/error.hpp"
#include "delaunay/instruction_set.hpp"
#include "delaunay/site_order.hpp"
#include "delaunay/site_queries.hpp"
#include "tripack/finite.hpp"
#include "tripack/plane_blocks.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

void check(std::span<const Point2> points) {
  delaunay::check_num_points(points.size());
  check_finite(points, "row");
}

struct Box {
  double low_x = std::numeric_limits<double>::infinity(), high_x = -low_x;
  double low_y = low_x, high_y = -low_x;
};

Box bounding_box(std::span<const Point2> points) {
  Box box;
  for (const Point2 p : points) {
    box.low_x = std::min(box.low_x, p.x), box.high_x = std::max(box.high_x, p.x);
    box.low_y = std::min(box.low_y, p.y), box.high_y = std::max(box.high_y, p.y);
  }
  return box;
}

// In the plane the chart is the coordinates themselves.
struct ChartedPlane {
  std::span<const Point2> points;
  [[nodiscard]] delaunay::Chart chart(Node row) const {
    return {points[at(row)].x, points[at(row)].y};
  }
  [[nodiscard]] bool less(Node a, Node b) const {
    return lexicographically_less(points[at(a)], points[at(b)]);
  }
};

delaunay::SiteOrder order_sites(std::span<const Point2> points, const RunOptions& run) {
  constexpr double cells = 65536;
  const Box box = bounding_box(points);
  const double half = std::max(delaunay::half_extent(box.low_x, box.high_x),
                               delaunay::half_extent(box.low_y, box.high_y));
  const delaunay::CellScale x(box.low_x, half, cells), y(box.low_y, half, cells);
  return delaunay::order_sites(delaunay::sorted_by_key(
                                   points.size(),
                                   [&](std::size_t i) {
                                     return delaunay::hilbert_key(x.cell(points[i].x),
                                                                  y.cell(points[i].y));
                                   },
                                   run),
                               ChartedPlane{points}, run);
}

bool is_on_one_line(std::span<const Point2> points) {
  return points.size() < 3 || std::all_of(points.begin(), points.end(), [&](Point2 p) {
           return orientation(points[0], points[1], p) == 0;
         });
}

// The lowest bit that is set in a number that is not 0, as a power of two.
double lowest_bit(double v) {
  int exponent = 0;
  const auto mantissa =
      static_cast<std::int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
  return std::ldexp(static_cast<double>(mantissa & -mantissa), exponent - 53);
}

// Of a power of two; the quotient is exact where it is not too large to matter.
bool is_multiple(double v, double unit) {
  if (std::abs(v) < unit) return v == 0;
  const double times = v / unit;
  return std::abs(times) >= 0x1p53 ||
         static_cast<double>(static_cast<std::int64_t>(times)) == times;
}

// The largest power of two of which all coordinates are multiples (lattices, whole
// numbers, pixels), or 0 where it is too small beside the spacing of the points for their
// products to be exact.
double lattice_unit(std::span<const Point2> points, const Box& box) {
  const double extent = std::max(box.high_x - box.low_x, box.high_y - box.low_y);
  const double spacing = extent / std::sqrt(static_cast<double>(points.size()));
  const double least = std::max(spacing * 0x1p-11, 0x1p-200);
  double unit = 0x1p200;
  for (const Point2 p : points) {
    for (const double v : {p.x, p.y}) {
      if (!is_multiple(v, unit)) unit = lowest_bit(v);
    }
    if (unit < least) return 0;
  }
  return unit;
}

double squared_distance(Point2 a, Point2 b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

Triangulation::Triangulation(std::span<const Point2> points, const RunOptions& options)
    : Triangulation(
          points, options, [&](const Triangulation& t, const delaunay::SiteOrder& order) {
            return Adjacency(
                delaunay::take_lists(build_rings(t.points_, order, options), options));
          }) {}

Triangulation::Triangulation(std::span<const Point2> points, const RunOptions& options,
                             const TopologyOf& topology) {
  check(points);
  delaunay::SiteOrder order = order_sites(points, options);
  points_.resize(order.rows.size());
  // Adding +0 turns -0 into +0: equal positions have equal bits.
  delaunay::for_each_ahead(
      order.rows, [&](Node row) { return &points[at(row)]; },
      [&](std::size_t site, const Point2* p) {
        points_[site] = {p->x + 0.0, p->y + 0.0};
      },
      options);
  const bool is_flat = points_.size() < 3 || is_on_one_line(points_);
  if (!is_flat) adjacency_ = topology(*this, order);
  rows_ = std::move(order.rows);
  sites_ = std::move(order.sites);
  if (is_flat) {
    make_chain();
    return;
  }
  num_triangles_ = adjacency_.num_triangles();
  dimension_ = 2;
}

delaunay::EdgeRings Triangulation::build_rings(std::span<const Point2> points,
                                               const delaunay::SiteOrder& order,
                                               const RunOptions& run) {
  using Builder = delaunay::RingBuilder<PlaneLanes<delaunay::Portable>>;
  const Box box = bounding_box(points);
  const double width = box.high_x - box.low_x, height = box.high_y - box.low_y;
  const PlanePoints plane{points.data(), lattice_unit(points, box),
                          width * width + height * height};
  return Builder(plane, order, plane_block_work()).build(run);
}

// Collinear sites are numbered in lexicographic order, which is their order along the
// line.
void Triangulation::make_chain() {
  std::vector<Site> order(points_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Site a, Site b) {
    return lexicographically_less(points_[at(a)], points_[at(b)]);
  });
  delaunay::renumber_sites(rows_, sites_, points_, std::span<const Site>(order));
  adjacency_ = Adjacency::chain(num_sites(), Adjacency::Chain::open);
  dimension_ = std::min(num_sites(), 2) - 1;
}

Arc Triangulation::find(Point2 p, Arc start) const {
  if (dimension_ < 2) return {};
  return delaunay::walk(adjacency_, start, [&](Site u, Site v) {
    return orientation(points_[at(u)], points_[at(v)], p);
  });
}

Location Triangulation::locate(Point2 p, Node hint) const {
  if (dimension_ < 2) return locate_in_chain(p);
  const Arc start = hint == none ? Arc{} : adjacency_.first_arc(sites_[at(hint)]);
  const auto side = [&](Site u, Site v) {
    return orientation(points_[at(u)], points_[at(v)], p);
  };
  return delaunay::describe(adjacency_, rows_, delaunay::walk(adjacency_, start, side),
                            side);
}

Location Triangulation::locate_in_chain(Point2 p) const {
  const auto after =
      std::lower_bound(points_.begin(), points_.end(), p, lexicographically_less);
  if (after == points_.end()) return {};
  const auto i = after - points_.begin();
  const Node row = rows_[static_cast<std::size_t>(i)];
  if (*after == p) return {Location::Kind::node, {row, none, none}};
  if (i == 0 || orientation(after[-1], after[0], p) != 0) return {};
  return {Location::Kind::edge, {rows_[static_cast<std::size_t>(i) - 1], row, none}};
}

Site Triangulation::nearest_site(Point2 p, Site start) const {
  if (num_sites() == 0) return none;
  return delaunay::descend(adjacency_, start,
                           [&](Site s) { return squared_distance(points_[at(s)], p); });
}

Node Triangulation::nearest(Point2 p, Node hint) const {
  const Site s = nearest_site(p, hint == none ? 0 : sites_[at(hint)]);
  return s == none ? none : rows_[at(s)];
}

std::vector<std::array<Node, 3>> Triangulation::triangles() const {
  return delaunay::list_triangles(adjacency_, rows_, sites_);
}

std::vector<Node> Triangulation::boundary() const {
  return delaunay::list_boundary(adjacency_, rows_);
}

std::vector<Node> Triangulation::neighbors(Node row) const {
  std::vector<Node> result;
  for (const Site s : adjacency_.neighbors(sites_[at(row)]))
    result.push_back(rows_[at(s)]);
  return result;
}

}  // namespace delone::tripack
