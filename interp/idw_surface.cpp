#include "interp/idw_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/scatter_surface.hpp"
#include "stripack/neighbor_search.hpp"
#include "tripack/neighbor_search.hpp"

namespace delone::interp {

namespace {

using delaunay::Neighbor;

void check(const InverseDistanceOptions& o) {
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

double scaled_radius(const PlaneDomain& domain, double radius) {
  return radius * domain.scale();
}
double scaled_radius(const SphereDomain&, double radius_km) {
  return radius_km / stripack::earth_radius_km;
}
double searched_radius(const PlaneDomain&, double radius) { return radius; }
double searched_radius(const SphereDomain& domain, double radius_km) {
  return scaled_radius(domain, radius_km);
}

template <Number T>
T power_of(const T& base, double power) {
  using std::pow;
  if (power == 2) return base * base;
  return power == 1 ? base : pow(base, power);
}

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
    const std::vector<Neighbor> near = neighbors(p, cursor);
    if (near.empty()) return T(std::numeric_limits<double>::quiet_NaN());
    cursor.site = triangulation_->sites()[at(near[0].row)];
    return mean(near, variables<T>(domain_.position(p)));
  }

 private:
  [[nodiscard]] bool has_radius() const noexcept {
    return std::isfinite(options_.radius);
  }

  [[nodiscard]] std::vector<Neighbor> neighbors(const Point& p,
                                                const Cursor& cursor) const {
    const delaunay::Node hint = triangulation_->rows()[at(cursor.site)];
    if (has_radius()) {
      return nodes_within(*triangulation_, p, searched_radius(domain_, options_.radius),
                          hint);
    }
    const auto most = std::min(options_.neighbors, triangulation_->num_sites() - 1);
    return nearest_k(*triangulation_, p, most + 1, hint);
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

template <class Domain>
using Surface = ScatterSurface<Domain, InverseDistance<Domain>>;

template <class Domain>
Surface<Domain> make_surface(
    const std::shared_ptr<const typename Domain::Triangulation>& t,
    std::span<const double> row_values, const InverseDistanceOptions& weights,
    const SurfaceOptions& options) {
  check(weights);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  const Domain domain(t->points());
  return {t, domain, values, options,
          InverseDistance<Domain>(t, domain, values, weights)};
}

}  // namespace

struct PlaneInverseDistance::State {
  Surface<PlaneDomain> surface;
};
struct SphereInverseDistance::State {
  Surface<SphereDomain> surface;
};

PlaneInverseDistance::PlaneInverseDistance(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights,
    const SurfaceOptions& options)
    : state_(std::make_shared<State>(State{
          make_surface<PlaneDomain>(triangulation, row_values, weights, options)})) {}

double PlaneInverseDistance::value(tripack::Point2 p) const {
  return state_->surface.value(p);
}

Gradient2 PlaneInverseDistance::gradient(tripack::Point2 p) const {
  return state_->surface.gradient(p);
}

std::vector<double> PlaneInverseDistance::values(std::span<const tripack::Point2> points,
                                                 const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<Gradient2> PlaneInverseDistance::gradients(
    std::span<const tripack::Point2> points, const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field PlaneInverseDistance::grid(const Grid& grid, const RunOptions& run) const {
  return state_->surface.grid(grid, run);
}

SphereInverseDistance::SphereInverseDistance(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights,
    const SurfaceOptions& options)
    : state_(std::make_shared<State>(State{
          make_surface<SphereDomain>(triangulation, row_values, weights, options)})) {}

double SphereInverseDistance::value(const stripack::Direction& p) const {
  return state_->surface.value(p);
}

GradientSphere SphereInverseDistance::gradient(const stripack::Direction& p) const {
  return state_->surface.gradient(p);
}

std::vector<double> SphereInverseDistance::values(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<GradientSphere> SphereInverseDistance::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field SphereInverseDistance::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return state_->surface.grid(lonlat_grid, run);
}

}  // namespace delone::interp
