#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// The integral of f over a flat triangle, by a product of Gauss rules that folds up at
/// the first corner: exact for polynomials of degree 10.
template <class F>
[[nodiscard]] double integral_over_triangle(PlaneSpace, const std::array<Point2, 3>& p,
                                            F f) {
  const Point2 u = PlaneSpace::difference(p[1], p[0]),
               v = PlaneSpace::difference(p[2], p[0]);
  double sum = 0;
  for (std::size_t i = 0; i < GaussRule::size; ++i) {
    const double s = gauss_rule.places[i];
    for (std::size_t j = 0; j < GaussRule::size; ++j) {
      const double a = s * (1 - gauss_rule.places[j]), b = s * gauss_rule.places[j];
      sum += s * gauss_rule.weights[i] * gauss_rule.weights[j] *
             f(Point2{p[0].x + a * u.x + b * v.x, p[0].y + a * u.y + b * v.y});
    }
  }
  return sum * (u.x * v.y - u.y * v.x);
}

/// The same over a spherical triangle, by its projection on the flat one; wide ones in
/// four parts.
template <class F>
[[nodiscard]] double integral_over_triangle(SphereSpace, const std::array<Vector3, 3>& p,
                                            F f) {
  constexpr double widest = 0.25;  // square of a chord
  const auto middle = [&](std::size_t i, std::size_t j) {
    const Vector3 sum = p[i] + p[j];
    return (1 / length(sum)) * sum;
  };
  const Vector3 u = p[1] - p[0], v = p[2] - p[0], w = p[2] - p[1];
  if (std::max({dot(u, u), dot(v, v), dot(w, w)}) > widest) {
    const Vector3 a = middle(1, 2), b = middle(2, 0), c = middle(0, 1);
    using Corners = std::array<Vector3, 3>;
    return integral_over_triangle(SphereSpace{}, Corners{p[0], c, b}, f) +
           integral_over_triangle(SphereSpace{}, Corners{c, p[1], a}, f) +
           integral_over_triangle(SphereSpace{}, Corners{b, a, p[2]}, f) +
           integral_over_triangle(SphereSpace{}, Corners{a, b, c}, f);
  }
  double sum = 0;
  for (std::size_t i = 0; i < GaussRule::size; ++i) {
    const double s = gauss_rule.places[i];
    for (std::size_t j = 0; j < GaussRule::size; ++j) {
      const double t = gauss_rule.places[j];
      const Vector3 q = p[0] + (s * (1 - t)) * u + (s * t) * v;
      const double size = length(q);
      sum += s * gauss_rule.weights[i] * gauss_rule.weights[j] / (size * size * size) *
             f((1 / size) * q);
    }
  }
  return sum * dot(p[0], cross(u, v));
}

/// The integral of a surface over all its triangles. The same for every number of
/// threads.
template <BlendSpace Space, class Cells>
[[nodiscard]] double integral_over_triangles(const Space& space, const Cells& cells,
                                             const RunOptions& run) {
  constexpr std::int64_t chunk = 1024;
  const auto& t = cells.triangulation();
  if (t.dimension() < 2) return 0;
  const std::int64_t num_sites = t.num_sites();
  std::vector<double> parts(at((num_sites + chunk - 1) / chunk));
  delaunay::parallel_chunks(
      num_sites, chunk, run, [&](std::int64_t first, std::int64_t last) {
        double sum = 0;
        for_each_triangle(
            t.adjacency(), static_cast<Site>(first), static_cast<Site>(last), [&](Arc a) {
              const std::array<Site, 3> corners = t.adjacency().left(a);
              std::array<typename Space::Vector, 3> p;
              for (std::size_t k = 0; k < 3; ++k)
                p[k] = space.vector(t.points()[at(corners[k])]);
              const auto facet = cells.facet(a);
              sum += integral_over_triangle(
                  Space{}, p, [&](const auto& q) -> double { return facet(q); });
            });
        parts[at(first / chunk)] = sum;
      });
  double total = 0;
  for (const double part : parts) total += part;
  return total / space.scale / space.scale;
}

}  // namespace delone::interp
