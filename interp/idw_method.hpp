#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/idw_surface.hpp"
#include "interp/scatter_surface.hpp"
#include "stripack/neighbor_search.hpp"
#include "tripack/neighbor_search.hpp"

namespace delone::interp {

using delaunay::Neighbor;

/// Throws Error for options out of range.
inline void check(const InverseDistanceOptions& o) {
  if (!(o.power > 0 && o.power <= 64)) {
    throw Error("the power of inverse distances is " + std::to_string(o.power) +
                "; take one above 0 and at most 64");
  }
  if (o.neighbors < 1) {
    throw Error("the number of neighbours is " + std::to_string(o.neighbors) +
                "; take at least 1");
  }
  if (!(o.radius > 0)) throw Error("the radius must be above 0");
}

template <Number T>
T distance_of(const PlaneDomain&, const std::array<T, 2>& p,
              const std::array<double, 2>& node) {
  using std::sqrt;
  return sqrt(squared_length(difference(p, node)));
}

// The angle. Beyond 90 degrees from the distance to the antipode, for arcsines lose their
// digits near 1.
template <Number T>
T distance_of(const SphereDomain&, const std::array<T, 3>& p,
              const std::array<double, 3>& node) {
  using std::asin, std::sqrt;
  const T chord = sqrt(squared_length(difference(p, node)));
  if (value_of(chord) < 1.5) return 2.0 * asin(0.5 * chord);
  const T rest = sqrt(squared_length(difference(p, {-node[0], -node[1], -node[2]})));
  return std::numbers::pi - 2.0 * asin(0.5 * rest);
}

inline double scaled_radius(const PlaneDomain& domain, double radius) {
  return radius * domain.scale();
}
inline double scaled_radius(const SphereDomain&, double radius_km) {
  return radius_km / stripack::earth_radius_km;
}
inline double searched_radius(const PlaneDomain&, double radius) { return radius; }
inline double searched_radius(const SphereDomain& domain, double radius_km) {
  return scaled_radius(domain, radius_km);
}

template <Number T>
T power_of(const T& base, double power) {
  using std::pow;
  if (power == 2) return base * base;
  return power == 1 ? base : pow(base, power);
}

/// A mean of the values of near sites (a Method of ScatterSurface).
template <class Domain>
class InverseDistance {
 public:
  using Triangulation = typename Domain::Triangulation;
  using Point = typename Domain::Point;
  static constexpr std::size_t dimension = Domain::dimension;

  InverseDistance(std::shared_ptr<const Triangulation> triangulation, Domain domain,
                  std::vector<double> site_values, const InverseDistanceOptions& options)
      : triangulation_(std::move(triangulation)),
        domain_(std::move(domain)),
        values_(std::move(site_values)),
        options_(options) {}

  [[nodiscard]] static bool is_exact() noexcept { return true; }

  template <Number T>
  [[nodiscard]] T evaluate(const Point& p, Cursor& cursor) const {
    const delaunay::Node hint = triangulation_->rows()[at(cursor.site)];
    const std::vector<Neighbor> near = neighbors(p, hint, 0);
    if (near.empty()) return T(std::numeric_limits<double>::quiet_NaN());
    cursor.site = triangulation_->sites()[at(near[0].row)];
    return mean(near, variables<T>(domain_.position(p)));
  }

  /// What the method over all other sites says at a site.
  [[nodiscard]] double without(Site s) const {
    const Point& p = triangulation_->points()[at(s)];
    const delaunay::Node row = triangulation_->rows()[at(s)];
    std::vector<Neighbor> near = neighbors(p, row, 1);
    std::erase_if(near, [row](const Neighbor& n) { return n.row == row; });
    if (near.empty()) return std::numeric_limits<double>::quiet_NaN();
    return mean(near, variables<double>(domain_.position(p)));
  }

 private:
  [[nodiscard]] bool has_radius() const noexcept {
    return std::isfinite(options_.radius);
  }

  // Those that have a say, the next one, and `num_more`.
  [[nodiscard]] std::vector<Neighbor> neighbors(const Point& p, delaunay::Node hint,
                                                std::int32_t num_more) const {
    if (has_radius()) {
      return nodes_within(*triangulation_, p, searched_radius(domain_, options_.radius),
                          hint);
    }
    const std::int32_t most = triangulation_->num_sites() - 1 - num_more;
    return nearest_k(*triangulation_, p,
                     std::min(options_.neighbors, most) + 1 + num_more, hint);
  }

  template <Number T>
  [[nodiscard]] T distance(const Neighbor& n, const std::array<T, dimension>& p) const {
    const Site s = triangulation_->sites()[at(n.row)];
    return distance_of(domain_, p, domain_.position(triangulation_->points()[at(s)]));
  }
  [[nodiscard]] double value(const Neighbor& n) const {
    return values_[at(triangulation_->sites()[at(n.row)])];
  }

  // Where all that has a say ends.
  template <Number T>
  [[nodiscard]] T limit(std::span<const Neighbor> near,
                        const std::array<T, dimension>& p) const {
    if (has_radius()) return T(scaled_radius(domain_, options_.radius));
    const bool has_next = near.size() > at(options_.neighbors);
    return has_next ? distance(near.back(), p)
                    : T(std::numeric_limits<double>::infinity());
  }

  template <Number T>
  [[nodiscard]] T mean(std::span<const Neighbor> near,
                       const std::array<T, dimension>& p) const {
    const T first = distance(near[0], p), end = limit(near, p);
    if (value_of(first) == 0) return T(value(near[0]));
    if (!(value_of(first) < value_of(end))) return T(plain_mean(near));
    const double origin = value(near[0]);
    T weights = 1.0, sum = 0.0;
    double low = origin, high = origin;
    for (const Neighbor& n : near.subspan(1)) {
      const T w = weight(distance(n, p), first, end);
      if (!(value_of(w) > 0)) continue;
      weights += w;
      sum += w * (value(n) - origin);
      low = std::min(low, value(n)), high = std::max(high, value(n));
    }
    const T result = sum / weights + origin;
    return with_value(result, std::clamp(value_of(result), low, high));
  }

  // Relative to that of the nearest node, so that nothing overflows.
  template <Number T>
  [[nodiscard]] T weight(const T& d, const T& first, const T& end) const {
    if (!(value_of(d) < value_of(end))) return T(0.0);
    // The exact order and the rounded distances may differ.
    const T near = value_of(d) > value_of(first) ? first / d : T(1.0);
    if (std::isinf(value_of(end))) return power_of(near, options_.power);
    return power_of(near * ((end - d) / (end - first)), options_.power);
  }

  [[nodiscard]] double plain_mean(std::span<const Neighbor> near) const {
    const double origin = value(near[0]);
    double sum = 0;
    for (const Neighbor& n : near) sum += value(n) - origin;
    return origin + sum / static_cast<double>(near.size());
  }

  std::shared_ptr<const Triangulation> triangulation_;
  Domain domain_;
  std::vector<double> values_;
  InverseDistanceOptions options_;
};

}  // namespace delone::interp
