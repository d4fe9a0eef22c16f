#pragma once

#include <cmath>
#include <concepts>

#include "interp/second_order.hpp"
#include "interp/sphere_vector.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// Coordinates about a node, in units of its radius: `u`, `v` in the tangent plane
/// (orthographic on the sphere), `w` half the squared distance (on the sphere, of the
/// chord: 1 - cos of the angle).
template <class S>
struct LocalPosition {
  S u, v, w;
};

// What the plane and the sphere are to a blended surface. A Position is a point with
// (scaled) coordinates of any scalar type: numbers, derivatives, or several numbers side
// by side.

struct PlaneSpace {
  using Triangulation = tripack::Triangulation;
  using Point = tripack::Point2;
  using Vector = tripack::Point2;
  template <class S>
  struct Position {
    S x, y;
  };
  [[nodiscard]] static Position<double> position(Vector p) noexcept { return {p.x, p.y}; }
  /// Axes at a node: those of the plane everywhere.
  struct Axes {};

  /// Power of two by which coordinates are multiplied before arithmetic.
  double scale = 1;

  [[nodiscard]] Vector vector(Point p) const noexcept {
    return {p.x * scale, p.y * scale};
  }
  [[nodiscard]] static Vector vector_of(const Position<double>& p) noexcept {
    return {p.x, p.y};
  }
  [[nodiscard]] static Axes axes(Vector) noexcept { return {}; }
  [[nodiscard]] static Vector difference(Vector a, Vector b) noexcept {
    return {a.x - b.x, a.y - b.y};
  }
  [[nodiscard]] static double dot(Vector a, Vector b) noexcept {
    return a.x * b.x + a.y * b.y;
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static S dot(Vector a,
                                                 const Position<S>& p) noexcept {
    return a.x * p.x + a.y * p.y;
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static Position<S> difference(const Position<S>& p,
                                                                  Vector a) noexcept {
    return {p.x - a.x, p.y - a.y};
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static LocalPosition<S> local(
      const Axes&, const Position<S>& d, double per_radius) noexcept {
    const S u = d.x * per_radius, v = d.y * per_radius;
    return {u, v, 0.5 * (u * u + v * v)};
  }
};

struct SphereSpace {
  static constexpr double scale = 1;
  using Triangulation = stripack::Triangulation;
  using Point = stripack::Direction;
  using Vector = Vector3;
  template <class S>
  struct Position {
    S x, y, z;
  };
  [[nodiscard]] static Position<double> position(Vector p) noexcept {
    return {p.x, p.y, p.z};
  }
  /// Two unit vectors that span the tangent plane.
  struct Axes {
    Vector3 u, v;
  };

  [[nodiscard]] static Vector vector(const Point& p) noexcept {
    return interp::vector(p);
  }
  [[nodiscard]] static Vector vector_of(const Position<double>& p) noexcept {
    return {p.x, p.y, p.z};
  }
  /// Without a square root and without a direction where they would be ill defined.
  /// Source: T. Duff et al., J. Comput. Graph. Tech. 6 (2017) 1-8.
  [[nodiscard]] static Axes axes(Vector n) noexcept {
    const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x},
            {b, sign + n.y * n.y * a, -n.y}};
  }
  [[nodiscard]] static Vector difference(Vector a, Vector b) noexcept { return a - b; }
  [[nodiscard]] static double dot(Vector a, Vector b) noexcept {
    return interp::dot(a, b);
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static S dot(Vector a,
                                                 const Position<S>& p) noexcept {
    return a.x * p.x + a.y * p.y + a.z * p.z;
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static Position<S> difference(const Position<S>& p,
                                                                  Vector a) noexcept {
    return {p.x - a.x, p.y - a.y, p.z - a.z};
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] static LocalPosition<S> local(
      const Axes& axes, const Position<S>& d, double per_radius) noexcept {
    const S u = dot(axes.u, d) * per_radius, v = dot(axes.v, d) * per_radius;
    const S squared = d.x * d.x + d.y * d.y + d.z * d.z;
    return {u, v, (0.5 * per_radius * per_radius) * squared};
  }
};

template <class T>
concept BlendSpace = requires(const typename T::Point& p) {
  { T{}.vector(p) } -> std::same_as<typename T::Vector>;
  { T::axes(T{}.vector(p)) } -> std::same_as<typename T::Axes>;
};

}  // namespace delone::interp
