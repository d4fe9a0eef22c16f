#include "interp/blend_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/blend_facet.hpp"
#include "interp/blend_hump.hpp"
#include "interp/least_curvature.hpp"
#include "interp/removed_site.hpp"

namespace delone::interp {

namespace {

constexpr Site most_tested = 600;
/// Errors beside those of the linear surface that are put up with.
constexpr double most_loss = 1.01;

double square(double a) { return a * a; }

// What counts of an error: more than its size, so that surfaces that miss by much lose,
// less than its square, in which one node would outweigh all others where data are wrong.
double weighed(double error) { return error * std::sqrt(error); }
// Back, but for a factor.
double mean_error(double sum) { return square(std::cbrt(sum)); }

/// What to choose from: gradients local, or local and global (automatic). Global ones
/// with the first stiffness only: curves of theirs would stand out of stiff triangles.
struct BlendCandidates {
  std::span<const Stiffness> stiffness;
  Gradients gradients = Gradients::automatic;
};

/// Errors at one node that was left out, by stiffness.
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
              std::span<const double> site_values, const BlendCandidates& candidates,
              const BlendFitOptions& options)
      : space_(space),
        triangulation_(&triangulation),
        site_values_(site_values),
        candidates_(candidates),
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
    for (std::size_t k = 0; k < candidates_.stiffness.size(); ++k) {
      const BlendFacet<Space, Degree> surface = facet(corners, models[k]);
      const double found =
          is_on_edge ? surface.beyond_edge(0, Space::position(p)) : surface(p);
      result.errors[k] = std::abs(found - value);
    }
    result.linear = std::abs(linear(spot, p) - value);
    return result;
  }

 private:
  using Models = std::array<BlendModel<Degree>, 3>;

  // The polynomials of the corners, by stiffness. Stencils are the same for all.
  [[nodiscard]] std::array<Models, num_stiffness_levels> fits(
      Site left_out, std::span<const Site> corners) const {
    std::array<Models, num_stiffness_levels> models;
    StencilGatherer<Space> gatherer(space_, *triangulation_);
    const auto gradients = gradients_without(left_out, corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto stencil =
          gatherer.around_without(left_out, corners, corners[k], num_nearest(Degree));
      for (std::size_t level = 0; level < candidates_.stiffness.size(); ++level) {
        BlendFitOptions options = options_;
        options.stiffness = candidates_.stiffness[level];
        models[level][k] =
            fit_blend_model<Space, Degree>(space_, *triangulation_, site_values_,
                                           corners[k], stencil, options, gradients[k]);
      }
    }
    return models;
  }

  [[nodiscard]] std::array<std::optional<Vector>, 3> gradients_without(
      Site left_out, std::span<const Site> corners) const {
    std::array<std::optional<Vector>, 3> gradients;
    if (candidates_.gradients == Gradients::global) {
      const auto found = least_curvature_gradients_without(left_out, corners, space_,
                                                           *triangulation_, site_values_);
      std::copy(found.begin(), found.end(), gradients.begin());
    }
    return gradients;
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
  BlendCandidates candidates_;
  BlendFitOptions options_;
};

/// The error of the linear surface that one node in fifty exceeds.
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

/// The errors of all nodes left out, for one kind of gradients.
struct Prediction {
  std::size_t level = 0;  ///< the best stiffness
  double score = 0;       ///< its mean_error without the rarest errors
  double linear_score = 0;
  std::int64_t num_tested = 0;
  double rms = 0, linear_rms = 0;
};

// A node left out leaves a hole of twice the spacing, in which smooth surfaces seem to
// need more stiffness, and to follow the data less, than they do in triangles. So, in
// small sets, where they predict clearly better than the linear one: what is stiffer or
// more local must predict better by this factor to be taken.
double handicap(double error, const Prediction& linear) {
  constexpr double smooth = 0.4, rough = 0.95, most = 0.2, few_tests = 100;
  if (!(linear.linear_score > 0)) return 1;
  const double smoothness =
      std::clamp((rough - error / linear.linear_score) / (rough - smooth), 0.0, 1.0);
  const double smallness =
      std::min(1.0, few_tests / static_cast<double>(linear.num_tested));
  return 1 + most * smoothness * smallness;
}

