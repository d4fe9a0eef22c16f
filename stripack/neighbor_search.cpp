#include "stripack/neighbor_search.hpp"

#include <algorithm>
#include <array>

#include "delaunay/neighbor_batch.hpp"
#include "delaunay/site_search.hpp"
#include "stripack/distance_order.hpp"
#include "stripack/query_order.hpp"

namespace delone::stripack {

namespace {

using delaunay::Candidate;
using delaunay::none;
using delaunay::SiteDistance;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool has_boundary(const Triangulation& t) {
  return t.dimension() < 2 || t.num_triangles() != 2 * std::int64_t{t.num_sites()} - 4;
}

// Some boundary site, or none. A point and its opposite are not both inside a hemisphere,
// so that one of two walks ends at the boundary, unless both lie on it.
Site find_boundary_site(const Triangulation& t, const Direction& p) {
  const Direction opposite = Direction::from(-p.x(), -p.y(), -p.z());
  for (const Direction& d : {p, opposite}) {
    const Arc a = t.find(d);
    if (!t.adjacency().has_left(a)) return a.origin;
  }
  for (Site s = 0; s < t.num_sites(); ++s) {
    if (t.adjacency().is_boundary(s)) return s;
  }
  return none;
}

// The sites that may have neighbours through the outside, which are not in the lists: on
// the boundary, and at the ends of a chain.
std::vector<Site> outer_sites(const Triangulation& t, const Direction& p) {
  if (!has_boundary(t)) return {};
  if (t.dimension() < 2) return {0, t.num_sites() - 1};
  const Site first = find_boundary_site(t, p);
  std::vector<Site> sites;
  for (Site s = first; sites.empty() || s != first; s = t.adjacency().neighbors(s)[0])
    sites.push_back(s);
  return sites;
}

/// Angles from one query, as delaunay/nearest_first.hpp wants them.
class Distances {
 public:
  Distances(const Triangulation& t, const Direction& query, bool may_hide)
      : t_(&t), points_(t.points()), query_(query), may_hide_(may_hide) {}

  [[nodiscard]] double squared(Site s) const {
    return squared_chord(query_, points_[at(s)]);
  }
  [[nodiscard]] int compare(const Candidate& a, const Candidate& b) const {
    const int certain = compare_distances_filter(a.squared, b.squared);
    if (certain != 0) return certain;
    return a.site == b.site ? 0
                            : compare_distances_exact(query_, points_[at(a.site)],
                                                      points_[at(b.site)]);
  }
  [[nodiscard]] bool is_before(Site a, Site b) const {
    const Direction &p = points_[at(a)], &q = points_[at(b)];
    return std::array{p.x(), p.y(), p.z()} < std::array{q.x(), q.y(), q.z()};
  }
  // More than twice the bound of the filter, which has room for the rounding here.
  [[nodiscard]] static double surely_nearer_than(double squared) {
    return squared - (0x1p-48 * squared + 0x1p-97);
  }
  // The circles that hidden neighbours have in common hold a hemisphere.
  [[nodiscard]] bool hides(const Candidate& c) const {
    return may_hide_ && c.squared > 2 - 0x1p-40;
  }
  [[nodiscard]] std::vector<Site> hidden() const { return outer_sites(*t_, query_); }

 private:
  const Triangulation* t_;
  std::span<const Direction> points_;
  Direction query_;
  bool may_hide_;
};

/// Positions, as delaunay/site_search.hpp wants them.
class Globe {
 public:
  using Point = Direction;
  using Geometry = Distances;

  explicit Globe(const Triangulation& t) : t_(t), may_hide_(has_boundary(t)) {}

  [[nodiscard]] const Adjacency& adjacency() const { return t_.adjacency(); }
  [[nodiscard]] Distances from(const Direction& query) const {
    return {t_, query, may_hide_};
  }
  [[nodiscard]] double distance(const Direction& query, Site s) const {
    return angle(query, t_.points()[at(s)]);
  }
  [[nodiscard]] static bool is_within(const Direction&, const SiteDistance& s,
                                      double radius) {
    return s.distance <= radius;
  }

