#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/nearest_few.hpp"
#include "delaunay/nearest_first.hpp"
#include "delaunay/neighbor_batch.hpp"

namespace delone::delaunay {

/// Sites around one query after the other, in exact order, with distances that never
/// decrease.
///
/// A Space knows positions: `adjacency()`, `from(query)` (a QueryGeometry),
/// `distance(query, site)` rounded, `is_within(query, site_distance, radius)`.
template <class Space>
class SiteSearch {
 public:
  using Point = typename Space::Point;

  explicit SiteSearch(const Space& space)
      : space_(space),
        nearest_first_(space_.adjacency()),
        nearest_few_(space_.adjacency()) {}

  /// `near`: any site; the walk begins there. There must be one.
  void start(const Point& query, Site near) {
    query_ = query;
    last_ = 0;
    nearest_first_.start(space_.from(query), near);
  }

  [[nodiscard]] std::optional<SiteDistance> next() {
    const auto candidate = nearest_first_.next();
    if (!candidate) return std::nullopt;
    return with_distance(candidate->site);
  }

  /// The first k, at most as many as there are sites; valid until the next call.
  [[nodiscard]] std::span<const SiteDistance> nearest(const Point& query, Site near,
                                                      std::size_t k) {
    found_.clear();
    if (k > nearest_few_.capacity) {
      start(query, near);
      while (found_.size() < k) found_.push_back(*next());
      return found_;
    }
    query_ = query;
    last_ = 0;
    for (const Candidate& c : nearest_few_.find(space_.from(query), near, k))
      found_.push_back(with_distance(c.site));
    return found_;
  }

  struct Around {
    std::span<const SiteDistance> found;
    Site nearest = none;
  };
  /// All within a radius; valid until the next call.
  [[nodiscard]] Around within(const Point& query, Site near, double radius) {
    start(query, near);
    found_.clear();
    Site nearest = none;
    for (auto s = next(); s; s = next()) {
      if (nearest == none) nearest = s->site;
      if (!space_.is_within(query, *s, radius)) break;
      found_.push_back(*s);
    }
    return {found_, nearest};
  }

 private:
  // The order is exact, the distances are rounded: without the maximum they may step back
  // by an ulp.
  [[nodiscard]] SiteDistance with_distance(Site s) {
    last_ = std::max(last_, space_.distance(query_, s));
    return {s, last_};
  }

  Space space_;
  NearestFirst<typename Space::Geometry> nearest_first_;
  NearestFew<typename Space::Geometry> nearest_few_;
  std::vector<SiteDistance> found_;
  Point query_{};
  double last_ = 0;
};

/// Sites as rows.
[[nodiscard]] inline std::vector<Neighbor> in_rows(std::span<const SiteDistance> found,
                                                   std::span<const Node> rows) {
  std::vector<Neighbor> result;
  result.reserve(found.size());
  for (const SiteDistance& f : found)
    result.push_back({rows[static_cast<std::size_t>(f.site)], f.distance});
  return result;
}

}  // namespace delone::delaunay
