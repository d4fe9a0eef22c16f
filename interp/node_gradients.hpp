#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/blend_space.hpp"
#include "interp/index.hpp"
#include "interp/linear_surface.hpp"
#include "interp/spot.hpp"
#include "interp/values.hpp"

namespace delone::interp {

/// A tangent vector by scaled length.
[[nodiscard]] inline tripack::Point2 scaled_gradient(const tripack::Triangulation&,
                                                     double scale, Site,
                                                     const Gradient2& g) {
  return {g.x / scale, g.y / scale};
}
[[nodiscard]] inline Vector3 scaled_gradient(const stripack::Triangulation& t, double,
                                             Site s, const GradientSphere& g) {
  const stripack::Direction& p = t.points()[at(s)];
  const Vector3 east = east_at(p);
  return g.east * east + g.north * cross(vector(p), east);
}

// Vectors of plane and space in the same words.

[[nodiscard]] inline bool is_usable(tripack::Point2 g) noexcept {
  return std::isfinite(g.x) && std::isfinite(g.y);
}
[[nodiscard]] inline bool is_usable(Vector3 g) noexcept {
  return std::isfinite(dot(g, g));
}
[[nodiscard]] inline tripack::Point2 sum_of(tripack::Point2 a,
                                            tripack::Point2 b) noexcept {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Vector3 sum_of(Vector3 a, Vector3 b) noexcept { return a + b; }
[[nodiscard]] inline tripack::Point2 part_of(tripack::Point2 a, double part) noexcept {
  return {part * a.x, part * a.y};
}
[[nodiscard]] inline Vector3 part_of(Vector3 a, double part) noexcept { return part * a; }

namespace detail {

[[nodiscard]] inline std::array<double, 2> parts(const Gradient2& g) {
  return {g.x, g.y};
}
[[nodiscard]] inline std::array<double, 2> parts(const GradientSphere& g) {
  return {g.east, g.north};
}

inline void check_gradients(std::size_t num_rows, std::size_t num_gradients) {
  if (num_rows == num_gradients) return;
  throw Error("there are " + std::to_string(num_gradients) + " gradients for " +
              std::to_string(num_rows) + " points; give one gradient a point");
}

}  // namespace detail

/// Of every site the mean of its rows' gradients; NaN where none is known. Throws Error
/// for another number of gradients than of rows, and for infinite ones, naming the row.
template <BlendSpace Space, class Gradient>
[[nodiscard]] std::vector<typename Space::Vector> gradients_at_sites(
    const typename Space::Triangulation& t, double scale,
    std::span<const Gradient> row_gradients) {
  detail::check_gradients(t.sites().size(), row_gradients.size());
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto parts_of = [&](delaunay::Node row) {
    return detail::parts(row_gradients[at(row)]);
  };
  const auto is_unknown = [&](delaunay::Node row) {
    return std::ranges::any_of(parts_of(row), [](double a) { return std::isnan(a); });
  };
  const RowsOfSites rows = rows_of_sites(t.sites(), t.num_sites());
  std::vector<typename Space::Vector> result(at(t.num_sites()));
  for (Site s = 0; s < t.num_sites(); ++s) {
    typename Space::Vector sum{};
    int count = 0;
    // Summed in an order that is not that of the rows.
    std::vector<delaunay::Node> known(rows.of(s).begin(), rows.of(s).end());
    std::erase_if(known, is_unknown);
    std::ranges::sort(known, {}, parts_of);
    for (const delaunay::Node row : known) {
      const auto g = scaled_gradient(t, scale, s, row_gradients[at(row)]);
      if (!is_usable(g)) {
        throw Error("row " + std::to_string(row) +
                        ": the gradient is not a finite number; give NaN where it is "
                        "not known",
                    {row});
      }
      sum = sum_of(sum, g);
      ++count;
    }
    result[at(s)] = part_of(sum, count == 0 ? unknown : 1.0 / count);
  }
  return result;
}

}  // namespace delone::interp
