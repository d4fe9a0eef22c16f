#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "interp/dual.hpp"
#include "interp/natural_cavity.hpp"

/// Natural-neighbour coordinates from the shape of a cavity and its corners as seen from
/// the query, in numbers of any kind: double, DoubleDouble, or either with derivatives.
/// Internal: use interp/natural_surface.hpp.
///
/// The query would take from the cell of corner i the polygon between the new cell's edge
/// and the old circumcentres C of the triangles at i. Its area is the sum of signed
/// triangles from the query to its edges, and edges are shared: C C' across a side within
/// the cavity belongs to the cells of both ends, c C across a side of the ring as well (c
/// the new circumcentre there), and c c' to one cell alone. So every circumcentre is
/// found once, relative to the query, and no polygon is made.
///
/// Sources: R. Sibson, Math. Proc. Camb. Phil. Soc. 87 (1980) 151-155; V. V. Belikov et
/// al., Comput. Math. Math. Phys. 37 (1997) 9-15 (Laplace); G. Farin, CAGD 7 (1990)
/// 281-292 (C1).
namespace delone::interp {

template <class T>
using PerCorner = SmallVector<T, CavityShape::usual>;

/// Areas of the signed triangles from the query to the edges of the pieces, summed for
/// each corner. `old_centers` one a triangle, `new_centers` one a side of the ring; `fan`
/// gives the area for an edge.
template <class T, class Center, class Fan>
[[nodiscard]] PerCorner<T> stolen_areas(const CavityShape& shape, std::size_t num_corners,
                                        std::span<const Center> old_centers,
                                        std::span<const Center> new_centers, Fan fan) {
  PerCorner<T> sums(num_corners, T{});
  T* const area = sums.data();
  const auto* const triangles = shape.triangles.data();
  for (std::size_t k = 1; k < shape.triangles.size(); ++k) {
    const auto& t = triangles[k];
    const T part = fan(old_centers[k], old_centers[at(t.parent)]);
    area[at(t.corners[1])] = area[at(t.corners[1])] + part;
    area[at(t.corners[0])] = area[at(t.corners[0])] - part;
  }
  const auto* const ring = shape.ring.data();
  const std::size_t size = shape.ring.size();
  for (std::size_t k = 0, last = size - 1; k < size; last = k++) {
    const std::size_t i = at(ring[k].corner),
                      j = at(ring[k + 1 == size ? 0 : k + 1].corner);
    const T outer = fan(new_centers[k], old_centers[at(ring[k].triangle)]);
    area[i] = area[i] + outer + fan(new_centers[last], new_centers[k]);
    area[j] = area[j] - outer;
  }
  return sums;
}

/// One over an area, the cross product of two sides with the given squares. In plain
/// doubles not a number, which then reaches the sum of the weights, if the angle between
/// them is below 2^-10, where circumcentres lose too many digits.
[[nodiscard]] inline double per_area(double area, double square, double other) noexcept {
  constexpr double squared_sine = 0x1p-20, least = 0x1p-600, most = 0x1p600;
  const double product = square * other;
  const bool is_good = (area > 0) & (area * area >= squared_sine * product) &
                       (product > least) & (product < most);
  return (is_good ? 1 : std::numeric_limits<double>::quiet_NaN()) / area;
}
[[nodiscard]] inline DoubleDouble per_area(const DoubleDouble& area, const DoubleDouble&,
                                           const DoubleDouble&) noexcept {
  return DoubleDouble{1} / area;
}
template <class T>
[[nodiscard]] Dual<T> per_area(const Dual<T>& area, const Dual<T>& square,
                               const Dual<T>& other) noexcept {
  const T inverse = per_area(area.value, square.value, other.value);
  const T slope = -(inverse * inverse);
  return {inverse, slope * area.x, slope * area.y};
}

/// Twice the circumcentre of the query and two corners.
template <class T>
[[nodiscard]] Pair<T> double_circumcenter(const Pair<T>& b, const Pair<T>& c) noexcept {
  const T bb = dot(b, b), cc = dot(c, c), scale = per_area(cross(b, c), bb, cc);
  return {(c.y * bb - b.y * cc) * scale, (b.x * cc - c.x * bb) * scale};
}

/// Sibson's coordinates in the plane, not normalised: areas (of the figure of twice the
/// size, doubled).
template <class T>
[[nodiscard]] PerCorner<T> sibson_areas(const CavityShape& shape,
                                        std::span<const Pair<T>> corners) {
  PerCorner<Pair<T>> old_centers(shape.triangles.size());
  Pair<T>* const old_center = old_centers.data();
  for (std::size_t k = 0; k < shape.triangles.size(); ++k) {
    const auto& c = shape.triangles[k].corners;
    const Pair<T> a = corners[at(c[0])];
    old_center[k] =
        a + a + double_circumcenter(corners[at(c[1])] - a, corners[at(c[2])] - a);
  }
  PerCorner<Pair<T>> new_centers(shape.ring.size());
  Pair<T>* const new_center = new_centers.data();
  shape.for_each_side([&](std::size_t i, std::size_t j, std::size_t k) {
    new_center[k] = double_circumcenter(corners[i], corners[j]);
  });
  return stolen_areas<T, Pair<T>>(
      shape, corners.size(), {old_center, old_centers.size()},
      {new_center, new_centers.size()},
      [](const Pair<T>& a, const Pair<T>& b) { return cross(a, b); });
}

/// Laplace coordinates in the plane, not normalised: the length of the new cell's edge
/// over the distance, twice. Each half of an edge is a cotangent times half the distance.
template <class T>
[[nodiscard]] PerCorner<T> laplace_ratios(const CavityShape& shape,
                                          std::span<const Pair<T>> corners) {
  PerCorner<T> sums(corners.size(), T{});
  T* const ratio = sums.data();
  shape.for_each_side([&](std::size_t i, std::size_t j, std::size_t) {
    const Pair<T> side = corners[j] - corners[i];
    const T scale = per_area(cross(corners[i], corners[j]), dot(corners[i], corners[i]),
                             dot(corners[j], corners[j]));
    ratio[i] = ratio[i] + dot(corners[j], side) * scale;
    ratio[j] = ratio[j] - dot(corners[i], side) * scale;
  });
  return sums;
}

/// Divided by their sum, what rounding made negative as zero. Nothing if the sum is not a
/// number, or too small to divide by.
template <class T>
[[nodiscard]] PerCorner<T> normalized(PerCorner<T> parts) {
  T sum{};
  for (T& part : parts) {
    if (value_of(part) <= 0) part = T{};
    sum = sum + part;
  }
  constexpr double least = 0x1p-1000;  // whose inverse is a number
  if (!(value_of(sum) > least) ||
      !(value_of(sum) < std::numeric_limits<double>::infinity()))
    return {};
  const T scale = Constant<T>::of(1) / sum;
  for (T& part : parts) part = part * scale;
  return parts;
}

/// What Farin's surface needs of a natural neighbour: its weight, where it is as seen
/// from the query, its value and its gradient in the same axes.
template <class T>
struct BezierCorner {
  T weight;
  Pair<T> offset;
  T value;
  Pair<T> gradient;
};

/// The value of Farin's C1 surface: the cubic Bezier simplex over the coordinates u whose
/// ordinates at corners and beside them are those of the values z and gradients g, and
/// those of three different corners make it exact for quadratics.
///
/// b_iij = z_i + g_i . (x_j - x_i) / 3 and b_ijk = (the six of these) / 4 - (z_i + z_j +
/// z_k) / 6. The coordinates have linear precision, sum u_j (x_j - x_i) = -d_i with d_i =
/// x_i - q, so the sums over pairs and triples fall apart into sums over corners.
template <class T>
[[nodiscard]] T farin_value(std::span<const BezierCorner<T>> corners) {
  T squares{}, value{}, cubes{}, beside{}, pairs{}, slopes{}, triples{}, curved{};
  Pair<T> slope{}, center{};
  for (const BezierCorner<T>& c : corners) squares = squares + c.weight * c.weight;
  for (const BezierCorner<T>& c : corners) {
    const T u = c.weight, uu = u * u, rest = T{1} - u, z = c.value;
    const T rise = dot(c.gradient, c.offset) * T{1.0 / 3};
    value = value + u * z;
    cubes = cubes + uu * u * z;
    beside = beside + uu * (z * rest - rise);
    pairs = pairs + u * (z * rest - rise);
    slopes = slopes + u * rise;
    slope = slope + u * c.gradient;
    center = center + uu * c.offset;
    triples = triples + u * z * (rest * rest - squares + uu);
  }
  curved = value * squares - cubes + dot(slope, center) * T{1.0 / 3} - squares * slopes;
  return cubes + T{3} * beside + T{1.5} * (pairs - beside - curved) - T{0.5} * triples;
}

/// What farin_value takes from a corner: of its value, and of its gradient the product
/// with this.
struct FarinShare {
  double value = 0;
  Pair<double> gradient;
};

/// The derivatives of farin_value by values and gradients, which are not read.
[[nodiscard]] inline PerCorner<FarinShare> farin_shares(
    std::span<const BezierCorner<double>> corners) {
  double squares = 0;
  Pair<double> center{};
  for (const BezierCorner<double>& c : corners) {
    squares += c.weight * c.weight;
    center = center + (c.weight * c.weight) * c.offset;
  }
  PerCorner<FarinShare> shares;
  for (const BezierCorner<double>& c : corners) {
    const double u = c.weight, uu = u * u, rest = 1 - u;
    const double value = uu * u + 1.5 * u * (1 + u) * rest - 1.5 * u * (squares - uu) -
                         0.5 * u * (rest * rest - squares + uu);
    shares.push_back(
        {value, (0.5 * u * (squares - u - 1)) * c.offset - (0.5 * u) * center});
  }
  return shares;
}

}  // namespace delone::interp