 private:
  const Triangulation& t_;
  bool may_hide_;
};

using Search = delaunay::SiteSearch<Globe>;

/// Sites by geodesics of WGS84. Those of the sphere come in the order of angles, and
/// there is no need to look farther than a node's least stretched distance.
class GeodesicSearch {
 public:
  explicit GeodesicSearch(const Triangulation& t) : t_(t), search_(Globe(t)) {}

  [[nodiscard]] std::span<const SiteDistance> nearest(const Direction& query, Site near,
                                                      std::size_t k) {
    start(query, near);
    for (auto s = search_.next(); s; s = search_.next()) {
      if (found_.size() == k && least_km(*s) > found_.back().distance) break;
      insert({s->site, kilometers(s->site)});
      if (found_.size() > k) found_.pop_back();
    }
    return found_;
  }

  [[nodiscard]] Search::Around within(const Direction& query, Site near, double radius) {
    start(query, near);
    Site first = none;
    for (auto s = search_.next(); s && !(least_km(*s) > radius); s = search_.next()) {
      if (first == none) first = s->site;
      const double distance = kilometers(s->site);
      if (distance <= radius) insert({s->site, distance});
    }
    return {found_, first == none ? near : first};
  }

 private:
  void start(const Direction& query, Site near) {
    found_.clear();
    query_ = lonlat(query);
    search_.start(query, near);
  }
  // The least radius of curvature, b^2 / a; the margins cover rounding of the angle and
  // GeographicLib's 15 nanometres.
  [[nodiscard]] static double least_km(const SiteDistance& s) {
    return 6335.439 * s.distance * (1 - 0x1p-40) - 1e-9;
  }
  [[nodiscard]] double kilometers(Site s) const {
    return geodesic_km(query_, lonlat(t_.points()[at(s)]));
  }
  void insert(const SiteDistance& s) {
    const auto after =
        std::ranges::upper_bound(found_, s.distance, {}, &SiteDistance::distance);
    found_.insert(after, s);
  }

