#pragma once

#include <array>

#include "interp/blend_facet.hpp"

namespace delone::interp {

/// What a blended surface at a point takes from what its triangle is made of.
struct BlendShares {
  std::array<double, 3> polynomials{};  ///< of the corners, their values included
  std::array<double, 3> values{};       ///< of the corners' values besides: tension
  /// Of a, b and c of the hump of the edge from corner k to the next.
  std::array<std::array<double, 3>, 3> humps{};
};

/// The weights of BlendFacet, which are the same for all values.
template <BlendSpace Space>
class BlendWeights {
 public:
  using Vector = typename Space::Vector;

  BlendWeights(const std::array<Vector, 3>& points,
               const std::array<double, 3>& tensions) noexcept
      : points_(points),
        tensions_(tensions),
        tension_((tensions[0] + tensions[1] + tensions[2]) / 3) {}

  /// At a (scaled) point of the closed triangle.
  [[nodiscard]] BlendShares operator()(const Vector& p) const noexcept {
    const std::array<double, 3> b = barycentric_at(p);
    std::array<double, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) {
      const double product = b[k] * b[(k + 1) % 3];
      edges[k] = product * product;
    }
    const double total = edges[0] + edges[1] + edges[2];
    if (!(total > 0)) return at_corner(b);
    const double inner = 27.0 * (b[0] * b[1] * b[2]),
                 linear = tension_ == 0 ? 0 : linear_part(inner * inner, tension_);
    BlendShares shares;
    for (std::size_t k = 0; k < 3; ++k) {
      add_edge(shares, k, p, (1 - linear) * edges[k] / total);
      shares.values[k] += linear * b[k];
    }
    return shares;
  }

  /// Of the blend of edge k alone, at any position.
  [[nodiscard]] BlendShares beyond_edge(std::size_t k, const Vector& p) const noexcept {
    BlendShares shares;
    add_edge(shares, k, p, 1);
    return shares;
  }

 private:
  [[nodiscard]] std::array<double, 3> barycentric_at(const Vector& p) const noexcept {
    if (is_thin(points_[0], points_[1], points_[2]))
      return corner_weights(points_[0], points_[1], points_[2], p);
    const auto map =
        barycentric(Space{}, points_[0], Space::difference(points_[1], points_[0]),
                    Space::difference(points_[2], points_[0]));
    const auto [second, third] =
        map(Space::position(p), Space::position(Space::difference(p, points_[0])));
    return {positive_part(1.0 - second - third), positive_part(second),
            positive_part(third)};
  }

  void add_edge(BlendShares& shares, std::size_t k, const Vector& p,
                double part) const noexcept {
    const std::size_t next = (k + 1) % 3;
    const Vector chord = Space::difference(points_[next], points_[k]);
    const double squared = Space::dot(chord, chord),
                 place = Space::dot(scaled(chord, 1 / squared),
                                    Space::difference(p, points_[k])),
                 t = kept_between_ends(place),
                 tension = 0.5 * (tensions_[k] + tensions_[next]),
                 step = edge_step(t, tension), s = t - 0.5, u = t - t * t,
                 linear = tension == 0
                              ? 0
                              : part * linear_part(16 * (u * u), tension * tension);
    shares.values[k] += linear * (1 - t);
    shares.values[next] += linear * t;
    part -= linear;
    shares.polynomials[k] += part * (1 - step);
    shares.polynomials[next] += part * step;
    shares.humps[k] = {part * (u * u), part * (u * u) * s, part * (u * u) * (s * s)};
  }

  static Point2 scaled(Point2 a, double s) noexcept { return {a.x * s, a.y * s}; }
  static Vector3 scaled(Vector3 a, double s) noexcept { return s * a; }

  [[nodiscard]] static BlendShares at_corner(const std::array<double, 3>& b) noexcept {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (b[k] > b[nearest]) nearest = k;
    BlendShares shares;
    shares.polynomials[nearest] = 1;
    return shares;
  }

  std::array<Vector, 3> points_;
  std::array<double, 3> tensions_;
  double tension_;
};

}  // namespace delone::interp
