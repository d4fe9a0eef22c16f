#include "interp/smooth_surface.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "interp/east_north.hpp"
#include "interp/reach.hpp"
#include "interp/smooth_fit.hpp"

namespace delone::interp {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_finite(const std::array<double, 2>& g) {  // the smallest sets have others
  return std::isfinite(g[0]) && std::isfinite(g[1]);
}

Gradient2 gradient_along(Point2, const std::array<double, 2>& g) {
  return is_finite(g) ? Gradient2{g[0], g[1]} : Gradient2{unknown, unknown};
}
GradientSphere gradient_along(const Direction& p, const std::array<double, 2>& g) {
  if (!is_finite(g)) return {unknown, unknown};
  const SphereSpace::Axes axes = SphereSpace::axes(vector(p));
  return east_and_north(g[0] * axes.u + g[1] * axes.v, p);
}

template <class Triangulation>
SmoothData checked_data(const Triangulation& t, std::span<const double> row_values,
                        const SmoothOptions& options) {
  if constexpr (std::same_as<Triangulation, stripack::Triangulation>) {
    if (options.outside == Outside::linear) {
      throw Error(
          "there is no linear continuation on the sphere; take nearest or missing");
    }
  }
  return smooth_data(t.sites(), t.num_sites(), row_values, options);
}

/// One a row from one a site.
template <class T>
std::vector<T> spread(std::span<const Site> sites, const std::vector<T>& of_sites) {
  std::vector<T> result;
  result.reserve(sites.size());
  for (const Site s : sites) result.push_back(of_sites[at(s)]);
  return result;
}

C1Options c1_options(const SmoothOptions& options) {
  C1Options result;
  static_cast<SurfaceOptions&>(result) = options;
  result.duplicates = Duplicates::first;
  if (options.choices) {
    result.choices = options.choices;
    return result;
  }
  result.gradients = Gradients::local;
  result.tension = 0;
  return result;
}

/// What both surfaces hold.
template <BlendSpace Space, class Surface, class Gradient>
struct SmoothState {
  std::vector<double> smoothed;
  SmoothFit fit;
  Surface surface;

  SmoothState(const std::shared_ptr<const typename Space::Triangulation>& t,
              std::span<const double> row_values, const SmoothOptions& options,
              const RunOptions& run)
      : SmoothState(
            t, options, run,
            fit_smooth<Space>(*t, checked_data(*t, row_values, options), options, run)) {}

 private:
  SmoothState(const std::shared_ptr<const typename Space::Triangulation>& t,
              const SmoothOptions& options, const RunOptions& run,
              const SmoothedSites& sites)
      : smoothed(spread(t->sites(), sites.values)),
        fit(sites.fit),
        surface(t, smoothed, gradients(*t, sites), c1_options(options),
                RunOptions{run.num_threads, {}}) {}

  static std::vector<Gradient> gradients(const typename Space::Triangulation& t,
                                         const SmoothedSites& sites) {
    std::vector<Gradient> of_sites;
    for (std::size_t s = 0; s < sites.gradients.size(); ++s)
      of_sites.push_back(gradient_along(t.points()[s], sites.gradients[s]));
    return spread(t.sites(), of_sites);
  }
};

}  // namespace

struct PlaneSmooth::State : SmoothState<PlaneSpace, PlaneC1, Gradient2> {
  using SmoothState::SmoothState;
};
struct SphereSmooth::State : SmoothState<SphereSpace, SphereC1, GradientSphere> {
  using SmoothState::SmoothState;
};

PlaneSmooth::PlaneSmooth(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const double> row_values, const SmoothOptions& options,
                         const RunOptions& run)
    : state_(std::make_shared<const State>(triangulation, row_values, options, run)) {}

const SmoothFit& PlaneSmooth::fit() const noexcept { return state_->fit; }
const std::vector<double>& PlaneSmooth::smoothed_values() const noexcept {
  return state_->smoothed;
}
double PlaneSmooth::value(tripack::Point2 p) const { return state_->surface.value(p); }
Gradient2 PlaneSmooth::gradient(tripack::Point2 p) const {
  return state_->surface.gradient(p);
}
Derivatives2 PlaneSmooth::derivatives(tripack::Point2 p) const {
  return state_->surface.derivatives(p);
}
std::vector<double> PlaneSmooth::values(std::span<const tripack::Point2> points,
                                        const RunOptions& run) const {
  return state_->surface.values(points, run);
}
std::vector<Gradient2> PlaneSmooth::gradients(std::span<const tripack::Point2> points,
                                              const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}
std::vector<Derivatives2> PlaneSmooth::derivatives(
    std::span<const tripack::Point2> points, const RunOptions& run) const {
  return state_->surface.derivatives(points, run);
}
Field PlaneSmooth::grid(const Grid& grid, const RunOptions& run) const {
  return state_->surface.grid(grid, run);
}

SphereSmooth::SphereSmooth(std::shared_ptr<const stripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const SmoothOptions& options, const RunOptions& run)
    : state_(std::make_shared<const State>(triangulation, row_values, options, run)) {}

const SmoothFit& SphereSmooth::fit() const noexcept { return state_->fit; }
const std::vector<double>& SphereSmooth::smoothed_values() const noexcept {
  return state_->smoothed;
}
double SphereSmooth::value(const stripack::Direction& p) const {
  return state_->surface.value(p);
}
GradientSphere SphereSmooth::gradient(const stripack::Direction& p) const {
  return state_->surface.gradient(p);
}
DerivativesSphere SphereSmooth::derivatives(const stripack::Direction& p) const {
  return state_->surface.derivatives(p);
}
std::vector<double> SphereSmooth::values(std::span<const stripack::Direction> points,
                                         const RunOptions& run) const {
  return state_->surface.values(points, run);
}
std::vector<GradientSphere> SphereSmooth::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}
std::vector<DerivativesSphere> SphereSmooth::derivatives(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.derivatives(points, run);
}
Field SphereSmooth::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return state_->surface.grid(lonlat_grid, run);
}

}  // namespace delone::interp
