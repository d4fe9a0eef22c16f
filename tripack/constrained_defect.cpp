#include "tripack/constrained_defect.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/region_queries.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::Defect;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool is_before(Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Positions of sites, as delaunay/defect.hpp wants them.
class Plane {
 public:
  explicit Plane(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] Point2 point(Site v) const { return t_.points()[at(v)]; }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[at(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return tripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return is_before(point(v), point(w)) == is_before(point(v), point(x));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }

 private:
  const ConstrainedTriangulation& t_;
};

Defect find_tiling_defect(const ConstrainedTriangulation& t, const Plane& plane) {
  const delaunay::Adjacency lists(
      t.mesh().to_lists(t.num_sites(), [](std::int32_t) { return false; }));
  if (auto defect = delaunay::find_ring_defect(lists, t.rows())) return defect;
  if (auto defect = delaunay::find_orientation_defect(lists, plane)) return defect;
  if (auto defect = delaunay::find_fan_defect(lists, plane)) return defect;
  return delaunay::find_euler_defect(lists);
}

Defect find_edge_defect(const ConstrainedTriangulation& t, const Plane& plane) {
  const ClosedMesh& mesh = t.mesh();
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), back = mesh.reverse(e);
      if (mesh.is_constraint(e)) continue;
      const std::array<Site, 4> v{mesh.origin(e), mesh.target(e), mesh.apex(e),
                                  mesh.apex(back)};
      if (std::find(v.begin(), v.end(), t.infinity()) != v.end()) continue;
      if (t.region_of(f) != t.region_of(ClosedMesh::face_of(back))) {
        return delaunay::name_of_edge(plane.row(v[0]), plane.row(v[1])) +
               " bounds a region but is no segment";
      }
      if (!plane.is_violated(v[0], v[1], v[2], v[3])) continue;
      return delaunay::name_of_edge(plane.row(v[0]), plane.row(v[1])) +
             " is not Delaunay: row " + std::to_string(plane.row(v[3])) +
             " is inside the circle of " +
             delaunay::name_of_triangle(
                 {plane.row(v[0]), plane.row(v[1]), plane.row(v[2])});
    }
  }
  return std::nullopt;
}

std::string name_of_segment(std::int64_t i) { return "segment " + std::to_string(i); }

// Are the sites of a path, if none was added, on its segment and in order?
Defect find_course_defect(const ConstrainedTriangulation& t, std::int64_t i,
                          const std::vector<Node>& path) {
  const auto& meeting = t.report().meeting;
  if (std::any_of(path.begin(), path.end(), [&](Node row) {
        return row >= t.num_input_rows() ||
               std::binary_search(meeting.begin(), meeting.end(), row);
      }))
    return std::nullopt;
  const Point2 a = t.point(path.front()), b = t.point(path.back());
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Point2 p = t.point(path[k - 1]), q = t.point(path[k]);
    if (orientation(a, b, q) == 0 && is_before(p, q) == is_before(a, b)) continue;
    return "row " + std::to_string(path[k]) + " is not in its place on " +
           name_of_segment(i);
  }
  return std::nullopt;
}

Defect find_path_defect(const ConstrainedTriangulation& t) {
  const auto constraints = t.constraint_edges();
  std::vector<bool> is_used(constraints.size());
  for (std::int64_t i = 0; i < t.num_segments(); ++i) {
    const std::vector<Node> path = t.path(i);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const auto [low, high] = std::minmax(path[k - 1], path[k]);
      const ConstrainedTriangulation::Segment piece{low, high};
      const auto found = std::lower_bound(constraints.begin(), constraints.end(), piece);
      if (found == constraints.end() || *found != piece) {
        return name_of_segment(i) + " lacks its piece " +
               delaunay::name_of_edge(low, high);
      }
      is_used[static_cast<std::size_t>(found - constraints.begin())] = true;
    }
    if (auto defect = find_course_defect(t, i, path)) return defect;
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused == is_used.end()) return std::nullopt;
  const auto& edge = constraints[static_cast<std::size_t>(unused - is_used.begin())];
  return delaunay::name_of_edge(edge[0], edge[1]) +
         " is marked but belongs to no segment";
}

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  if (auto defect = delaunay::find_map_defect(t.rows(), t.sites())) return defect;
  if (t.mesh().num_faces() == 0) return std::nullopt;
  if (auto defect = delaunay::find_link_defect(t.mesh())) return defect;
  const Plane plane(t);
  if (auto defect = find_tiling_defect(t, plane)) return defect;
  if (auto defect = find_edge_defect(t, plane)) return defect;
  return find_path_defect(t);
}

}  // namespace delone::tripack
