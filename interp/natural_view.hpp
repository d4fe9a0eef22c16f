#pragma once

#include <array>
#include <cmath>
#include <span>

#include "interp/natural_cavity.hpp"
#include "interp/natural_formulas.hpp"
#include "interp/natural_surface.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/spot.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/predicate_filters.hpp"
#include "tripack/predicate_filters.hpp"

namespace delone::interp {

/// What a point of the plane, or a site, sees of the sites around it. Coordinates are
/// relative to it, times `scale`, a power of two.
class PlaneView {
 public:
  using Vertex = Pair<double>;
  using Slope = Pair<double>;  // of the values at a site, per scaled length
  PlaneView(const tripack::Triangulation& t, double scale, tripack::Point2 p) noexcept
      : points_(t.points()), scale_(scale), p_(p), scaled_p_{p.x * scale, p.y * scale} {}

  [[nodiscard]] Vertex vertex(Site s) const noexcept {
    const tripack::Point2 v = points_[at(s)];
    return {v.x * scale_ - scaled_p_.x, v.y * scale_ - scaled_p_.y};
  }
  [[nodiscard]] bool is_inside_circle(std::span<const Site, 3> sites, const Vertex& a,
                                      const Vertex& b, const Vertex& c) const noexcept {
    const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
    const double det = aa * cross(b, c) + bb * cross(c, a) + cc * cross(a, b);
    // The bound of tripack::in_circle_filter, whose differences these are.
    constexpr double tiny = 0x1p-400;
    const double bound =
        tripack::in_circle_bound * ((aa + tiny) * ((bb + cc) + tiny) + bb * cc);
    if (std::abs(det) > bound) return det > 0;
    return tripack::in_circle(points_[at(sites[0])], points_[at(sites[1])],
                              points_[at(sites[2])], p_) > 0;
  }

  /// Of the sites around the point: not negative, with sum one.
  [[nodiscard]] PerCorner<double> weights(NaturalKind kind,
                                          const Cavity<Vertex>& cavity) const;
  /// The same with derivatives; those of weights that are zero count as zero. Empty where
  /// they are not finite.
  [[nodiscard]] PerCorner<Dual<double>> sloped_weights(
      NaturalKind kind, const Cavity<Vertex>& cavity) const;
  /// The place of a site for planar formulas.
  [[nodiscard]] static Pair<double> flat(const Vertex& v) noexcept { return v; }
  [[nodiscard]] BezierCorner<double> bezier_corner(const Vertex& v, double weight,
                                                   double value,
                                                   Slope slope) const noexcept {
    return {weight, v, value, slope};
  }
  [[nodiscard]] BezierCorner<Dual<double>> bezier_corner(const Vertex& v,
                                                         const Dual<double>& weight,
                                                         double value,
                                                         Slope slope) const noexcept {
    return {weight, {{v.x, -1, 0}, {v.y, 0, -1}}, {value}, {{slope.x}, {slope.y}}};
  }
  /// A slope as seen from the point (which is its site) for the room, and back.
  [[nodiscard]] static Slope slope(Pair<double> flat_slope) noexcept {
    return flat_slope;
  }

 private:
  template <class T>
  [[nodiscard]] PerCorner<T> accurate_weights(NaturalKind kind,
                                              const Cavity<Vertex>& cavity) const;
  [[nodiscard]] PerCorner<double> linear_weights(const Cavity<Vertex>& cavity) const;

  std::span<const tripack::Point2> points_;
  double scale_;
  tripack::Point2 p_;
  Pair<double> scaled_p_;
};

/// The same for a direction. Coordinates are those of stripack::LocalFrame.
class SphereView {
 public:
  using Vertex = stripack::Spoke;
  using Slope = Vector3;  // tangent at the site, per radian
  SphereView(const stripack::Triangulation& t, double /*scale*/,
             const stripack::Direction& p) noexcept
      : points_(t.points()), p_(p), frame_(p) {}

  [[nodiscard]] Vertex vertex(Site s) const noexcept {
    return frame_.spoke(points_[at(s)]);
  }
  /// The determinant of the spokes. These are known to 8 u of their lengths (u = 2^-53),
  /// their rises r to 16 u, so a product r |b| |c| is to 64 u; |b| |c| <= 2 sqrt(r_b
  /// r_c), and the sum of r_a 2 sqrt(r_b r_c) is at most 2 (r_a r_b + r_b r_c + r_c r_a).
  [[nodiscard]] bool is_inside_circle(std::span<const Site, 3> sites, const Vertex& a,
                                      const Vertex& b, const Vertex& c) const noexcept {
    constexpr double bound = 256 * 0x1p-53, tiny = 0x1p-400;
    const double det = a.rise * (b.x * c.y - b.y * c.x) +
                       b.rise * (c.x * a.y - c.y * a.x) +
                       c.rise * (a.x * b.y - a.y * b.x);
    const double size = (a.rise + tiny) * (b.rise + c.rise + tiny) + b.rise * c.rise;
    if (std::abs(det) > bound * size) return det > 0;
    return stripack::in_circle(points_[at(sites[0])], points_[at(sites[1])],
                               points_[at(sites[2])], p_) > 0;
  }

  [[nodiscard]] PerCorner<double> weights(NaturalKind kind,
                                          const Cavity<Vertex>& cavity) const;
  /// Derivatives along the axes of the frame.
  [[nodiscard]] PerCorner<Dual<double>> sloped_weights(
      NaturalKind kind, const Cavity<Vertex>& cavity) const;
  /// The site by stereographic projection on the tangent plane.
  [[nodiscard]] static Pair<double> flat(const Vertex& v) noexcept {
    const double stretch = 2 / (2 - v.rise);
    return {stretch * v.x, stretch * v.y};
  }
  [[nodiscard]] BezierCorner<double> bezier_corner(const Vertex& v, double weight,
                                                   double value,
                                                   const Slope& slope) const noexcept;
  [[nodiscard]] BezierCorner<Dual<double>> bezier_corner(
      const Vertex& v, const Dual<double>& weight, double value,
      const Slope& slope) const noexcept;
  /// A tangent vector in space from its components along the axes.
  [[nodiscard]] Slope slope(Pair<double> components) const noexcept;

 private:
  [[nodiscard]] PerCorner<double> linear_weights(const Cavity<Vertex>& cavity) const;
  [[nodiscard]] stripack::LocalVector local(const Vector3& v) const noexcept;

  std::span<const stripack::Direction> points_;
  stripack::Direction p_;
  stripack::LocalFrame frame_;
};

}  // namespace delone::interp
