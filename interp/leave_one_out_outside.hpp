#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "interp/leave_one_out_frame.hpp"
#include "interp/leave_one_out_stars.hpp"
#include "interp/linear_surface.hpp"

namespace delone::interp {

template <class Triangulation>
struct LinearOver;
template <>
struct LinearOver<tripack::Triangulation> {
  using Surface = PlaneLinear;
};
template <>
struct LinearOver<stripack::Triangulation> {
  using Surface = SphereLinear;
};

/// Do the other sites not enclose this one? Of a chain, a site beyond their chain.
template <class Triangulation>
[[nodiscard]] bool is_left_outside(const RemovedSite<Triangulation>& removed) {
  if (removed.triangulation().dimension() == 2)
    return spot_left_by(removed).kind == Spot::Kind::outside;
  constexpr int rings = 2;
  const std::vector<double> zeros(at(removed.triangulation().num_sites()));
  const double predicted = rebuilt_prediction(
      removed, zeros, rings, [](auto local, const std::vector<double>& values) {
        return typename LinearOver<Triangulation>::Surface(std::move(local), values);
      });
  return std::isnan(predicted);
}

/// `predict()` where a surface has a value of its own at a removed site: within the
/// others and beyond with Outside::linear, no farther from them than max_distance.
template <class Triangulation, class Predict>
[[nodiscard]] double predicted_within(const RemovedSite<Triangulation>& removed,
                                      std::span<const double> site_values,
                                      const SurfaceOptions& options, Predict predict) {
  if (options.outside != Outside::linear && is_left_outside(removed))
    return predicted_outside(removed, site_values, options);
  if (!is_near_others(removed, options)) return std::numeric_limits<double>::quiet_NaN();
  return predict();
}

}  // namespace delone::interp
