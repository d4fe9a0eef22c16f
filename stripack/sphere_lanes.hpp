#pragma once

#include "delaunay/lanes.hpp"
#include "delaunay/twofold_lanes.hpp"
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
/// 48 u leaves room, and 2^-99 (size_x + size_y) covers the constant. No size is above
/// the square of the diagonal of the points' bounding box, nor above 4, which gives the
/// errors that hold for a whole block.
///
/// With twice the precision (delaunay::TwofoldArithmetic, its notation) and the lengths:
/// a component of A x B has p = 4, error 15 u^2; cross p = 7 and 48 u^2 of sqrt(2) size:
/// p = 10, error 68 u^2 size. dot p = 5, error 24 u^2 size. d to 16 u^2: 8 for its sums,
/// 8 for d^2 / 2, which makes 48 u^2 of size; rounding of the terms of d (at most 12 u
/// size) 108, of their sum with dot 17: p = 17 and 197 u^2 size in all. (w_x - w_a)(w_x -
/// w_b) is off by 2^-148. The products of the determinant 252 + 197 + 68 u^2, their
/// difference 57 more, twice: 1148 u^2 size_x size_y. 2048 u^2 and 2^-140 (size_x +
/// size_y) leave room.
template <class InstructionSet>
class SphereLanes {
 public:
  using Points = SpherePoints;
  using Double4 = delaunay::Double4;
  using Mask4 = delaunay::Mask4;
  using Site = std::int32_t;
  using Arithmetic = delaunay::TwofoldArithmetic<InstructionSet>;
  static constexpr bool can_close = true;

  /// For merging any of the points.
  explicit SphereLanes(const SpherePoints& p) noexcept : points_(p.points) {
    set_errors(4);
  }
  /// For the points begin .. end - 1.
  SphereLanes(const SpherePoints& p, Site begin, Site end) noexcept : points_(p.points) {
    set_errors(square_diagonal(begin, end));
  }

  /// An end of the base.
  struct Corner {
    Double4 x, y, z;
  };
  struct Lanes {
    Double4 cross, dot;
    Mask4 is_end;  ///< the candidate is an end of the base
  };

  [[gnu::always_inline]] Corner corner(Site a) const noexcept {
    const Direction& p = points_[a];
    return {delaunay::four(p.x()), delaunay::four(p.y()), delaunay::four(p.z())};
  }

  /// Four sites, one a lane.
  [[gnu::always_inline]] Corner corners(const Site (&s)[4]) const noexcept {
    const Direction &p = points_[s[0]], &q = points_[s[1]], &r = points_[s[2]],
                    &t = points_[s[3]];
    return {Double4{p.x(), q.x(), r.x(), t.x()}, Double4{p.y(), q.y(), r.y(), t.y()},
            Double4{p.z(), q.z(), r.z(), t.z()}};
  }

  [[gnu::always_inline]] static Lanes lanes(const Corner& a, const Corner& b,
                                            const Corner& x) noexcept {
    const Double4 ax = a.x - x.x, ay = a.y - x.y, az = a.z - x.z;
    const Double4 bx = b.x - x.x, by = b.y - x.y, bz = b.z - x.z;
    const Double4 nx = InstructionSet::difference_of_products(ay, bz, az, by);
    const Double4 ny = InstructionSet::difference_of_products(az, bx, ax, bz);
    const Double4 nz = InstructionSet::difference_of_products(ax, by, ay, bx);
    return {InstructionSet::sum_of_products(x.x, nx, x.y, ny, x.z, nz),
            InstructionSet::sum_of_products(ax, bx, ay, by, az, bz),
            delaunay::are_zero(ax, ay, az) | delaunay::are_zero(bx, by, bz)};
  }
  [[gnu::always_inline]] Lanes lanes(const Corner& a, const Corner& b,
                                     const Site (&s)[4]) const noexcept {
    return lanes(a, b, corners(s));
  }

