#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "interp/natural_view.hpp"
#include "interp/operator_terms.hpp"
#include "interp/plane_cells.hpp"
#include "interp/reach.hpp"
#include "interp/sphere_cells.hpp"

namespace delone::interp {

/// What plane and sphere need besides their views.
template <class View>
struct NaturalRoom;
template <>
struct NaturalRoom<PlaneView> {
  using Point = tripack::Point2;
  using Triangulation = tripack::Triangulation;
  using Linear = PlaneCells;
  using Reach = PlaneReach;
  using Gradient = Point2;  // per unit of x and y
  [[nodiscard]] static Gradient gradient(const PlaneView&, Pair<double> g,
                                         double scale) noexcept {
    return {g.x * scale, g.y * scale};
  }
  [[nodiscard]] static Gradient gradient(Pair<double> slope, double scale) noexcept {
    return {slope.x * scale, slope.y * scale};
  }
};
template <>
struct NaturalRoom<SphereView> {
  using Point = stripack::Direction;
  using Triangulation = stripack::Triangulation;
  using Linear = SphereCells;
  using Reach = SphereReach;
  using Gradient = Vector3;  // tangent to the sphere
  [[nodiscard]] static Gradient gradient(const SphereView& view, Pair<double> g,
                                         double) noexcept {
    return view.slope(g);
  }
  [[nodiscard]] static Gradient gradient(Vector3 slope, double) noexcept { return slope; }
};

/// A natural-neighbour surface: what its queries and its weights share. Where the
/// triangulation does not hold a point strictly inside its hull, the linear surface knows
/// what to do.
///
/// A value depends on the point alone: the triangle from which the cavity is found is the
/// one that holds it, of two the one with the smaller sites, beginning with its smallest.
template <class View>
class NaturalCells {
 public:
  using Room = NaturalRoom<View>;
  using Point = typename Room::Point;
  using Triangulation = typename Room::Triangulation;
  using Gradient = typename Room::Gradient;
  using Slope = typename View::Slope;

  NaturalCells(std::shared_ptr<const Triangulation> triangulation,
               std::vector<double> site_values, std::vector<Slope> site_slopes,
               double scale, const NaturalOptions& options)
      : triangulation_(std::move(triangulation)),
        values_(std::move(site_values)),
        slopes_(std::move(site_slopes)),
        kind_(options.kind),
        scale_(scale),
        linear_(triangulation_, values_, options.surface()),
        reach_(reach_of(*triangulation_, options.surface())) {}

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }

  [[nodiscard]] double value(const Point& p, Cursor& cursor) const {
    const std::optional<Arc> start = enclosing(p, cursor);
    if (!start) return linear_value(p, cursor);
    if (!is_reached(p, *start)) return std::numeric_limits<double>::quiet_NaN();
    const View view(*triangulation_, scale_, p);
    const auto cavity = find_cavity(triangulation_->adjacency(), view, *start);
    const PerCorner<double> weights = view.weights(kind_, cavity);
    return is_cubic() ? cubic_value(view, cavity, weights) : mean(cavity.sites, weights);
  }

  /// sibson_c1: Sibson's.
  [[nodiscard]] NaturalWeights weights(const Point& p, Cursor& cursor) const {
    NaturalWeights result;
    const std::optional<Arc> start = enclosing(p, cursor);
    if (!start) {
      const Combination linear =
          is_usable(p) ? linear_.combination(p, cursor) : Combination{};
      for (std::size_t k = 0; k < linear.sites().size(); ++k)
        result.add(linear.sites()[k], linear.weights()[k]);
      return result;
    }
    if (!is_reached(p, *start)) return result;
    const View view(*triangulation_, scale_, p);
    const auto cavity = find_cavity(triangulation_->adjacency(), view, *start);
    const PerCorner<double> weights = view.weights(kind_, cavity);
    for (std::size_t k = 0; k < weights.size(); ++k)
      result.add(cavity.sites[k], weights[k]);
    return result;
  }

