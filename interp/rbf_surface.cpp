#include "interp/rbf_surface.hpp"

#include "interp/radial_method.hpp"

namespace delone::interp {

namespace {

template <class Domain>
using Surface = ScatterSurface<Domain, Radial<Domain>>;

template <class Domain>
Surface<Domain> make_surface(
    const std::shared_ptr<const typename Domain::Triangulation>& t,
    std::span<const double> row_values, const RadialOptions& radial,
    const SurfaceOptions& options, const RunOptions& run) {
  check(radial);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  const Domain domain(t->points());
  ScatterNodes<Domain::dimension> nodes{{}, values};
  nodes.points.reserve(values.size());
  for (const auto& p : t->points()) nodes.points.push_back(domain.position(p));
  return {t, domain, values, options,
          Radial<Domain>(domain, std::move(nodes), radial, run)};
}

}  // namespace

struct PlaneRadial::State {
  Surface<PlaneDomain> surface;
};
struct SphereRadial::State {
  Surface<SphereDomain> surface;
};

PlaneRadial::PlaneRadial(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const double> row_values, const RadialOptions& radial,
                         const SurfaceOptions& options, const RunOptions& run)
    : state_(std::make_shared<State>(State{
          make_surface<PlaneDomain>(triangulation, row_values, radial, options, run)})) {}

double PlaneRadial::value(tripack::Point2 p) const { return state_->surface.value(p); }

Gradient2 PlaneRadial::gradient(tripack::Point2 p) const {
  return state_->surface.gradient(p);
}

std::vector<double> PlaneRadial::values(std::span<const tripack::Point2> points,
                                        const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<Gradient2> PlaneRadial::gradients(std::span<const tripack::Point2> points,
                                              const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field PlaneRadial::grid(const Grid& grid, const RunOptions& run) const {
  return state_->surface.grid(grid, run);
}

SphereRadial::SphereRadial(std::shared_ptr<const stripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const RadialOptions& radial, const SurfaceOptions& options,
                           const RunOptions& run)
    : state_(std::make_shared<State>(State{make_surface<SphereDomain>(
          triangulation, row_values, radial, options, run)})) {}

double SphereRadial::value(const stripack::Direction& p) const {
  return state_->surface.value(p);
}

GradientSphere SphereRadial::gradient(const stripack::Direction& p) const {
  return state_->surface.gradient(p);
}

std::vector<double> SphereRadial::values(std::span<const stripack::Direction> points,
                                         const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<GradientSphere> SphereRadial::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field SphereRadial::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return state_->surface.grid(lonlat_grid, run);
}

}  // namespace delone::interp
