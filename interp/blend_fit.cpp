#include "interp/blend_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "interp/blend_samples.hpp"

namespace delone::interp {

namespace {

constexpr double radius_factor = 1.05;
constexpr double least_distance = 0.001;  // of the radius, for weights
constexpr double most_tension = 0.98;

// The degrees below which a mix prefers the higher and above which the lower one, by the
// part of the neighbours' rises that is not predicted.
constexpr double smooth = 0.05, rough = 0.15;
constexpr double trust_in_smooth = 3;

/// Parts of the degrees in the mix, summing to one.
template <std::size_t Size>
std::array<double, Size> mix(std::array<double, Size> errors, double doubt) {
  const double total = errors[0], best = *std::min_element(errors.begin(), errors.end());
  const double unpredicted = std::sqrt(best / total);
  const double roughness =
      std::clamp((unpredicted - smooth) / (rough - smooth), 0.0, 1.0);
  const double handicap = roughness * (doubt + trust_in_smooth) - trust_in_smooth;
  for (std::size_t d = 0; d < Size; ++d)
    errors[d] *= std::exp(handicap * static_cast<double>(d));
  const double least = *std::min_element(errors.begin(), errors.end());
  std::array<double, Size> parts{};
  double sum = 0;
  for (std::size_t d = 0; d < Size; ++d) {
    const double ratio = errors[d] > least ? least / errors[d] : 1;
    parts[d] = ratio * std::sqrt(ratio);
    sum += parts[d];
  }
  for (double& part : parts) part /= sum;
  return parts;
}

/// The values that a node's polynomial may take: those of its stencil widened by half
/// their range, but never far beyond the data; or those of its neighbours.
template <int Degree>
void set_bounds(BlendModel<Degree>& model, std::span<const double> site_values,
                std::span<const StencilNode> stencil, const BlendFitOptions& options) {
  constexpr double stencil_part = 0.5, range_part = 0.15;
  const bool is_local = options.bounds == Bounds::local;
  double least = model.value, most = model.value;
  for (const StencilNode& n : stencil) {
    if (is_local && !n.is_neighbor) continue;
    least = std::min(least, site_values[at(n.site)]);
    most = std::max(most, site_values[at(n.site)]);
  }
  if (!is_local) {
    const double wider = stencil_part * (most - least),
                 widest = range_part * (options.range.most - options.range.least);
    least = std::max(least - wider, options.range.least - widest);
    most = std::min(most + wider, options.range.most + widest);
  }
  model.least = std::min(0.0, least - model.value);
  model.most = std::max(0.0, most - model.value);
  if (model.least == 0 || model.most == 0) model.coefficients.fill(0);
}

template <BlendSpace Space, int Degree>
BlendSamples<Degree> samples_of(const Space& space,
                                const typename Space::Triangulation& triangulation,
                                std::span<const double> site_values, Site site,
                                std::span<const StencilNode> stencil, double radius) {
  const auto center = space.vector(triangulation.points()[at(site)]);
  const auto axes = Space::axes(center);
  BlendSamples<Degree> samples;
  for (const StencilNode& n : stencil) {
    const auto d =
        Space::difference(space.vector(triangulation.points()[at(n.site)]), center);
    const double distance =
        std::max(std::sqrt(n.squared_distance) / radius, least_distance);
    const double ratio = (1 - distance) / distance;
    samples.add(model_terms<Degree>(Space::local(axes, Space::position(d), 1 / radius)),
                site_values[at(n.site)] - site_values[at(site)], ratio * ratio,
                n.is_neighbor);
  }
  return samples;
}

}  // namespace

Stiffness stiffness_level(std::size_t level) noexcept {
  constexpr std::array<Stiffness, num_stiffness_levels> levels{
      Stiffness{0.1, 0}, Stiffness{-0.3, 0.4}, Stiffness{0.1, 0.6}, Stiffness{0.3, 0.8},
      Stiffness{0.8, 0.97}};
  return levels[std::min(level, num_stiffness_levels - 1)];
}

template <BlendSpace Space, int Degree>
BlendModel<Degree> fit_blend_model(const Space& space,
                                   const typename Space::Triangulation& triangulation,
                                   std::span<const double> site_values, Site site,
                                   std::span<const StencilNode> stencil,
                                   const BlendFitOptions& options) {
  BlendModel<Degree> model;
  model.value = site_values[at(site)];
  double squared_radius = 0;
  for (const StencilNode& n : stencil)
    squared_radius = std::max(squared_radius, n.squared_distance);
  const double radius = radius_factor * std::sqrt(squared_radius);
  model.per_radius = 1 / radius;
  if (!(model.per_radius < std::numeric_limits<double>::max())) {
    model.per_radius = 0;
    return model;
  }
  BlendSamples<Degree> samples =
      samples_of<Space, Degree>(space, triangulation, site_values, site, stencil, radius);
  samples.factor();
  std::array<double, Degree + 1> errors = samples.errors();
  if (!(errors[0] > 0)) return model;
  // Two neighbours: their plane, which nothing can contradict.
  if (samples.size() == 2) errors[1] = 0;
  const std::array<double, Degree + 1> parts = mix(errors, options.stiffness.doubt);
  for (int degree = 1; degree <= Degree; ++degree) {
    const double part = parts[static_cast<std::size_t>(degree)];
    if (part < 1e-6) continue;
    const auto x = samples.solve(BlendSamples<Degree>::end_term(degree));
    for (std::size_t c = 0; c < x.size(); ++c) model.coefficients[c] += part * x[c];
  }
  const double tension = options.stiffness.tension;
  model.tension = std::min(most_tension, tension + (1 - tension) * std::sqrt(parts[0]));
  set_bounds(model, site_values, stencil, options);
  return model;
}

template BlendModel<3> fit_blend_model<PlaneSpace, 3>(const PlaneSpace&,
                                                      const tripack::Triangulation&,
                                                      std::span<const double>, Site,
                                                      std::span<const StencilNode>,
                                                      const BlendFitOptions&);
template BlendModel<4> fit_blend_model<PlaneSpace, 4>(const PlaneSpace&,
                                                      const tripack::Triangulation&,
                                                      std::span<const double>, Site,
                                                      std::span<const StencilNode>,
                                                      const BlendFitOptions&);
template BlendModel<3> fit_blend_model<SphereSpace, 3>(const SphereSpace&,
                                                       const stripack::Triangulation&,
                                                       std::span<const double>, Site,
                                                       std::span<const StencilNode>,
                                                       const BlendFitOptions&);
template BlendModel<4> fit_blend_model<SphereSpace, 4>(const SphereSpace&,
                                                       const stripack::Triangulation&,
                                                       std::span<const double>, Site,
                                                       std::span<const StencilNode>,
                                                       const BlendFitOptions&);

}  // namespace delone::interp