  /// Appends what the value takes from the sites, of sibson_c1 too, with gradients of
  /// which `slope_weights(s)` tells what they take from the rises to the neighbours of s.
  template <class SlopeWeights>
  void add_terms(const Point& p, Cursor& cursor, SlopeWeights slope_weights,
                 NodalTerms& row) const {
    const std::optional<Arc> start = enclosing(p, cursor);
    if (!start) {
      if (!is_usable(p)) return;
      const Combination linear = linear_.combination(p, cursor);
      if (!is_cubic() || linear.sites().size() != 2)
        return add_mean(linear.sites(), linear.weights(), row);
      const View view(*triangulation_, scale_, p);
      return add_cubic(view, ends(view, linear), end_weights(view, linear),
                       linear.weights(), slope_weights, row);
    }
    if (!is_reached(p, *start)) return;
    const View view(*triangulation_, scale_, p);
    const auto cavity = find_cavity(triangulation_->adjacency(), view, *start);
    const PerCorner<double> weights = view.weights(kind_, cavity);
    const std::span<const double> all{weights.data(), weights.size()};
    if (!is_cubic()) return add_mean({cavity.sites.data(), all.size()}, all, row);
    add_cubic(view, cavity, weights, all, slope_weights, row);
  }

  [[nodiscard]] Gradient gradient(const Point& p, Cursor& cursor) const {
    const std::optional<Arc> start = enclosing(p, cursor);
    if (!start) return linear_gradient(p, cursor);
    if (!is_reached(p, *start)) return linear_.gradient(p, cursor);
    const View view(*triangulation_, scale_, p);
    const auto cavity = find_cavity(triangulation_->adjacency(), view, *start);
    const PerCorner<Dual<double>> weights = view.sloped_weights(kind_, cavity);
    const Dual<double> f = weights.empty() ? Dual<double>{0, NAN, NAN}
                           : is_cubic()    ? cubic<Dual<double>>(view, cavity, weights)
                                           : sloped_mean(cavity.sites, weights);
    if (!std::isfinite(f.x) || !std::isfinite(f.y)) return linear_.gradient(p, cursor);
    return Room::gradient(view, {f.x, f.y}, scale_);
  }

 private:
  using Sites = SmallVector<Site, CavityShape::usual>;

  [[nodiscard]] bool is_usable(const Point& p) const noexcept {
    return is_finite(p) && triangulation_->num_sites() > 0;
  }
  [[nodiscard]] bool is_cubic() const noexcept {
    return kind_ == NaturalKind::sibson_c1 && triangulation_->dimension() == 2;
  }

  // The triangle that holds a point strictly inside the hull that is not a node; nothing
  // for other points. On the sphere also one with the point on its boundary edge, for
  // whose cells that edge is no end.
  [[nodiscard]] std::optional<Arc> enclosing(const Point& p, Cursor& cursor) const {
    if (!is_usable(p) || triangulation_->dimension() != 2) return {};
    const Adjacency& t = triangulation_->adjacency();
    cursor.arc = triangulation_->find(p, cursor.arc);
    if (!t.has_left(cursor.arc)) return {};
    return from_triangle(p, cursor.arc);
  }

