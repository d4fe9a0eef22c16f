#include "interp/blend_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/blend_facet.hpp"
#include "interp/blend_hump.hpp"

namespace delone::interp {

namespace {

constexpr Site most_tested = 600;
constexpr std::size_t patch_size = 120;

/// A node's surroundings: all sites within some rings of it, without it.
std::vector<Site> surroundings(const Adjacency& t, Site center) {
  std::vector<Site> sites{center};
  for (std::size_t first = 0; sites.size() < patch_size;) {
    const std::size_t end = sites.size();
    for (std::size_t k = first; k < end && sites.size() < 4 * patch_size; ++k) {
      for (const Site w : t.neighbors(sites[k])) {
        if (std::find(sites.begin(), sites.end(), w) == sites.end()) sites.push_back(w);
        if (sites.size() >= 4 * patch_size) break;
      }
    }
    if (sites.size() == end) break;
    first = end;
  }
  sites.erase(sites.begin());
  return sites;
}

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
  LeaveOneOut(const Space& space, const Triangulation& triangulation,
              std::span<const double> site_values, const BlendFitOptions& options)
      : space_(space),
        triangulation_(&triangulation),
        site_values_(site_values),
        options_(options) {}

  [[nodiscard]] LeftOut operator()(Site left_out) const {
    const Patch patch(*this, left_out);
    const auto& p = triangulation_->points()[at(left_out)];
    const Arc arc = patch.triangulation.find(p);
    LeftOut result;
    if (patch.triangulation.dimension() < 2 ||
        !patch.triangulation.adjacency().has_left(arc))
      return result;
    result.is_tested = true;
    const auto corners = smallest_first(patch.triangulation.adjacency().left(arc));
    const double value = site_values_[at(left_out)];
    const auto position = Space::position(space_.vector(p));
    StencilGatherer<Space> gatherer(space_, patch.triangulation);
    for (std::size_t level = 0; level < num_stiffness_levels; ++level) {
      BlendFitOptions options = options_;
      options.stiffness = stiffness_level(level);
      std::array<BlendModel<Degree>, 3> models;
      for (std::size_t k = 0; k < 3; ++k) {
        models[k] = fit_blend_model<Space, Degree>(
            space_, patch.triangulation, patch.values, corners[k],
            gatherer.around(corners[k], num_nearest(Degree)), options);
      }
      const double error = facet(patch, corners, models)(space_.vector(p)) - value;
      result.errors[level] = error * error;
    }
    const double error = linear(patch, corners, position) - value;
    result.linear = error * error;
    return result;
  }

 private:
  struct Patch {
    Triangulation triangulation;
    std::vector<double> values;
    Patch(const LeaveOneOut& all, Site left_out) {
      const std::vector<Site> sites =
          surroundings(all.triangulation_->adjacency(), left_out);
      std::vector<typename Space::Point> points;
      for (const Site s : sites) points.push_back(all.triangulation_->points()[at(s)]);
      triangulation = Triangulation(points, {.num_threads = 1, .progress = {}});
      for (const Node row : triangulation.rows())
        values.push_back(all.site_values_[at(sites[at(row)])]);
    }
  };

  [[nodiscard]] std::array<typename Space::Vector, 3> points_of(
      const Patch& patch, const std::array<Site, 3>& corners) const {
    const auto points = patch.triangulation.points();
    return {space_.vector(points[at(corners[0])]), space_.vector(points[at(corners[1])]),
            space_.vector(points[at(corners[2])])};
  }

  [[nodiscard]] BlendFacet<Space, Degree> facet(
      const Patch& patch, const std::array<Site, 3>& corners,
      const std::array<BlendModel<Degree>, 3>& models) const {
    const double limit = options_.bounds == Bounds::local
                             ? 0
                             : 0.1 * (options_.range.most - options_.range.least);
    typename BlendFacet<Space, Degree>::Corners parts;
    parts.points = points_of(patch, corners);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      parts.models[k] = &models[k];
      parts.humps[k] = edge_hump<Space, Degree>(parts.points[k], parts.points[next],
                                                models[k], models[next], limit);
    }
    return BlendFacet<Space, Degree>(parts);
  }

  [[nodiscard]] double linear(const Patch& patch, const std::array<Site, 3>& corners,
                              const typename Space::template Position<double>& p) const {
    const auto points = points_of(patch, corners);
    const auto b = corner_weights(points[0], points[1], points[2], Space::vector_of(p));
    const auto value = [&](std::size_t k) { return patch.values[at(corners[k])]; };
    return value(0) + b[1] * (value(1) - value(0)) + b[2] * (value(2) - value(0));
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
// data are wrong no surface predicts, and one such node outweighs all others.
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
