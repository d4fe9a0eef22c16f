#include "interp/leave_one_out_smooth.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/blend_cells.hpp"
#include "interp/blend_choice.hpp"
#include "interp/blend_hump.hpp"
#include "interp/least_curvature.hpp"
#include "interp/leave_one_out_frame.hpp"
#include "interp/leave_one_out_stars.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

PlaneSpace space_of(const PlaneCells& cells) { return {cells.scale()}; }
SphereSpace space_of(const SphereCells&) { return {}; }

/// The range of all values but one.
class RangeOfOthers {
 public:
  explicit RangeOfOthers(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    const auto second = sorted.begin() + std::min(std::ssize(sorted), std::ptrdiff_t{2});
    std::partial_sort(sorted.begin(), second, sorted.end());
    std::copy(sorted.begin(), second, least_.begin());
    std::partial_sort(sorted.begin(), second, sorted.end(), std::greater<>());
    std::copy(sorted.begin(), second, most_.begin());
  }
  [[nodiscard]] ValueRange without(double value) const noexcept {
    return {value == least_[0] ? least_[1] : least_[0],
            value == most_[0] ? most_[1] : most_[0]};
  }

 private:
  std::array<double, 2> least_{}, most_{};
};

/// How the whole surface is fitted.
struct KeptChoices {
  BlendFitOptions fit;
  Gradients gradients = Gradients::local;
};

template <BlendSpace Space, int Degree>
KeptChoices choices_of(const Space& space, const typename Space::Triangulation& t,
                       std::span<const double> site_values, const C1Options& options,
                       const RunOptions& run) {
  KeptChoices kept{{}, options.gradients};
  kept.fit.bounds = options.bounds;
  const auto [least, most] = std::ranges::minmax_element(site_values);
  kept.fit.range = {*least, *most};
  const BlendChoice choice =
      choose_blend<Space, Degree>(space, t, site_values, options, kept.fit, run);
  kept.fit.stiffness = choice.stiffness;
  kept.gradients = choice.gradients;
  return kept;
}

template <BlendSpace Space, int Degree>
class LeftOutBlend {
 public:
  using Triangulation = typename Space::Triangulation;
  using Vector = typename Space::Vector;
  using Removed = RemovedSite<Triangulation>;
  using Stars = RemainingStars<Triangulation>;

  LeftOutBlend(const Space& space, std::span<const double> site_values,
               const KeptChoices& kept, const SurfaceOptions& options)
      : space_(space),
        values_(site_values),
        others_(site_values),
        kept_(kept),
        options_(options) {}

  [[nodiscard]] double operator()(const Removed& removed) const {
    const Spot spot = spot_left_by(removed);
    if (spot.kind == Spot::Kind::outside) {
      return options_.outside == Outside::linear
                 ? continued(removed)
                 : predicted_outside(removed, values_, options_);
    }
    if (!is_near_others(removed, options_)) return missing;
    const Stars stars(removed);
    if (spot.kind == Spot::Kind::edge)
      return on_edge(removed, stars, spot.sites[0], spot.sites[1]);
    return facet(removed, stars, spot.sites, 3)(vector_of(removed, removed.site()));
  }