  [[nodiscard]] std::optional<Arc> from_triangle(const Point& p, Arc arc) const {
    const Adjacency& t = triangulation_->adjacency();
    const auto points = triangulation_->points();
    const std::array<Site, 3> c = t.left(arc);
    std::size_t num_on = 0, on = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &from = points[at(c[k])], &to = points[at(c[(k + 1) % 3])];
      if (orientation_filter(from, to, p) != 0 || orientation(from, to, p) != 0) continue;
      ++num_on, on = k;
    }
    if (num_on > 1) return {};
    const Arc here = from_smallest_corner(t, arc);
    if (num_on == 0) return here;
    const Arc beyond = on == 0   ? t.reverse(arc)
                       : on == 1 ? t.next(t.reverse(t.next(arc)))
                                 : t.next(arc);
    if (!t.has_left(beyond))
      return std::is_same_v<View, SphereView> && !is_cubic() ? std::optional(here)
                                                             : std::nullopt;
    const Arc there = from_smallest_corner(t, beyond);
    return t.left(here) < t.left(there) ? here : there;
  }

  [[nodiscard]] bool is_reached(const Point& p, Arc start) const {
    return reach_.covers(p, start.origin);
  }

  static void add_mean(std::span<const Site> sites, std::span<const double> weights,
                       NodalTerms& row) {
    for (std::size_t k = 0; k < sites.size(); ++k) row.add(sites[k], weights[k]);
  }

  // The mean with the weights of `otherwise` where cubic_value takes one.
  template <class SlopeWeights>
  void add_cubic(const View& view, const Cavity<typename View::Vertex>& cavity,
                 const PerCorner<double>& weights, std::span<const double> otherwise,
                 SlopeWeights slope_weights, NodalTerms& row) const {
    PerCorner<BezierCorner<double>> corners;
    for (std::size_t k = 0; k < weights.size(); ++k)
      corners.push_back(view.bezier_corner(cavity.vertices[k], weights[k], 0, Slope{}));
    const PerCorner<FarinShare> shares = farin_shares({corners.data(), corners.size()});
    for (const FarinShare& share : shares) {
      if (!std::isfinite(share.value) || !std::isfinite(share.gradient.x) ||
          !std::isfinite(share.gradient.y))
        return add_mean({cavity.sites.data(), weights.size()}, otherwise, row);
    }
    row.add(cavity.sites[0], 1);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const Site s = cavity.sites[k];
      if (k > 0) row.add_rise(cavity.sites[0], s, shares[k].value);
      const std::span<const Slope> slopes = slope_weights(s);
      const std::span<const Site> ring = triangulation_->adjacency().neighbors(s);
      for (std::size_t j = 0; j < ring.size(); ++j) {
        const auto corner = view.bezier_corner(cavity.vertices[k], 0, 0, slopes[j]);
        row.add_rise(s, ring[j], dot(shares[k].gradient, corner.gradient));
      }
    }
  }

  [[nodiscard]] double mean(const Sites& sites,
                            const PerCorner<double>& weights) const noexcept {
    return bounded_mean({sites.data(), sites.size()}, {weights.data(), weights.size()},
                        values_);
  }

  [[nodiscard]] Dual<double> sloped_mean(
      const Sites& sites, const PerCorner<Dual<double>>& weights) const noexcept {
    const double first = values_[at(sites[0])];
    Dual<double> sum{};
    for (std::size_t k = 1; k < sites.size(); ++k)
      sum = sum + weights[k] * Dual<double>{values_[at(sites[k])] - first, 0, 0};
    return sum;
  }

  template <class T>
  [[nodiscard]] T cubic(const View& view, const Cavity<typename View::Vertex>& cavity,
                        const PerCorner<T>& weights) const {
    const double first = values_[at(cavity.sites[0])];
    PerCorner<BezierCorner<T>> corners;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::size_t s = at(cavity.sites[k]);
      corners.push_back(view.bezier_corner(cavity.vertices[k], weights[k],
                                           values_[s] - first, slopes_[s]));
    }
    return T{first} + farin_value<T>({corners.data(), corners.size()});
  }

  // The mean where offsets and slopes are too large or too small for their products.
  [[nodiscard]] double cubic_value(const View& view,
                                   const Cavity<typename View::Vertex>& cavity,
                                   const PerCorner<double>& weights) const {
    const double value = cubic<double>(view, cavity, weights);
    return std::isfinite(value) ? value : mean(cavity.sites, weights);
  }

  // Nodes, boundary edges, chains and what is outside.
  [[nodiscard]] double linear_value(const Point& p, Cursor& cursor) const {
    if (!is_usable(p)) return std::numeric_limits<double>::quiet_NaN();
    const Combination linear = linear_.combination(p, cursor);
    if (!is_cubic() || linear.sites().size() != 2) return linear.value(values_);
    const View view(*triangulation_, scale_, p);
    const double value =
        cubic<double>(view, ends(view, linear), end_weights(view, linear));
    return std::isfinite(value) ? value : linear.value(values_);
  }
  [[nodiscard]] Gradient linear_gradient(const Point& p, Cursor& cursor) const {
    if (is_cubic() && is_usable(p)) {
      const Combination linear = linear_.combination(p, cursor);
      const auto points = triangulation_->points();
      if (linear.sites().size() == 1 && points[at(linear.sites()[0])] == p)
        return Room::gradient(slopes_[at(linear.sites()[0])], scale_);
    }
    return linear_.gradient(p, cursor);
  }
  [[nodiscard]] static Cavity<typename View::Vertex> ends(const View& view,
                                                          const Combination& edge) {
    Cavity<typename View::Vertex> cavity;
    for (const Site s : edge.sites()) cavity.add(s, view.vertex(s));
    return cavity;
  }
  // By the distances of the ends in the flat picture: what weights tend to there.
  [[nodiscard]] static PerCorner<double> end_weights(const View& view,
                                                     const Combination& edge) {
    const auto distance = [&](std::size_t k) {
      const Pair<double> d = View::flat(view.vertex(edge.sites()[k]));
      return std::hypot(d.x, d.y);
    };
    const double part = distance(0) / (distance(0) + distance(1));
    PerCorner<double> weights(2, part);
    weights[0] = 1 - part;
    return weights;
  }

  std::shared_ptr<const Triangulation> triangulation_;
  std::vector<double> values_;
  std::vector<Slope> slopes_;
  NaturalKind kind_;
  double scale_;
  typename Room::Linear linear_;
  typename Room::Reach reach_;
};

}  // namespace delone::interp
