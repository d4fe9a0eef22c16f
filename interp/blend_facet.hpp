#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "interp/blend_model.hpp"
#include "interp/blend_space.hpp"
#include "interp/node_batch.hpp"
#include "interp/pack.hpp"
#include "interp/plane_facet.hpp"
#include "interp/sphere_facet.hpp"

namespace delone::interp {

/// What an edge adds to its two nodal polynomials between its ends: t^2 (1 - t)^2 (a + b
/// s + c s^2) with t from 0 at the smaller site to 1 at the larger, s = t - 1/2.
struct EdgeHump {
  double a = 0, b = 0, c = 0;
};

/// The part of the second end at a place t along an edge: 0 before the edge, 1 beyond it,
/// in between a step with zero slope at both ends. Tension 0: 3 t^2 - 2 t^3; towards 1
/// linear but for short parabolas at the ends. Continuously differentiable.
template <class S>
[[nodiscard, gnu::always_inline]] inline S edge_step(const S& t,
                                                     double tension) noexcept {
  const double bend = 0.5 * (1 - tension), slope = 1 / (1 - bend);
  const S low = positive_part(S(bend) - t), high = positive_part(t - S(1 - bend));
  const S straight =
      slope * (t - S(0.5 * bend)) + (0.5 * slope / bend) * (low * low - high * high);
  return (1 - tension) * (t * t * (S(3.0) - 2.0 * t)) + tension * straight;
}

/// The same with its derivatives, of full relative precision near t = 0.
[[nodiscard]] inline SecondOrder edge_step_near_start(const SecondOrder& t,
                                                      double tension) noexcept {
  const double bend = 0.5 * (1 - tension), slope = 1 / (1 - bend);
  if (!(t.value < bend)) return edge_step(t, tension);
  return t * t *
         ((1 - tension) * (SecondOrder(3.0) - 2.0 * t) +
          SecondOrder(tension * (0.5 * slope / bend)));
}

/// The part of the linear interpolant where `inner` (0 at the rim, 1 in the middle) is
/// squared so: 0 and flat at the rim, next to the tension in the middle.
template <class S>
[[nodiscard, gnu::always_inline]] inline S linear_part(const S& squared,
                                                       double tension) noexcept {
  return tension * (squared / (squared + S((1 - tension) * (1 - tension))));
}

/// 0 .. 1; beyond the ends constant.
template <class S>
[[nodiscard, gnu::always_inline]] inline S kept_between_ends(const S& t) noexcept {
  return S(1.0) - positive_part(S(1.0) - positive_part(t));
}

/// Barycentric coordinates of the second and third corner as functions of the position
/// relative to the first.
class PlaneBarycentric {
 public:
  PlaneBarycentric(Point2 u, Point2 v) noexcept {
    const double area = u.x * v.y - u.y * v.x;
    second_ = {v.y / area, -v.x / area};
    third_ = {-u.y / area, u.x / area};
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] std::pair<S, S> operator()(
      const PlaneSpace::Position<S>&, const PlaneSpace::Position<S>& d) const noexcept {
    return {PlaneSpace::dot(second_, d), PlaneSpace::dot(third_, d)};
  }

 private:
  Point2 second_, third_;
};

/// The same where the ray through the position meets the flat triangle (see
/// PlainSphereFacet).
class SphereBarycentric {
 public:
  SphereBarycentric(Vector3 a, Vector3 u, Vector3 v) noexcept
      : second_(cross(v, a)), third_(cross(a, u)), normal_(cross(u, v)) {}
  template <class S>
  [[nodiscard, gnu::always_inline]] std::pair<S, S> operator()(
      const SphereSpace::Position<S>& p,
      const SphereSpace::Position<S>& d) const noexcept {
    const S height = SphereSpace::dot(normal_, p);
    return {SphereSpace::dot(second_, d) / height, SphereSpace::dot(third_, d) / height};
  }

