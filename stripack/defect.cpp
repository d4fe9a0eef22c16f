#include "stripack/defect.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/ring_check.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::Chain;
using delaunay::Defect;
using delaunay::Ties;

// Signs of the components of a x b, each as an orientation with an axis, which is exact.
std::array<int, 3> cross_signs(const Direction& a, const Direction& b) {
  return {orientation(a, b, Direction::from(1, 0, 0)),
          orientation(a, b, Direction::from(0, 1, 0)),
          orientation(a, b, Direction::from(0, 0, 1))};
}

// The face of the cube that a ray goes through, and where: rounded quotients are the same
// for all triples of one direction, whatever their length.
struct CubePoint {
  std::size_t axis;
  bool is_negative;
  double u, v;
  friend auto operator<=>(const CubePoint&, const CubePoint&) = default;
};

CubePoint on_cube(const Direction& d) {
  const std::array<double, 3> c{d.x(), d.y(), d.z()};
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    axis = std::abs(c[k]) > std::abs(c[axis]) ? k : axis;
  const double height = std::abs(c[axis]);
  return {axis, c[axis] < 0, c[(axis + 1) % 3] / height, c[(axis + 2) % 3] / height};
}

// An order of directions, exact: triples that differ in length only are equivalent. Where
// the quotients agree the exact ones decide, whose order is a sign of the cross product.
bool is_before(const Direction& a, const Direction& b) {
  const CubePoint p = on_cube(a), q = on_cube(b);
  if (p != q) return p < q;
  const auto signs = cross_signs(a, b);
  const int along_v = signs[(p.axis + 1) % 3], along_u = signs[(p.axis + 2) % 3];
  return along_v != 0 ? along_v > 0 : along_u > 0;
}

/// Positions of sites, as delaunay/defect.hpp wants them.
class Sphere {
 public:
  Sphere(std::span<const Direction> points, std::span<const Node> rows, Ties ties)
      : points_(points), rows_(rows), ties_(ties) {}

  [[nodiscard]] const Direction& at(Site v) const {
    return points_[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] Node row(Site v) const { return rows_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return stripack::orientation(at(v), at(w), at(x));
  }
  // On one great circle the two normals are parallel: the same way or opposite ways.
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return cross_signs(at(v), at(w)) == cross_signs(at(v), at(x));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    if (ties_ == Ties::any) return in_circle(at(v), at(w), at(x), at(y)) > 0;
    return in_circle_perturbed(at(v), at(w), at(x), at(y)) >= 0;
  }

 private:
  std::span<const Direction> points_;
  std::span<const Node> rows_;
  Ties ties_;
};

constexpr std::array<int, 3> no_signs{0, 0, 0};

// A site that spans a great circle with site 0: the first that is not opposite to it.
// With two opposite sites only there is none, and every third one would do.
Site second_site(const Sphere& sphere, Site n) {
  for (Site v = 1; v < n; ++v) {
    if (cross_signs(sphere.at(0), sphere.at(v)) != no_signs) return v;
  }
  return delaunay::none;
}

Site find_site_off_circle(const Sphere& sphere, Site n) {
  const Site second = second_site(sphere, n);
  for (Site v = 1; v < n && second != delaunay::none; ++v) {
    if (sphere.orientation(0, second, v) != 0) return v;
  }
  return delaunay::none;
}

Defect find_dimension_defect(const Sphere& sphere, Site n, int dimension) {
  const int expected = n < 2                                               ? n - 1
                       : find_site_off_circle(sphere, n) == delaunay::none ? 1
                                                                           : 2;
  if (dimension == expected) return std::nullopt;
  return "dimension " + std::to_string(dimension) + " instead of " +
         std::to_string(expected);
}

// Orders the sites of one great circle by angle from site 0, counter-clockwise about the
// normal of site 0 and the second site.
class CircleOrder {
 public:
  CircleOrder(const Sphere& sphere, Site second)
      : sphere_(sphere), normal_(cross_signs(sphere.at(0), sphere.at(second))) {}

  // +1 if the step from v to w is less than pi, 0 at 0 and pi, -1 beyond.
  [[nodiscard]] int turn(Site v, Site w) const {
    const auto signs = cross_signs(sphere_.at(v), sphere_.at(w));
    return signs == no_signs ? 0 : signs == normal_ ? 1 : -1;
  }
  [[nodiscard]] bool operator()(Site v, Site w) const {
    if (half(v) != half(w)) return half(v) < half(w);
    return turn(v, w) > 0;
  }