 private:
  using Facet = BlendFacet<Space, Degree>;
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] Vector vector_of(const Removed& removed, Site s) const {
    return space_.vector(removed.triangulation().points()[at(s)]);
  }

  // Beyond it, too. Any third corner will do: the surface on the edge does not know it.
  [[nodiscard]] double on_edge(const Removed& removed, const Stars& stars, Site from,
                               Site to) const {
    const auto rim = stars.rim();
    const auto third = std::find_if(rim.begin(), rim.end(),
                                    [&](Site s) { return s != from && s != to; });
    const Site other = third == rim.end() ? beside(stars, from, to) : *third;
    const Vector p = vector_of(removed, removed.site());
    return facet(removed, stars, {std::min(from, to), std::max(from, to), other}, 2)
        .beyond_edge(0, Space::position(p));
  }
  [[nodiscard]] static Site beside(const Stars& stars, Site from, Site to) {
    const auto around = stars.neighbors(from);
    return around.front() == to ? around.back() : around.front();
  }

  // The hull edge that is nearest, of those that come to light.
  [[nodiscard]] double continued(const Removed& removed) const {
    if constexpr (std::same_as<Space, PlaneSpace>) {
      if (!is_near_others(removed, options_)) return missing;
      const Stars stars(removed);
      if (is_chain(removed, stars)) return along_chain(removed, stars);
      Site best = none, behind_best = none;
      double least = std::numeric_limits<double>::infinity();
      for (Site s = stars.rim().front(); s != stars.rim().back();) {
        const Site next = stars.neighbors(s).back();
        const double distance = squared_distance_to(removed, s, next);
        if (best == none || distance < least)
          best = s, behind_best = next, least = distance;
        s = next;
      }
      return on_edge(removed, stars, best, behind_best);
    } else {
      return missing;  // refused by SphereCells
    }
  }

  [[nodiscard]] double squared_distance_to(const Removed& removed, Site from,
                                           Site to) const {
    const Vector a = vector_of(removed, from),
                 along = Space::difference(vector_of(removed, to), a),
                 d = Space::difference(vector_of(removed, removed.site()), a);
    const double part =
        std::clamp(Space::dot(along, d) / Space::dot(along, along), 0.0, 1.0);
    const Vector apart{d.x - part * along.x, d.y - part * along.y};
    return Space::dot(apart, apart);
  }

  // Are all that remain on a line?
  [[nodiscard]] static bool is_chain(const Removed& removed, const Stars& stars) {
    return stars.hole()->dimension() < 2 &&
           std::ssize(stars.rim()) + 1 == removed.triangulation().num_sites();
  }
  [[nodiscard]] double along_chain(const Removed& removed, const Stars& stars) const {
    std::vector<double> values;
    for (const delaunay::Node k : stars.hole()->rows())
      values.push_back(values_[at(stars.rim()[at(k)])]);
    const typename LinearCellsOf<Space>::Type cells(stars.hole(), std::move(values),
                                                    options_);
    Cursor cursor;
    return cells.value(removed.position(), cursor);
  }

  [[nodiscard]] Facet facet(const Removed& removed, const Stars& stars,
                            const std::array<Site, 3>& corners,
                            std::size_t num_fitted) const {
    BlendFitOptions fit = kept_.fit;
    fit.range = others_.without(values_[at(removed.site())]);
    StencilGatherer<Space, Stars> gatherer(space_, removed.triangulation(), stars);
    const auto gradients = gradients_at(removed, std::span(corners).first(num_fitted));
    std::array<BlendModel<Degree>, 3> models;
    for (std::size_t k = 0; k < num_fitted; ++k)
      models[k] = fit_blend_model<Space, Degree>(
          space_, removed.triangulation(), values_, corners[k],
          gatherer.around(corners[k], num_nearest(Degree)), fit, gradients[k]);
    typename Facet::Corners parts;
    for (std::size_t k = 0; k < 3; ++k) {
      parts.points[k] = vector_of(removed, corners[k]);
      parts.models[k] = &models[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      parts.humps[k] = edge_hump<Space, Degree>(parts.points[k], parts.points[next],
                                                models[k], models[next], most_hump(fit));
    }
    return Facet(parts);
  }

  // What a node says of another's gradient falls off by a factor of four a step.
  [[nodiscard]] std::array<std::optional<Vector>, 3> gradients_at(
      const Removed& removed, std::span<const Site> corners) const {
    std::array<std::optional<Vector>, 3> gradients;
    if (kept_.gradients != Gradients::global) return gradients;
    const std::vector<Site> around = surroundings(removed);
    const auto is_around = [&](Site s) {
      return std::binary_search(around.begin(), around.end(), s);
    };
    const auto found =
        std::all_of(corners.begin(), corners.end(), is_around)
            ? gradients_among(removed, around, corners)
            : least_curvature_gradients_without(removed.site(), corners, space_,
                                                removed.triangulation(), values_);
    std::copy(found.begin(), found.end(), gradients.begin());
    return gradients;
  }

  // Fewer rings beside hubs, and none around one.
  [[nodiscard]] static std::vector<Site> surroundings(const Removed& removed) {
    constexpr int num_rings = 4;
    constexpr std::int32_t most_ends = 1500;
    const Adjacency& t = removed.triangulation().adjacency();
    std::vector<Site> sites{removed.site()};
    for (int ring = 0; ring < num_rings; ++ring) {
      std::int32_t num_ends = 0;
      for (const Site s : sites) num_ends += t.degree(s);
      if (num_ends > most_ends) break;
      const std::size_t size = sites.size();
      for (std::size_t i = 0; i < size; ++i)
        sites.insert(sites.end(), t.neighbors(sites[i]).begin(),
                     t.neighbors(sites[i]).end());
      std::sort(sites.begin(), sites.end());
      sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    }
    std::erase(sites, removed.site());
    return sites;
  }

  // Those of least curvature over a set of sites, at some of them.
  [[nodiscard]] std::vector<Vector> gradients_among(const Removed& removed,
                                                    std::span<const Site> sites,
                                                    std::span<const Site> wanted) const {
    const RunOptions alone{.num_threads = 1, .progress = {}};
    std::vector<typename Space::Point> points;
    for (const Site s : sites) points.push_back(removed.triangulation().points()[at(s)]);
    const Triangulation local(points, alone);
    std::vector<double> values;
    for (const delaunay::Node row : local.rows())
      values.push_back(values_[at(sites[at(row)])]);
    const auto all = least_curvature_gradients(space_, local, values, alone);
    std::vector<Vector> found;
    for (const Site s : wanted) {
      const auto row = std::lower_bound(sites.begin(), sites.end(), s) - sites.begin();
      found.push_back(all[at(local.sites()[static_cast<std::size_t>(row)])]);
    }
    return found;
  }

  Space space_;
  std::span<const double> values_;
  RangeOfOthers others_;
  KeptChoices kept_;
  SurfaceOptions options_;
};