 private:
  Vector3 second_, third_, normal_;
};

[[nodiscard]] inline PlaneBarycentric barycentric(PlaneSpace, Point2, Point2 u,
                                                  Point2 v) noexcept {
  return {u, v};
}
[[nodiscard]] inline SphereBarycentric barycentric(SphereSpace, Vector3 a, Vector3 u,
                                                   Vector3 v) noexcept {
  return {a, u, v};
}

template <BlendSpace Space, int Degree>
class BlendFacet;

/// BlendFacet::fill_groups_as for the instruction set of the machine.
template <BlendSpace Space, int Degree>
[[nodiscard]] std::uint64_t fill_groups(const BlendFacet<Space, Degree>& facet,
                                        const NodeBatch& batch) noexcept;

/// A blended surface in one triangle.
///
/// Every corner has a polynomial in coordinates about it (BlendModel), every edge blends
/// those of its ends by a step of the foot of the perpendicular on it, the triangle
/// blends its edges with weights (b_i b_j)^2, b barycentric. Step and weights are flat
/// where they end, so value and gradient on an edge are those of its own blend, which the
/// triangle on the other side shares, and at a corner those of its polynomial:
/// continuously differentiable everywhere. All parts are weights between 0 and 1 that sum
/// to one, however thin the triangle: the surface stays within what its polynomials are
/// kept in, up to the humps. Edges' humps make the surface along an edge the Hermite
/// curve of its ends. Tension lets the linear interpolant in, by a weight that is flat at
/// the edges, and along edges the line between the ends, by one that is flat there.
template <BlendSpace Space, int Degree>
class BlendFacet {
 public:
  using Vector = typename Space::Vector;
  template <class S>
  using Position = typename Space::template Position<S>;
  using Model = BlendModel<Degree>;
  /// `humps[k]` is that of the edge from corner k to the next.
  struct Corners {
    std::array<Vector, 3> points;
    std::array<const Model*, 3> models;
    std::array<EdgeHump, 3> humps;
  };

  explicit BlendFacet(const Corners& corners) noexcept
      : points_(corners.points),
        humps_(corners.humps),
        barycentric_(barycentric(Space{}, points_[0],
                                 Space::difference(points_[1], points_[0]),
                                 Space::difference(points_[2], points_[0]))),
        is_thin_(is_thin(points_[0], points_[1], points_[2])) {
    for (std::size_t k = 0; k < 3; ++k) {
      models_[k] = *corners.models[k];
      axes_[k] = Space::axes(points_[k]);
      base_[k] = models_[k].value - corners.models[0]->value;
      tension_ += models_[k].tension / 3;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vector along = Space::difference(points_[next], points_[k]);
      const double squared = Space::dot(along, along);
      along_[k] = scaled(along, 1 / squared);
      edge_tension_[k] = 0.5 * (models_[k].tension + models_[next].tension);
    }
  }

  /// At a (scaled) point of the closed triangle.
  [[nodiscard]] double operator()(const Vector& p) const noexcept {
    return value(Space::position(p));
  }
  [[nodiscard]] SecondOrder operator()(const Position<SecondOrder>& p) const noexcept {
    const Rises<SecondOrder> rises = rises_at<SecondOrder>(p, softened<SecondOrder>);
    return SecondOrder(models_[0].value) + blend<SecondOrder>(p, rises, weights(p));
  }

  /// The blend of edge k alone, at any position: how the surface continues beyond an edge
  /// of the hull. Beyond the ends of the edge it is the polynomial of the end.
  template <class S>
  [[nodiscard]] S beyond_edge(std::size_t k, const Position<S>& p) const noexcept {
    return S(models_[0].value) + edge_blend<S>(k, p, rises_at<S>(p, softened<S>));
  }
  /// The same with the place t along the edge, 0 at its first end, given.
  template <class S>
  [[nodiscard]] S beyond_edge(std::size_t k, const Position<S>& p,
                              const S& t) const noexcept {
    return S(models_[0].value) +
           edge_blend_at<S>(k, kept_between_ends(t), rises_at<S>(p, softened<S>));
  }

  /// Evaluates the nodes and empties the batch. The same bits as one by one.
  //
  // In groups of as many as there are lanes; where a node needs a case of its own (a rise
  // near a bound, a corner), its group is done one by one.
  void fill(NodeBatch& batch) const noexcept {
    batch.fill_lanes();
    const std::uint64_t open = is_thin_ ? ~std::uint64_t{0} : fill_groups(*this, batch);
    for (std::size_t k = 0; open != 0 && k < batch.size(); ++k) {
      if ((open >> k & 1) == 0) continue;
      *batch.values[k] =
          value(position_in<double>(batch, [k](const double* from) { return from[k]; }));
    }
    batch.clear();
  }
  /// The groups of a triangle that is not thin, compiled for an instruction set. Bits of
  /// the nodes that are left open.
  template <class InstructionSet>
  [[nodiscard]] std::uint64_t fill_groups_as(const NodeBatch& batch) const noexcept {
    using Lanes = LanesOf<InstructionSet>;
    std::uint64_t open = 0;
    for (std::size_t i = 0; i < batch.size(); i += Lanes::size)
      open |= (fill_group<InstructionSet>(batch, i) ? 0 : Lanes::all_bits) << i;
    return open;
  }

