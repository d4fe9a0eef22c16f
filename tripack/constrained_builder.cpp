#include "tripack/constrained_builder.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/mesh_walk.hpp"
#include "delaunay/ring_faces.hpp"
#include "delaunay/site_order.hpp"
#include "tripack/constrained_crossing.hpp"

namespace delone::tripack {

namespace {

using delaunay::FaceRegions;
using delaunay::MeshPlace;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

void check(Point2 p, const char* what, std::size_t number) {
  if (std::isfinite(p.x) && std::isfinite(p.y)) return;
  throw Error(std::string(what) + " " + std::to_string(number) +
                  ": a coordinate is not a finite number; correct it",
              {static_cast<std::int64_t>(number)});
}

const PlanarGraph& checked(const PlanarGraph& graph) {
  for (std::size_t i = 0; i < graph.holes.size(); ++i) check(graph.holes[i], "hole", i);
  for (std::size_t i = 0; i < graph.regions.size(); ++i)
    check(graph.regions[i].point, "region", i);
  return graph;
}

// A few units in the last place of the largest coordinate.
double find_reach(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2 p : points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest * 0x1p-50;
}

}  // namespace

ConstraintBuilder::ConstraintBuilder(const PlanarGraph& graph,
                                     const ConstraintOptions& options,
                                     const RunOptions& run)
    : ConstraintBuilder(checked(graph), options, triangulate(graph.points, run)) {}

ConstraintBuilder::ConstraintBuilder(const PlanarGraph& graph,
                                     const ConstraintOptions& options,
                                     const Triangulation& t)
    : ConstraintBuilder(graph, options, copy(t)) {}

ConstraintBuilder::ConstraintBuilder(const PlanarGraph& graph,
                                     const ConstraintOptions& options, Start start)
    : graph_(graph),
      options_(options),
      dimension_(start.dimension),
      points_(std::move(start.points)),
      reach_(find_reach(points_)),
      rows_(std::move(start.rows)),
      sites_(std::move(start.sites)),
      plane_(points_),
      mesh_(std::move(start.mesh), plane_, static_cast<Site>(points_.size())),
      list_(delaunay::clean_segments(graph.segments, sites_)) {
  if (dimension_ == 2) {
    insert_segments();
  } else {
    divide_chain();
  }
}

// From the builder's rings straight to faces: neighbour lists would be made for nothing.
ConstraintBuilder::Start ConstraintBuilder::triangulate(std::span<const Point2> points,
                                                        const RunOptions& run) {
  std::optional<ClosedMesh> mesh;
  Triangulation t(
      points, run, [&](const Triangulation& sorted, const delaunay::SiteOrder& order) {
        mesh =
            delaunay::take_faces(Triangulation::build_rings(sorted.points_, order, run));
        return Adjacency();
      });
  if (t.dimension() < 2) mesh = ClosedMesh::from(t.adjacency());
  return {std::move(t.points_), std::move(t.rows_), std::move(t.sites_),
          std::move(mesh).value(), t.dimension()};
}

ConstraintBuilder::Start ConstraintBuilder::copy(const Triangulation& t) {
  return {t.points_, t.rows_, t.sites_, ClosedMesh::from(t.adjacency()), t.dimension()};
}

void ConstraintBuilder::insert_segments() {
  for (const auto& segment : list_.segments) {
    mesh_.insert(segment.sites[0], segment.sites[1],
                 [&](const Mesh::Edge& piece, HalfEdge e) { cross(piece, e); });
  }
}

// Collinear sites are numbered along their line.
void ConstraintBuilder::divide_chain() {
  for (const auto& segment : list_.segments) {
    const Site end = segment.sites[1];
    for (Site a = segment.sites[0]; a + 1 < end; ++a) mesh_.divide(a, end, a + 1);
  }
}

Site ConstraintBuilder::add_site(Point2 p) {
  if (std::cmp_equal(points_.size(), mesh_.ghost())) points_.emplace_back();
  points_.push_back(p);
  return static_cast<Site>(points_.size()) - 1;
}

void ConstraintBuilder::cross(const Mesh::Edge& piece, HalfEdge crossed) {
  const Mesh::Edge ends{mesh_.mesh().origin(crossed), mesh_.mesh().target(crossed)};
  if (options_.crossings == Crossings::error) refuse_crossing(piece, ends);
  const Site v = add_site(rounded_crossing(position(piece[0]), position(piece[1]),
                                           position(ends[0]), position(ends[1]), reach_));
  if (mesh_.divide_crossing(piece, crossed, v) != v) drop_site();
}

void ConstraintBuilder::refuse_crossing(const Mesh::Edge& piece,
                                        const Mesh::Edge& crossed) {
  const std::int64_t one = find_owner(list_, mesh_.paths(), piece);
  const std::int64_t other = find_owner(list_, mesh_.paths(), crossed);
  const auto [first, second] = std::minmax(one, other);
  const auto name = [&](std::int64_t i) {
    const auto& ends = graph_.segments[static_cast<std::size_t>(i)];
    return std::to_string(i) + " (rows " + std::to_string(ends[0]) + " and " +
           std::to_string(ends[1]) + ")";
  };
  throw Error("segments " + name(first) + " and " + name(second) +
                  " cross; divide them at a common point, or have crossings split",
              {first, second});
}

// The region that holds `p`; nothing outside the hull.
std::optional<std::int32_t> ConstraintBuilder::region_at(
    std::span<const std::int32_t> region_of_face, Point2 p, const char* what,
    std::size_t number) const {
  const ClosedMesh& mesh = mesh_.mesh();
  const HalfEdge start = delaunay::real_edge_at(mesh, 0, mesh_.ghost());
  const MeshPlace place = delaunay::walk(mesh, mesh_.ghost(), start, [&](Site u, Site v) {
    return orientation(plane_.at(u), plane_.at(v), p);
  });
  return delaunay::region_at(mesh, mesh_.ghost(), region_of_face, place, what, number);
}

std::vector<bool> ConstraintBuilder::find_removed(const FaceRegions& regions) const {
  std::vector<bool> is_removed(at(regions.count));
  if (options_.domain == Domain::hull) return is_removed;
  const ClosedMesh& mesh = mesh_.mesh();
  const std::int32_t outside =
      regions.of_face[at(ClosedMesh::face_of(mesh.edge_at(mesh_.ghost())))];
  if (options_.domain == Domain::even_odd) {
    const auto parity = delaunay::find_parities(
        mesh, regions,
        delaunay::find_odd_edges(mesh, mesh_.paths(), graph_.segments, sites_), outside);
    if (parity.empty()) {
      throw Error(
          "the segments do not form closed rings, so there is no inside by counting "
          "rings; close them, or name holes by points");
    }
    for (std::size_t i = 0; i < parity.size(); ++i) is_removed[i] = parity[i] != 1;
  }
  is_removed[at(outside)] = true;
  for (std::size_t i = 0; i < graph_.holes.size(); ++i) {
    if (const auto region = region_at(regions.of_face, graph_.holes[i], "hole", i))
      is_removed[at(*region)] = true;
  }
  return is_removed;
}

delaunay::DomainFaces ConstraintBuilder::classify() const {
  FaceRegions flooded = delaunay::flood_regions(mesh_.mesh());
  if (flooded.count == 0) return {};
  const std::vector<bool> is_removed = find_removed(flooded);
  delaunay::DomainFaces domain =
      delaunay::keep_regions(mesh_.mesh(), mesh_.ghost(), std::move(flooded), is_removed);
  for (std::size_t i = 0; i < graph_.regions.size(); ++i) {
    const auto region =
        region_at(domain.region_of_face, graph_.regions[i].point, "region", i);
    if (!region || *region == none || domain.regions[at(*region)].seed != none) continue;
    domain.regions[at(*region)].seed = static_cast<std::int32_t>(i);
    domain.regions[at(*region)].attribute = graph_.regions[i].attribute;
  }
  return domain;
}

ConstrainedTriangulation ConstraintBuilder::finish() && {
  ConstrainedTriangulation t;
  const Site infinity = mesh_.ghost();
  t.num_input_rows_ = static_cast<Node>(sites_.size());
  delaunay::DomainFaces domain = classify();
  t.num_triangles_ = domain.num_triangles();
  t.region_of_face_ = std::move(domain.region_of_face);
  t.regions_ = std::move(domain.regions);
  const bool needs_report =
      !mesh_.shared_pieces().empty() || mesh_.paths().has_divisions();
  if (std::cmp_greater(points_.size(), infinity))
    points_.erase(points_.begin() + infinity);
  const auto num_sites = static_cast<Site>(points_.size());
  for (Site v = infinity; v < num_sites; ++v) {
    rows_.push_back(static_cast<Node>(sites_.size()));
    sites_.push_back(v);
  }
  mesh_.put_ghost_last(num_sites);
  t.paths_ = mesh_.take_paths();
  t.mesh_ = mesh_.take_mesh();
  if (needs_report) {
    t.report_ =
        delaunay::report_segments(std::move(list_), t.paths_, rows_, t.num_input_rows_);
  } else {
    t.report_.zero_length = std::move(list_.zero_length);
    t.report_.repeated = std::move(list_.repeated);
  }
  t.points_ = std::move(points_);
  t.rows_ = std::move(rows_);
  t.sites_ = std::move(sites_);
  t.segments_ = graph_.segments;
  return t;
}

}  // namespace delone::tripack
