#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "interp/blend_facet.hpp"
#include "interp/node_batch.hpp"

namespace delone::interp {

[[nodiscard]] inline SecondOrder sqrt(const SecondOrder& a) noexcept {
  const double root = std::sqrt(a.value), d = 0.5 / root, dd = -0.5 * d / a.value;
  return {root,
          d * a.x,
          d * a.y,
          d * a.xx + dd * a.x * a.x,
          d * a.xy + dd * a.x * a.y,
          d * a.yy + dd * a.y * a.y};
}

/// The point at s (0 .. 1) of the segment from a to b; on the sphere of the chord, seen
/// from the centre.
template <class S>
[[nodiscard]] PlaneSpace::Position<S> point_along(Point2 a, Point2 b,
                                                  const S& s) noexcept {
  return {S(a.x) + (b.x - a.x) * s, S(a.y) + (b.y - a.y) * s};
}
template <class S>
[[nodiscard]] SphereSpace::Position<S> point_along(Vector3 a, Vector3 b,
                                                   const S& s) noexcept {
  using std::sqrt;
  const S x = S(a.x) + (b.x - a.x) * s, y = S(a.y) + (b.y - a.y) * s,
          z = S(a.z) + (b.z - a.z) * s, size = sqrt(x * x + y * y + z * z);
  return {x / size, y / size, z / size};
}

/// A blended surface in one triangle at curves whose ends have values on both sides.
///
/// Along such an edge the blends of the two triangles at it differ. Both take the mean:
/// each adds half the difference at the foot of the point on the edge (by the two
/// barycentric coordinates of its ends), with the weight of that edge in the blend, which
/// is 1 on the edge and flat on the others. So the surface is continuous across the edge,
/// and continuously differentiable across the others, except at the edge's ends.
template <BlendSpace Space, int Degree>
class BarrierFacet {
 public:
  using Own = BlendFacet<Space, Degree>;
  using Vector = typename Space::Vector;
  template <class S>
  using Position = typename Space::template Position<S>;

  /// The triangle across edge k of this one, whose edge `other_k` that is.
  struct Across {
    std::size_t k, other_k;
    Own other;
  };

  BarrierFacet(const Own& own, const std::array<Vector, 3>& points,
               std::vector<Across> across)
      : own_(own), points_(points), across_(std::move(across)) {}

  [[nodiscard]] double operator()(const Vector& p) const noexcept {
    const double value = own_(p);
    if (across_.empty()) return value;
    const auto weights = is_thin(points_[0], points_[1], points_[2])
                             ? corner_weights(points_[0], points_[1], points_[2], p)
                             : weights_at<double>(Space::position(p));
    return value + correction(weights);
  }
  [[nodiscard]] SecondOrder operator()(const Position<SecondOrder>& p) const noexcept {
    const SecondOrder value = own_(p);
    return across_.empty() ? value : value + correction(weights_at<SecondOrder>(p));
  }

  void fill(NodeBatch& batch) const noexcept {
    if (across_.empty()) return own_.fill(batch);
    for (std::size_t i = 0; i < batch.size(); ++i)
      *batch.values[i] = (*this)(vector_in(batch, i));
    batch.clear();
  }

 private:
  [[nodiscard]] static Vector vector_in(const NodeBatch& batch, std::size_t i) noexcept {
    if constexpr (std::is_same_v<Space, PlaneSpace>) {
      return {batch.x[i], batch.y[i]};
    } else {
      return {batch.x[i], batch.y[i], batch.z[i]};
    }
  }

  template <class S>
  [[nodiscard]] std::array<S, 3> weights_at(const Position<S>& p) const noexcept {
    const auto coordinates =
        barycentric(Space{}, points_[0], Space::difference(points_[1], points_[0]),
                    Space::difference(points_[2], points_[0]));
    const auto [second, third] = coordinates(p, Space::difference(p, points_[0]));
    return {positive_part(S(1.0) - second - third), positive_part(second),
            positive_part(third)};
  }

  template <class S>
  [[nodiscard]] S correction(const std::array<S, 3>& b) const noexcept {
    std::array<S, 3> weights;
    for (std::size_t k = 0; k < 3; ++k) {
      const S product = b[k] * b[(k + 1) % 3];
      weights[k] = product * product;
    }
    const S total = weights[0] + weights[1] + weights[2];
    S sum(0.0);
    if (!(value_of(total) > 0)) return sum;
    for (const Across& a : across_) {
      const std::size_t next = (a.k + 1) % 3;
      if (!(value_of(weights[a.k]) > 0)) continue;
      const Position<S> foot =
          point_along(points_[a.k], points_[next], b[next] / (b[a.k] + b[next]));
      const S difference = a.other.template beyond_edge<S>(a.other_k, foot) -
                           own_.template beyond_edge<S>(a.k, foot);
      sum = sum + 0.5 * (weights[a.k] / total * difference);
    }
    return sum;
  }

  Own own_;
  std::array<Vector, 3> points_;
  std::vector<Across> across_;
};

}  // namespace delone::interp
