#include "interp/region_integral.hpp"

#include <numbers>
#include <string>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/error.hpp"
#include "interp/region_sum.hpp"
#include "stripack/measures.hpp"
#include "tripack/measures.hpp"

namespace delone::interp {

namespace {

using delaunay::ClosedMesh;
using delaunay::HalfEdge;

template <class Graph, class Ring, class Segments>
Graph graph_of(std::span<const Ring> rings, Segments segments) {
  Graph graph;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    if (rings[k].size() < 3) {
      throw Error("ring " + std::to_string(k) + " has fewer than three corners; give " +
                  "every ring three or more");
    }
    const auto first = static_cast<Node>(graph.points.size());
    const auto size = static_cast<Node>(rings[k].size());
    graph.points.insert(graph.points.end(), rings[k].begin(), rings[k].end());
    for (Node i = 0; i < size; ++i)
      segments(graph).push_back({first + i, first + (i + 1) % size});
  }
  return graph;
}

/// Calls f(half-edge) for the sides of the domain's faces, and g(face) for the faces.
template <class Domain, class F, class G>
void for_each_side(const Domain& domain, F f, G g) {
  const ClosedMesh& mesh = domain.mesh();
  for (std::int32_t face = 0; face < mesh.num_face_slots(); ++face) {
    if (mesh.is_free(face) || domain.region_of(face) == none) continue;
    g(mesh.face(face));
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(face, k);
      if (domain.region_of(ClosedMesh::face_of(mesh.reverse(e))) == none) f(e);
    }
  }
}

template <class Point>
struct BoundaryAndArea {
  RegionBoundary<Point> boundary;
  double area = 0;
};

/// Corners in the order of sites, sides in that of their corners.
template <class Point, class Domain>
BoundaryAndArea<Point> boundary_of(const Domain& domain) {
  BoundaryAndArea<Point> result;
  std::vector<Point>& corners = result.boundary.corners;
  auto& sides = result.boundary.sides;
  const auto points = domain.points();
  std::vector<std::int32_t> numbers(points.size(), none);
  for_each_side(
      domain,
      [&](HalfEdge e) {
        const Site from = domain.mesh().origin(e), to = domain.mesh().target(e);
        numbers[at(from)] = 0;
        sides.push_back({from, to});
      },
      [&](const ClosedMesh::Face& face) {
        result.area += signed_area(points[at(face.node[0])], points[at(face.node[1])],
                                   points[at(face.node[2])]);
      });
  for (std::size_t s = 0; s < points.size(); ++s) {
    if (numbers[s] == none) continue;
    numbers[s] = static_cast<std::int32_t>(corners.size());
    corners.push_back(points[s]);
  }
  for (auto& [from, to] : sides) {
    from = numbers[at(from)];
    to = numbers[at(to)];
  }
  std::ranges::sort(sides);
  return result;
}

/// Nodes all round, so that whatever the rings leave is triangulated too.
void add_axes(std::vector<stripack::Direction>& points) {
  for (const double sign : {1.0, -1.0}) {
    points.push_back(stripack::Direction::from(sign, 0, 0));
    points.push_back(stripack::Direction::from(0, sign, 0));
    points.push_back(stripack::Direction::from(0, 0, sign));
  }
}

}  // namespace

double SphereArea::operator()(const Vector3& p) const noexcept {
  // Radii of curvature N M = b^2 / (1 - e^2 sin^2 latitude)^2, of WGS84.
  constexpr double flattening = 1 / 298.257223563, minor_km = 6378.137 * (1 - flattening),
                   e2 = flattening * (2 - flattening);
  if (unit_ == AreaUnit::steradian) return 1;
  if (unit_ == AreaUnit::km2_sphere)
    return stripack::earth_radius_km * stripack::earth_radius_km;
  const double radius = minor_km / (1 - e2 * p.z * p.z);
  return radius * radius;
}

PlaneRegion::PlaneRegion(std::span<const tripack::Polygon> rings, const RunOptions& run)
    : PlaneRegion(tripack::ConstrainedTriangulation(
          graph_of<tripack::PlanarGraph>(
              rings, [](auto& graph) -> auto& { return graph.segments; }),
          {.domain = delaunay::Domain::even_odd}, run)) {}

PlaneRegion::PlaneRegion(const tripack::ConstrainedTriangulation& domain)
    : is_everything_(false), area_(0) {
  auto [boundary, area] = boundary_of<tripack::Point2>(domain);
  is_everything_ = boundary.sides.empty() && area > 0;
  boundary_ = std::move(boundary);
  area_ = area;
}

SphereRegion::SphereRegion() : area_(4 * std::numbers::pi) {}

SphereRegion::SphereRegion(std::span<const std::vector<stripack::Direction>> rings,
                           std::optional<stripack::Direction> outside,
                           const RunOptions& run)
    : is_everything_(false), area_(0) {
  if (rings.empty()) return;
  auto graph = graph_of<stripack::SphereGraph>(
      rings, [](auto& g) -> auto& { return g.arcs; });
  add_axes(graph.points);
  *this =
      SphereRegion(stripack::ConstrainedTriangulation(graph, {.outside = outside}, run));
}

SphereRegion::SphereRegion(const stripack::ConstrainedTriangulation& domain)
    : is_everything_(false), area_(0) {
  auto [boundary, area] = boundary_of<stripack::Direction>(domain);
  is_everything_ = boundary.sides.empty() && area > 0;
  boundary_ = std::move(boundary);
  area_ = area;
}

}  // namespace delone::interp
