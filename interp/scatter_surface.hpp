#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/cursor.hpp"
#include "interp/scatter_domain.hpp"
#include "interp/spot.hpp"
#include "interp/surface_options.hpp"

namespace delone::interp {

/// What every meshless method on a domain does the same way: nodes, the outside, reach,
/// and reading at one point, many points and on a grid.
///
/// A Method has
///   evaluate<T>(point, cursor)   its value with T = double, with the gradient with T =
///                                ScatterJet; a function of the point alone, NaN if
///                                missing
///   is_exact()                   does it pass through the values of the nodes?
template <class Domain, class Method>
class ScatterSurface {
 public:
  using Triangulation = typename Domain::Triangulation;
  using Point = typename Domain::Point;
  using Gradient = typename Domain::Gradient;
  static constexpr std::size_t dimension = Domain::dimension;

  ScatterSurface(std::shared_ptr<const Triangulation> triangulation, Domain domain,
                 std::vector<double> site_values, const SurfaceOptions& options,
                 Method method)
      : triangulation_(std::move(triangulation)),
        domain_(std::move(domain)),
        values_(std::move(site_values)),
        options_(options),
        method_(std::move(method)) {}

  [[nodiscard]] double value(const Point& p, Cursor& cursor) const {
    const Answer answer = answer_at(p, cursor);
    if (answer.kind == Answer::Kind::missing) return missing;
    if (answer.kind == Answer::Kind::nearest) return values_[at(answer.site)];
    if (answer.kind == Answer::Kind::node && method_.is_exact())
      return values_[at(answer.site)];
    return method_.template evaluate<double>(p, cursor);
  }

  [[nodiscard]] Gradient gradient(const Point& p, Cursor& cursor) const {
    const Answer answer = answer_at(p, cursor);
    if (answer.kind == Answer::Kind::missing) return Domain::missing_gradient();
    if (answer.kind == Answer::Kind::nearest) return {};
    const auto jet = method_.template evaluate<ScatterJet<dimension>>(p, cursor);
    if (std::isnan(jet.value)) return Domain::missing_gradient();
    return domain_.gradient(jet.slope, p);
  }

  [[nodiscard]] double value(const Point& p) const {
    Cursor cursor;
    return value(p, cursor);
  }
  [[nodiscard]] Gradient gradient(const Point& p) const {
    Cursor cursor;
    return gradient(p, cursor);
  }
  [[nodiscard]] std::vector<double> values(std::span<const Point> points,
                                           const RunOptions& run) const {
    return evaluate_along_curve<double>(
        points, triangulation_->adjacency(), run,
        [&](const Point& p, Cursor& cursor) { return value(p, cursor); });
  }
  [[nodiscard]] std::vector<Gradient> gradients(std::span<const Point> points,
                                                const RunOptions& run) const {
    return evaluate_along_curve<Gradient>(
        points, triangulation_->adjacency(), run,
        [&](const Point& p, Cursor& cursor) { return gradient(p, cursor); });
  }
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run) const {
    return Domain::field(
        grid, run, [&](const Point& p, Cursor& cursor) { return value(p, cursor); });
  }

 private:
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  struct Answer {
    enum class Kind : std::uint8_t { missing, node, nearest, method };
    Kind kind = Kind::missing;
    Site site = none;
  };

  [[nodiscard]] Answer answer_at(const Point& p, Cursor& cursor) const {
    if (triangulation_->num_sites() == 0 || !is_finite(p)) return {};
    const Spot spot = find_spot(*triangulation_, p, cursor.arc);
    if (spot.kind == Spot::Kind::node) return {Answer::Kind::node, spot.sites[0]};
    const bool is_outside = spot.kind == Spot::Kind::outside;
    if (is_outside && options_.outside == Outside::missing) return {};
    const auto reach = reach_of(*triangulation_, options_);
    const bool takes_nearest = is_outside && options_.outside == Outside::nearest;
    if (takes_nearest || reach.is_limited()) {
      cursor.site = nearest_site(*triangulation_, p, cursor.site);
      if (!reach.covers(p, cursor.site)) return {};
    }
    if (takes_nearest) return {Answer::Kind::nearest, cursor.site};
    return {Answer::Kind::method, none};
  }

  std::shared_ptr<const Triangulation> triangulation_;
  Domain domain_;
  std::vector<double> values_;
  SurfaceOptions options_;
  Method method_;
};

/// The values of the sites, once the options have been looked at. Outside::linear is
/// refused on the sphere.
template <class Triangulation>
[[nodiscard]] std::vector<double> checked_site_values(const Triangulation& t,
                                                      std::span<const double> row_values,
                                                      const SurfaceOptions& options) {
  check(options);
  if constexpr (std::same_as<Triangulation, stripack::Triangulation>) {
    if (options.outside == Outside::linear) {
      throw Error(
          "there is no linear continuation on the sphere; take nearest or missing");
    }
  }
  return values_at_sites(t.sites(), t.num_sites(), row_values, options.duplicates);
}

}  // namespace delone::interp