 private:
  template <class S>
  using Rises = std::array<S, 3>;

  [[nodiscard]] double value(const Position<double>& p) const noexcept {
    const Rises<double> rises = rises_at<double>(p, softened<double>);
    return models_[0].value +
           blend<double>(p, rises, is_thin_ ? thin_weights(p) : weights(p));
  }

  template <class S, class Load>
  [[nodiscard, gnu::always_inline]] static Position<S> position_in(const NodeBatch& batch,
                                                                   Load load) noexcept {
    if constexpr (std::is_same_v<Space, PlaneSpace>) {
      return {load(batch.x), load(batch.y)};
    } else {
      return {load(batch.x), load(batch.y), load(batch.z)};
    }
  }

  template <class InstructionSet>
  [[nodiscard]] bool fill_group(const NodeBatch& batch,
                                std::size_t begin) const noexcept {
    using P = Pack<InstructionSet>;
    using Lanes = LanesOf<InstructionSet>;
    const auto p = position_in<P>(
        batch, [begin](const double* from) { return P(Lanes::load(from + begin)); });
    bool is_plain = true;
    const Rises<P> rises = rises_at<P>(p, [&](const P& rise, double least, double most) {
      is_plain = is_plain && is_within(rise, free_part * least, free_part * most);
      return rise;
    });
    const P sum = blend<P>(p, rises, weights(p));
    if (!is_plain || Lanes::word(Lanes::are_numbers(sum.lanes)) != Lanes::all_bits)
      return false;
    const P values = P(models_[0].value) + sum;
    for (std::size_t k = 0; k < Lanes::size && begin + k < batch.size(); ++k)
      *batch.values[begin + k] = values.lanes[static_cast<int>(k)];
    return true;
  }

  template <class InstructionSet>
  [[nodiscard, gnu::always_inline]] static bool is_within(const Pack<InstructionSet>& a,
                                                          double least,
                                                          double most) noexcept {
    using Lanes = LanesOf<InstructionSet>;
    return (Lanes::word(Lanes::are_from(a.lanes, Lanes::all(least))) &
            Lanes::word(Lanes::are_from(Lanes::all(most), a.lanes))) == Lanes::all_bits;
  }

  static Point2 scaled(Point2 a, double s) noexcept { return {a.x * s, a.y * s}; }
  static Vector3 scaled(Vector3 a, double s) noexcept { return s * a; }

  // Above the value of the first corner, so that constants come out exactly.
  template <class S, class Soften>
  [[nodiscard]] Rises<S> rises_at(const Position<S>& p, Soften soften) const noexcept {
    Rises<S> rises;
    for (std::size_t k = 0; k < 3; ++k) {
      const Model& m = models_[k];
      const LocalPosition<S> local =
          Space::local(axes_[k], Space::difference(p, points_[k]), m.per_radius);
      rises[k] =
          S(base_[k]) + soften(polynomial_rise<Degree, S>(m, local), m.least, m.most);
    }
    return rises;
  }

  template <class S>
  [[nodiscard]] std::array<S, 3> weights(const Position<S>& p) const noexcept {
    const auto [second, third] = barycentric_(p, Space::difference(p, points_[0]));
    return {positive_part(S(1.0) - second - third), positive_part(second),
            positive_part(third)};
  }
  [[nodiscard]] std::array<double, 3> thin_weights(
      const Position<double>& p) const noexcept {
    return corner_weights(points_[0], points_[1], points_[2], Space::vector_of(p));
  }

  // The blend along edge k, without regard to the third corner.
  template <class S>
  [[nodiscard, gnu::always_inline]] S edge_blend(std::size_t k, const Position<S>& p,
                                                 const Rises<S>& rises) const noexcept {
    return edge_blend_at<S>(
        k, kept_between_ends(Space::dot(along_[k], Space::difference(p, points_[k]))),
        rises);
  }
  template <class S>
  [[nodiscard, gnu::always_inline]] S edge_blend_at(
      std::size_t k, const S& t, const Rises<S>& rises) const noexcept {
    const std::size_t next = (k + 1) % 3;
    const S step = edge_step(t, edge_tension_[k]), s = t - S(0.5), u = t - t * t;
    const EdgeHump& h = humps_[k];
    const S curve = rises[k] + step * (rises[next] - rises[k]) +
                    u * u * (S(h.a) + s * (S(h.b) + h.c * s));
    return tightened<S>(curve, S(base_[k]) + (base_[next] - base_[k]) * t, u,
                        edge_tension_[k]);
  }