  [[gnu::always_inline]] Double4 sizes(Site a, Site b,
                                       const Lanes& lanes) const noexcept {
    const Direction &p = points_[a], &q = points_[b];
    const double x = q.x() - p.x(), y = q.y() - p.y(), z = q.z() - p.z();
    return lanes.dot + 0.5 * (x * x + y * y + z * z);
  }

  /// No sum of rounded coordinates is known to be exact.
  [[gnu::always_inline]] static constexpr bool is_exact() noexcept { return false; }

  /// Errors of cross, and of dot_x cross_y - dot_y cross_x: of any points of the block,
  /// or of those of the sizes given.
  [[gnu::always_inline]] Double4 cross_error() const noexcept { return cross_error_; }
  [[gnu::always_inline]] Double4 circle_error() const noexcept { return circle_error_; }
  [[gnu::always_inline]] Double4 cross_error(const Double4& size) const noexcept {
    return 10 * 0x1p-53 * size + 0x1p-1000;
  }
  [[gnu::always_inline]] Double4 circle_error(const Double4& size_x,
                                              const Double4& size_y) const noexcept {
    return 48 * 0x1p-53 * (size_x * size_y) + 0x1p-99 * (size_x + size_y) + 0x1p-1000;
  }

  using TwofoldLanes = delaunay::TwofoldLanes;
  [[gnu::always_inline]] static TwofoldLanes twofold_lanes(const Corner& a,
                                                           const Corner& b,
                                                           const Corner& x) noexcept {
    const auto ax = Arithmetic::difference(a.x, x.x),
               ay = Arithmetic::difference(a.y, x.y),
               az = Arithmetic::difference(a.z, x.z);
    const auto bx = Arithmetic::difference(b.x, x.x),
               by = Arithmetic::difference(b.y, x.y),
               bz = Arithmetic::difference(b.z, x.z);
    const auto minor = [](const auto& p, const auto& q, const auto& r, const auto& t) {
      return Arithmetic::difference(Arithmetic::product(p, q), Arithmetic::product(r, t));
    };
    const auto sum = [](const auto& p, const auto& q, const auto& r) {
      return Arithmetic::sum(Arithmetic::sum(p, q), r);
    };
    const auto cross = sum(Arithmetic::product(x.x, minor(ay, bz, az, by)),
                           Arithmetic::product(x.y, minor(az, bx, ax, bz)),
                           Arithmetic::product(x.z, minor(ax, by, ay, bx)));
    auto dot = sum(Arithmetic::product(ax, bx), Arithmetic::product(ay, by),
                   Arithmetic::product(az, bz));
    dot.low += length_term(a, b, x);
    return {cross, dot};
  }
  [[gnu::always_inline]] Double4 twofold_cross_error(const Double4& size) const noexcept {
    return 0x1p-99 * size + 0x1p-1000;
  }
  [[gnu::always_inline]] Double4 twofold_circle_error(
      const Double4& size_x, const Double4& size_y) const noexcept {
    return 0x1p-95 * (size_x * size_y) + 0x1p-140 * (size_x + size_y) + 0x1p-1000;
  }

  /// Exact sign.
  [[gnu::always_inline]] int orientation(Site a, Site b, Site c) const noexcept {
    const Direction &p = points_[a], &q = points_[b], &r = points_[c];
    const double ax = p.x() - r.x(), ay = p.y() - r.y(), az = p.z() - r.z();
    const double bx = q.x() - r.x(), by = q.y() - r.y(), bz = q.z() - r.z();
    const double det = r.x() * (ay * bz - az * by) + r.y() * (az * bx - ax * bz) +
                       r.z() * (ax * by - ay * bx);
    const double error = cross_error_[0];
    if (det > error || det < -error) [[likely]]
      return det > 0 ? 1 : -1;
    return orientation_closely(a, b, c);
  }
  /// Exact sign, ties broken: never 0.
  [[gnu::noinline]] int in_circle(Site a, Site b, Site c, Site d) const noexcept {
    return in_circle_perturbed(points_[a], points_[b], points_[c], points_[d]);
  }

