#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "interp/barrier_space.hpp"
#include "interp/reach.hpp"

namespace delone::interp {

/// Which points are no farther than max_distance from an observation, in a straight line,
/// whatever lies between. Vertices of curves are no observations, so it knows the
/// triangulation of those alone; without a limit it knows nothing.
template <BlendSpace Space>
class BarrierReach {
 public:
  using Point = typename Space::Point;

  /// `of_sites`: values of the mesh's sites, NaN where there is no observation.
  BarrierReach(const BarrierMeshIn<Space>& mesh, std::span<const double> of_sites,
               const SurfaceOptions& options)
      : options_(options), is_limited_(std::isfinite(options.max_distance)) {
    if (!is_limited_) return;
    std::vector<Point> observations;
    for (Site s = 0; s < mesh.num_sites(); ++s)
      if (!std::isnan(of_sites[at(s)])) observations.push_back(mesh.points()[at(s)]);
    observations_ = std::make_shared<const typename Space::Triangulation>(observations);
    if (observations.empty()) return;
    near_.reserve(at(mesh.num_sites()));
    Site start = 0;
    for (const Point& p : mesh.points())
      near_.push_back(start = nearest_site(*observations_, p, start));
  }

  /// `start`: a site of the mesh near p.
  [[nodiscard]] bool covers(const Point& p, Site start) const {
    if (!is_limited_) return true;
    return !near_.empty() &&
           reach_of(*observations_, options_).covers(p, near_[at(start)]);
  }
  [[nodiscard]] bool covers_triangle(const std::array<Site, 3>&) const noexcept {
    return !is_limited_;
  }

 private:
  SurfaceOptions options_;
  bool is_limited_;
  std::shared_ptr<const typename Space::Triangulation> observations_;
  std::vector<Site> near_;  ///< of every site of the mesh an observation
};

}  // namespace delone::interp
