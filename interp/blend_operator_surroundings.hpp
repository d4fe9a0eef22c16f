#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "interp/blend_samples.hpp"
#include "interp/blend_space.hpp"
#include "interp/c1_options.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

/// A degree whose weights add up to no more than `full` counts in full, to more than
/// `most` not. Products of coefficients and terms that add up to more than `products`
/// lose too many digits.
struct MagnitudeLimits {
  double full, most, products;
};

/// A node with its stencil, without values.
template <BlendSpace Space, int Degree>
class BlendSurroundings {
 public:
  using Triangulation = typename Space::Triangulation;
  using Vector = typename Space::Vector;
  using Terms = std::array<double, num_blend_terms(Degree)>;

  BlendSurroundings(const Space& space, const Triangulation& triangulation, Site site,
                    std::span<const StencilNode> stencil, double nearness,
                    Gradients gradients, std::span<const double> site_values = {})
      : space_(space),
        triangulation_(&triangulation),
        site_(site),
        nearness_(nearness),
        is_slope_known_(gradients != Gradients::local),
        center_(vector_of(site)),
        axes_(Space::axes(center_)) {
    double squared_radius = 0;
    for (const StencilNode& n : stencil)
      squared_radius = std::max(squared_radius, n.squared_distance);
    const double radius = radius_factor<Degree> * std::sqrt(squared_radius);
    per_radius_ = 1 / radius;
    if (!(per_radius_ < std::numeric_limits<double>::max())) {
      per_radius_ = 0;
      return;
    }
    for (const StencilNode& n : stencil) {
      const double distance =
          std::max(std::sqrt(n.squared_distance) / radius, least_distance);
      const double ratio = (1 - distance) / distance;
      const double rise =
          site_values.empty() ? 0 : site_values[at(n.site)] - site_values[at(site)];
      Terms terms = terms_at(vector_of(n.site));
      if (is_slope_known_) {
        places_.push_back({terms[0], terms[1]});
        terms[0] = terms[1] = 0;
      }
      samples_.add(terms, rise, std::pow(ratio, nearness), n.is_neighbor);
    }
    samples_.factor();
  }

  /// 0: the stencil has no extent that a number can hold.
  [[nodiscard]] double per_radius() const noexcept { return per_radius_; }
  [[nodiscard]] double nearness() const noexcept { return nearness_; }
  [[nodiscard]] bool is_slope_known() const noexcept { return is_slope_known_; }
  [[nodiscard]] const std::vector<std::array<double, 2>>& places() const noexcept {
    return places_;
  }
  [[nodiscard]] const BlendSamples<Degree>& samples() const noexcept { return samples_; }
  [[nodiscard]] BlendInfluence<Degree> influence(int degree) const {
    return samples_.influence(samples_.end_term(degree));
  }

  /// `f(terms)` at the middles of edges and triangles around.
  template <class F>
  void for_each_place(F f) const {
    for_each_probe([&](const Vector& p) {
      f(terms_at(p));
      return true;
    });
  }

  /// The largest sum of magnitudes of the weights that the polynomial of a degree takes
  /// in the triangles around; infinite where it is the small difference of large terms.
  [[nodiscard]] double magnitude(int degree, const MagnitudeLimits& limits) const {
    const BlendInfluence<Degree> x = influence(degree);
    double largest = 0;
    for_each_probe([&](const Vector& p) {
      // Not a number counts as too large.
      const double here =
          magnitude_at(terms_at(p), x, samples_.end_term(degree), limits.products);
      if (!(here <= largest)) largest = here;
      return largest <= limits.most;
    });
    return largest;
  }

 private:
  using Point2 = tripack::Point2;
  static Point2 on_surface(Point2 p) noexcept { return p; }
  static Vector3 on_surface(Vector3 p) noexcept { return (1 / length(p)) * p; }
  static Point2 plus(Point2 a, Point2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
  static Vector3 plus(Vector3 a, Vector3 b) noexcept { return a + b; }
  static Point2 times(double s, Point2 a) noexcept { return {s * a.x, s * a.y}; }
  static Vector3 times(double s, Vector3 a) noexcept { return s * a; }

  [[nodiscard]] Vector vector_of(Site s) const {
    return space_.vector(triangulation_->points()[at(s)]);
  }
  [[nodiscard]] Terms terms_at(const Vector& p) const {
    return model_terms<Degree>(
        Space::local(axes_, Space::position(Space::difference(p, center_)), per_radius_));
  }

  [[nodiscard]] double magnitude_at(const Terms& terms, const BlendInfluence<Degree>& x,
                                    std::size_t num_terms, double most_products) const {
    double sum = 0, magnitude = 0, of_products = 0;
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      double weight = 0;
      for (std::size_t c = 0; c < num_terms; ++c) {
        weight += terms[c] * x[c][r];
        of_products += std::abs(terms[c] * x[c][r]);
      }
      sum += weight;
      magnitude += std::abs(weight);
    }
    if (!(of_products < most_products)) return std::numeric_limits<double>::infinity();
    return magnitude + std::abs(1 - sum);
  }

  // As long as f says so: the middles of edges and triangles around. Towards the
  // neighbours themselves the polynomial does not count.
  template <class F>
  void for_each_probe(F f) const {
    const Adjacency& t = triangulation_->adjacency();
    Arc a = t.first_arc(site_);
    for (std::int32_t i = 0; i < t.degree(site_); ++i, a = t.next(a)) {
      const Vector to = vector_of(t.target(a));
      if (!f(on_surface(times(0.5, plus(center_, to))))) return;
      if (!t.has_left(a)) continue;
      const Vector third = vector_of(t.left(a)[2]);
      if (!f(on_surface(times(1.0 / 3, plus(center_, plus(to, third)))))) return;
    }
  }

  Space space_;
  const Triangulation* triangulation_;
  Site site_;
  double nearness_;
  bool is_slope_known_;
  Vector center_;
  typename Space::Axes axes_;
  double per_radius_ = 0;
  BlendSamples<Degree> samples_;
  std::vector<std::array<double, 2>> places_;  ///< if the slope is known
};

}  // namespace delone::interp
