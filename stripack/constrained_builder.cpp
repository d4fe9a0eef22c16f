#include "stripack/constrained_builder.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/ring_faces.hpp"
#include "delaunay/site_order.hpp"
#include "stripack/constrained_crossing.hpp"

namespace delone::stripack {

namespace {

using delaunay::FaceRegions;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool are_antipodes(const Direction& a, const Direction& b) {
  return is_same_direction(a, Direction::from(-b.x(), -b.y(), -b.z()));
}

}  // namespace

ConstraintBuilder::ConstraintBuilder(const SphereGraph& graph,
                                     const SphereConstraintOptions& options,
                                     const RunOptions& run)
    : ConstraintBuilder(graph, options, triangulate(graph.points, run)) {}

ConstraintBuilder::ConstraintBuilder(const SphereGraph& graph,
                                     const SphereConstraintOptions& options,
                                     const Triangulation& t)
    : ConstraintBuilder(graph, options, copy(t)) {}

ConstraintBuilder::ConstraintBuilder(const SphereGraph& graph,
                                     const SphereConstraintOptions& options, Start start)
    : graph_(graph),
      options_(options),
      dimension_(start.dimension),
      points_(std::move(start.points)),
      rows_(std::move(start.rows)),
      sites_(std::move(start.sites)),
      sphere_(points_),
      mesh_(std::move(start.mesh), sphere_, static_cast<Site>(points_.size())),
      list_(delaunay::clean_segments(graph.arcs, sites_)) {
  check_arcs();
  insert_arcs();
}

// From the builder's rings straight to faces: neighbour lists would be made for nothing.
ConstraintBuilder::Start ConstraintBuilder::triangulate(std::span<const Direction> points,
                                                        const RunOptions& run) {
  std::optional<ClosedMesh> mesh;
  Triangulation t(
      points, run,
      [&](const Triangulation& sorted, const delaunay::SiteOrder& order,
          const std::vector<Site>& first) {
        if (auto rings = Triangulation::build_rings(sorted.points_, order, run))
          mesh = delaunay::take_faces(*std::move(rings));
        return mesh ? Adjacency()
                    : Triangulation::build(sorted.points_, first, order, run);
      });
  if (!mesh) mesh = ClosedMesh::from(t.adjacency());
  return {std::move(t.points_), std::move(t.rows_), std::move(t.sites_), *std::move(mesh),
          t.dimension()};
}

ConstraintBuilder::Start ConstraintBuilder::copy(const Triangulation& t) {
  return {t.points_, t.rows_, t.sites_, ClosedMesh::from(t.adjacency()), t.dimension()};
}

void ConstraintBuilder::check_arcs() const {
  for (std::size_t i = 0; i < graph_.arcs.size(); ++i) {
    const auto [a, b] = graph_.arcs[i];
    if (!are_antipodes(graph_.points[at(a)], graph_.points[at(b)])) continue;
    throw Error("arc " + std::to_string(i) + " joins antipodes (rows " +
                    std::to_string(a) + " and " + std::to_string(b) +
                    "), which many great circles do; add a point between",
                {static_cast<std::int64_t>(i)});
  }
}

void ConstraintBuilder::insert_arcs() {
  for (const auto& [ends, number] : list_.segments) {
    if (dimension_ < 2) {
      divide_chain(ends[0], ends[1]);
    } else {
      mesh_.insert(ends[0], ends[1],
                   [&](const Mesh::Edge& piece, HalfEdge e) { cross(piece, e); });
    }
  }
}

// Sites of one great circle are numbered along it.
void ConstraintBuilder::divide_chain(Site a, Site b) {
  const auto n = static_cast<Site>(rows_.size());
  const Site up = (a + 1) % n;
  const bool goes_up =
      up == b || is_inside_arc(sphere_.at(a), sphere_.at(b), sphere_.at(up));
  const Site step = goes_up ? 1 : n - 1;
  for (Site next = (a + step) % n; next != b; a = next, next = (next + step) % n)
    mesh_.divide(a, b, next);
}

Site ConstraintBuilder::add_site(const Direction& p) {
  if (std::cmp_equal(points_.size(), mesh_.ghost())) points_.emplace_back();
  points_.push_back(p);
  return static_cast<Site>(points_.size()) - 1;
}

void ConstraintBuilder::cross(const Mesh::Edge& piece, HalfEdge crossed) {
  const Mesh::Edge ends{mesh_.mesh().origin(crossed), mesh_.mesh().target(crossed)};
  if (options_.crossings == Crossings::error) refuse_crossing(piece, ends);
  const auto n = static_cast<std::int64_t>(list_.segments.size()) + 16;
  if (++num_crossings_ > 64 * n * n)
    throw Error("arcs cross too often, and too close to one another, to be divided");
  const Site v = add_site(rounded_crossing(sphere_.at(piece[0]), sphere_.at(piece[1]),
                                           sphere_.at(ends[0]), sphere_.at(ends[1])));
  if (mesh_.divide_crossing(piece, crossed, v) != v) points_.pop_back();
}

void ConstraintBuilder::refuse_crossing(const Mesh::Edge& piece,
                                        const Mesh::Edge& crossed) {
  const std::int64_t one = find_owner(list_, mesh_.paths(), piece);
  const std::int64_t other = find_owner(list_, mesh_.paths(), crossed);
  const auto [first, second] = std::minmax(one, other);
  const auto name = [&](std::int64_t i) {
    const auto& ends = graph_.arcs[static_cast<std::size_t>(i)];
    return std::to_string(i) + " (rows " + std::to_string(ends[0]) + " and " +
           std::to_string(ends[1]) + ")";
  };
  throw Error("arcs " + name(first) + " and " + name(second) +
                  " cross; divide them at a common point, or have crossings split",
              {first, second});
}

delaunay::MeshPlace ConstraintBuilder::place_of(const Direction& p) const {
  const HalfEdge start = delaunay::real_edge_at(mesh_.mesh(), 0, mesh_.ghost());
  return delaunay::walk(mesh_.mesh(), mesh_.ghost(), start, [&](Site u, Site v) {
    return orientation(sphere_.at(u), sphere_.at(v), p);
  });
}

// The region on the left of the first arc.
std::int32_t ConstraintBuilder::first_left_region(const FaceRegions& regions) const {
  for (const auto& ends : graph_.arcs) {
    const Site a = sites_[at(ends[0])], b = sites_[at(ends[1])];
    if (a == b) continue;
    const HalfEdge e = mesh_.mesh().find(a, mesh_.paths().path(a, b)[1]);
    return regions.of_face[at(ClosedMesh::face_of(e))];
  }
  return none;
}

std::vector<bool> ConstraintBuilder::removed_by_parity(const FaceRegions& regions) const {
  const ClosedMesh& mesh = mesh_.mesh();
  std::int32_t start = none;
  if (options_.outside) {
    const auto place = place_of(*options_.outside);
    const HalfEdge e = place.kind == delaunay::MeshPlace::Kind::site
                           ? mesh.edge_at(place.site)
                           : place.at;
    static_cast<void>(delaunay::region_at(mesh, mesh_.ghost(), regions.of_face, place,
                                          "the outside point, number", 0));
    start = regions.of_face[at(ClosedMesh::face_of(e))];
  } else {
    start = first_left_region(regions);
  }
  if (start == none) return std::vector<bool>(at(regions.count), true);  // no rings
  const auto parity = delaunay::find_parities(
      mesh, regions, delaunay::find_odd_edges(mesh, mesh_.paths(), graph_.arcs, sites_),
      start);
  if (parity.empty()) {
    throw Error(
        "the arcs do not form closed rings, so there is no inside by counting rings; "
        "close them, or name holes by points");
  }
  const std::int8_t kept = options_.outside ? 1 : 0;
  std::vector<bool> is_removed(parity.size());
  for (std::size_t i = 0; i < parity.size(); ++i) is_removed[i] = parity[i] != kept;
  return is_removed;
}

std::vector<bool> ConstraintBuilder::find_removed(const FaceRegions& regions) const {
  const ClosedMesh& mesh = mesh_.mesh();
  std::vector<bool> is_removed(at(regions.count));
  if (options_.domain == Domain::hull) return is_removed;
  const auto remove = [&](const Direction& p, const char* what, std::size_t number) {
    if (const auto region = delaunay::region_at(mesh, mesh_.ghost(), regions.of_face,
                                                place_of(p), what, number))
      is_removed[at(*region)] = true;
  };
  const HalfEdge beyond = mesh.edge_at(mesh_.ghost());
  const std::int32_t beyond_region =
      beyond == none ? none : regions.of_face[at(ClosedMesh::face_of(beyond))];
  if (options_.domain == Domain::even_odd) {
    is_removed = removed_by_parity(regions);
    if (beyond_region != none && !is_removed[at(beyond_region)]) {
      throw Error(
          "the domain reaches beyond the hull of the points, which all lie in a "
          "hemisphere; add points in it, or name a point outside");
    }
  } else {
    if (options_.outside) remove(*options_.outside, "the outside point, number", 0);
    if (beyond_region != none) is_removed[at(beyond_region)] = true;
  }
  for (std::size_t i = 0; i < graph_.holes.size(); ++i)
    remove(graph_.holes[i], "hole", i);
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
        delaunay::region_at(mesh_.mesh(), mesh_.ghost(), domain.region_of_face,
                            place_of(graph_.regions[i].point), "region", i);
    if (!region || *region == none || domain.regions[at(*region)].seed != none) continue;
    domain.regions[at(*region)].seed = static_cast<std::int32_t>(i);
    domain.regions[at(*region)].attribute = graph_.regions[i].attribute;
  }
  return domain;
}

ConstrainedTriangulation ConstraintBuilder::finish() && {
  ConstrainedTriangulation t;
  const Site ghost = mesh_.ghost();
  t.num_input_rows_ = static_cast<Node>(sites_.size());
  delaunay::DomainFaces domain = classify();
  t.num_triangles_ = domain.num_triangles();
  t.region_of_face_ = std::move(domain.region_of_face);
  t.regions_ = std::move(domain.regions);
  const bool needs_report =
      !mesh_.shared_pieces().empty() || mesh_.paths().has_divisions();
  if (std::cmp_greater(points_.size(), ghost)) points_.erase(points_.begin() + ghost);
  const auto num_sites = static_cast<Site>(points_.size());
  for (Site v = ghost; v < num_sites; ++v) {
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
  t.segments_ = graph_.arcs;
  return t;
}

}  // namespace delone::stripack