 private:
  // 0: site 0 itself; 1: less than pi from it; 2: opposite; 3: beyond.
  [[nodiscard]] int half(Site v) const {
    const int sign = turn(0, v);
    return v == 0 ? 0 : sign > 0 ? 1 : sign == 0 ? 2 : 3;
  }

  const Sphere& sphere_;
  std::array<int, 3> normal_;
};

// The chain around the circle is open at the one gap of pi or more, if there is one. Two
// gaps of exactly pi (two opposite sites, nothing else) are a chain of two.
Defect find_circle_chain_defect(const Triangulation& t, const Sphere& sphere,
                                Site second) {
  std::vector<Site> order(static_cast<std::size_t>(t.num_sites()));
  std::iota(order.begin(), order.end(), 0);
  const CircleOrder angles(sphere, second);
  std::sort(order.begin(), order.end(), angles);
  const auto is_gap = [&](Site v, Site w) { return angles.turn(v, w) <= 0; };
  const auto gap = std::adjacent_find(order.begin(), order.end(), is_gap);
  if (gap != order.end()) std::rotate(order.begin(), gap + 1, order.end());
  const bool is_open = gap != order.end() || is_gap(order.back(), order.front());
  return delaunay::find_chain_defect(t.adjacency(), order,
                                     is_open ? Chain::open : Chain::closed, t.rows());
}

Defect find_circle_defect(const Triangulation& t, const Sphere& sphere) {
  if (t.num_triangles() != 0) return "points of one great circle have no triangles";
  const Site n = t.num_sites();
  const Site second = second_site(sphere, n);
  if (second != delaunay::none) return find_circle_chain_defect(t, sphere, second);
  std::vector<Site> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return delaunay::find_chain_defect(t.adjacency(), order, Chain::open, t.rows());
}

std::vector<Direction> gather(std::span<const Direction> points,
                              std::span<const Node> rows) {
  std::vector<Direction> result;
  result.reserve(rows.size());
  for (const Node row : rows) result.push_back(points[static_cast<std::size_t>(row)]);
  return result;
}

Defect find_missing_triangles(const Sphere& sphere, Site n) {
  const Site v = find_site_off_circle(sphere, n);
  if (v == delaunay::none) return std::nullopt;
  return "no triangles, but rows " + std::to_string(sphere.row(0)) + ", " +
         std::to_string(sphere.row(second_site(sphere, n))) + " and " +
         std::to_string(sphere.row(v)) + " are not on one great circle";
}

// Lists without triangles must be those of the chain.
Defect find_list_chain_defect(std::span<const Direction> points,
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
  const Sphere sphere(t.points(), t.rows(), Ties::canonical);
  if (auto defect = find_dimension_defect(sphere, t.num_sites(), t.dimension()))
    return defect;
  if (t.dimension() < 2) return find_circle_defect(t, sphere);
  if (auto defect = delaunay::find_ring_defect(t.adjacency(), t.rows())) return defect;
  if (t.num_triangles() != t.adjacency().num_triangles()) {
    return "num_triangles() is not the number of triangles in the lists";
  }
  return delaunay::find_geometry_defect(t.adjacency(), sphere);
}

Defect find_defect(std::span<const Direction> points,
                   std::span<const std::array<std::int32_t, 3>> triangles) {
  const auto positions = delaunay::merge_positions(points, is_before);
  const auto sites = gather(points, positions.rows);
  const Sphere sphere(sites, positions.rows, Ties::any);
  if (triangles.empty())
    return find_missing_triangles(sphere, static_cast<Site>(sites.size()));
  auto list = delaunay::site_triangles(triangles, positions);
  if (list.defect) return list.defect;
  return delaunay::find_list_defect(std::move(list.triangles), positions.rows, sphere);
}

Defect find_defect(std::span<const Direction> points,
                   const delaunay::NeighborRings& lists) {
  if (lists.size() != points.size()) {
    return std::to_string(lists.size()) + " lists of neighbours for " +
           std::to_string(points.size()) + " points";
  }
  if (auto defect = delaunay::find_list_entry_defect(lists)) return defect;
  const auto at = [&](Node row) { return points[static_cast<std::size_t>(row)]; };
  const auto found = delaunay::triangles_of_lists(
      lists, [&](Node a, Node b, Node c) { return orientation(at(a), at(b), at(c)); });
  if (found.defect) return found.defect;
  if (auto defect = find_defect(points, found.triangles)) return defect;
  return found.triangles.empty() ? find_list_chain_defect(points, lists) : std::nullopt;
}

}  // namespace delone::stripack
