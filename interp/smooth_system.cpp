#include "interp/smooth_system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "interp/blend_hump.hpp"
#include "interp/index.hpp"
#include "interp/plane_cells.hpp"

namespace delone::interp {

namespace {

// Weights of edges stay between these: the first keeps every node tied to its
// neighbours where triangles are flat, the second keeps needles within the numbers.
constexpr double least_weight = 0x1p-16, most_weight = 128;
// Shorter edges (of the domain's extent) pull as if they were so long.
constexpr double least_length = 0x1p-17;

Eigen::Index column(std::int32_t i) { return i; }

PlaneSpace space_over(const tripack::Triangulation& t) {
  return {coordinate_scale(t.points())};
}
SphereSpace space_over(const stripack::Triangulation&) { return {}; }

// To be multiplied on top of the space's own scale.
double extent_scale(std::span<const std::array<double, 3>> places) {
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::ranges::minmax(
        places, {}, [k](const std::array<double, 3>& p) { return p[k]; });
    extent = std::max(extent, high[k] - low[k]);
  }
  return std::exp2(-std::ilogb(extent));
}

double doubled_area(Point2 u, Point2 v) { return std::abs(u.x * v.y - u.y * v.x); }
double doubled_area(Vector3 u, Vector3 v) { return length(cross(u, v)); }

double area_on(Point2 a, Point2 b, Point2 c) {
  return 0.5 * doubled_area(PlaneSpace::difference(b, a), PlaneSpace::difference(c, a));
}
// The angle in space (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983)).
double area_on(Vector3 a, Vector3 b, Vector3 c) {
  const double volume = std::abs(dot(a, cross(b - a, c - a)));
  return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

std::array<double, 3> place_of(Point2 p) { return {p.x, p.y, 0}; }
std::array<double, 3> place_of(Vector3 p) { return {p.x, p.y, p.z}; }

std::array<double, 2> components(const PlaneSpace::Axes&, Point2 t) { return {t.x, t.y}; }
std::array<double, 2> components(const SphereSpace::Axes& axes, Vector3 t) {
  return {dot(axes.u, t), dot(axes.v, t)};
}

bool is_direction(const std::array<double, 2>& t) {
  return std::abs(t[0] * t[0] + t[1] * t[1] - 1) < 0.5;  // false for NaN
}

/// What the triangles at an edge have to say about it.
struct EdgeSides {
  double cotangents = 0, area = 0;
};

template <BlendSpace Space>
class SystemMaker {
 public:
  using Vector = typename Space::Vector;
  SystemMaker(const typename Space::Triangulation& t, std::span<const double> weights)
      : t_(t) {
    const Space space = space_over(t);
    for (const auto& p : t.points()) {
      points_.push_back(space.vector(p));
      system_.places.push_back(place_of(Space::difference(points_.back(), points_[0])));
    }
    const double more = extent_scale(system_.places);
    for (auto& place : system_.places)
      for (double& x : place) x *= more;
    stretch_ = stretch(more);
    system_.is_chain = t.dimension() < 2;
    system_.scale = space.scale * more;
    system_.extent_scale = more;
    system_.weights =
        Eigen::Map<const Eigen::VectorXd>(weights.data(), std::ssize(weights));
    system_.weights /= system_.weights.mean();
  }

  SmoothSystem made() && {
    add_edges();
    list_edges();
    set_trend();
    return std::move(system_);
  }

 private:
  // Products of coordinates must not underflow; points of the sphere stay on it.
  double stretch(double more) {
    if constexpr (std::is_same_v<Space, SphereSpace>) return more;
    for (std::size_t s = 0; s < points_.size(); ++s)
      points_[s] = scaled_place(system_.places[s], points_[s]);
    return 1;
  }
  static Point2 scaled_place(const std::array<double, 3>& place, Point2) {
    return {place[0], place[1]};
  }
  static Vector3 scaled_place(const std::array<double, 3>&, Vector3 p) { return p; }

  void add_edges() {
    const Adjacency& t = t_.adjacency();
    for (Site v = 0; v < t.num_sites(); ++v) {
      Arc a = t.first_arc(v);
      for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a))
        if (v < t.target(a)) add_edge(a);
    }
    if (system_.is_chain) return;
    t.for_each_triangle([&](Arc a) {
      const std::array<Site, 3> c = t.left(a);
      system_.area += area_on(points_[at(c[0])], points_[at(c[1])], points_[at(c[2])]) *
                      stretch_ * stretch_;
    });
  }

