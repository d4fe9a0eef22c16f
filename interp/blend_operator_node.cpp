#include "interp/blend_operator_node.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/blend_fit.hpp"
#include "interp/blend_mix.hpp"
#include "interp/blend_operator_surroundings.hpp"
#include "interp/blend_operator_temper.hpp"
#include "interp/c1_surface.hpp"
#include "interp/plane_cells.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

// Exponents of the weights of samples: softer ones than those of the surface that adapts
// to values, which let the nearest nodes decide, amplify values a third as much.
constexpr std::array soft_nearness{1.0, 0.5, 0.25};
constexpr double usual_nearness = 2;

constexpr MagnitudeLimits soft_limits{12, 24, 256}, usual_limits{200, 400, 1024};

/// Less of a degree is left out of a polynomial, as by fit_blend_model.
constexpr double least_part = 1e-6;
/// Terms that others span up to less than this are not determined.
constexpr double least_independence = 1e-7;

[[nodiscard]] bool is_known(Gradients gradients) noexcept {
  return gradients == Gradients::global || gradients == Gradients::given;
}

/// How much a degree may count, 0 .. 1.
template <BlendSpace Space, int Degree>
double trust_in(const BlendSurroundings<Space, Degree>& around, int degree,
                const MagnitudeLimits& limits) {
  const int first = around.is_slope_known() ? 2 : 1;
  if (degree < first) return 1;
  if (around.per_radius() == 0 ||
      around.samples().size() < BlendSamples<Degree>::end_term(degree))
    return 0;
  for (int d = first; d <= degree; ++d)
    if (!(around.samples().independence(d) >= least_independence)) return 0;
  const double magnitude = around.magnitude(degree, limits);
  if (!(magnitude < limits.most)) return 0;
  return std::min(1.0, (limits.most - magnitude) / (limits.most - limits.full));
}

/// The parts of degrees that are wanted, as far as they can be trusted; what is left goes
/// to the next lower one.
template <BlendSpace Space, int Degree>
C1NodeChoice trusted(const BlendSurroundings<Space, Degree>& around,
                     const std::array<double, Degree + 1>& wanted,
                     const MagnitudeLimits& limits, double least_tension) {
  C1NodeChoice choice;
  choice.nearness = around.nearness();
  double left = 0;
  for (int degree = Degree; degree >= 1; --degree) {
    const auto d = static_cast<std::size_t>(degree);
    const double whole = wanted[d] + left;
    // What is left out of the polynomial need not be trusted.
    choice.parts[d] =
        whole < least_part ? whole : whole * trust_in(around, degree, limits);
    left = whole - choice.parts[d];
  }
  choice.parts[0] = wanted[0] + left;
  choice.tension = tension_of(choice.parts[0], least_tension);
  return choice;
}

/// What fit_blend_model would mix for the values.
template <int Degree>
std::array<double, Degree + 1> wanted_by_values(const BlendSamples<Degree>& samples,
                                                double doubt) {
  std::array<double, Degree + 1> errors = samples.errors();
  if (!(errors[0] > 0)) return {1};
  if (samples.size() == 2) errors[1] = 0;
  return mix_degrees(errors, doubt);
}

[[nodiscard]] Gradients known_or_local(Gradients gradients) noexcept {
  return is_known(gradients) ? gradients : Gradients::local;
}

/// `choose(site, stencil)` for every site.
template <BlendSpace Space, int Degree, class Choose>
std::vector<C1NodeChoice> for_all_nodes(const Space& space,
                                        const typename Space::Triangulation& t,
                                        const RunOptions& run, Choose choose) {
  constexpr std::int64_t chunk = 512;
  std::vector<C1NodeChoice> result(at(t.num_sites()));
  if (t.dimension() < 2) return result;
  delaunay::parallel_chunks(
      t.num_sites(), chunk, run, [&](std::int64_t first, std::int64_t last) {
        StencilGatherer<Space> gatherer(space, t);
        for (auto s = static_cast<Site>(first); s < last; ++s)
          result[at(s)] = choose(s, gatherer.around(s, num_nearest(Degree)));
      });
  return result;
}

