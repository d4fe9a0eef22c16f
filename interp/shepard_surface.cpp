#include "interp/shepard_surface.hpp"

#include "interp/shepard_method.hpp"

namespace delone::interp {

namespace {

template <class Domain>
using Surface = ScatterSurface<Domain, Shepard<Domain>>;

template <class Domain>
Surface<Domain> make_surface(
    const std::shared_ptr<const typename Domain::Triangulation>& t,
    std::span<const double> row_values, const ShepardOptions& shepard,
    const SurfaceOptions& options, const RunOptions& run) {
  const ShepardCounts counts = shepard_counts(shepard);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  const Domain domain(t->points());
  ScatterNodes<Domain::dimension> nodes{{}, values};
  nodes.points.reserve(values.size());
  for (const auto& p : t->points()) nodes.points.push_back(domain.position(p));
  return {t, domain, values, options,
          Shepard<Domain>(domain, std::move(nodes), counts, run)};
}

}  // namespace

struct PlaneShepard::State {
  Surface<PlaneDomain> surface;
};
struct SphereShepard::State {
  Surface<SphereDomain> surface;
};

PlaneShepard::PlaneShepard(std::shared_ptr<const tripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const ShepardOptions& shepard, const SurfaceOptions& options,
                           const RunOptions& run)
    : state_(std::make_shared<State>(State{make_surface<PlaneDomain>(
          triangulation, row_values, shepard, options, run)})) {}

double PlaneShepard::value(tripack::Point2 p) const { return state_->surface.value(p); }

Gradient2 PlaneShepard::gradient(tripack::Point2 p) const {
  return state_->surface.gradient(p);
}

std::vector<double> PlaneShepard::values(std::span<const tripack::Point2> points,
                                         const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<Gradient2> PlaneShepard::gradients(std::span<const tripack::Point2> points,
                                               const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field PlaneShepard::grid(const Grid& grid, const RunOptions& run) const {
  return state_->surface.grid(grid, run);
}

SphereShepard::SphereShepard(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const ShepardOptions& shepard, const SurfaceOptions& options,
                             const RunOptions& run)
    : state_(std::make_shared<State>(State{make_surface<SphereDomain>(
          triangulation, row_values, shepard, options, run)})) {}

double SphereShepard::value(const stripack::Direction& p) const {
  return state_->surface.value(p);
}

GradientSphere SphereShepard::gradient(const stripack::Direction& p) const {
  return state_->surface.gradient(p);
}

std::vector<double> SphereShepard::values(std::span<const stripack::Direction> points,
                                          const RunOptions& run) const {
  return state_->surface.values(points, run);
}

std::vector<GradientSphere> SphereShepard::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return state_->surface.gradients(points, run);
}

Field SphereShepard::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return state_->surface.grid(lonlat_grid, run);
}

}  // namespace delone::interp
