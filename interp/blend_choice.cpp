#include "interp/blend_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/blend_facet.hpp"
#include "interp/blend_hump.hpp"
#include "interp/removed_site.hpp"

namespace delone::interp {

namespace {

constexpr Site most_tested = 600;
/// Errors beside those of the linear surface that are put up with.
constexpr double most_loss = 1.01;

/// Squared errors at one node that was left out.
struct LeftOut {
  bool is_tested = false;
  std::array<double, num_stiffness_levels> errors{};
  double linear = 0;
};

template <BlendSpace Space, int Degree>
class LeaveOneOut {
 public:
  using Triangulation = typename Space::Triangulation;
  using Vector = typename Space::Vector;
  LeaveOneOut(const Space& space, const Triangulation& triangulation,
              std::span<const double> site_values, const BlendFitOptions& options)
      : space_(space),
        triangulation_(&triangulation),
        site_values_(site_values),
        options_(options) {}

  [[nodiscard]] LeftOut operator()(Site left_out) const {
    const RemovedSite<Triangulation> removed(*triangulation_, left_out);
    const Spot spot = removed.spot();
    LeftOut result;
    if (spot.kind != Spot::Kind::triangle && spot.kind != Spot::Kind::edge) return result;
    result.is_tested = true;
    const auto corners = corners_of(spot, removed.rim());
    const double value = site_values_[at(left_out)];
    const Vector p = vector_of(left_out);
    const bool is_on_edge = spot.kind == Spot::Kind::edge;
    const auto models = fits(left_out, std::span(corners).first(is_on_edge ? 2 : 3));
    for (std::size_t level = 0; level < num_stiffness_levels; ++level) {
      const BlendFacet<Space, Degree> surface = facet(corners, models[level]);
      const double found =
          is_on_edge ? surface.beyond_edge(0, Space::position(p)) : surface(p);
      result.errors[level] = square(found - value);
    }
    result.linear = square(linear(spot, p) - value);
    return result;
  }

 private:
  using Models = std::array<BlendModel<Degree>, 3>;

  static double square(double a) { return a * a; }

  // The polynomials of the corners, by stiffness. Stencils are the same for all.
  [[nodiscard]] std::array<Models, num_stiffness_levels> fits(
      Site left_out, std::span<const Site> corners) const {
    std::array<Models, num_stiffness_levels> models;
    StencilGatherer<Space> gatherer(space_, *triangulation_);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto stencil =
          gatherer.around_without(left_out, corners, corners[k], num_nearest(Degree));
      for (std::size_t level = 0; level < num_stiffness_levels; ++level) {
        BlendFitOptions options = options_;
        options.stiffness = stiffness_level(level);
        models[level][k] = fit_blend_model<Space, Degree>(
            space_, *triangulation_, site_values_, corners[k], stencil, options);
      }
    }
    return models;
  }

  // Of an edge any third corner will do: the surface on the edge does not know it.
  static std::array<Site, 3> corners_of(const Spot& spot, std::span<const Site> rim) {
    if (spot.kind == Spot::Kind::triangle) return spot.sites;
    const auto third = std::find_if(rim.begin(), rim.end(), [&](Site s) {
      return s != spot.sites[0] && s != spot.sites[1];
    });
    return {spot.sites[0], spot.sites[1], *third};
  }

  [[nodiscard]] Vector vector_of(Site s) const {
    return space_.vector(triangulation_->points()[at(s)]);
  }

