#include "tripack/defect.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/ring_check.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::Chain;
using delaunay::Defect;
using delaunay::Ties;

/// Positions of sites, as delaunay/defect.hpp wants them.
class Plane {
 public:
  Plane(std::span<const Point2> points, std::span<const Node> rows, Ties ties)
      : points_(points), rows_(rows), ties_(ties) {}

  [[nodiscard]] Point2 at(Site v) const { return points_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] Node row(Site v) const { return rows_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return tripack::orientation(at(v), at(w), at(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return lexicographically_less(at(v), at(w)) == lexicographically_less(at(v), at(x));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    if (ties_ == Ties::any) return in_circle(at(v), at(w), at(x), at(y)) > 0;
    return in_circle_perturbed(at(v), at(w), at(x), at(y)) >= 0;
  }

 private:
  std::span<const Point2> points_;
  std::span<const Node> rows_;
  Ties ties_;
};

// Some site off the line through the first two; none if there is none.
Site find_site_off_line(const Plane& plane, Site n) {
  for (Site v = 2; v < n; ++v) {
    if (plane.orientation(0, 1, v) != 0) return v;
  }
  return delaunay::none;
}

Defect find_dimension_defect(const Plane& plane, Site n, int dimension) {
  const int expected = n < 2                                            ? n - 1
                       : find_site_off_line(plane, n) == delaunay::none ? 1
                                                                        : 2;
  if (dimension == expected) return std::nullopt;
  return "dimension " + std::to_string(dimension) + " instead of " +
         std::to_string(expected);
}

Defect find_line_defect(const Triangulation& t) {
  std::vector<Site> order(static_cast<std::size_t>(t.num_sites()));
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](Site v) { return t.points()[static_cast<std::size_t>(v)]; };
  std::sort(order.begin(), order.end(),
            [&](Site a, Site b) { return lexicographically_less(at(a), at(b)); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (at(order[i - 1]) == at(order[i])) return "two sites share one position";
  }
  if (t.num_triangles() != 0) return "collinear points have no triangles";
  return delaunay::find_chain_defect(t.adjacency(), order, Chain::open, t.rows());
}

std::vector<Point2> gather(std::span<const Point2> points, std::span<const Node> rows) {
  std::vector<Point2> result;
  result.reserve(rows.size());
  for (const Node row : rows) result.push_back(points[static_cast<std::size_t>(row)]);
  return result;
}

Defect find_missing_triangles(const Plane& plane, Site n) {
  const Site v = find_site_off_line(plane, n);
  if (v == delaunay::none) return std::nullopt;
  return "no triangles, but rows " + std::to_string(plane.row(0)) + ", " +
         std::to_string(plane.row(1)) + " and " + std::to_string(plane.row(v)) +
         " are not on one line";
}

Defect find_infinite(std::span<const Point2> points) {
  const auto bad = std::find_if(points.begin(), points.end(), [](Point2 p) {
    return !std::isfinite(p.x) || !std::isfinite(p.y);
  });
  if (bad == points.end()) return std::nullopt;
  return "row " + std::to_string(bad - points.begin()) + " is not finite";
}

// Lists without triangles must be those of the chain.
Defect find_list_chain_defect(std::span<const Point2> points,
                              const delaunay::NeighborRings& lists) {
  const Triangulation chain(points);
  for (Node row = 0; row < chain.num_rows(); ++row) {
    std::vector<Node> list = lists[static_cast<std::size_t>(row)];
    if (list.empty() && chain.rows()[static_cast<std::size_t>(
                            chain.sites()[static_cast<std::size_t>(row)])] != row)
      continue;
    if (!std::ranges::is_permutation(list, chain.neighbors(row))) {
      return "row " + std::to_string(row) +
             " is not joined to its neighbours along the chain";
    }
  }
  return std::nullopt;
}

}  // namespace

Defect find_defect(const Triangulation& t) {
  if (t.adjacency().num_sites() != t.num_sites() ||
      std::ssize(t.points()) != t.num_sites()) {
    return "sites, points and adjacency lists differ in number";
  }
  if (auto defect = delaunay::find_map_defect(t.rows(), t.sites())) return defect;
  const Plane plane(t.points(), t.rows(), Ties::canonical);
  if (auto defect = find_dimension_defect(plane, t.num_sites(), t.dimension()))
    return defect;
  if (t.dimension() < 2) return find_line_defect(t);
  if (auto defect = delaunay::find_ring_defect(t.adjacency(), t.rows())) return defect;
  if (t.num_triangles() != t.adjacency().num_triangles()) {
    return "num_triangles() is not the number of triangles in the lists";
  }
  return delaunay::find_geometry_defect(t.adjacency(), plane);
}

Defect find_defect(std::span<const Point2> points,
                   std::span<const std::array<std::int32_t, 3>> triangles) {
  if (auto defect = find_infinite(points)) return defect;
  const auto positions = delaunay::merge_positions(points, lexicographically_less);
  const auto sites = gather(points, positions.rows);
  const Plane plane(sites, positions.rows, Ties::any);
  if (triangles.empty())
    return find_missing_triangles(plane, static_cast<Site>(sites.size()));
  auto list = delaunay::site_triangles(triangles, positions);
  if (list.defect) return list.defect;
  return delaunay::find_list_defect(std::move(list.triangles), positions.rows, plane);
}

Defect find_defect(std::span<const Point2> points, const delaunay::NeighborRings& lists) {
  if (lists.size() != points.size()) {
    return std::to_string(lists.size()) + " lists of neighbours for " +
           std::to_string(points.size()) + " points";
  }
  if (auto defect = find_infinite(points)) return defect;
  if (auto defect = delaunay::find_list_entry_defect(lists)) return defect;
  const auto at = [&](Node row) { return points[static_cast<std::size_t>(row)]; };
  const auto found = delaunay::triangles_of_lists(
      lists, [&](Node a, Node b, Node c) { return orientation(at(a), at(b), at(c)); });
  if (found.defect) return found.defect;
  if (auto defect = find_defect(points, found.triangles)) return defect;
  return found.triangles.empty() ? find_list_chain_defect(points, lists) : std::nullopt;
}

}  // namespace delone::tripack