  void add_edge(Arc arc) {
    const Site v = arc.origin, w = t_.adjacency().target(arc);
    const Vector a = points_[at(v)], b = points_[at(w)];
    const auto between = edge_between(Space{}, a, b);
    SmoothEdge edge{v,
                    w,
                    components(Space::axes(a), between.direction_at_first()),
                    components(Space::axes(b), between.direction_at_second()),
                    2 * between.half,
                    0,
                    0,
                    0};
    // Opposite nodes, and what is too near for its direction to be known.
    if (!is_direction(edge.tangent_first) || !is_direction(edge.tangent_second)) {
      edge.length = 0;
      edge.tangent_first = edge.tangent_second = {1, 0};
    }
    const double chord = edge.length;
    edge.length *= stretch_;
    const double length = std::max(edge.length, least_length);
    edge.bend = system_.is_chain ? 1 / length : weight_of(arc, chord);
    edge.pull = 12 * edge.bend / (length * length);
    if (system_.is_chain) edge.across = edge.bend, system_.area += edge.length;
    system_.edges.push_back(edge);
  }

  double weight_of(Arc arc, double chord) const {
    const Adjacency& t = t_.adjacency();
    EdgeSides sides;
    for (const Arc side : {arc, t.reverse(arc)})
      if (t.has_left(side)) add_side(sides, t.left(side), side.origin);
    const double by_area = sides.area > 0 ? 2.0 / 3 * sides.area / (chord * chord) : 0;
    return std::max(least_weight,
                    std::min({most_weight, most_bend * by_area, sides.cotangents}));
  }

  // `origin` and the next corner are the edge's ends.
  void add_side(EdgeSides& sides, std::array<Site, 3> corners, Site origin) const {
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), origin),
                corners.end());
    const Vector across = points_[at(corners[2])];
    const Vector u = Space::difference(points_[at(corners[0])], across),
                 v = Space::difference(points_[at(corners[1])], across);
    const double doubled = doubled_area(u, v);
    if (!(doubled > 0)) return;
    sides.cotangents += 0.5 * Space::dot(u, v) / doubled;
    sides.area += 0.5 * doubled;
  }

  void list_edges() {
    std::vector<std::int32_t>& offsets = system_.offsets;
    offsets.assign(points_.size() + 1, 0);
    for (const SmoothEdge& e : system_.edges)
      ++offsets[at(e.first) + 1], ++offsets[at(e.second) + 1];
    for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
    system_.edge_lists.resize(2 * system_.edges.size());
    std::vector<std::int32_t> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t e = 0; e < system_.edges.size(); ++e) {
      for (const Site s : {system_.edges[e].first, system_.edges[e].second})
        system_.edge_lists[at(next[at(s)]++)] = static_cast<std::int32_t>(e);
    }
  }

  void set_trend() {
    constexpr std::int32_t count = std::is_same_v<Space, PlaneSpace> ? 2 : 3;
    system_.is_trend_charged = count == 3;
    system_.trend.setZero(3 * std::ssize(points_), count);
    for (std::int32_t s = 0; s < system_.num_sites(); ++s) {
      const auto axes = Space::axes(points_[at(s)]);
      for (std::int32_t k = 0; k < count; ++k) {
        const auto g = gradient_of_coordinate(axes, k);
        system_.trend(3 * s, k) = system_.places[at(s)][at(k)];
        system_.trend(3 * s + 1, k) = g[0];
        system_.trend(3 * s + 2, k) = g[1];
      }
    }
  }
  static std::array<double, 2> gradient_of_coordinate(const PlaneSpace::Axes&,
                                                      std::int32_t k) {
    return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0};
  }
  static std::array<double, 2> gradient_of_coordinate(const SphereSpace::Axes& axes,
                                                      std::int32_t k) {
    return components(axes, {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0});
  }

  const typename Space::Triangulation& t_;
  std::vector<Vector> points_;
  double stretch_ = 1;  ///< multiplies lengths between `points_`
  SmoothSystem system_;
};

