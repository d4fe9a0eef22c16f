#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/site_set.hpp"

namespace delone::delaunay {

/// A site and its squared distance from the query, rounded.
struct Candidate {
  double squared = 0;
  Site site = none;
};

/// What the search needs to know about one query point:
///   squared(s)      rounded squared distance of site s
///   compare(a, b)   exact: -1 if a is nearer than b, +1 if farther, 0 if as far
///   is_before(a, b) the order of sites as far as one another, by coordinates
///   hides(a)        may a site that is as far as `a`, or farther, have no neighbour that
///                   is nearer? (90 degrees away, on the sphere)
///   hidden()        all sites that might
template <class G>
concept QueryGeometry = requires(const G& g, Candidate a, Site s) {
  { g.squared(s) } -> std::same_as<double>;
  { g.compare(a, a) } -> std::same_as<int>;
  { g.is_before(s, s) } -> std::same_as<bool>;
  { g.hides(a) } -> std::same_as<bool>;
  { g.hidden() } -> std::same_as<std::vector<Site>>;
};

/// A site that has no neighbour nearer to the query, walking from `near`: one of the
/// nearest, unless it hides some.
template <QueryGeometry G>
[[nodiscard]] Candidate descend_exactly(const Adjacency& adjacency, const G& geometry,
                                        Site near) {
  Candidate best{geometry.squared(near), near};
  for (Site from = none; from != best.site;) {
    from = best.site;
    for (const Site w : adjacency.neighbors(from)) {
      const Candidate c{geometry.squared(w), w};
      if (geometry.compare(c, best) < 0) best = c;
    }
  }
  return best;
}

/// The order in which sites are given.
template <QueryGeometry G>
[[nodiscard]] bool comes_after(const G& geometry, const Candidate& a,
                               const Candidate& b) {
  const int order = geometry.compare(a, b);
  return order != 0 ? order > 0 : geometry.is_before(b.site, a.site);
}

/// The sites of a Delaunay triangulation in the exact order of their distances from a
/// point, one after the other, those as far as one another in the order of coordinates.
///
/// Why it is complete: grow a circle that touches the circle about the query through a
/// site q from inside, in q, from nothing. The first site it meets is joined to q, for
/// the circle is empty, and it is nearer than q. So every site that is not a nearest one
/// has a neighbour that is nearer, and those that are nearest are joined among
/// themselves, for no site is inside their circle. The next site is therefore always one
/// of those joined to the sites already given. This holds however ties are broken.
///
/// Cost for k sites: the sum of their degrees, times log k. One object serves many
/// queries; what it keeps is memory, never an answer.
template <QueryGeometry G>
class NearestFirst {
 public:
  explicit NearestFirst(const Adjacency& adjacency) : adjacency_(adjacency) {}

  /// Begins anew. `near`: any site; the nearer to the query, the shorter the walk. There
  /// must be a site.
  void start(const G& geometry, Site near) {
    geometry_.emplace(geometry);
    frontier_.clear();
    seen_.clear();
    has_hidden_ = false;
    first_ = descend_exactly(adjacency_, geometry, near);
    add(first_.site);
    expand_ties();
  }

  /// The next site; nothing after the last.
  [[nodiscard]] std::optional<Candidate> next() {
    if (frontier_.empty()) return std::nullopt;
    if (!has_hidden_ && geometry_->hides(frontier_.front())) add_hidden();
    std::pop_heap(frontier_.begin(), frontier_.end(), after());
    const Candidate nearest = frontier_.back();
    frontier_.pop_back();
    if (nearest.site != first_.site) expand(nearest.site);
    return nearest;
  }

 private:
  [[nodiscard]] Candidate candidate(Site s) const { return {geometry_->squared(s), s}; }

  [[nodiscard]] auto after() const {
    return [this](const Candidate& a, const Candidate& b) {
      return comes_after(*geometry_, a, b);
    };
  }

  // False if the site was there already.
  bool add(Site s) {
    if (!seen_.insert(s)) return false;
    frontier_.push_back(candidate(s));
    std::push_heap(frontier_.begin(), frontier_.end(), after());
    return true;
  }

  void expand(Site s) {
    for (const Site w : adjacency_.neighbors(s)) add(w);
  }

  // Of several nearest sites the descent found any one; the others are joined to it.
  void expand_ties() {
    std::vector<Site> tied{first_.site};
    while (!tied.empty()) {
      const Site s = tied.back();
      tied.pop_back();
      for (const Site w : adjacency_.neighbors(s)) {
        if (add(w) && geometry_->compare(candidate(w), first_) == 0) tied.push_back(w);
      }
    }
  }

  void add_hidden() {
    has_hidden_ = true;
    for (const Site s : geometry_->hidden()) add(s);
  }

  const Adjacency& adjacency_;
  std::optional<G> geometry_;
  std::vector<Candidate> frontier_;  // a heap, the nearest in front
  SiteSet seen_;
  Candidate first_;
  bool has_hidden_ = false;
};

}  // namespace delone::delaunay
