#include "stripack/triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "delaunay/closed_hull.hpp"
#include "delaunay/curve_order.hpp"
#include "delaunay/defect.hpp"
#include "delaunay/edge_rings.hpp"
#include "delaunay/hull_lists.hpp"
#include "delaunay/instruction_set.hpp"
#include "delaunay/site_order.hpp"
#include "delaunay/site_queries.hpp"
#include "stripack/distance_order.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"
#include "stripack/sphere_blocks.hpp"
#include "stripack/sphere_chart.hpp"
#include "stripack/sphere_geometry.hpp"

namespace delone::stripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

struct ChartedSphere {
  std::span<const Direction> points;
  [[nodiscard]] delaunay::Chart chart(Node row) const {
    return chart_of(points[at(row)]);
  }
  [[nodiscard]] bool less(Node a, Node b) const {
    const Direction &p = points[at(a)], &q = points[at(b)];
    if (is_less_u(p, q)) return true;
    return !is_less_u(q, p) && is_less_v(p, q);
  }
};

// Half, lune and hemisphere, then the place along the curve of the octant.
std::uint32_t sphere_key(const Direction& d) {
  const delaunay::CellScale u(-1, 1, 65536), v(0, 1, 65536);
  const Octant octant = octant_of(d);
  const auto [s, t] = chart_of(d, octant);
  constexpr double first[2] = {2, 0};
  const std::uint32_t cell =
      delaunay::hilbert_key(u.cell(s), v.cell(t + first[octant.is_north]));
  return (octant.half << 2 | octant.lune << 1 | octant.is_north) << 29 | cell >> 3;
}

delaunay::SiteOrder order_sites(std::span<const Direction> points,
                                const RunOptions& run) {
  return delaunay::order_sites(
      delaunay::sorted_by_key(
          points.size(), [&](std::size_t i) { return sphere_key(points[i]); }, run),
      ChartedSphere{points}, run);
}

// Three sites that are not on one great circle, counter-clockwise; {} if there are none.
std::vector<Site> first_triangle(std::span<const Direction> points) {
  std::size_t other = 1;  // the first site that is not opposite to site 0
  const Direction opposite =
      points.empty() ? Direction()
                     : Direction::from(-points[0].x(), -points[0].y(), -points[0].z());
  while (other < points.size() && is_same_direction(points[other], opposite)) ++other;
  for (std::size_t i = other + 1; i < points.size(); ++i) {
    const int s = orientation(points[0], points[other], points[i]);
    const Site b = static_cast<Site>(other), c = static_cast<Site>(i);
    if (s > 0) return {0, b, c};
    if (s < 0) return {b, 0, c};
  }
  return {};
}

