#pragma once

#include "delaunay/lanes.hpp"
#include "delaunay/twofold_lanes.hpp"
#include "tripack/point.hpp"
#include "tripack/predicate_filters.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

/// Points in site order, the unit of the lattice they lie on (a power of two of which all
/// coordinates are multiples, or 0), and the square of their bounding box's diagonal.
struct PlanePoints {
  const Point2* points;
  double unit, square_diagonal;
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
/// leaves room. The added constant covers underflow. Overflow makes bounds NaN or
/// infinite, so that nothing is certain. No size is above the square of the diagonal of
/// the points' bounding box, which gives the errors that hold for a whole block.
///
/// With twice the precision (delaunay::TwofoldArithmetic, its notation): differences have
/// p = 1 and no error; cross and dot p = 4 and an error of 15 u^2 size; the products of
/// the determinant 41 + 2 15 and their difference 19 more, each of size_x size_y, twice:
/// 180 u^2. 32 and 256 u^2 leave room.
///
/// On a lattice of unit g (a power of two) cross, dot and size are multiples of g^2 and
/// exact up to 2^53 g^2, the products of the determinant multiples of g^4 and exact up to
/// 2^53 g^4. Where the sizes promise that, errors are 0 and a tie is known to be one.
template <class InstructionSet>
class PlaneLanes {
 public:
  using Points = PlanePoints;
  using Double4 = delaunay::Double4;
  using Mask4 = delaunay::Mask4;
  using Site = std::int32_t;
  using Arithmetic = delaunay::TwofoldArithmetic<InstructionSet>;
  static constexpr bool can_close = false;

  /// For merging any of the points.
  explicit PlaneLanes(const PlanePoints& p) noexcept
      : points_(p.points),
        exact_size_(p.unit > 0 ? 0x1p50 * p.unit * p.unit : -1),
        exact_product_(p.unit > 0 ? exact_size_ * p.unit * p.unit : -1) {
    set_errors(p.square_diagonal);
  }
  /// For the points begin .. end - 1.
  PlaneLanes(const PlanePoints& p, Site begin, Site end) noexcept : PlaneLanes(p) {
    set_errors(square_diagonal(begin, end));
  }

  /// An end of the base.
  struct Corner {
    Double4 x, y;
  };
  struct Lanes {
    Double4 cross, dot;
    Mask4 is_end;  ///< the candidate is an end of the base
  };

  [[gnu::always_inline]] Corner corner(Site a) const noexcept {
    const Point2& p = points_[a];
    return {delaunay::four(p.x), delaunay::four(p.y)};
  }

  /// Four sites, one a lane.
  [[gnu::always_inline]] Corner corners(const Site (&s)[4]) const noexcept {
    const auto [x, y] = delaunay::transposed(&points_[s[0]].x, &points_[s[1]].x,
                                             &points_[s[2]].x, &points_[s[3]].x);
    return {x, y};
  }

  [[gnu::always_inline]] static Lanes lanes(const Corner& a, const Corner& b,
                                            const Corner& x) noexcept {
    const Double4 ax = a.x - x.x, ay = a.y - x.y, bx = b.x - x.x, by = b.y - x.y;
    return {InstructionSet::difference_of_products(ax, by, ay, bx),
            InstructionSet::sum_of_products(ax, bx, ay, by),
            delaunay::are_zero(ax, ay) | delaunay::are_zero(bx, by)};
  }
  [[gnu::always_inline]] Lanes lanes(const Corner& a, const Corner& b,
                                     const Site (&s)[4]) const noexcept {
    return lanes(a, b, corners(s));
  }

  [[gnu::always_inline]] Double4 sizes(Site a, Site b,
                                       const Lanes& lanes) const noexcept {
    const double x = points_[b].x - points_[a].x, y = points_[b].y - points_[a].y;
    return lanes.dot + 0.5 * (x * x + y * y);
  }

  /// Are signs of the block free of errors?
  [[gnu::always_inline]] bool is_exact() const noexcept { return circle_error_[0] == 0; }