template <BlendSpace Space, int Degree>
std::vector<C1NodeChoice> from_geometry(const Space& space,
                                        const typename Space::Triangulation& t,
                                        const C1Options& options, const RunOptions& run) {
  const double tension = options.tension.value_or(0);
  std::array<double, Degree + 1> wanted{};
  wanted.back() = 1;
  const GradientSamples<Space> samples(space, t, options.gradients, run);
  return for_all_nodes<Space, Degree>(
      space, t, run, [&](Site s, std::span<const StencilNode> stencil) {
        C1NodeChoice best;
        for (const double nearness : soft_nearness) {
          const BlendSurroundings<Space, Degree> around(
              space, t, s, stencil, nearness, known_or_local(options.gradients));
          const C1NodeChoice choice = samples.tempered(
              around, s, stencil, trusted(around, wanted, soft_limits, tension), tension);
          if (nearness == soft_nearness.front() ||
              choice.parts[Degree] > best.parts[Degree])
            best = choice;
          if (best.parts[Degree] == 1) break;
        }
        return best;
      });
}

template <BlendSpace Space, int Degree>
std::vector<C1NodeChoice> from_values(const Space& space,
                                      const typename Space::Triangulation& t,
                                      std::span<const double> site_values,
                                      const Stiffness& stiffness, const RunOptions& run) {
  return for_all_nodes<Space, Degree>(
      space, t, run, [&](Site s, std::span<const StencilNode> stencil) {
        const BlendSurroundings<Space, Degree> around(
            space, t, s, stencil, usual_nearness, Gradients::local, site_values);
        if (around.per_radius() == 0) return C1NodeChoice{};
        return trusted(around, wanted_by_values(around.samples(), stiffness.doubt),
                       usual_limits, stiffness.tension);
      });
}

template <BlendSpace Space>
std::shared_ptr<const C1Choices> all_choices(const Space& space,
                                             const typename Space::Triangulation& t,
                                             const C1Options& options,
                                             const RunOptions& run) {
  C1Options without_gradients = options;
  without_gradients.gradients = Gradients::automatic;
  check(without_gradients);
  check_linear(options);
  return std::make_shared<const C1Choices>(
      C1Choices{options.degree,
                options.degree == FitDegree::quartic
                    ? from_geometry<Space, 4>(space, t, options, run)
                    : from_geometry<Space, 3>(space, t, options, run),
                known_or_local(options.gradients)});
}

/// The stiffness that a surface chose, known by its tension.
Stiffness stiffness_taken(const C1Options& options, const C1Fit& fit) {
  if (options.tension) return stiffness_of(*options.tension);
  Stiffness stiffness;
  for (std::size_t level = 0; level < num_stiffness_levels; ++level)
    if (stiffness_levels[level].tension == fit.tension)
      stiffness = stiffness_levels[level];
  return stiffness;
}

template <BlendSpace Space, class Surface>
std::shared_ptr<const C1Choices> choices_of(
    const Space& space, const std::shared_ptr<const typename Space::Triangulation>& t,
    std::span<const double> row_values, C1Options options, const RunOptions& run) {
  options.choices = {};
  options.gradients = Gradients::local;
  const Stiffness stiffness =
      stiffness_taken(options, Surface(t, row_values, options, run).fit());
  const std::vector<double> values =
      values_at_sites(t->sites(), t->num_sites(), row_values, options.duplicates);
  return std::make_shared<const C1Choices>(
      C1Choices{options.degree,
                options.degree == FitDegree::quartic
                    ? from_values<Space, 4>(space, *t, values, stiffness, run)
                    : from_values<Space, 3>(space, *t, values, stiffness, run),
                Gradients::local});
}

}  // namespace

void check_linear(const C1Options& options) {
  if (options.bounds == Bounds::local) {
    throw Error(
        "a surface with local bounds is not linear in the data, so it has no fixed "
        "choices "
        "and no operator; leave the bounds out");
  }
}

void check_choices(const C1Options& options, Site num_sites) {
  if (!options.choices) return;
  check_linear(options);
  const C1Choices& choices = *options.choices;
  if (options.gradients != Gradients::automatic && options.gradients != choices.gradients)
    throw Error("the choices are for other gradients; make them with the same ones");
  if (choices.degree != options.degree)
    throw Error("the choices are for another degree of fits; give both the same");
  if (choices.nodes.size() != at(num_sites)) {
    throw Error("there are " + std::to_string(choices.nodes.size()) + " choices for " +
                std::to_string(num_sites) + " positions; make them for these points");
  }
  if (options.tension)
    throw Error("fixed choices hold the tension; make them with it instead");
  for (const C1NodeChoice& node : choices.nodes) {
    const double sum = std::accumulate(node.parts.begin(), node.parts.end(), 0.0);
    if (!(std::abs(sum - 1) < 1e-9) || !(node.tension >= 0 && node.tension < 1) ||
        !(node.nearness > 0 && node.nearness <= 4))
      throw Error(
          "a choice has parts that do not sum to one, or a tension outside 0 .. 1");
  }
}

