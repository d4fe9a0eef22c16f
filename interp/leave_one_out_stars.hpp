#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/reach.hpp"
#include "interp/removed_site.hpp"

namespace delone::interp {

/// What holds a removed site among the others, as RemovedSite::spot; on the sphere also
/// where the boundary runs straight through the site: the edge between its boundary
/// neighbours, or outside if these are half a turn apart or more.
[[nodiscard]] inline Spot spot_left_by(
    const RemovedSite<tripack::Triangulation>& removed) {
  return removed.spot();
}
[[nodiscard]] inline Spot spot_left_by(
    const RemovedSite<stripack::Triangulation>& removed) {
  if (!removed.is_on_straight_boundary()) return removed.spot();
  const auto points = removed.triangulation().points();
  const auto rim = removed.rim();
  const auto is_left = [&](Site s) {
    return orientation(points[at(rim.back())], points[at(rim.front())], points[at(s)]) >
           0;
  };
  const bool is_edge = std::any_of(rim.begin() + 1, rim.end() - 1, is_left);
  return is_edge ? removed.spot() : Spot{};
}

/// Is the nearest of the other sites within the options' max_distance?
template <class Triangulation>
[[nodiscard]] bool is_near_others(const RemovedSite<Triangulation>& removed,
                                  const SurfaceOptions& options) {
  if (!(options.max_distance < std::numeric_limits<double>::infinity())) return true;
  const Site nearest = removed.nearest();
  if (nearest == none) return false;
  const std::vector one{removed.triangulation().points()[at(nearest)]};
  const Triangulation alone(one, {.num_threads = 1, .progress = {}});
  return reach_of(alone, options).covers(removed.position(), 0);
}

/// The prediction for a site that the others do not hold, unless it is continued.
template <class Triangulation>
[[nodiscard]] double predicted_outside(const RemovedSite<Triangulation>& removed,
                                       std::span<const double> site_values,
                                       const SurfaceOptions& options) {
  const Site nearest = removed.nearest();
  const bool is_missing =
      options.outside == Outside::missing || !is_near_others(removed, options);
  return is_missing || nearest == none ? std::numeric_limits<double>::quiet_NaN()
                                       : site_values[at(nearest)];
}

/// The neighbours that every site has once one is removed: for the sites of the rim some
/// that it had and some across the hole, for all others what they had. A NeighborGraph.
///
/// The triangles in the hole are those of the canonical triangulation of the rim that lie
/// in it, which is built: O(k log k) for k neighbours, and O(d) besides for the d
/// neighbours that they have themselves. The sites that remain must not all be on a line.
template <class Triangulation>
class RemainingStars {
 public:
  explicit RemainingStars(const RemovedSite<Triangulation>& removed)
      : all_(&removed.triangulation().adjacency()),
        removed_(removed.site()),
        is_open_(removed.is_boundary()),
        rim_(removed.rim()),
        hole_(triangulated(removed)) {
    numbers_.reserve(rim_.size());
    for (std::size_t k = 0; k < rim_.size(); ++k) numbers_.emplace_back(rim_[k], k);
    std::sort(numbers_.begin(), numbers_.end());
    for (std::size_t k = 0; k < rim_.size(); ++k) add_star(k);
  }

  /// The triangulation of the rim, whose rows are the sites of `rim()`.
  [[nodiscard]] const std::shared_ptr<const Triangulation>& hole() const noexcept {
    return hole_;
  }
  [[nodiscard]] std::span<const Site> rim() const noexcept { return rim_; }

  [[nodiscard]] std::span<const Site> neighbors(Site s) const noexcept {
    const std::size_t k = number_in_rim(s);
    if (k == rim_.size()) return all_->neighbors(s);
    const std::size_t begin = k == 0 ? 0 : stars_[k - 1].end;
    return {neighbors_.data() + begin, stars_[k].end - begin};
  }
  [[nodiscard]] std::int32_t degree(Site s) const noexcept {
    return static_cast<std::int32_t>(neighbors(s).size());
  }
  [[nodiscard]] bool is_boundary(Site s) const noexcept {
    const std::size_t k = number_in_rim(s);
    return k == rim_.size() ? all_->is_boundary(s) : stars_[k].is_boundary;
  }

