#include "interp/idw_surface.hpp"

#include "interp/idw_method.hpp"

namespace delone::interp {

namespace {

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
