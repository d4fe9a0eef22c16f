#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// How good the triangles of a triangulation are. All zero if there are none.
struct TriangleQuality {
  double shortest_edge = 0, longest_edge = 0;
  double smallest_angle_deg = 0;  ///< Theta, which a Delaunay triangulation makes largest
  double largest_angle_deg = 0;
  /// Radius of the inscribed circle over that of the circumscribed one: 1/2 for an
  /// equilateral triangle, 0 for a flat one.
  double smallest_aspect_ratio = 0, mean_aspect_ratio = 0;
};

using Position = std::array<double, 3>;

/// The angle at `at` between b and c, radians; accurate for small angles too (an arc
/// cosine is not).
[[nodiscard]] inline double corner_angle(const Position& at, const Position& b,
                                         const Position& c) {
  const Position u{b[0] - at[0], b[1] - at[1], b[2] - at[2]},
      v{c[0] - at[0], c[1] - at[1], c[2] - at[2]};
  const double cross = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                  u[0] * v[1] - u[1] * v[0]);
  return std::atan2(cross, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}

/// 4 sin(A/2) sin(B/2) sin(C/2)
[[nodiscard]] inline double aspect_ratio(const std::array<double, 3>& angles) noexcept {
  return 4 * std::sin(angles[0] / 2) * std::sin(angles[1] / 2) * std::sin(angles[2] / 2);
}

/// Over all triangles; `position(site)`, `length(site, site)`.
template <class PositionOf, class Length>
[[nodiscard]] TriangleQuality measure_triangles(const Adjacency& t, PositionOf position,
                                                Length length) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto num_triangles = static_cast<double>(t.num_triangles());
  if (num_triangles == 0) return {};
  TriangleQuality quality{infinity, 0, infinity, 0, infinity, 0};
  t.for_each_triangle([&](Arc arc) {
    const std::array<Site, 3> corner = t.left(arc);
    std::array<double, 3> angles{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Site a = corner[i], b = corner[(i + 1) % 3], c = corner[(i + 2) % 3];
      const double edge = length(a, b);
      quality.shortest_edge = std::min(quality.shortest_edge, edge);
      quality.longest_edge = std::max(quality.longest_edge, edge);
      angles[i] = corner_angle(position(a), position(b), position(c));
      const double degrees = angles[i] * 180 / std::numbers::pi;
      quality.smallest_angle_deg = std::min(quality.smallest_angle_deg, degrees);
      quality.largest_angle_deg = std::max(quality.largest_angle_deg, degrees);
    }
    const double ratio = aspect_ratio(angles);
    quality.smallest_aspect_ratio = std::min(quality.smallest_aspect_ratio, ratio);
    quality.mean_aspect_ratio += ratio / num_triangles;
  });
  return quality;
}

}  // namespace delone::delaunay
