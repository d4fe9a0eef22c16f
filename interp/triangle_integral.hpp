#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/blend_space.hpp"
#include "interp/triangle_nodes.hpp"

namespace delone::interp {

/// Six-point Gauss-Legendre rule on 0 .. 1.
struct GaussRule {
  static constexpr std::size_t size = 6;
  std::array<double, size> places, weights;
};
inline constexpr GaussRule gauss_rule{
    {0.033765242898423987, 0.16939530676686775, 0.38069040695840154, 0.61930959304159846,
     0.83060469323313225, 0.96623475710157601},
    {0.085662246189585173, 0.18038078652406930, 0.23395696728634552, 0.23395696728634552,
     0.18038078652406930, 0.085662246189585173}};

// `corners` count from `origin`, in which small triangles keep their digits. f(q) is a
// number or anything that is added and multiplied by numbers. The integral is negative if
// the corners run clockwise.

/// The integral of f over a flat triangle, by a product of Gauss rules that folds up at
/// the first corner: exact for polynomials of degree 10.
template <class F>
[[nodiscard]] auto integral_over_triangle(PlaneSpace, Point2 origin,
                                          const std::array<Point2, 3>& corners, F f) {
  const Point2 u = PlaneSpace::difference(corners[1], corners[0]),
               v = PlaneSpace::difference(corners[2], corners[0]);
  decltype(f(origin)) sum{};
  for (std::size_t i = 0; i < GaussRule::size; ++i) {
    const double s = gauss_rule.places[i];
    for (std::size_t j = 0; j < GaussRule::size; ++j) {
      const double a = s * (1 - gauss_rule.places[j]), b = s * gauss_rule.places[j];
      sum = sum + (s * gauss_rule.weights[i] * gauss_rule.weights[j]) *
                      f(Point2{origin.x + (corners[0].x + a * u.x + b * v.x),
                               origin.y + (corners[0].y + a * u.y + b * v.y)});
    }
  }
  return (u.x * v.y - u.y * v.x) * sum;
}

/// The same over a spherical triangle, by its projection on the flat one; wide ones in
/// four parts.
template <class F>
[[nodiscard]] std::invoke_result_t<F&, const Vector3&> integral_over_triangle(
    SphereSpace, const Vector3& origin, const std::array<Vector3, 3>& corners, F f) {
  constexpr double widest = 0.25;  // square of a chord
  using Corners = std::array<Vector3, 3>;
  const Vector3 u = corners[1] - corners[0], v = corners[2] - corners[0],
                w = corners[2] - corners[1];
  if (std::max({dot(u, u), dot(v, v), dot(w, w)}) > widest) {
    const Corners p{origin + corners[0], origin + corners[1], origin + corners[2]};
    const auto middle = [&](std::size_t i, std::size_t j) {
      const Vector3 sum = (1 / length(p[i])) * p[i] + (1 / length(p[j])) * p[j];
      return (1 / length(sum)) * sum;
    };
    const Vector3 a = middle(1, 2), b = middle(2, 0), c = middle(0, 1);
    const auto part = [&](const Corners& q) {
      return integral_over_triangle(SphereSpace{}, Vector3{}, q, f);
    };
    return part({p[0], c, b}) + part({c, p[1], a}) + part({b, a, p[2]}) + part({a, b, c});
  }
  const Vector3 first = origin + corners[0];
  decltype(f(first)) sum{};
  for (std::size_t i = 0; i < GaussRule::size; ++i) {
    const double s = gauss_rule.places[i];
    for (std::size_t j = 0; j < GaussRule::size; ++j) {
      const double t = gauss_rule.places[j];
      const Vector3 q = first + ((s * (1 - t)) * u + (s * t) * v);
      const double size = length(q);
      sum = sum +
            (s * gauss_rule.weights[i] * gauss_rule.weights[j] / (size * size * size)) *
                f((1 / size) * q);
    }
  }
  return dot(first, cross(u, v)) * sum;
}

/// The integral over all triangles of `f(facet, q)`, of which a number or a sum of
/// several (see above) is made at every place. The same for every number of threads.
template <BlendSpace Space, class Cells, class F>
[[nodiscard]] auto integral_over_triangles(const Space& space, const Cells& cells,
                                           const RunOptions& run, F f) {
  using Vector = typename Space::Vector;
  using Sum = decltype(f(cells.facet(Arc{}), Vector{}));
  constexpr std::int64_t chunk = 1024;
  const auto& t = cells.triangulation();
  Sum total{};
  if (t.dimension() < 2) return total;
  const std::int64_t num_sites = t.num_sites();
  std::vector<Sum> parts(at((num_sites + chunk - 1) / chunk));
  delaunay::parallel_chunks(
      num_sites, chunk, run, [&](std::int64_t first, std::int64_t last) {
        Sum sum{};
        for_each_triangle(
            t.adjacency(), static_cast<Site>(first), static_cast<Site>(last), [&](Arc a) {
              std::array<Vector, 3> p;
              const std::array<Site, 3> corners = t.adjacency().left(a);
              for (std::size_t k = 0; k < 3; ++k)
                p[k] = space.vector(t.points()[at(corners[k])]);
              const Vector origin = p[0];
              for (Vector& corner : p) corner = Space::difference(corner, origin);
              const auto facet = cells.facet(a);
              sum = sum +
                    integral_over_triangle(Space{}, origin, p,
                                           [&](const Vector& q) { return f(facet, q); });
            });
        parts[at(first / chunk)] = sum;
      });
  for (const Sum& part : parts) total = total + part;
  return (1 / space.scale) * ((1 / space.scale) * total);
}

/// The integral of a surface over all its triangles.
template <BlendSpace Space, class Cells>
[[nodiscard]] double integral_over_triangles(const Space& space, const Cells& cells,
                                             const RunOptions& run) {
  return integral_over_triangles(
      space, cells, run,
      [](const auto& facet, const auto& q) -> double { return facet(q); });
}

}  // namespace delone::interp
