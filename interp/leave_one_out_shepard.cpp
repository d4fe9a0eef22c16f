#include <utility>

#include "interp/leave_one_out_scatter.hpp"
#include "interp/leave_one_out_scatter_frame.hpp"
#include "interp/shepard_method.hpp"

namespace delone::interp {

namespace {

// Distances are rounded, and differ from those that boxes are compared with.
constexpr double slightly_wider = 1 + 0x1p-40;

/// The surface over some of the nodes, and what each node's function depends on.
template <std::size_t D>
struct LeftOutLevel {
  ScatterNodes<D> nodes;
  SiteNumbers sites;
  BoxTree<D> points;
  std::vector<NodalFunction<D>> functions;
  BoxTree<D> influences;
};

template <std::size_t D>
LeftOutLevel<D> left_out_level(ScatterNodes<D> nodes, SiteNumbers sites,
                               const ShepardCounts& counts, const RunOptions& run) {
  LeftOutLevel<D> level{std::move(nodes), std::move(sites), {}, {}, {}};
  level.points = point_tree<D>(level.nodes.points);
  const std::size_t size = level.nodes.points.size();
  level.functions.resize(size, {.chart = NodalChart<D>({})});
  std::vector<Box<D>> boxes(size);
  delaunay::parallel_chunks(static_cast<std::int64_t>(size), 256, run,
                            [&](std::int64_t first, std::int64_t last) {
                              for (std::int64_t k = first; k < last; ++k) {
                                const auto node =
                                    fitted(level.nodes, level.points, at(k), counts);
                                level.functions[at(k)] = node.function;
                                boxes[at(k)] = ball_box(node.function.position,
                                                        slightly_wider * node.influence);
                              }
                            });
  level.influences = BoxTree<D>(std::move(boxes));
  return level;
}

template <class Domain>
class LeftOutShepard {
 public:
  static constexpr std::size_t D = Domain::dimension;
  using Position = std::array<double, D>;

  LeftOutShepard(ScatterNodes<D> nodes, const ShepardCounts& counts,
                 const RunOptions& run)
      : counts_(counts) {
    SiteNumbers sites = SiteNumbers::all(nodes.points.size());
    for (;;) {
      levels_.push_back(left_out_level(nodes, sites, counts, run));
      if (nodes.points.size() <= counts.weighted + 1) break;
      const auto numbers = numbers_of_every_eighth(nodes);
      nodes = selected(nodes, numbers);
      sites = sites.selected(numbers);
    }
    constants_ = constant_level(nodes);
  }

  [[nodiscard]] double without(Site s) const {
    return blend(0, levels_[0].nodes.points[at(s)], s);
  }

 private:
  [[nodiscard]] double blend(std::size_t level, const Position& p, Site s) const {
    if (level == levels_.size()) return constant(p, s);
    const auto functions = functions_at(levels_[level], p, s);
    ShepardMean<double, D> mean(p, counts_.degree);
    for (const NodalFunction<D>& f : functions) mean.add(f);
    if (mean.is_empty()) return blend(level + 1, p, s);
    return mean.is_covered() ? mean.value() : mean.completed(blend(level + 1, p, s));
  }

  // Those whose discs may hold p.
  [[nodiscard]] std::vector<NodalFunction<D>> functions_at(const LeftOutLevel<D>& level,
                                                           const Position& p,
                                                           Site s) const {
    const std::int32_t gone = level.sites.of(s);
    std::vector<NodalFunction<D>> functions;
    level.influences.for_each_holding(p, [&](std::int32_t k) {
      if (k == gone) return;
      functions.push_back(
          gone == none
              ? level.functions[at(k)]
              : fitted(level.nodes, level.points, at(k), counts_, gone).function);
    });
    return functions;
  }

  [[nodiscard]] double constant(const Position& p, Site s) const {
    std::vector<NodalFunction<D>> others = constants_.nodes;
    const std::int32_t gone = levels_.back().sites.of(s);
    if (gone != none) others.erase(others.begin() + gone);
    ShepardMean<double, D> mean(p, counts_.degree);
    for (const NodalFunction<D>& f : others) mean.add(f);
    return mean.is_empty() ? nearest_value<D>(others, p) : mean.value();
  }

  ShepardCounts counts_;
  std::vector<LeftOutLevel<D>> levels_;
  ShepardLevel<D> constants_;
};

template <class Surface, class Triangulation>
std::vector<double> rebuilt(const Triangulation& t, std::span<const double> site_values,
                            const ShepardOptions& shepard, SurfaceOptions options,
                            const RunOptions& run) {
  options.duplicates = Duplicates::mean;  // sites do not repeat
  const RunOptions alone{.num_threads = 1, .progress = {}};
  return wholly_rebuilt(
      t, site_values, run, [&](auto others, const std::vector<double>& values) {
        return Surface(std::move(others), values, shepard, options, alone);
      });
}

template <class Surface, class Domain>
LeaveOneOut leave_out(const std::shared_ptr<const typename Domain::Triangulation>& t,
                      std::span<const double> row_values, const ShepardOptions& shepard,
                      const SurfaceOptions& options, const RunOptions& run) {
  const ShepardCounts counts = shepard_counts(shepard);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  if (t->num_sites() <= most_rebuilt)
    return left_out_rows(t->sites(), rebuilt<Surface>(*t, values, shepard, options, run),
                         row_values);
  const LeftOutShepard<Domain> method(nodes_of(Domain(t->points()), *t, values), counts,
                                      {run.num_threads, {}});
  const auto predict = [&](const RemovedSite<typename Domain::Triangulation>& removed) {
    return predicted_within(removed, values, options,
                            [&] { return method.without(removed.site()); });
  };
  return left_out_rows(t->sites(), predict_left_out(*t, run, predict, 64), row_values);
}

}  // namespace

LeaveOneOut leave_out_shepard(std::shared_ptr<const tripack::Triangulation> triangulation,
                              std::span<const double> row_values,
                              const ShepardOptions& shepard,
                              const SurfaceOptions& options, const RunOptions& run) {
  return leave_out<PlaneShepard, PlaneDomain>(triangulation, row_values, shepard, options,
                                              run);
}

LeaveOneOut leave_out_shepard(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const ShepardOptions& shepard,
    const SurfaceOptions& options, const RunOptions& run) {
  return leave_out<SphereShepard, SphereDomain>(triangulation, row_values, shepard,
                                                options, run);
}

}  // namespace delone::interp