template <BlendSpace Space, int Degree>
std::vector<double> predictions(const typename LinearCellsOf<Space>::Type& cells,
                                const C1Options& options, const RunOptions& run) {
  const Space space = space_of(cells);
  const auto& t = cells.triangulation();
  const KeptChoices kept =
      choices_of<Space, Degree>(space, t, cells.site_values(), options, run);
  return predict_left_out(
      t, run, LeftOutBlend<Space, Degree>(space, cells.site_values(), kept, options));
}

template <BlendSpace Space>
LeaveOneOut leave_out(std::shared_ptr<const typename Space::Triangulation> t,
                      std::span<const double> row_values, const C1Options& options,
                      const RunOptions& run) {
  check(options);
  if (options.choices)
    throw Error(
        "choices that are fixed for all nodes do not fit a set without one of them; "
        "leave them out");
  const typename LinearCellsOf<Space>::Type cells(
      t, values_at_sites(t->sites(), t->num_sites(), row_values, options.duplicates),
      options);
  if (t->dimension() < 2) return leave_out_linear(std::move(t), row_values, options, run);
  return left_out_rows(t->sites(),
                       options.degree == FitDegree::quartic
                           ? predictions<Space, 4>(cells, options, run)
                           : predictions<Space, 3>(cells, options, run),
                       row_values);
}

}  // namespace

LeaveOneOut leave_out_c1(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const double> row_values, const C1Options& options,
                         const RunOptions& run) {
  return leave_out<PlaneSpace>(std::move(triangulation), row_values, options, run);
}

LeaveOneOut leave_out_c1(std::shared_ptr<const stripack::Triangulation> triangulation,
                         std::span<const double> row_values, const C1Options& options,
                         const RunOptions& run) {
  // Beyond a rim a value of all of the rim counts, which is not known without the site.
  C1Options known = options;
  if (known.outside == Outside::linear) known.outside = Outside::missing;
  return leave_out<SphereSpace>(std::move(triangulation), row_values, known, run);
}

}  // namespace delone::interp