template <int Degree>
BlendModel<Degree> BlendNode<Degree>::model(Site node,
                                            std::span<const double> site_values,
                                            std::array<double, 2> slope) const {
  BlendModel<Degree> result;
  result.value = site_values[at(node)];
  result.per_radius = per_radius;
  result.least = -std::numeric_limits<double>::infinity();
  result.most = std::numeric_limits<double>::infinity();
  result.tension = tension;
  const bool is_slope_known = !places.empty();
  for (double& part : slope) part = is_slope_known ? part / per_radius : 0;
  std::vector<double> rises;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    rises.push_back(site_values[at(sites[k])] - result.value);
    if (is_slope_known) rises[k] -= slope[0] * places[k][0] + slope[1] * places[k][1];
  }
  for (std::size_t c = 0; c < result.coefficients.size(); ++c) {
    for (std::size_t k = 0; k < sites.size(); ++k)
      result.coefficients[c] += weights_of(c)[k] * rises[k];
  }
  for (std::size_t i = 0; i < 2 && is_slope_known; ++i)
    result.coefficients[i] = gradient_part * slope[i];
  return result;
}

template <BlendSpace Space, int Degree>
BlendNode<Degree> blend_node(const Space& space,
                             const typename Space::Triangulation& triangulation,
                             Site site, std::span<const StencilNode> stencil,
                             const C1NodeChoice& choice, Gradients gradients) {
  const BlendSurroundings<Space, Degree> around(space, triangulation, site, stencil,
                                                choice.nearness, gradients);
  BlendNode<Degree> node;
  node.per_radius = around.per_radius();
  node.tension = choice.tension;
  if (node.per_radius == 0 || choice.parts[0] == 1) return node;
  node.places = around.places();
  node.gradient_part = 1 - choice.parts[0];
  for (const StencilNode& n : stencil) node.sites.push_back(n.site);
  node.weights.resize(num_blend_terms(Degree) * stencil.size());
  for (int degree = 1; degree <= Degree; ++degree) {
    const double part = choice.parts[static_cast<std::size_t>(degree)];
    if (part < least_part) continue;
    const BlendInfluence<Degree> x = around.influence(degree);
    for (std::size_t c = 0; c < around.samples().end_term(degree); ++c) {
      for (std::size_t k = 0; k < stencil.size(); ++k)
        node.weights[c * stencil.size() + k] += part * x[c][k];
    }
  }
  return node;
}

std::shared_ptr<const C1Choices> c1_choices(const tripack::Triangulation& triangulation,
                                            const C1Options& options,
                                            const RunOptions& run) {
  return all_choices(PlaneSpace{coordinate_scale(triangulation.points())}, triangulation,
                     options, run);
}

std::shared_ptr<const C1Choices> c1_choices(const stripack::Triangulation& triangulation,
                                            const C1Options& options,
                                            const RunOptions& run) {
  return all_choices(SphereSpace{}, triangulation, options, run);
}

std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const tripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options, const RunOptions& run) {
  return choices_of<PlaneSpace, PlaneC1>({coordinate_scale(triangulation->points())},
                                         triangulation, row_values, options, run);
}

std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const stripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options, const RunOptions& run) {
  return choices_of<SphereSpace, SphereC1>({}, triangulation, row_values, options, run);
}

template struct BlendNode<3>;
template struct BlendNode<4>;

template BlendNode<3> blend_node<PlaneSpace, 3>(const PlaneSpace&,
                                                const tripack::Triangulation&, Site,
                                                std::span<const StencilNode>,
                                                const C1NodeChoice&, Gradients);
template BlendNode<4> blend_node<PlaneSpace, 4>(const PlaneSpace&,
                                                const tripack::Triangulation&, Site,
                                                std::span<const StencilNode>,
                                                const C1NodeChoice&, Gradients);
template BlendNode<3> blend_node<SphereSpace, 3>(const SphereSpace&,
                                                 const stripack::Triangulation&, Site,
                                                 std::span<const StencilNode>,
                                                 const C1NodeChoice&, Gradients);
template BlendNode<4> blend_node<SphereSpace, 4>(const SphereSpace&,
                                                 const stripack::Triangulation&, Site,
                                                 std::span<const StencilNode>,
                                                 const C1NodeChoice&, Gradients);

}  // namespace delone::interp
