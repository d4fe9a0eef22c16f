#include <utility>

#include "interp/leave_one_out_scatter.hpp"
#include "interp/leave_one_out_scatter_frame.hpp"
#include "interp/radial_method.hpp"

namespace delone::interp {

namespace {

/// The splines over some of the nodes, and what they are made of.
template <std::size_t D>
struct LeftOutLevel {
  ScatterNodes<D> nodes;
  SiteNumbers sites;
  std::vector<Disc<D>> discs;
  RadialLevel<D> splines;
};

/// Splines that were solved again without a site: level and number of the disc.
template <std::size_t D>
struct SolvedAgain {
  std::size_t level = 0;
  std::int32_t disc = none;
  Patch<D> patch;
};

template <class Domain>
class LeftOutRadial {
 public:
  static constexpr std::size_t D = Domain::dimension;
  using Position = std::array<double, D>;
  using Removed = RemovedSite<typename Domain::Triangulation>;

  LeftOutRadial(const Domain& domain, const ScatterNodes<D>& nodes,
                const RadialOptions& options, const RunOptions& run)
      : options_(options), scale_(domain.scale()), points_(point_tree<D>(nodes.points)) {
    ScatterNodes<D> rest = nodes;
    SiteNumbers sites = SiteNumbers::all(nodes.points.size());
    while (rest.points.size() > at(options.most_at_once)) {
      add_level(rest, sites, covering_discs(rest, at(options.neighbors)), run);
      const auto numbers = numbers_of_every_eighth(rest);
      rest = selected(rest, numbers);
      sites = sites.selected(numbers);
    }
    add_level(rest, sites, {disc_of_all(rest)}, run);
    const auto& patches = levels_[0].splines.patches;
    is_held_ = std::any_of(patches.begin(), patches.end(),
                           [](const Patch<D>& p) { return p.is_held(); });
  }

  [[nodiscard]] double without(const Removed& removed) const {
    return with_kernel(options_.kernel,
                       [&](auto kernel) { return without(kernel, removed); });
  }

 private:
  using Again = std::vector<SolvedAgain<D>>;

  void add_level(const ScatterNodes<D>& nodes, const SiteNumbers& sites,
                 std::vector<Disc<D>> discs, const RunOptions& run) {
    RadialLevel<D> splines = make_level(nodes, discs, options_, scale_, run);
    levels_.push_back({nodes, sites, std::move(discs), std::move(splines)});
  }

  template <class Kernel>
  [[nodiscard]] double without(Kernel kernel, const Removed& removed) const {
    Again again;
    const Site s = removed.site();
    const Position& p = levels_[0].nodes.points[at(s)];
    double value = blend(kernel, 0, p, s, again);
    if (options_.smoothing > 0 || !is_any_held(again)) return value;
    for (const Site k : removed.rim()) value += bump(kernel, k, s, again);
    return value;
  }

  [[nodiscard]] bool is_any_held(const Again& again) const {
    return is_held_ || std::any_of(again.begin(), again.end(), [](const auto& a) {
             return a.level == 0 && a.patch.is_held();
           });
  }

  // Only one that has the site as its nearest reaches it.
  template <class Kernel>
  [[nodiscard]] double bump(Kernel kernel, Site k, Site s, Again& again) const {
    const ScatterNodes<D>& nodes = levels_[0].nodes;
    const Position& center = nodes.points[at(k)];
    auto near = points_.nearest(center, 3);
    std::erase_if(near, [&](const auto& n) { return n.item == k || n.item == s; });
    if (near.empty()) return 0;
    const double radius = 0.5 * std::sqrt(near[0].squared);
    const double r =
        std::sqrt(squared_length(difference(nodes.points[at(s)], center))) / radius;
    if (!(r < 1)) return 0;
    return (nodes.values[at(k)] - blend(kernel, 0, center, s, again)) * bell(r);
  }

  template <class Kernel>
  [[nodiscard]] double blend(Kernel kernel, std::size_t level, const Position& p, Site s,
                             Again& again) const {
    const LeftOutLevel<D>& here = levels_[level];
    const std::int32_t gone = here.sites.of(s);
    RadialMean<double, D, Kernel> mean(p);
    here.splines.discs.for_each_holding(p, [&](std::int32_t k) {
      const auto& nodes = here.discs[at(k)].nodes;
      const bool knows =
          gone != none && std::binary_search(nodes.begin(), nodes.end(), gone);
      mean.add(knows ? solved_again(level, k, gone, again) : here.splines.patches[at(k)]);
    });
    if (mean.is_empty()) return blend(kernel, level + 1, p, s, again);
    if (level + 1 == levels_.size() || mean.is_covered()) return mean.value();
    return mean.completed(blend(kernel, level + 1, p, s, again));
  }

  [[nodiscard]] const Patch<D>& solved_again(std::size_t level, std::int32_t k,
                                             std::int32_t gone, Again& again) const {
    for (const auto& a : again)
      if (a.level == level && a.disc == k) return a.patch;
    Disc<D> disc = levels_[level].discs[at(k)];
    std::erase(disc.nodes, gone);
    again.push_back({level, k, Patch<D>(disc, levels_[level].nodes, options_, scale_)});
    return again.back().patch;
  }

  RadialOptions options_;
  double scale_;
  BoxTree<D> points_;
  std::vector<LeftOutLevel<D>> levels_;
  bool is_held_ = false;
};

template <class Surface, class Triangulation>
std::vector<double> rebuilt(const Triangulation& t, std::span<const double> site_values,
                            const RadialOptions& radial, SurfaceOptions options,
                            const RunOptions& run) {
  options.duplicates = Duplicates::mean;  // sites do not repeat
  const RunOptions alone{.num_threads = 1, .progress = {}};
  return wholly_rebuilt(
      t, site_values, run, [&](auto others, const std::vector<double>& values) {
        return Surface(std::move(others), values, radial, options, alone);
      });
}

template <class Surface, class Domain>
LeaveOneOut leave_out(const std::shared_ptr<const typename Domain::Triangulation>& t,
                      std::span<const double> row_values, const RadialOptions& radial,
                      const SurfaceOptions& options, const RunOptions& run) {
  check(radial);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  if (t->num_sites() <= most_rebuilt)
    return left_out_rows(t->sites(), rebuilt<Surface>(*t, values, radial, options, run),
                         row_values);
  const Domain domain(t->points());
  const LeftOutRadial<Domain> method(domain, nodes_of(domain, *t, values), radial,
                                     {run.num_threads, {}});
  const auto predict = [&](const RemovedSite<typename Domain::Triangulation>& removed) {
    return predicted_within(removed, values, options,
                            [&] { return method.without(removed); });
  };
  return left_out_rows(t->sites(), predict_left_out(*t, run, predict, 4), row_values);
}

}  // namespace

LeaveOneOut leave_out_radial(std::shared_ptr<const tripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const RadialOptions& radial, const SurfaceOptions& options,
                             const RunOptions& run) {
  return leave_out<PlaneRadial, PlaneDomain>(triangulation, row_values, radial, options,
                                             run);
}

LeaveOneOut leave_out_radial(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const RadialOptions& radial, const SurfaceOptions& options,
                             const RunOptions& run) {
  return leave_out<SphereRadial, SphereDomain>(triangulation, row_values, radial, options,
                                               run);
}

}  // namespace delone::interp
