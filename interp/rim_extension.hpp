#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "interp/blend_space.hpp"
#include "interp/second_order.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

using stripack::Direction;

[[nodiscard]] inline double square_root(double a) noexcept { return std::sqrt(a); }
[[nodiscard]] inline SecondOrder square_root(const SecondOrder& a) noexcept {
  const double r = std::sqrt(a.value), x = a.x / (2 * r), y = a.y / (2 * r);
  return {
      r, x, y, (a.xx / 2 - x * x) / r, (a.xy / 2 - x * y) / r, (a.yy / 2 - y * y) / r};
}

/// What of a surface's continuation counts beyond the rim of a set in a hemisphere, by
/// the cosine of the distance to it: all at the rim, nothing from 90 degrees on; flat at
/// both ends.
template <class S>
[[nodiscard]] S rim_part(const S& cosine) noexcept {
  return cosine * cosine * (S(3.0) - 2.0 * cosine);
}

/// The point of a rim's edge nearest to a position.
template <class S>
struct RimFoot {
  S place;   ///< along the chord, 0 .. 1
  S cosine;  ///< of the distance
};

/// On the arc from a to b, for a position whose nearest point lies between the ends. From
/// differences to a, so that it is as good for edges of a metre.
template <class S>
[[nodiscard]] RimFoot<S> rim_foot(Vector3 a, Vector3 b,
                                  const SphereSpace::Position<S>& p) noexcept {
  const Vector3 chord = b - a, across = cross(a, chord);
  const Vector3 normal = (1 / length(across)) * across,
                along = (1 / dot(chord, chord)) * chord;
  const auto d = SphereSpace::difference(p, a);
  const S height = SphereSpace::dot(normal, d), squared = height * height,
          cosine = square_root(S(1.0) - squared);
  const S place =
      (SphereSpace::dot(along, d) - 0.5 * (squared / (S(1.0) + cosine))) / cosine;
  return {place, cosine};
}

/// The nearest part of a rim.
struct RimPlace {
  enum class Kind : std::uint8_t {
    edge,    ///< between two sites
    corner,  ///< a site, `from`; `to` the next of the rim, or none
    far      ///< 90 degrees and more away
  };
  Kind kind = Kind::far;
  Site from = none, to = none;
  /// From `from`, the triangles on its left; {} for points on one great circle.
  Arc arc{};
};

/// The rim of a set of directions that fits in a hemisphere: the boundary of its hull,
/// which is convex, or the chain of a set on one great circle.
///
/// So the nearest point of the rim is unique for every direction less than 90 degrees
/// from it and changes continuously with it; where everything is farther, a convex region
/// about the antipode, there is one value: the mean along the rim.
class RimExtension {
 public:
  /// At least one site. `site_values` in the order of sites.
  RimExtension(const stripack::Triangulation& t, std::span<const double> site_values);

  /// Of a direction that the triangulation does not hold. O(sqrt h), h edges.
  [[nodiscard]] RimPlace nearest(const Direction& p) const noexcept;
  /// The mean of the values along the rim, by length. Exact where they are equal.
  [[nodiscard]] double far_value() const noexcept { return far_value_; }

 private:
  struct Box {
    Vector3 low, high;
    [[nodiscard]] double squared_distance(Vector3 p) const noexcept;
  };
  void follow_boundary(const stripack::Triangulation& t);
  void follow_chain(const stripack::Triangulation& t);
  void make_boxes();
  [[nodiscard]] Box box_of(std::size_t begin, std::size_t end) const noexcept;
  [[nodiscard]] double mean_along(std::span<const double> site_values) const noexcept;
  /// The place of edge i nearest to p; of the last node of an open chain, the node.
  struct Reached {
    double squared_chord;
    RimPlace place;
  };
  [[nodiscard]] Reached reached(std::size_t i, Vector3 p) const noexcept;
  [[nodiscard]] std::size_t num_edges() const noexcept {
    return is_closed_ ? sites_.size() : sites_.size() - 1;
  }

  std::vector<Site> sites_;  // along the rim, the set on the left
  std::vector<Arc> arcs_;    // to the next
  std::vector<Vector3> points_;
  std::vector<Box> boxes_;
  std::size_t box_size_ = 1;
  bool is_closed_ = true;
  double far_value_ = 0;
};

}  // namespace delone::interp
