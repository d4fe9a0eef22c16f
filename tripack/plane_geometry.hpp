#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "delaunay/closed_hull.hpp"
#include "tripack/point.hpp"
#include "tripack/predicate_rungs.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

/// Local coordinates in which a point set lies in the square [-1, 1]^2: a translation and
/// a scaling by a power of two. One rounding, of the translation, at most u = 2^-53.
class LocalFrame {
 public:
  explicit LocalFrame(std::span<const Point2> points);
  /// The point lifted to the paraboloid z = -(x^2 + y^2).
  [[nodiscard]] delaunay::Vector3 lift(Point2 p) const noexcept {
    const double x = (p.x - center_.x) * scale_, y = (p.y - center_.y) * scale_;
    return {x, y, -(x * x + y * y)};
  }
  /// The largest power of two of which all local coordinates of the points are multiples,
  /// if it is at least 2^-26 and they are local without rounding (lattices, whole
  /// numbers, pixels); else 0.
  [[nodiscard]] double lattice_unit(std::span<const Point2> points) const noexcept;

 private:
  Point2 center_;
  double scale_ = 1;
};

/// The plane as a closed polyhedron: points lifted to the paraboloid, and a node at
/// infinity straight below it, which closes the surface over the convex hull with
/// vertical faces.
class PlaneGeometry {
 public:
  using Face = delaunay::Face;
  using Site = delaunay::Site;
  using Vector3 = delaunay::Vector3;

  explicit PlaneGeometry(std::span<const Point2> points)
      : points_(points), frame_(points), infinity_(static_cast<Site>(points.size())) {
    const double g = frame_.lattice_unit(points);
    exact_area_ = g > 0 ? 0x1p50 * g * g * g * g : -1;
  }

  [[nodiscard]] Site infinity() const noexcept { return infinity_; }
  // Lifted anew each time: cheaper than 24 bytes a site of memory and cache.
  [[nodiscard]] Vector3 point(Site s) const noexcept { return frame_.lift(original(s)); }

  [[nodiscard]] bool is_finite(Site s) const noexcept { return s != infinity_; }

  [[nodiscard]] bool is_front(const Face& f) const noexcept {
    return f.node[0] != infinity_ && f.node[1] != infinity_ && f.node[2] != infinity_;
  }

  /// Bound on the error of normal . q - offset for a face with sides B, C from its first
  /// corner: the local coordinates of each point are off by at most e = 8.2 u
  /// (translation u in x and y, lifting 8 u in z), which moves the sixfold volume by at
  /// most 2.5 e D (|B| + |C|) with D <= 3.5 the largest distance; rounding of the two
  /// products adds 94 u (|B| + |C|). Together 166 u; second-order terms and the use of
  /// 1-norms fit into 192 u.
  static constexpr double plane_error = 192 * 0x1p-53;

  // The hull edge from -> to, the outside on its left: a vertical plane. Moving one of
  // its ends by e turns it about the other, so a point at distance D sees it move by e D
  // however short the edge is: 8.1 u for e = 1.42 u, D <= 2.83 and two ends; 16 u with
  // room. The rest is proportional to the edge.
  double set_vertical_plane(Face& f) const noexcept {
    const std::size_t k = f.node[0] == infinity_ ? 0 : f.node[1] == infinity_ ? 1 : 2;
    const Vector3 from = point(f.node[(k + 1) % 3]), to = point(f.node[(k + 2) % 3]);
    f.normal = {from.y - to.y, to.x - from.x, 0};
    f.offset = f.normal.x * from.x + f.normal.y * from.y;
    return plane_error * (std::abs(f.normal.x) + std::abs(f.normal.y)) + 16 * 0x1p-53;
  }

  [[nodiscard]] bool sees(const std::array<Site, 3>& node, Site q) const noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      if (node[k] == infinity_)
        return sees_vertical(node[(k + 1) % 3], node[(k + 2) % 3], q);
    }
    return in_circle_perturbed(original(node[0]), original(node[1]), original(node[2]),
                               original(q)) > 0;
  }

  /// Local coordinates that are multiples of g lift to multiples of g^2, and all terms of
  /// normal . q - offset are multiples of g^4. With P the product of the norms, no sum of
  /// terms exceeds 8 P: if that is at most 2^53 g^4, nothing is rounded.
  [[nodiscard]] double exact_area() const noexcept { return exact_area_; }
  [[nodiscard]] bool sees_tie(const std::array<Site, 3>& node, Site q) const noexcept {
    return break_tie(original(node[0]), original(node[1]), original(node[2]),
                     original(q)) > 0;
  }

  [[nodiscard]] double side(Site a, Site b, Site q) const noexcept {
    const Point2 from = original(a), to = original(b), p = original(q);
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  }

  [[nodiscard]] int exact_side(Site a, Site b, Site q) const noexcept {
    return orientation(original(a), original(b), original(q));
  }

 private:
  [[nodiscard]] Point2 original(Site s) const noexcept {
    return points_[static_cast<std::size_t>(s)];
  }

  // A point on the line of a hull edge is inside its (infinite) circle if it is between
  // the ends.
  [[nodiscard]] bool sees_vertical(Site from, Site to, Site q) const noexcept {
    const Point2 a = original(from), b = original(to), p = original(q);
    const int s = orientation(a, b, p);
    if (s != 0) return s > 0;
    const auto less = [](Point2 u, Point2 v) {
      return u.x < v.x || (u.x == v.x && u.y < v.y);
    };
    return less(a, p) == less(p, b);
  }

  std::span<const Point2> points_;
  LocalFrame frame_;
  Site infinity_;
  double exact_area_;
};

}  // namespace delone::tripack