  const Triangulation& t_;
  Search search_;
  LonLat query_;
  std::vector<SiteDistance> found_;
};

Site start_site(const Triangulation& t, Node hint) {
  return hint == none ? 0 : t.sites()[at(hint)];
}

std::size_t num_found(const Triangulation& t, std::int32_t k) {
  return at(std::min(k, t.num_sites()));
}

// One query.
template <class AnySearch, class Ask>
std::vector<Neighbor> answer(const Triangulation& t, AnySearch search, Ask ask) {
  if (t.num_sites() == 0) return {};
  return delaunay::in_rows(ask(search), t.rows());
}

// Many queries with k answers each.
template <class MakeSearch>
NeighborTable answer_k(const Triangulation& t, std::span<const Direction> queries,
                       std::int32_t k, const RunOptions& run, MakeSearch make_search) {
  delaunay::check_num_neighbors(k);
  const auto order = order_along_curve(queries);
  const std::size_t count = num_found(t, k);
  return delaunay::answer_evenly(order, t.rows(), count, run, make_search,
                                 [&](auto& search, std::size_t i, Site near) {
                                   return search.nearest(queries[i], near, count);
                                 });
}

// Many queries with all answers within a radius.
template <class MakeSearch>
NeighborTable answer_within(const Triangulation& t, std::span<const Direction> queries,
                            double radius, const RunOptions& run,
                            MakeSearch make_search) {
  delaunay::check_radius(radius);
  const auto order = order_along_curve(queries);
  return delaunay::answer_unevenly(order, t.rows(), run, make_search,
                                   [&](auto& search, std::size_t i, Site near) {
                                     return search.within(queries[i], near, radius);
                                   });
}

}  // namespace

Node nearest_exact(const Triangulation& t, const Direction& p, Node hint) {
  if (t.num_sites() == 0) return none;
  Search search{Globe(t)};
  return t.rows()[at(search.nearest(p, start_site(t, hint), 1)[0].site)];
}

std::vector<Neighbor> nearest_k(const Triangulation& t, const Direction& p,
                                std::int32_t k, Node hint) {
  delaunay::check_num_neighbors(k);
  return answer(t, Search(Globe(t)), [&](Search& search) {
    return search.nearest(p, start_site(t, hint), num_found(t, k));
  });
}

std::vector<Neighbor> nodes_within(const Triangulation& t, const Direction& p,
                                   double radius, Node hint) {
  delaunay::check_radius(radius);
  return answer(t, Search(Globe(t)), [&](Search& search) {
    return search.within(p, start_site(t, hint), radius).found;
  });
}

NeighborTable nearest_k(const Triangulation& t, std::span<const Direction> queries,
                        std::int32_t k, const RunOptions& run) {
  return answer_k(t, queries, k, run, [&] { return Search(Globe(t)); });
}

NeighborTable nodes_within(const Triangulation& t, std::span<const Direction> queries,
                           double radius, const RunOptions& run) {
  return answer_within(t, queries, radius, run, [&] { return Search(Globe(t)); });
}

NeighborTable nearest_k_of_nodes(const Triangulation& t, std::int32_t k,
                                 const RunOptions& run) {
  delaunay::check_num_neighbors(k);
  if (t.num_sites() == 0) return {};
  const std::size_t count = at(std::min(k, t.num_sites() - 1));
  return delaunay::answer_for_rows(
      t.rows(), t.sites(), count, run, [&] { return Search(Globe(t)); },
      [&](Search& search, Site s) {
        return search.nearest(t.points()[at(s)], s, count + 1).subspan(1);
      });
}

std::vector<Neighbor> nearest_k_wgs84(const Triangulation& t, const Direction& p,
                                      std::int32_t k, Node hint) {
  delaunay::check_num_neighbors(k);
  return answer(t, GeodesicSearch(t), [&](GeodesicSearch& search) {
    return search.nearest(p, start_site(t, hint), num_found(t, k));
  });
}

std::vector<Neighbor> nodes_within_wgs84(const Triangulation& t, const Direction& p,
                                         double radius_km, Node hint) {
  delaunay::check_radius(radius_km);
  return answer(t, GeodesicSearch(t), [&](GeodesicSearch& search) {
    return search.within(p, start_site(t, hint), radius_km).found;
  });
}

NeighborTable nearest_k_wgs84(const Triangulation& t, std::span<const Direction> queries,
                              std::int32_t k, const RunOptions& run) {
  return answer_k(t, queries, k, run, [&] { return GeodesicSearch(t); });
}

NeighborTable nodes_within_wgs84(const Triangulation& t,
                                 std::span<const Direction> queries, double radius_km,
                                 const RunOptions& run) {
  return answer_within(t, queries, radius_km, run, [&] { return GeodesicSearch(t); });
}

struct NearestNodes::State {
  const Triangulation& t;
  Search search;
  bool has_started = false;
};

NearestNodes::NearestNodes(const Triangulation& t)
    : state_(new State{t, Search(Globe(t))}) {}
NearestNodes::~NearestNodes() = default;
NearestNodes::NearestNodes(NearestNodes&&) noexcept = default;
NearestNodes& NearestNodes::operator=(NearestNodes&&) noexcept = default;

void NearestNodes::start(const Direction& p, Node hint) {
  if (state_->t.num_sites() == 0) return;
  state_->search.start(p, start_site(state_->t, hint));
  state_->has_started = true;
}

std::optional<Neighbor> NearestNodes::next() {
  if (!state_->has_started) return std::nullopt;
  const auto s = state_->search.next();
  if (!s) return std::nullopt;
  return Neighbor{state_->t.rows()[at(s->site)], s->distance};
}

}  // namespace delone::stripack