// In the mean square a surface must not be worse than the linear one, as long as any is
// not.
Prediction best_of(const std::vector<LeftOut>& tests, std::size_t num_levels) {
  Prediction result;
  constexpr double far_better = 2;
  const double limit = rarely_exceeded(tests);
  std::array<double, num_stiffness_levels> squares{}, scores{}, usual_scores{};
  double linear_squares = 0;
  for (const LeftOut& test : tests) {
    if (!test.is_tested) continue;
    ++result.num_tested;
    linear_squares += square(test.linear);
    result.linear_score += weighed(test.linear);
    for (std::size_t k = 0; k < num_levels; ++k) {
      squares[k] += square(test.errors[k]);
      scores[k] += weighed(test.errors[k]);
      if (test.linear <= limit) usual_scores[k] += weighed(test.errors[k]);
    }
  }
  result.linear_score = mean_error(result.linear_score);
  for (double& score : scores) score = mean_error(score);
  std::array<double, num_stiffness_levels> handicapped{};
  for (std::size_t k = 0; k < num_levels; ++k) {
    if (squares[k] > square(most_loss) * linear_squares) scores[k] *= 0x1p100;
    handicapped[k] = k > 0 ? scores[k] * handicap(scores[0], result) : scores[k];
  }
  const auto last = handicapped.begin() + static_cast<std::ptrdiff_t>(num_levels);
  result.level = static_cast<std::size_t>(std::min_element(handicapped.begin(), last) -
                                          handicapped.begin());
  // Some nodes at the hull that no surface predicts must not stiffen what predicts all
  // others far better.
  for (std::size_t k = 0; k < result.level; ++k) {
    const bool is_safe = !(squares[k] > square(most_loss) * linear_squares);
    if (is_safe &&
        far_better * mean_error(usual_scores[k]) < mean_error(usual_scores[result.level]))
      result.level = k;
  }
  const double count = std::max(1.0, static_cast<double>(result.num_tested));
  result.score = mean_error(usual_scores[result.level]);
  result.rms = std::sqrt(squares[result.level] / count);
  result.linear_rms = std::sqrt(linear_squares / count);
  return result;
}

template <BlendSpace Space, int Degree>
Prediction predict(const Space& space, const typename Space::Triangulation& triangulation,
                   std::span<const double> site_values, const BlendCandidates& candidates,
                   const BlendFitOptions& options, const RunOptions& run) {
  const Site num_sites = triangulation.num_sites(),
             num_tested = std::min(num_sites, most_tested);
  std::vector<LeftOut> tests(at(num_tested));
  const LeaveOneOut<Space, Degree> leave_one_out(space, triangulation, site_values,
                                                 candidates, options);
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
  return best_of(tests, candidates.stiffness.size());
}

template <BlendSpace Space, int Degree>
BlendChoice best_candidate(const Space& space,
                           const typename Space::Triangulation& triangulation,
                           std::span<const double> site_values,
                           const BlendCandidates& candidates,
                           const BlendFitOptions& options, const RunOptions& run) {
  constexpr double well_predicted = 0.05;  // of the linear surface's errors
  const auto prediction = [&](const BlendCandidates& of_one_kind) {
    return predict<Space, Degree>(space, triangulation, site_values, of_one_kind, options,
                                  run);
  };
  Gradients gradients = Gradients::local;
  Prediction best = prediction({candidates.stiffness, gradients});
  if (candidates.gradients == Gradients::automatic &&
      best.rms > well_predicted * best.linear_rms) {
    // At the hull, and where data are wrong, neither predicts: some such nodes would
    // outweigh all others.
    const Prediction global =
        prediction({candidates.stiffness.first(1), Gradients::global});
    const double most = handicap(global.score, global);
    if (global.score < most * best.score && global.rms < most * best.rms) {
      best = global;
      gradients = Gradients::global;
    }
  }
  return {candidates.stiffness[best.level], gradients, best.num_tested, best.rms,
          best.linear_rms};
}

}  // namespace

template <BlendSpace Space, int Degree>
BlendChoice choose_blend(const Space& space,
                         const typename Space::Triangulation& triangulation,
                         std::span<const double> site_values, const C1Options& options,
                         const BlendFitOptions& fit, const RunOptions& run) {
  const std::array given{options.tension ? stiffness_of(*options.tension)
                                         : stiffness_levels.front()};
  const bool is_tension_open = !options.tension && options.gradients != Gradients::global;
  if (!is_tension_open && options.gradients != Gradients::automatic)
    return {given[0], options.gradients};
  BlendCandidates candidates{given, options.gradients};
  if (is_tension_open) candidates.stiffness = stiffness_levels;
  return best_candidate<Space, Degree>(space, triangulation, site_values, candidates, fit,
                                       run);
}

template BlendChoice choose_blend<PlaneSpace, 3>(const PlaneSpace&,
                                                 const PlaneSpace::Triangulation&,
                                                 std::span<const double>,
                                                 const C1Options&, const BlendFitOptions&,
                                                 const RunOptions&);
template BlendChoice choose_blend<PlaneSpace, 4>(const PlaneSpace&,
                                                 const PlaneSpace::Triangulation&,
                                                 std::span<const double>,
                                                 const C1Options&, const BlendFitOptions&,
                                                 const RunOptions&);
template BlendChoice choose_blend<SphereSpace, 3>(
    const SphereSpace&, const SphereSpace::Triangulation&, std::span<const double>,
    const C1Options&, const BlendFitOptions&, const RunOptions&);
template BlendChoice choose_blend<SphereSpace, 4>(
    const SphereSpace&, const SphereSpace::Triangulation&, std::span<const double>,
    const C1Options&, const BlendFitOptions&, const RunOptions&);

}  // namespace delone::interp
