#pragma once

#include "delaunay/lanes.hpp"
#include "stripack/direction.hpp"
#include "stripack/predicate_filters.hpp"
#include "stripack/predicates.hpp"
#include "stripack/sphere_chart.hpp"

namespace delone::stripack {

/// Directions in site order.
struct SpherePoints {
  const Direction* points;
};

/// The sphere as blocks are merged on it (delaunay::DivideConquer).
///
/// A candidate x is looked at from the base a -> b, with A = a - x, B = b - x:
///   cross = det(a, b, x) = x . (A x B),  dot = A . B,  size = (|A|^2 + |B|^2) / 2.
/// It is left of the base if cross > 0. For unit vectors dot is |a + b| times the depth
/// of x below the plane through a and b that is square to a + b, and cross is |a x b|
/// times its height above the great circle ab; so the plane through a, b and x has slope
/// dot / cross about the axis ab, and y is beyond it if dot_x cross_y - dot_y cross_x >
/// 0: the formula of the plane.
///
/// Errors, with u = 2^-53. Differences are off by a factor (1 + u). cross: 6.5 sqrt(2) u
/// |A| |B| (see orientation_bound), 10 u of size leaves room. dot: 5 u of size. With
/// lengths w = 1 + d, |d| <= 4 u, the exact value in place of dot is
///   dot + (d_b |A|^2 + d_a |B|^2 - d_x |a - b|^2) / 2 - (w_a + w_b) (w_x - w_a)(w_x -
///   w_b) / 2,
/// which differs by at most 12 u size + 2^-100. With cross^2 + dot^2 <= size^2 the
/// determinant is off by 2 sqrt(17^2 + 10^2) u of size_x size_y and 2 u for its products:
/// 48 u leaves room, and 2^-99 (size_x + size_y) covers the constant.
template <class InstructionSet>
class SphereLanes {
 public:
  using Points = SpherePoints;
  using Double4 = delaunay::Double4;
  using Site = std::int32_t;
  static constexpr bool can_close = true;

  explicit SphereLanes(const SpherePoints& p) noexcept : points_(p.points) {}

  struct Base {
    double ax, ay, az, bx, by, bz, half_square;
  };
  struct Lanes {
    Double4 cross, dot, size, cross_error;
  };

  [[gnu::always_inline]] Base base(Site a, Site b) const noexcept {
    const Direction &p = points_[a], &q = points_[b];
    const double x = q.x() - p.x(), y = q.y() - p.y(), z = q.z() - p.z();
    return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), 0.5 * (x * x + y * y + z * z)};
  }

  [[gnu::always_inline]] Lanes lanes(const Base& base,
                                     const Site (&s)[4]) const noexcept {
    const Direction &p = points_[s[0]], &q = points_[s[1]], &r = points_[s[2]],
                    &t = points_[s[3]];
    const Double4 x{p.x(), q.x(), r.x(), t.x()}, y{p.y(), q.y(), r.y(), t.y()},
        z{p.z(), q.z(), r.z(), t.z()};
    const Double4 ax = base.ax - x, ay = base.ay - y, az = base.az - z;
    const Double4 bx = base.bx - x, by = base.by - y, bz = base.bz - z;
    const Double4 cross =
        x * (ay * bz - az * by) + y * (az * bx - ax * bz) + z * (ax * by - ay * bx);
    const Double4 dot = ax * bx + ay * by + az * bz, size = dot + base.half_square;
    return {cross, dot, size, 10 * 0x1p-53 * size + 0x1p-1000};
  }

  /// Error of dot_x cross_y - dot_y cross_x.
  [[gnu::always_inline]] Double4 circle_error(const Double4& size_x,
                                              const Double4& size_y) const noexcept {
    return 48 * 0x1p-53 * (size_x * size_y) + 0x1p-99 * (size_x + size_y) + 0x1p-1000;
  }

  /// Exact sign.
  [[gnu::always_inline]] int orientation(Site a, Site b, Site c) const noexcept {
    const int certain = orientation_filter(points_[a], points_[b], points_[c]);
    return certain != 0 ? certain
                        : stripack::orientation(points_[a], points_[b], points_[c]);
  }
  /// Exact sign, ties broken: never 0.
  [[gnu::noinline]] int in_circle(Site a, Site b, Site c, Site d) const noexcept {
    return in_circle_perturbed(points_[a], points_[b], points_[c], points_[d]);
  }
  // No sum of rounded coordinates is known to be exact.
  [[gnu::noinline]] int break_tie(Site a, Site b, Site c, Site d) const noexcept {
    return in_circle(a, b, c, d);
  }

  /// Is x certainly outside of the disc with diameter ab?
  [[nodiscard]] bool is_outside_disc(Site a, Site b, Site x) const noexcept {
    const Lanes l = lanes(base(a, b), {x, x, x, x});
    return l.dot[0] > 18 * 0x1p-53 * l.size[0] + 0x1p-99;
  }

  [[gnu::always_inline]] bool less_u(Site a, Site b) const noexcept {
    return is_less_u(points_[a], points_[b]) ||
           (!is_less_u(points_[b], points_[a]) && is_less_v(points_[a], points_[b]));
  }
  [[gnu::always_inline]] bool less_v(Site a, Site b) const noexcept {
    return is_less_v(points_[a], points_[b]) ||
           (!is_less_v(points_[b], points_[a]) && is_less_u(points_[a], points_[b]));
  }

 private:
  const Direction* points_;
};

}  // namespace delone::stripack
