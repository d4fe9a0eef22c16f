#include "interp/blend_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "interp/blend_mix.hpp"
#include "interp/blend_samples.hpp"

namespace delone::interp {

namespace {

/// mix_degrees where the slope is known: the constant has no part.
template <std::size_t Size>
std::array<double, Size> mix_above_slope(const std::array<double, Size>& errors,
                                         double doubt) {
  std::array<double, Size - 1> above{};
  std::copy(errors.begin() + 1, errors.end(), above.begin());
  std::array<double, Size> parts{};
  if (!(above[0] > 0)) return parts;
  above = mix_degrees(above, doubt);
  std::copy(above.begin(), above.end(), parts.begin() + 1);
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

/// Linear terms of a polynomial that are known beforehand.
struct Slope {
  double u = 0, v = 0;
  bool is_known = false;
};

template <BlendSpace Space>
Slope slope_of(const std::optional<typename Space::Vector>& gradient,
               const typename Space::Axes& axes, double radius) {
  if (!gradient) return {};
  const LocalPosition<double> g = Space::local(axes, Space::position(*gradient), radius);
  return {g.u, g.v, true};
}

// Where the slope is known the fit is to what remains, without linear terms.
template <BlendSpace Space, int Degree>
BlendSamples<Degree> samples_of(const Space& space,
                                std::span<const typename Space::Point> points,
                                std::span<const double> site_values, Site site,
                                std::span<const StencilNode> stencil, double radius,
                                const typename Space::Axes& axes, const Slope& slope) {
  const auto center = space.vector(points[at(site)]);
  BlendSamples<Degree> samples;
  for (const StencilNode& n : stencil) {
    const auto d = Space::difference(space.vector(points[at(n.site)]), center);
    const double distance =
        std::max(std::sqrt(n.squared_distance) / radius, least_distance);
    const double ratio = (1 - distance) / distance;
    auto terms = model_terms<Degree>(Space::local(axes, Space::position(d), 1 / radius));
    double rise = site_values[at(n.site)] - site_values[at(site)];
    if (slope.is_known) {
      rise -= slope.u * terms[0] + slope.v * terms[1];
      terms[0] = terms[1] = 0;
    }
    samples.add(terms, rise, ratio * ratio, n.is_neighbor);
  }
  return samples;
}

}  // namespace

template <BlendSpace Space, int Degree>
BlendModel<Degree> fit_blend_model(
    const Space& space, std::span<const typename Space::Point> points,
    std::span<const double> site_values, Site site, std::span<const StencilNode> stencil,
    const BlendFitOptions& options,
    const std::optional<typename Space::Vector>& gradient) {
  BlendModel<Degree> model;
  model.value = site_values[at(site)];
  double squared_radius = 0;
  for (const StencilNode& n : stencil)
    squared_radius = std::max(squared_radius, n.squared_distance);
  const double radius = radius_factor<Degree> * std::sqrt(squared_radius);
  model.per_radius = 1 / radius;
  if (!(model.per_radius < std::numeric_limits<double>::max())) {
    model.per_radius = 0;
    return model;
  }
  const auto axes = Space::axes(space.vector(points[at(site)]));
  const Slope slope = slope_of<Space>(gradient, axes, radius);
  BlendSamples<Degree> samples = samples_of<Space, Degree>(
      space, points, site_values, site, stencil, radius, axes, slope);
  samples.factor();
  std::array<double, Degree + 1> errors = samples.errors();
  if (!(errors[0] > 0) && !slope.is_known) return model;
  // Two neighbours: their plane, which nothing can contradict.
  if (samples.size() == 2) errors[1] = 0;
  const std::array<double, Degree + 1> parts =
      slope.is_known ? mix_above_slope(errors, options.stiffness.doubt)
                     : mix_degrees(errors, options.stiffness.doubt);
  for (int degree = 1; degree <= Degree; ++degree) {
    const double part = parts[static_cast<std::size_t>(degree)];
    if (part < 1e-6) continue;
    const auto x = samples.solve(BlendSamples<Degree>::end_term(degree));
    for (std::size_t c = 0; c < x.size(); ++c) model.coefficients[c] += part * x[c];
  }
  if (slope.is_known) {
    model.coefficients[0] = slope.u;
    model.coefficients[1] = slope.v;
  }
  const double tension = options.stiffness.tension;
  model.tension = std::min(most_tension, tension + (1 - tension) * std::sqrt(parts[0]));
  set_bounds(model, site_values, stencil, options);
  return model;
}

template <BlendSpace Space, int Degree>
BlendModel<Degree> fit_blend_model(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, Site site, std::span<const StencilNode> stencil,
    const BlendFitOptions& options,
    const std::optional<typename Space::Vector>& gradient) {
  return fit_blend_model<Space, Degree>(space, triangulation.points(), site_values, site,
                                        stencil, options, gradient);
}

template BlendModel<3> fit_blend_model<PlaneSpace, 3>(
    const PlaneSpace&, const PlaneSpace::Triangulation&, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<tripack::Point2>&);
template BlendModel<4> fit_blend_model<PlaneSpace, 4>(
    const PlaneSpace&, const PlaneSpace::Triangulation&, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<tripack::Point2>&);
template BlendModel<3> fit_blend_model<SphereSpace, 3>(
    const SphereSpace&, const SphereSpace::Triangulation&, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&, const std::optional<Vector3>&);
template BlendModel<4> fit_blend_model<SphereSpace, 4>(
    const SphereSpace&, const SphereSpace::Triangulation&, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&, const std::optional<Vector3>&);
template BlendModel<3> fit_blend_model<PlaneSpace, 3>(
    const PlaneSpace&, std::span<const tripack::Point2>, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<tripack::Point2>&);
template BlendModel<4> fit_blend_model<PlaneSpace, 4>(
    const PlaneSpace&, std::span<const tripack::Point2>, std::span<const double>, Site,
    std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<tripack::Point2>&);
template BlendModel<3> fit_blend_model<SphereSpace, 3>(
    const SphereSpace&, std::span<const stripack::Direction>, std::span<const double>,
    Site, std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<Vector3>&);
template BlendModel<4> fit_blend_model<SphereSpace, 4>(
    const SphereSpace&, std::span<const stripack::Direction>, std::span<const double>,
    Site, std::span<const StencilNode>, const BlendFitOptions&,
    const std::optional<Vector3>&);

}  // namespace delone::interp
