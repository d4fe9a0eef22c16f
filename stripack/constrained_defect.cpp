#include "stripack/constrained_defect.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/region_queries.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::Defect;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Positions of sites, as delaunay/defect.hpp wants them.
class Sphere {
 public:
  explicit Sphere(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] const Direction& point(Site v) const { return t_.points()[at(v)]; }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[at(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return stripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return is_inside_arc(point(v), point(w), point(x)) ||
           is_inside_arc(point(v), point(x), point(w));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }

 private:
  const ConstrainedTriangulation& t_;
};

Defect find_tiling_defect(const ConstrainedTriangulation& t, const Sphere& sphere) {
  const delaunay::Adjacency lists(
      t.mesh().to_lists(t.num_sites(), [](std::int32_t) { return false; }));
  if (auto defect = delaunay::find_ring_defect(lists, t.rows())) return defect;
  if (auto defect = delaunay::find_orientation_defect(lists, sphere)) return defect;
  if (auto defect = delaunay::find_fan_defect(lists, sphere)) return defect;
  return delaunay::find_euler_defect(lists);
}

Defect find_edge_defect(const ConstrainedTriangulation& t, const Sphere& sphere) {
  const ClosedMesh& mesh = t.mesh();
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), back = mesh.reverse(e);
      if (mesh.is_constraint(e)) continue;
      const std::array<Site, 4> v{mesh.origin(e), mesh.target(e), mesh.apex(e),
                                  mesh.apex(back)};
      if (std::find(v.begin(), v.end(), t.ghost()) != v.end()) continue;
      if (t.region_of(f) != t.region_of(ClosedMesh::face_of(back))) {
        return delaunay::name_of_edge(sphere.row(v[0]), sphere.row(v[1])) +
               " bounds a region but is no arc";
      }
      if (!sphere.is_violated(v[0], v[1], v[2], v[3])) continue;
      return delaunay::name_of_edge(sphere.row(v[0]), sphere.row(v[1])) +
             " is not Delaunay: row " + std::to_string(sphere.row(v[3])) +
             " is inside the circle of " +
             delaunay::name_of_triangle(
                 {sphere.row(v[0]), sphere.row(v[1]), sphere.row(v[2])});
    }
  }
  return std::nullopt;
}

std::string name_of_segment(std::int64_t i) { return "arc " + std::to_string(i); }

// Are the sites of a path, if none was added, on its segment and in order?
Defect find_course_defect(const ConstrainedTriangulation& t, std::int64_t i,
                          const std::vector<Node>& path) {
  const auto& meeting = t.report().meeting;
  if (std::any_of(path.begin(), path.end(), [&](Node row) {
        return row >= t.num_input_rows() ||
               std::binary_search(meeting.begin(), meeting.end(), row);
      }))
    return std::nullopt;
  const Direction &a = t.point(path.front()), &b = t.point(path.back());
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const Direction &p = t.point(path[k - 1]), &q = t.point(path[k]);
    if (is_inside_arc(a, b, q) && (k == 1 || is_inside_arc(p, b, q))) continue;
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
  return delaunay::name_of_edge(edge[0], edge[1]) + " is marked but belongs to no arc";
}

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  if (auto defect = delaunay::find_map_defect(t.rows(), t.sites())) return defect;
  if (t.mesh().num_faces() == 0) return std::nullopt;
  if (auto defect = delaunay::find_link_defect(t.mesh())) return defect;
  const Sphere sphere(t);
  if (auto defect = find_tiling_defect(t, sphere)) return defect;
  if (auto defect = find_edge_defect(t, sphere)) return defect;
  return find_path_defect(t);
}

}  // namespace delone::stripack
