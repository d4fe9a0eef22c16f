#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

/// Short ways to make triangulations, values and comparisons.
namespace delone::support {

inline std::shared_ptr<const tripack::Triangulation> triangulated(
    const PlanePoints& points) {
  return std::make_shared<const tripack::Triangulation>(points);
}
inline std::shared_ptr<const stripack::Triangulation> triangulated(
    const SpherePoints& points) {
  return std::make_shared<const stripack::Triangulation>(points);
}

/// Points of a family: a third as many where next to every predicate takes exact
/// arithmetic, so that no test takes seconds.
template <class Family>
auto affordable(const Family& family, std::size_t n, std::uint64_t seed) {
  bool is_costly = false;
  for (const std::string_view name :
       {"tiny_components", "ulps_apart", "all_scales", "one_far_away"})
    is_costly |= name == family.name;
  return family.make(is_costly ? n / 3 : n, seed);
}

inline stripack::Direction at_lonlat(double lon_deg, double lat_deg) {
  return stripack::Direction::from(stripack::LonLat{lon_deg, lat_deg});
}

/// The region that covers the sites; no wider than the largest double.
inline interp::Region region_of(const tripack::Triangulation& t) {
  const interp::Region r = interp::covering_region(t);
  const double most = 0x1p1022;
  return {std::max(r.west, -most), std::min(r.east, most), std::max(r.south, -most),
          std::min(r.north, most)};
}

/// Points of the closed hull that codes lose: nodes, edge points as near as doubles come,
/// random ones.
inline PlanePoints points_of_the_hull(const tripack::Triangulation& t,
                                      std::uint64_t seed) {
  SplitMix64 random(seed);
  PlanePoints points(t.points().begin(), t.points().end());
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) {
      return t.points()[static_cast<std::size_t>(corners[k % 3])];
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const tripack::Point2 a = corner(k), b = corner(k + 1);
      points.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
      const double s = random.uniform(), u = random.uniform() * (1 - s);
      points.push_back({a.x + s * (b.x - a.x) + u * (corner(k + 2).x - a.x),
                        a.y + s * (b.y - a.y) + u * (corner(k + 2).y - a.y)});
    }
  });
  return points;
}

template <class Points, class F>
std::vector<double> sampled(const Points& points, F f) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const auto& p : points) values.push_back(f(p));
  return values;
}

inline std::vector<double> random_values(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<double> values(n);
  for (double& v : values) v = random.between(-1, 1);
  return values;
}

/// The same bits, every NaN counting as the same.
inline bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Index of the first difference; the common size if there is none.
inline std::size_t first_difference(std::span<const double> a,
                                    std::span<const double> b) {
  const auto pair = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), is_same);
  return static_cast<std::size_t>(pair.first - a.begin());
}

inline std::size_t count_missing(std::span<const double> values) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(),
                                                [](double v) { return std::isnan(v); }));
}

}  // namespace delone::support