  [[nodiscard]] BlendFacet<Space, Degree> facet(const std::array<Site, 3>& corners,
                                                const Models& models) const {
    typename BlendFacet<Space, Degree>::Corners parts;
    for (std::size_t k = 0; k < 3; ++k) {
      parts.points[k] = vector_of(corners[k]);
      parts.models[k] = &models[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      parts.humps[k] =
          edge_hump<Space, Degree>(parts.points[k], parts.points[next], models[k],
                                   models[next], most_hump(options_));
    }
    return BlendFacet<Space, Degree>(parts);
  }

  [[nodiscard]] double linear(const Spot& spot, Vector p) const {
    const auto value = [&](std::size_t k) { return site_values_[at(spot.sites[k])]; };
    const Vector a = vector_of(spot.sites[0]), b = vector_of(spot.sites[1]);
    if (spot.kind == Spot::Kind::edge)
      return value(0) + edge_weight(a, b, p) * (value(1) - value(0));
    const auto weights = corner_weights(a, b, vector_of(spot.sites[2]), p);
    return value(0) + weights[1] * (value(1) - value(0)) +
           weights[2] * (value(2) - value(0));
  }

  Space space_;
  const Triangulation* triangulation_;
  std::span<const double> site_values_;
  BlendFitOptions options_;
};

/// The squared error of the linear surface that one node in fifty exceeds.
double rarely_exceeded(const std::vector<LeftOut>& tests) {
  constexpr std::size_t one_in = 50;
  std::vector<double> errors;
  for (const LeftOut& test : tests)
    if (test.is_tested) errors.push_back(test.linear);
  if (errors.empty()) return 0;
  const auto last =
      errors.end() - 1 - static_cast<std::ptrdiff_t>(errors.size() / one_in);
  std::nth_element(errors.begin(), last, errors.end());
  return *last;
}

// The nodes that the linear surface predicts worst do not decide: at the hull and where
// data are wrong no surface predicts, and one such node outweighs all others. But with
// all nodes a surface must not be worse than the linear one, as long as any is not.
StiffnessChoice best_of(const std::vector<LeftOut>& tests) {
  StiffnessChoice choice;
  const double limit = rarely_exceeded(tests);
  std::array<double, num_stiffness_levels> scores{};
  for (const LeftOut& test : tests) {
    if (!test.is_tested) continue;
    ++choice.num_tested;
    choice.linear_rms += test.linear;
    for (std::size_t k = 0; k < num_stiffness_levels; ++k) {
      choice.rms[k] += test.errors[k];
      if (test.linear <= limit) scores[k] += test.errors[k];
    }
  }
  const double count = std::max(1.0, static_cast<double>(choice.num_tested));
  for (double& rms : choice.rms) rms = std::sqrt(rms / count);
  choice.linear_rms = std::sqrt(choice.linear_rms / count);
  for (std::size_t k = 0; k < num_stiffness_levels; ++k) {
    if (choice.rms[k] > most_loss * choice.linear_rms) scores[k] *= 0x1p100;
  }
  choice.level = static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) -
                                          scores.begin());
  return choice;
}

}  // namespace

template <BlendSpace Space, int Degree>
StiffnessChoice choose_stiffness(const Space& space,
                                 const typename Space::Triangulation& triangulation,
                                 std::span<const double> site_values,
                                 const BlendFitOptions& options, const RunOptions& run) {
  const Site num_sites = triangulation.num_sites(),
             num_tested = std::min(num_sites, most_tested);
  std::vector<LeftOut> tests(at(num_tested));
  const LeaveOneOut<Space, Degree> leave_one_out(space, triangulation, site_values,
                                                 options);
  constexpr std::int64_t chunk = 16;
  RunOptions quiet = run;
  quiet.progress = {};
  delaunay::parallel_chunks(
      num_tested, chunk, quiet, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t k = first; k < last; ++k) {
          const std::int64_t site = (2 * k + 1) * num_sites / (2 * num_tested);
          tests[at(k)] = leave_one_out(static_cast<Site>(site));
        }
      });
  return best_of(tests);
}

template StiffnessChoice choose_stiffness<PlaneSpace, 3>(const PlaneSpace&,
                                                         const tripack::Triangulation&,
                                                         std::span<const double>,
                                                         const BlendFitOptions&,
                                                         const RunOptions&);
template StiffnessChoice choose_stiffness<PlaneSpace, 4>(const PlaneSpace&,
                                                         const tripack::Triangulation&,
                                                         std::span<const double>,
                                                         const BlendFitOptions&,
                                                         const RunOptions&);
template StiffnessChoice choose_stiffness<SphereSpace, 3>(const SphereSpace&,
                                                          const stripack::Triangulation&,
                                                          std::span<const double>,
                                                          const BlendFitOptions&,
                                                          const RunOptions&);
template StiffnessChoice choose_stiffness<SphereSpace, 4>(const SphereSpace&,
                                                          const stripack::Triangulation&,
                                                          std::span<const double>,
                                                          const BlendFitOptions&,
                                                          const RunOptions&);

}  // namespace delone::interp