  // Nearer to the line between the ends, but as it is near the ends. By the square of the
  // tension: what little tension nodes have by themselves must not cost accuracy.
  template <class S>
  [[nodiscard, gnu::always_inline]] static S tightened(const S& curve, const S& line,
                                                       const S& u,
                                                       double tension) noexcept {
    if (tension == 0) return curve;
    return curve + linear_part(16.0 * (u * u), tension * tension) * (line - curve);
  }

  // The same above the rise of corner c. Derivatives of the edges' weights grow like one
  // over the distance to a corner; seen from it, what they multiply falls with its square
  // and keeps its digits.
  [[nodiscard]] SecondOrder edge_blend_above(
      std::size_t c, std::size_t k, const Position<SecondOrder>& p,
      const Rises<SecondOrder>& rises) const noexcept {
    const std::size_t next = (k + 1) % 3;
    if (c != k && c != next) return edge_blend(k, p, rises) - rises[c];
    const SecondOrder t = kept_between_ends(
                          Space::dot(along_[k], Space::difference(p, points_[k]))),
                      back = kept_between_ends(
                          -1.0 *
                          Space::dot(along_[k], Space::difference(p, points_[next]))),
                      step = edge_step_near_start(c == k ? t : back, edge_tension_[k]),
                      s = t - SecondOrder(0.5), u = t * back;
    const EdgeHump& h = humps_[k];
    const SecondOrder curve =
        step * (rises[c == k ? next : k] - rises[c]) +
        u * u * (SecondOrder(h.a) + s * (SecondOrder(h.b) + h.c * s));
    const SecondOrder line = SecondOrder(base_[k]) + (base_[next] - base_[k]) * t;
    return tightened(curve, line - rises[c], u, edge_tension_[k]);
  }

  template <class S>
  [[nodiscard, gnu::always_inline]] S blend(const Position<S>& p, const Rises<S>& rises,
                                            const std::array<S, 3>& b) const noexcept {
    std::array<S, 3> edge_weights;
    for (std::size_t k = 0; k < 3; ++k) {
      const S product = b[k] * b[(k + 1) % 3];
      edge_weights[k] = product * product;
    }
    const S total = edge_weights[0] + edge_weights[1] + edge_weights[2];
    if constexpr (!is_pack<S>) {  // of four numbers, 0 / 0 tells
      if (!(value_of(total) > 0)) return at_corner(rises, b);
    }
    S sum;
    if constexpr (std::is_same_v<S, SecondOrder>) {
      const std::size_t c = nearest_corner(b);
      for (std::size_t k = 0; k < 3; ++k)
        sum = sum + edge_weights[k] * edge_blend_above(c, k, p, rises);
      sum = rises[c] + sum / total;
    } else {
      sum = edge_weights[0] * edge_blend(0, p, rises) +
            edge_weights[1] * edge_blend(1, p, rises) +
            edge_weights[2] * edge_blend(2, p, rises);
      sum = sum / total;
    }
    if (tension_ == 0) return sum;
    const S linear = base_[1] * b[1] + base_[2] * b[2];
    const S inner = 27.0 * (b[0] * b[1] * b[2]), squared = inner * inner;
    const S part = linear_part(squared, tension_);
    return sum + part * (linear - sum);
  }

  // Weights that underflow: at a corner, or as near as makes no difference.
  template <class S>
  [[nodiscard]] static S at_corner(const Rises<S>& rises,
                                   const std::array<S, 3>& b) noexcept {
    return rises[nearest_corner(b)];
  }

  template <class S>
  [[nodiscard]] static std::size_t nearest_corner(const std::array<S, 3>& b) noexcept {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (value_of(b[k]) > value_of(b[nearest])) nearest = k;
    return nearest;
  }

  std::array<Vector, 3> points_;
  std::array<typename Space::Axes, 3> axes_;
  std::array<Model, 3> models_;
  std::array<Vector, 3> along_;
  std::array<double, 3> base_{}, edge_tension_{};
  std::array<EdgeHump, 3> humps_;
  decltype(barycentric(Space{}, Vector{}, Vector{}, Vector{})) barycentric_;
  double tension_ = 0;
  bool is_thin_;
};

}  // namespace delone::interp