// By insertion into a closed polyhedron.
Adjacency build_by_insertion(std::span<const Direction> points,
                             const std::vector<Site>& first, const Progress& progress) {
  const auto n = static_cast<Site>(points.size());
  auto lists = [&] {
    const SphereGeometry geometry(points);
    delaunay::ClosedHull hull(geometry, n);
    const Site a = first[0], b = first[1], c = first[2];
    // Two faces back to back: every further site sees exactly one of them.
    const std::array<std::array<Site, 3>, 2> start{{{a, b, c}, {a, c, b}}};
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

double squared_sum(const Direction& a, const Direction& b) {
  const double dx = a.x() + b.x(), dy = a.y() + b.y(), dz = a.z() + b.z();
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace

// What is left of the order are its keys.
delaunay::SiteOrder Triangulation::number_sites(std::span<const Direction> points,
                                                const RunOptions& options) {
  delaunay::check_num_points(points.size());
  delaunay::SiteOrder order = order_sites(points, options);
  points_.resize(order.rows.size());
  delaunay::for_each_ahead(
      order.rows, [&](Node row) { return &points[at(row)]; },
      [&](std::size_t site, const Direction* p) { points_[site] = *p; }, options);
  rows_ = std::move(order.rows);
  sites_ = std::move(order.sites);
  if (num_sites() < num_rows()) settle_lengths(points);
  return order;
}

Triangulation::Triangulation(std::span<const Direction> points, const RunOptions& options)
    : Triangulation(points, options,
                    [&](const Triangulation& t, const delaunay::SiteOrder& order,
                        const std::vector<Site>& first) {
                      return build(t.points_, first, order, options);
                    }) {}

Triangulation::Triangulation(std::span<const Direction> points, const RunOptions& options,
                             const KnownTopology& topology)
    : Triangulation(points, options,
                    [&](const Triangulation& t, const delaunay::SiteOrder&,
                        const std::vector<Site>&) { return topology(t.rows_); }) {}

Triangulation::Triangulation(std::span<const Direction> points, const RunOptions& options,
                             const TopologyOf& topology) {
  const delaunay::SiteOrder order = number_sites(points, options);
  const std::vector<Site> first = first_triangle(points_);
  if (first.empty()) {
    make_chain();
    return;
  }
  adjacency_ = topology(*this, order, first);
  num_triangles_ = adjacency_.num_triangles();
  dimension_ = 2;
}

std::optional<delaunay::EdgeRings> Triangulation::build_rings(
    std::span<const Direction> points, const delaunay::SiteOrder& order,
    const RunOptions& run) {
  using Builder = delaunay::RingBuilder<SphereLanes<delaunay::Portable>>;
  const auto second =
      std::partition_point(order.keys.begin(), order.keys.end(),
                           [](std::uint32_t key) { return key >> 31 == 0; });
  return Builder({points.data()}, order, sphere_block_work())
      .build_halves(static_cast<Site>(second - order.keys.begin()), run);
}

Adjacency Triangulation::build(std::span<const Direction> points,
                               const std::vector<Site>& first,
                               const delaunay::SiteOrder& order, const RunOptions& run) {
  if (auto rings = build_rings(points, order, run)) {
    Adjacency result(delaunay::take_lists(*std::move(rings), run));
    if (!delaunay::find_euler_defect(result)) return result;
  }
  return build_by_insertion(points, first, run.progress);
}

// One direction may come as triples of lengths an ulp apart; which of them is kept, and
// so how ties are broken, must not depend on the order of rows.
void Triangulation::settle_lengths(std::span<const Direction> points) {
  for (std::size_t row = 0; row < points.size(); ++row) {
    Direction& kept = points_[at(sites_[row])];
    if (lexicographically_less(points[row], kept)) kept = points[row];
  }
}

void Triangulation::make_chain() {
  const GreatCircleChain chain = order_along_great_circle(points_);
  delaunay::renumber_sites(rows_, sites_, points_, std::span<const Site>(chain.order));
  adjacency_ = Adjacency::chain(num_sites(), chain.kind);
  dimension_ = std::min(num_sites(), 2) - 1;
}

Arc Triangulation::find(const Direction& p, Arc start) const {
  if (dimension_ < 2) return {};
  return delaunay::walk(adjacency_, start, [&](Site u, Site v) {
    return orientation(points_[at(u)], points_[at(v)], p);
  });
}

Location Triangulation::locate(const Direction& p, Node hint) const {
  if (dimension_ < 2) return locate_in_chain(p);
  const Arc start = hint == none ? Arc{} : adjacency_.first_arc(sites_[at(hint)]);
  const auto side = [&](Site u, Site v) {
    return orientation(points_[at(u)], points_[at(v)], p);
  };
  return delaunay::describe(adjacency_, rows_, delaunay::walk(adjacency_, start, side),
                            side);
}

Location Triangulation::locate_in_chain(const Direction& p) const {
  for (Site s = 0; s < num_sites(); ++s) {
    if (is_same_direction(points_[at(s)], p))
      return {Location::Kind::node, {rows_[at(s)], none, none}};
  }
  for (Site s = 0; s < num_sites(); ++s) {
    for (const Site t : adjacency_.neighbors(s)) {
      if (is_inside_arc(points_[at(s)], points_[at(t)], p))
        return {Location::Kind::edge, {rows_[at(s)], rows_[at(t)], none}};
    }
  }
  return {};
}

Site Triangulation::nearest_site(const Direction& p, Site start) const {
  if (num_sites() == 0) return none;
  const auto chord = [&](Site s) { return squared_chord(points_[at(s)], p); };
  const Site best = delaunay::descend(adjacency_, start, chord);
  return chord(best) < 2 ? best : nearest_beyond_90_degrees(p, best);
}

// Neighbours through the outside are not in the lists. They separate cells only at 90
// degrees and more from the nearest site (their circumcentres see a face from behind),
// and join boundary sites only. Out there chords hardly differ: the tangent of half the
// angle tells.
Site Triangulation::nearest_beyond_90_degrees(const Direction& p, Site start) const {
  const auto distance = [&](Site s) {
    return squared_chord(points_[at(s)], p) / squared_sum(points_[at(s)], p);
  };
  Site best = delaunay::descend(adjacency_, start, distance);
  while (adjacency_.is_boundary(best)) {
    Site better = best;
    for (Site s = 0; s < num_sites(); ++s) {
      if (adjacency_.is_boundary(s) && distance(s) < distance(better)) better = s;
    }
    if (better == best) break;
    best = delaunay::descend(adjacency_, better, distance);
  }
  return best;
}

Node Triangulation::nearest(const Direction& p, Node hint) const {
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

}  // namespace delone::stripack