  /// Is x certainly outside of the disc with diameter ab?
  [[nodiscard]] bool is_outside_disc(Site a, Site b, Site x) const noexcept {
    const Lanes l = lanes(corner(a), corner(b), {x, x, x, x});
    return l.dot[0] > 18 * 0x1p-53 * sizes(a, b, l)[0] + 0x1p-99;
  }

  [[gnu::always_inline]] bool less_u(Site a, Site b) const noexcept {
    const Direction &p = points_[a], &q = points_[b];
    const double left = p.x() * q.y(), right = p.y() * q.x();
    return left != right ? left > right : less_u_closely(p, q);
  }
  [[gnu::always_inline]] bool less_v(Site a, Site b) const noexcept {
    const Direction &p = points_[a], &q = points_[b];
    const double left = p.z() * axis_part(q), right = q.z() * axis_part(p);
    return left != right ? left < right : less_v_closely(p, q);
  }

 private:
  [[gnu::noinline]] int orientation_closely(Site a, Site b, Site c) const noexcept {
    const int certain = orientation_filter(points_[a], points_[b], points_[c]);
    if (certain != 0) return certain;
    const Corner x = corner(a), y = corner(b), z = corner(c);
    const double det = twofold_lanes(x, y, z).cross.rounded()[0];
    const double error =
        twofold_cross_error(lanes(x, y, z).dot + 0.5 * squared_distance(x, y))[0];
    if (det > error || det < -error) return det > 0 ? 1 : -1;
    return stripack::orientation(points_[a], points_[b], points_[c]);
  }
  /// What the lengths of a, b and x add to dot, see above.
  [[gnu::always_inline]] static Double4 length_term(const Corner& a, const Corner& b,
                                                    const Corner& x) noexcept {
    const Double4 da = length_excess(a), db = length_excess(b), dx = length_excess(x);
    return 0.5 * (db * squared_distance(a, x) + da * squared_distance(b, x) -
                  dx * squared_distance(a, b)) -
           (dx - da) * (dx - db);
  }
  [[gnu::always_inline]] static Double4 squared_distance(const Corner& p,
                                                         const Corner& q) noexcept {
    const Double4 x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
    return InstructionSet::sum_of_products(x, x, y, y, z, z);
  }
  /// |v| - 1 = (|v|^2 - 1) / 2, up to 2^-102.
  [[gnu::always_inline]] static Double4 length_excess(const Corner& v) noexcept {
    const auto square = Arithmetic::sum(
        Arithmetic::sum(Arithmetic::product(v.x, v.x), Arithmetic::product(v.y, v.y)),
        Arithmetic::product(v.z, v.z));
    return 0.5 * ((square.high - 1) + square.low);
  }

  [[gnu::noinline]] static bool less_u_closely(const Direction& p,
                                               const Direction& q) noexcept {
    return is_less_u(p, q) || (!is_less_u(q, p) && is_less_v(p, q));
  }
  [[gnu::noinline]] static bool less_v_closely(const Direction& p,
                                               const Direction& q) noexcept {
    return is_less_v(p, q) || (!is_less_v(q, p) && is_less_u(p, q));
  }
  // Rounding up of the diagonal is in the room the bounds leave.
  void set_errors(double square_diagonal) noexcept {
    const Double4 size = delaunay::four(square_diagonal);
    cross_error_ = cross_error(size);
    circle_error_ = circle_error(size, size);
  }
  [[nodiscard]] double square_diagonal(Site begin, Site end) const noexcept {
    const Direction& first = points_[begin];
    double low[3] = {first.x(), first.y(), first.z()};
    double high[3] = {first.x(), first.y(), first.z()};
    for (Site s = begin + 1; s < end; ++s) {
      const double p[3] = {points_[s].x(), points_[s].y(), points_[s].z()};
      for (int k = 0; k < 3; ++k) {
        low[k] = p[k] < low[k] ? p[k] : low[k];
        high[k] = high[k] < p[k] ? p[k] : high[k];
      }
    }
    double square = 0;
    for (int k = 0; k < 3; ++k) square += (high[k] - low[k]) * (high[k] - low[k]);
    return square;
  }

  const Direction* points_;
  Double4 cross_error_, circle_error_;
};

}  // namespace delone::stripack
