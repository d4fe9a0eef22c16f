#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "interp/leave_one_out_frame.hpp"
#include "interp/leave_one_out_outside.hpp"
#include "interp/scatter_nodes.hpp"
#include "interp/scatter_surface.hpp"

namespace delone::interp {

/// Up to so many sites a surface that looks far is built again for each of them.
inline constexpr std::int32_t most_rebuilt = 64;

/// What the surface `make(triangulation, values)` over all other sites says, for every
/// site.
template <class Triangulation, class Make>
[[nodiscard]] std::vector<double> wholly_rebuilt(const Triangulation& t,
                                                 std::span<const double> site_values,
                                                 const RunOptions& run, Make make) {
  const RunOptions alone{.num_threads = 1, .progress = {}};
  const auto predict = [&](const RemovedSite<Triangulation>& removed) {
    const auto gone = static_cast<std::ptrdiff_t>(removed.site());
    std::vector points(t.points().begin(), t.points().end());
    std::vector values(site_values.begin(), site_values.end());
    points.erase(points.begin() + gone);
    values.erase(values.begin() + gone);
    return make(std::make_shared<const Triangulation>(points, alone), values)
        .value(removed.position());
  };
  return predict_left_out(t, run, predict, 4);
}

/// The sites as a meshless method sees them.
template <class Domain>
[[nodiscard]] ScatterNodes<Domain::dimension> nodes_of(
    const Domain& domain, const typename Domain::Triangulation& t,
    std::vector<double> site_values) {
  ScatterNodes<Domain::dimension> nodes{{}, std::move(site_values)};
  nodes.points.reserve(nodes.values.size());
  for (const auto& p : t.points()) nodes.points.push_back(domain.position(p));
  return nodes;
}

/// Some of the sites, ascending.
class SiteNumbers {
 public:
  SiteNumbers() = default;
  explicit SiteNumbers(std::vector<Site> sites) : sites_(std::move(sites)) {}
  [[nodiscard]] static SiteNumbers all(std::size_t count) {
    std::vector<Site> sites(count);
    for (std::size_t i = 0; i < count; ++i) sites[i] = static_cast<Site>(i);
    return SiteNumbers(std::move(sites));
  }
  /// `none` if the site is not one of them.
  [[nodiscard]] std::int32_t of(Site s) const noexcept {
    const auto found = std::lower_bound(sites_.begin(), sites_.end(), s);
    return found != sites_.end() && *found == s
               ? static_cast<std::int32_t>(found - sites_.begin())
               : none;
  }
  [[nodiscard]] SiteNumbers selected(std::span<const std::int32_t> numbers) const {
    std::vector<Site> sites;
    for (const std::int32_t i : numbers) sites.push_back(sites_[at(i)]);
    return SiteNumbers(std::move(sites));
  }

 private:
  std::vector<Site> sites_;
};

}  // namespace delone::interp
