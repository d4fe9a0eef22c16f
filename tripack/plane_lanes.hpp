#pragma once

#include "delaunay/lanes.hpp"
#include "tripack/point.hpp"
#include "tripack/predicate_filters.hpp"
#include "tripack/predicate_rungs.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

/// Points in site order, and the unit of the lattice they lie on: a power of two of which
/// all coordinates are multiples, or 0.
struct PlanePoints {
  const Point2* points;
  double unit;
};

/// The plane as blocks are merged in it (delaunay::DivideConquer).
///
/// A candidate x is looked at from the base a -> b, with A = a - x, B = b - x:
///   cross = A x B,  dot = A . B,  size = (|A|^2 + |B|^2) / 2 = dot + |a - b|^2 / 2.
/// It is left of the base if cross > 0, and a further candidate y is inside circle(a, b,
/// x) if the angle at y is larger, that is if dot_x cross_y - dot_y cross_x > 0.
///
/// Errors, with u = 2^-53: each difference is off by a factor (1 + u), so cross and dot
/// by at most 4 u |A| |B| <= 4 u size (the products of a sum are at most |A| |B| by
/// Cauchy), and size itself by less than 11 u. 5 u leaves room. In the determinant the
/// errors of the factors make 4 u (|dot| + |cross|) of either point times the size of the
/// other, at most 8 sqrt(2) u, its products and their sum 2 u more: 16 u of size_x size_y
/// leaves room. The added constant covers underflow. Overflow makes bounds infinite, so
/// that nothing is certain.
///
/// On a lattice of unit g (a power of two) cross, dot and size are multiples of g^2 and
/// exact up to 2^53 g^2, the products of the determinant multiples of g^4 and exact up to
/// 2^53 g^4. Where the sizes promise that, errors are 0 and a tie is known to be one.
template <class InstructionSet>
class PlaneLanes {
 public:
  using Points = PlanePoints;
  using Double4 = delaunay::Double4;
  using Site = std::int32_t;
  static constexpr bool can_close = false;

  explicit PlaneLanes(const PlanePoints& p) noexcept
      : points_(p.points),
        exact_size_(p.unit > 0 ? 0x1p50 * p.unit * p.unit : -1),
        exact_product_(p.unit > 0 ? exact_size_ * p.unit * p.unit : -1) {}

  struct Base {
    double ax, ay, bx, by, half_square;
  };
  struct Lanes {
    Double4 cross, dot, size, cross_error;
  };

  [[gnu::always_inline]] Base base(Site a, Site b) const noexcept {
    const Point2 p = points_[a], q = points_[b];
    const double x = q.x - p.x, y = q.y - p.y;
    return {p.x, p.y, q.x, q.y, 0.5 * (x * x + y * y)};
  }

  [[gnu::always_inline]] Lanes lanes(const Base& base,
                                     const Site (&s)[4]) const noexcept {
    const Point2 &p = points_[s[0]], &q = points_[s[1]], &r = points_[s[2]],
                 &t = points_[s[3]];
    const Double4 x{p.x, q.x, r.x, t.x}, y{p.y, q.y, r.y, t.y};
    const Double4 ax = base.ax - x, ay = base.ay - y;
    const Double4 bx = base.bx - x, by = base.by - y;
    const Double4 dot = ax * bx + ay * by, size = dot + base.half_square;
    const Double4 error = 5 * 0x1p-53 * size + 0x1p-960;
    return {ax * by - ay * bx, dot, size, size <= exact_size_ ? Double4{} : error};
  }

  /// Error of dot_x cross_y - dot_y cross_x.
  [[gnu::always_inline]] Double4 circle_error(const Double4& size_x,
                                              const Double4& size_y) const noexcept {
    const Double4 product = size_x * size_y;
    const Double4 error = 16 * 0x1p-53 * product + 0x1p-960;
    return product <= exact_product_ ? Double4{} : error;
  }

  /// Exact sign.
  [[gnu::always_inline]] int orientation(Site a, Site b, Site c) const noexcept {
    const int certain = orientation_filter(points_[a], points_[b], points_[c]);
    return certain != 0 ? certain
                        : tripack::orientation(points_[a], points_[b], points_[c]);
  }
  /// Exact sign, ties broken: never 0.
  [[gnu::noinline]] int in_circle(Site a, Site b, Site c, Site d) const noexcept {
    return in_circle_perturbed(points_[a], points_[b], points_[c], points_[d]);
  }
  /// The same for four points known to lie on one circle.
  [[gnu::noinline]] int break_tie(Site a, Site b, Site c, Site d) const noexcept {
    return tripack::break_tie(points_[a], points_[b], points_[c], points_[d]);
  }

  [[gnu::always_inline]] bool less_u(Site a, Site b) const noexcept {
    const Point2 &p = points_[a], &q = points_[b];
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
  [[gnu::always_inline]] bool less_v(Site a, Site b) const noexcept {
    const Point2 &p = points_[a], &q = points_[b];
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  }

 private:
  const Point2* points_;
  double exact_size_, exact_product_;
};

}  // namespace delone::tripack