// The three expressions whose squares an edge charges, as rows over its six unknowns.
Eigen::Matrix<double, 3, 6> charged_rows(const SmoothEdge& e) {
  const auto [ax, ay] = e.tangent_first;
  const auto [bx, by] = e.tangent_second;
  const double half = 0.5 * e.length;
  Eigen::Matrix<double, 3, 6> rows;
  rows << 0, -ax, -ay, 0, bx, by,  //
      0, ay, -ax, 0, -by, bx,      //
      -1, -half * ax, -half * ay, 1, -half * bx, -half * by;
  return rows;
}

Eigen::Matrix<double, 1, 6> row_across(const SmoothEdge& e) {
  const auto [ax, ay] = e.tangent_first;
  const auto [bx, by] = e.tangent_second;
  Eigen::Matrix<double, 1, 6> row;
  row << 0, ay, -ax, 0, by, -bx;
  return row;
}

Eigen::Vector3d charges(const SmoothEdge& e) { return {e.bend, e.bend, e.pull}; }

}  // namespace

Eigen::Matrix<double, 6, 6> edge_matrix(const SmoothEdge& edge) noexcept {
  const Eigen::Matrix<double, 3, 6> rows = charged_rows(edge);
  Eigen::Matrix<double, 6, 6> matrix =
      rows.transpose() * charges(edge).asDiagonal() * rows;
  if (edge.across > 0)
    matrix += edge.across * row_across(edge).transpose() * row_across(edge);
  return matrix;
}

double SmoothSystem::parameter(double wavelength) const noexcept {
  const double length = wavelength / (2 * std::numbers::pi);
  return length * length * length * length * static_cast<double>(num_sites()) / area;
}

Eigen::VectorXd SmoothSystem::apply(double parameter, const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (const SmoothEdge& e : edges) {
    const Eigen::Index a = 3 * column(e.first), b = 3 * column(e.second);
    Eigen::Matrix<double, 6, 1> ends;
    ends << x.segment<3>(a), x.segment<3>(b);
    const Eigen::Matrix<double, 3, 6> rows = charged_rows(e);
    const Eigen::Vector3d charged = charges(e).cwiseProduct(rows * ends);
    Eigen::Matrix<double, 6, 1> forces = parameter * (rows.transpose() * charged);
    if (e.across > 0)
      forces +=
          parameter * e.across * row_across(e).dot(ends) * row_across(e).transpose();
    result.segment<3>(a) += forces.head<3>();
    result.segment<3>(b) += forces.tail<3>();
  }
  for (Eigen::Index s = 0; s < weights.size(); ++s)
    result[3 * s] += weights[s] * x[3 * s];
  return result;
}

template <BlendSpace Space>
SmoothSystem smooth_system(const typename Space::Triangulation& triangulation,
                           std::span<const double> weights) {
  return SystemMaker<Space>(triangulation, weights).made();
}

template SmoothSystem smooth_system<PlaneSpace>(const tripack::Triangulation&,
                                                std::span<const double>);
template SmoothSystem smooth_system<SphereSpace>(const stripack::Triangulation&,
                                                 std::span<const double>);

}  // namespace delone::interp