  /// Errors of cross, and of dot_x cross_y - dot_y cross_x: of any points of the block,
  /// or of those of the sizes given.
  [[gnu::always_inline]] Double4 cross_error() const noexcept { return cross_error_; }
  [[gnu::always_inline]] Double4 circle_error() const noexcept { return circle_error_; }
  [[gnu::always_inline]] Double4 cross_error(const Double4& size) const noexcept {
    const Double4 error = 5 * 0x1p-53 * size + (0x1p-960 + 0 * size);
    return size <= exact_size_ ? Double4{} : error;
  }
  [[gnu::always_inline]] Double4 circle_error(const Double4& size_x,
                                              const Double4& size_y) const noexcept {
    const Double4 product = size_x * size_y;
    const Double4 error = 16 * 0x1p-53 * product + 0x1p-960;
    return product <= exact_product_ ? Double4{} : error;
  }

  using TwofoldLanes = delaunay::TwofoldLanes;
  [[gnu::always_inline]] static TwofoldLanes twofold_lanes(const Corner& a,
                                                           const Corner& b,
                                                           const Corner& x) noexcept {
    const auto ax = Arithmetic::difference(a.x, x.x),
               ay = Arithmetic::difference(a.y, x.y),
               bx = Arithmetic::difference(b.x, x.x),
               by = Arithmetic::difference(b.y, x.y);
    return {
        Arithmetic::difference(Arithmetic::product(ax, by), Arithmetic::product(ay, bx)),
        Arithmetic::sum(Arithmetic::product(ax, bx), Arithmetic::product(ay, by))};
  }
  [[gnu::always_inline]] Double4 twofold_cross_error(const Double4& size) const noexcept {
    return 0x1p-101 * size + (0x1p-960 + 0 * size);
  }
  [[gnu::always_inline]] Double4 twofold_circle_error(
      const Double4& size_x, const Double4& size_y) const noexcept {
    return 0x1p-98 * (size_x * size_y) + 0x1p-960;
  }

  /// Exact sign.
  [[gnu::always_inline]] int orientation(Site a, Site b, Site c) const noexcept {
    const Point2 &p = points_[a], &q = points_[b], &r = points_[c];
    const double det = (p.x - r.x) * (q.y - r.y) - (p.y - r.y) * (q.x - r.x);
    const double error = cross_error_[0];
    if (det > error || det < -error) [[likely]]
      return det > 0 ? 1 : -1;
    return error == 0 ? 0 : orientation_closely(a, b, c);
  }
  /// Exact sign, ties broken: never 0.
  [[gnu::noinline]] int in_circle(Site a, Site b, Site c, Site d) const noexcept {
    return in_circle_perturbed(points_[a], points_[b], points_[c], points_[d]);
  }

  [[gnu::always_inline]] bool less_u(Site a, Site b) const noexcept {
    const Point2 &p = points_[a], &q = points_[b];
    return (p.x < q.x) | ((p.x == q.x) & (p.y < q.y));
  }
  [[gnu::always_inline]] bool less_v(Site a, Site b) const noexcept {
    const Point2 &p = points_[a], &q = points_[b];
    return (p.y < q.y) | ((p.y == q.y) & (p.x < q.x));
  }

 private:
  [[gnu::noinline]] int orientation_closely(Site a, Site b, Site c) const noexcept {
    return tripack::orientation(points_[a], points_[b], points_[c]);
  }
  // Rounding up of the diagonal is in the room the bounds leave.
  void set_errors(double square_diagonal) noexcept {
    const Double4 size = delaunay::four(square_diagonal);
    cross_error_ = cross_error(size);
    circle_error_ = circle_error(size, size);
  }
  [[nodiscard]] double square_diagonal(Site begin, Site end) const noexcept {
    Point2 low = points_[begin], high = low;
    for (Site s = begin + 1; s < end; ++s) {
      const Point2 p = points_[s];
      low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
      high = {high.x < p.x ? p.x : high.x, high.y < p.y ? p.y : high.y};
    }
    const double x = high.x - low.x, y = high.y - low.y;
    return x * x + y * y;
  }

  const Point2* points_;
  double exact_size_, exact_product_;
  Double4 cross_error_, circle_error_;
};

}  // namespace delone::tripack