 private:
  /// New neighbours of a site of the rim, counter-clockwise, on both sides of a gap.
  struct Across {
    std::vector<Site> before_gap, behind_gap;
    bool is_closed = false;  ///< no gap, everything before it
  };
  struct Star {
    std::size_t end;  ///< in neighbors_
    bool is_boundary;
  };

  static std::shared_ptr<const Triangulation> triangulated(
      const RemovedSite<Triangulation>& removed) {
    const auto points = removed.triangulation().points();
    std::vector<typename RemovedSite<Triangulation>::Point> rim;
    for (const Site s : removed.rim()) rim.push_back(points[at(s)]);
    return std::make_shared<const Triangulation>(
        rim, RunOptions{.num_threads = 1, .progress = {}});
  }

  [[nodiscard]] std::size_t number_in_rim(Site s) const noexcept {
    const auto found =
        std::lower_bound(numbers_.begin(), numbers_.end(), std::pair(s, std::size_t{0}));
    return found != numbers_.end() && found->first == s ? found->second : rim_.size();
  }

  [[nodiscard]] Site hole_site(std::size_t k) const noexcept { return hole_->sites()[k]; }
  [[nodiscard]] Site site_of(Site in_hole) const noexcept {
    return rim_[at(hole_->rows()[at(in_hole)])];
  }

  /// From one site of the rim to another; no index if they are not joined.
  [[nodiscard]] Arc hole_arc(std::size_t from, std::size_t to) const noexcept {
    const Adjacency& t = hole_->adjacency();
    Arc arc{hole_site(from), none};
    for (std::int32_t i = 0; i < t.degree(arc.origin); ++i) {
      arc = i == 0 ? t.first_arc(arc.origin) : t.next(arc);
      if (t.target(arc) == hole_site(to)) return arc;
    }
    return {arc.origin, none};
  }

  // The hole lies, seen from a site of the rim, counter-clockwise from the next one to
  // the one before.
  [[nodiscard]] Across across_hole(std::size_t k) const {
    const std::size_t size = rim_.size();
    const Adjacency& t = hole_->adjacency();
    Across across;
    const bool has_next = !is_open_ || k + 1 < size, has_previous = !is_open_ || k > 0;
    const Site last = has_previous ? hole_site((k + size - 1) % size) : none;
    if (has_next) {
      for (Arc a = hole_arc(k, (k + 1) % size); a.index != none && t.has_left(a);) {
        a = t.next(a);
        across.is_closed = t.target(a) == last;
        if (across.is_closed) return across;
        across.before_gap.push_back(site_of(t.target(a)));
      }
    }
    if (has_previous) {
      Arc a = hole_arc(k, (k + size - 1) % size);
      while (a.index != none && t.has_left(t.previous(a))) {
        a = t.previous(a);
        across.behind_gap.push_back(site_of(t.target(a)));
      }
      std::reverse(across.behind_gap.begin(), across.behind_gap.end());
    }
    return across;
  }

  void add(std::span<const Site> sites) {
    neighbors_.insert(neighbors_.end(), sites.begin(), sites.end());
  }

  void add_star(std::size_t k) {
    const std::span<const Site> all = all_->neighbors(rim_[k]);
    const auto place = static_cast<std::size_t>(
        std::find(all.begin(), all.end(), removed_) - all.begin());
    const auto before = all.first(place), behind = all.subspan(place + 1);
    const bool was_boundary = all_->is_boundary(rim_[k]);
    const Across across = across_hole(k);
    if (across.is_closed && was_boundary) {
      add(before), add(across.before_gap), add(behind);
    } else {
      add(across.behind_gap), add(behind), add(before), add(across.before_gap);
    }
    stars_.push_back({neighbors_.size(), was_boundary || !across.is_closed});
  }

  const Adjacency* all_;
  Site removed_;
  bool is_open_;  ///< was the site on the boundary?
  std::span<const Site> rim_;
  std::shared_ptr<const Triangulation> hole_;
  std::vector<std::pair<Site, std::size_t>> numbers_;  ///< of the sites in the rim
  std::vector<Star> stars_;
  std::vector<Site> neighbors_;
};

}  // namespace delone::interp
