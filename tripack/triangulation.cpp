#include "tripack/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "delaunay/closed_hull.hpp"
#include "delaunay/curve_order.hpp"
#include "delaunay/error.hpp"
#include "delaunay/hull_lists.hpp"
#include "delaunay/site_queries.hpp"
#include "delaunay/wide_integer.hpp"
#include "tripack/plane_geometry.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::KeyedRow;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

void check(std::span<const Point2> points) {
  delaunay::check_num_points(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) +
                    ": a coordinate is not a finite number; remove the row",
                {row});
  }
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

// Equal on the chart is equal: it holds both coordinates.
struct WholeChart {
  [[nodiscard]] static bool less(Node, Node) { return false; }
  [[nodiscard]] static bool is_same(Node, Node) { return true; }
};

delaunay::SiteOrder order_sites(std::span<const Point2> points) {
  constexpr double cells = 65536;
  const Box box = bounding_box(points);
  const double half = std::max(delaunay::half_extent(box.low_x, box.high_x),
                               delaunay::half_extent(box.low_y, box.high_y));
  const delaunay::CellScale x(box.low_x, half, cells), y(box.low_y, half, cells);
  delaunay::Buffer<KeyedRow> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    items[i] = KeyedRow{delaunay::hilbert_key(x.cell(points[i].x), y.cell(points[i].y))}
                   << 32 |
               i;
  }
  delaunay::sort_by_key(items);
  return delaunay::site_order(
      items,
      [&](Node row) {
        return delaunay::Chart{points[at(row)].x, points[at(row)].y};
      },
      WholeChart{});
}

// The first three sites that are not on one line; {} if there are none.
std::vector<Site> first_triangle(std::span<const Point2> points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    const int s = orientation(points[0], points[1], points[i]);
    if (s > 0) return {0, 1, static_cast<Site>(i)};
    if (s < 0) return {1, 0, static_cast<Site>(i)};
  }
  return {};
}

Adjacency build(std::span<const Point2> points, const std::vector<Site>& first,
                const Progress& progress) {
  const auto n = static_cast<Site>(points.size());
  auto lists = [&] {
    const PlaneGeometry geometry(points);
    delaunay::ClosedHull hull(geometry, n + 1);
    const Site a = first[0], b = first[1], c = first[2], infinity = geometry.infinity();
    const std::array<std::array<Site, 3>, 4> start{
        {{a, b, c}, {b, a, infinity}, {c, b, infinity}, {a, c, infinity}}};
    hull.start(start);
    ProgressMeter meter(progress, n);
    delaunay::for_each_in_insertion_order(n, [&](Site q) {
      meter.step();
      if (q != a && q != b && q != c) hull.insert(q);
    });
    return delaunay::HullLists(
               hull, n, [&](const delaunay::Face& f) { return geometry.is_front(f); })
        .build();
  }();
  return Adjacency(std::move(lists));
}

bool lexicographically_less(Point2 a, Point2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

double squared_distance(Point2 a, Point2 b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

LocalFrame::LocalFrame(std::span<const Point2> points) {
  const Box box = bounding_box(points);
  center_ = {box.low_x / 2 + box.high_x / 2, box.low_y / 2 + box.high_y / 2};
  const double half =
      std::max({box.high_x - center_.x, center_.x - box.low_x, box.high_y - center_.y,
                center_.y - box.low_y, std::numeric_limits<double>::min()});
  scale_ = std::ldexp(1.0, std::min(1000, -std::ilogb(half) - 1));
}

double LocalFrame::lattice_unit(std::span<const Point2> points) const noexcept {
  constexpr double cells = 0x1p26;
  std::int64_t bits = 0;
  const auto add = [&](double v, double center) {
    const delaunay::TwoTerms local = delaunay::exact_difference(v, center);
    const double steps = local.value * scale_ * cells;
    const auto whole = static_cast<std::int64_t>(steps);
    bits |= whole;
    return local.tail == 0 && static_cast<double>(whole) == steps;
  };
  for (const Point2 p : points) {
    if (!add(p.x, center_.x) || !add(p.y, center_.y)) return 0;
  }
  return bits == 0 ? 1 : static_cast<double>(bits & -bits) / cells;
}

Triangulation::Triangulation(std::span<const Point2> points, const RunOptions& options) {
  check(points);
  delaunay::SiteOrder order = order_sites(points);
  rows_ = std::move(order.rows);
  sites_ = std::move(order.sites);
  points_.resize(rows_.size());
  // Adding +0 turns -0 into +0: equal positions have equal bits.
  std::transform(rows_.begin(), rows_.end(), points_.begin(), [&](Node row) {
    return Point2{points[at(row)].x + 0.0, points[at(row)].y + 0.0};
  });
  const std::vector<Site> first = first_triangle(points_);
  if (first.empty()) {
    make_chain();
    return;
  }
  adjacency_ = build(points_, first, options.progress);
  num_triangles_ = adjacency_.num_triangles();
  dimension_ = 2;
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
