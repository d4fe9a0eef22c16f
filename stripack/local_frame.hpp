#pragma once

#include <cmath>
#include <concepts>

#include "delaunay/lanes.hpp"
#include "stripack/direction.hpp"

/// The sphere as a site sees it. Internal: use stripack/voronoi.hpp and
/// stripack/measures.hpp.
///
/// In the tangent plane at a site v every direction c is (up, x, y), c = up v + x e1 +
/// y e2, of any length; (x / up, y / up) is its central projection. With (x, y) the
/// tangential part of another site w and rise = 1 - v . w, what is as far from v as from
/// w is the line
///   x X + y Y = rise Up,
/// exactly as in the plane, where rise is half the squared distance. So circumcentres and
/// cells keep all digits however small a triangle is: nothing is subtracted but w - v.
namespace delone::stripack {

using Double2 = double __attribute__((vector_size(16)));

/// A number, or several that are worked on at once. What is written for both is
/// always inlined: see delaunay/instruction_set.hpp.
template <class T>
concept Real = std::same_as<T, double> || std::same_as<T, Double2> ||
    std::same_as<T, delaunay::Double4>;

/// An answer, or one for each.
template <Real T>
using Truth = decltype(T{} < T{});

/// A vector of space.
template <Real T>
struct BasicSpaceVector {
  T x{}, y{}, z{};
};
using SpaceVector = BasicSpaceVector<double>;

template <Real T, Real U>
[[nodiscard, gnu::always_inline]] inline auto operator-(
    const BasicSpaceVector<T>& a, const BasicSpaceVector<U>& b) noexcept {
  return BasicSpaceVector<T>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <Real T>
[[nodiscard, gnu::always_inline]] inline auto operator+(
    const BasicSpaceVector<T>& a, const BasicSpaceVector<T>& b) noexcept {
  return BasicSpaceVector<T>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <Real T, Real U>
[[nodiscard, gnu::always_inline]] inline T dot(const BasicSpaceVector<T>& a,
                                               const BasicSpaceVector<U>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard, gnu::always_inline]] inline SpaceVector vector(const Direction& d) noexcept {
  return {d.x(), d.y(), d.z()};
}

/// 1 / |d| - 1 to 2^-104: what the length of a direction differs from 1 by rounding.
[[nodiscard]] double stretch(const Direction& d) noexcept;

/// Another site as seen from v.
template <Real T>
struct BasicSpoke {
  T x{}, y{};
  T square{};  ///< x^2 + y^2
  T rise{};    ///< 1 - cosine of the distance
};
using Spoke = BasicSpoke<double>;

/// A direction as seen from v, of any length.
template <Real T>
struct BasicLocalVector {
  T up{}, x{}, y{};
};
using LocalVector = BasicLocalVector<double>;

/// The way from one site to another as seen from v: its tangential part.
template <Real T>
struct BasicSide {
  T x{}, y{};
  T square{};        ///< x^2 + y^2
  T space_square{};  ///< of its length in space
};

/// Circumcentres from spokes b and c, with answers whether they can be relied on.
///
/// With u = 2^-53 a spoke of length L is known to 8 u L: w - v and the axes are rounded,
/// and w has a length of 1 +- 2 u. Of the products below any two that cancel are off by
/// 32 u L_b L_c together, so a centre at the distance R is found to 32 u R / sin(A), A
/// the angle at v. Across the spokes of a needle, whose base is s = L sin(A), that is too
/// much: it is 1 / sin^2(A) of its width. For A below 7 degrees the base is taken for the
/// second spoke: with c = b + e and rise_c = rise_b + fall the same determinants are
/// those of (b, e), and nothing cancels unless the angle B at b is near 0 or pi as well.
/// e comes from c - b, which is rounded once; that b and c are not of the same length
/// moves c by d b, d = (|b|^2 - |c|^2) / 2 = (b - c) . (b + c) / 2. So e is known to 16 u
/// s, and the centre to 48 u R / sin(B).
template <Real T>
struct Circumcenters {
  static constexpr double squared_sine = 1.0 / 64;
  static constexpr double smallest = 0x1p-900;  // of squares of determinants

  [[nodiscard, gnu::always_inline]] static BasicLocalVector<T> plain(
      const BasicSpoke<T>& b, const BasicSpoke<T>& c) noexcept {
    return {b.x * c.y - b.y * c.x, b.rise * c.y - c.rise * b.y,
            b.x * c.rise - c.x * b.rise};
  }
  [[nodiscard, gnu::always_inline]] static Truth<T> is_plain(
      const BasicLocalVector<T>& center, const BasicSpoke<T>& b,
      const BasicSpoke<T>& c) noexcept {
    const T square = center.up * center.up;
    return (square >= squared_sine * (b.square * c.square)) & (square > smallest);
  }

  [[nodiscard, gnu::always_inline]] static BasicLocalVector<T> of_needle(
      const BasicSpoke<T>& b, const BasicSpoke<T>& c, const BasicSide<T>& e) noexcept {
    const T fall =
        (e.x * (2 * b.x + e.x) + e.y * (2 * b.y + e.y)) / (2 - b.rise - c.rise);
    return {b.x * e.y - b.y * e.x, b.rise * e.y - fall * b.y, b.x * fall - e.x * b.rise};
  }
  /// Not for spokes longer than 60 degrees, nor for a base that is seen end on.
  [[nodiscard, gnu::always_inline]] static Truth<T> is_needle(
      const BasicLocalVector<T>& center, const BasicSpoke<T>& b, const BasicSpoke<T>& c,
      const BasicSide<T>& e) noexcept {
    constexpr double end_on = 1.0 / 16;
    const T square = center.up * center.up;
    return (square >= squared_sine * (b.square * e.square)) & (square > smallest) &
           (e.square >= end_on * e.space_square) & (b.rise + c.rise < 0.5);
  }
};

/// Tangential axes: right-handed with v.
///
/// Source: T. Duff et al., Building an Orthonormal Basis, Revisited, J. Comput. Graph.
/// Tech. 6 (2017) 1-8.
class LocalFrame {
 public:
  [[gnu::always_inline]] explicit LocalFrame(const Direction& v) noexcept : up_(v) {
    const double sign = std::copysign(1.0, v.z()), a = -1 / (sign + v.z());
    const double b = v.x() * v.y() * a;
    first_ = {1 + sign * v.x() * v.x() * a, sign * b, -sign * v.x()};
    second_ = {b, sign + v.y() * v.y() * a, -v.y()};
  }

  /// Coordinates to a few units of rounding of the distance.
  [[nodiscard, gnu::always_inline]] Spoke spoke(const Direction& w) const noexcept {
    const BasicSpoke<double> s = open_spoke(vector(w));
    return is_close(s) ? spoke_of_close_site(w) : s;
  }
  /// The same, but for sites so close that they are found beside the axes only: there
  /// lengths differ by more than that.
  template <Real T>
  [[nodiscard, gnu::always_inline]] BasicSpoke<T> open_spoke(
      const BasicSpaceVector<T>& w) const noexcept {
    // The chord of sites close to each other is spoilt by the lengths of v and w: its
    // square is off by the square of their difference. The square root of 1 - x^2 - y^2
    // needs two terms there.
    constexpr double near = 0x1p-40;
    const auto d = w - vector(up_);
    const T x = dot(d, first_), y = dot(d, second_);
    const T square = x * x + y * y, chord2 = dot(d, d);
    return {x, y, square, chord2 < near ? square * (0.5 + 0.125 * square) : 0.5 * chord2};
  }
  template <Real T>
  [[nodiscard, gnu::always_inline]] static Truth<T> is_close(
      const BasicSpoke<T>& s) noexcept {
    constexpr double closest = 0x1p-100, quarter_turn = 1;
    return (s.square < closest) & (s.rise < quarter_turn);
  }
  template <Real T>
  [[nodiscard, gnu::always_inline]] BasicSide<T> side(
      const BasicSpaceVector<T>& b, const BasicSpaceVector<T>& c,
      const BasicSpoke<T>& to_b) const noexcept {
    const auto d = c - b;
    const T longer = -0.5 * dot(d, b + c);
    const T x = dot(d, first_) + longer * to_b.x, y = dot(d, second_) + longer * to_b.y;
    return {x, y, x * x + y * y, dot(d, d)};
  }

  /// The axis of the circle through v and two sites: the outward normal of the face
  /// (v, b, c) of the polyhedron. `up` is positive if the face is seen by the centre from
  /// inside.
  [[nodiscard]] LocalVector circumcenter(const Direction& b, const Direction& c,
                                         const Spoke& to_b,
                                         const Spoke& to_c) const noexcept {
    using Centers = Circumcenters<double>;
    const LocalVector plain = Centers::plain(to_b, to_c);
    if (Centers::is_plain(plain, to_b, to_c)) return plain;
    const BasicSide<double> e = side(vector(b), vector(c), to_b);
    const LocalVector of_needle = Centers::of_needle(to_b, to_c, e);
    if (Centers::is_needle(of_needle, to_b, to_c, e)) return of_needle;
    return circumcenter_wide(b, c);
  }
  /// The same in twice the precision.
  [[nodiscard]] LocalVector circumcenter_wide(const Direction& b,
                                              const Direction& c) const noexcept;

  /// That of the directions v, b and c to a few units of rounding, slivers included.
  [[nodiscard]] double determinant(const Direction& b, const Direction& c) const noexcept;

  [[nodiscard]] LocalVector local(const Direction& d) const noexcept {
    const SpaceVector v = vector(d);
    return {dot(v, vector(up_)), dot(v, first_), dot(v, second_)};
  }
  /// Throws Error on the zero vector.
  [[nodiscard]] Direction direction(const LocalVector& c) const {
    return Direction::from(c.up * up_.x() + c.x * first_.x + c.y * second_.x,
                           c.up * up_.y() + c.x * first_.y + c.y * second_.y,
                           c.up * up_.z() + c.x * first_.z + c.y * second_.z);
  }

 private:
  [[nodiscard]] Spoke spoke_of_close_site(const Direction& w) const noexcept;
  [[nodiscard]] LocalVector circumcenter_here(const Direction& b,
                                              const Direction& c) const noexcept;

  Direction up_;
  SpaceVector first_, second_;
};

}  // namespace delone::stripack
