#include "tripack/neighbor_search.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "delaunay/error.hpp"
#include "delaunay/neighbor_batch.hpp"
#include "delaunay/site_search.hpp"
#include "tripack/distance_order.hpp"
#include "tripack/query_order.hpp"

namespace delone::tripack {

namespace {

using delaunay::Candidate;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Distances from one query, as delaunay/nearest_first.hpp wants them.
class Distances {
 public:
  Distances(std::span<const Point2> points, Point2 query)
      : points_(points), query_(query) {}

  [[nodiscard]] double squared(Site s) const {
    return squared_distance(query_, points_[at(s)]);
  }
  [[nodiscard]] int compare(const Candidate& a, const Candidate& b) const {
    const int certain = compare_distances_filter(a.squared, b.squared);
    if (certain != 0) return certain;
    return compare_distances_exact(query_, points_[at(a.site)], points_[at(b.site)]);
  }
  [[nodiscard]] bool is_before(Site a, Site b) const {
    const Point2 p = points_[at(a)], q = points_[at(b)];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
  // Twice the bound of the filter, which has room for the rounding here.
  [[nodiscard]] static double surely_nearer_than(double squared) {
    return squared - (0x1p-48 * squared + 0x1p-999);
  }
  [[nodiscard]] static bool hides(const Candidate&) { return false; }
  [[nodiscard]] static std::vector<Site> hidden() { return {}; }

 private:
  std::span<const Point2> points_;
  Point2 query_;
};

/// Positions, as delaunay/site_search.hpp wants them.
class Plane {
 public:
  using Point = Point2;
  using Geometry = Distances;

  explicit Plane(const Triangulation& t) : t_(t) {}

  [[nodiscard]] const Adjacency& adjacency() const { return t_.adjacency(); }
  [[nodiscard]] Distances from(Point2 query) const {
    return Distances(t_.points(), query);
  }
  [[nodiscard]] double distance(Point2 query, Site s) const {
    return tripack::distance(query, t_.points()[at(s)]);
  }
  [[nodiscard]] bool is_within(Point2 query, const delaunay::SiteDistance& s,
                               double radius) const {
    return std::isinf(radius) ||
           tripack::is_within(query, t_.points()[at(s.site)], radius);
  }

 private:
  const Triangulation& t_;
};

using Search = delaunay::SiteSearch<Plane>;

void check_query(Point2 p) {
  if (std::isfinite(p.x) && std::isfinite(p.y)) return;
  throw Error("the query point is not finite");
}

Site start_site(const Triangulation& t, Node hint) {
  return hint == none ? 0 : t.sites()[at(hint)];
}

std::size_t num_found(const Triangulation& t, std::int32_t k) {
  return at(std::min(k, t.num_sites()));
}

}  // namespace

Node nearest_exact(const Triangulation& t, Point2 p, Node hint) {
  check_query(p);
  if (t.num_sites() == 0) return none;
  Search search{Plane(t)};
  return t.rows()[at(search.nearest(p, start_site(t, hint), 1)[0].site)];
}

std::vector<Neighbor> nearest_k(const Triangulation& t, Point2 p, std::int32_t k,
                                Node hint) {
  delaunay::check_num_neighbors(k);
  check_query(p);
  if (t.num_sites() == 0) return {};
  Search search{Plane(t)};
  return delaunay::in_rows(search.nearest(p, start_site(t, hint), num_found(t, k)),
                           t.rows());
}

std::vector<Neighbor> nodes_within(const Triangulation& t, Point2 p, double radius,
                                   Node hint) {
  delaunay::check_radius(radius);
  check_query(p);
  if (t.num_sites() == 0) return {};
  Search search{Plane(t)};
  return delaunay::in_rows(search.within(p, start_site(t, hint), radius).found, t.rows());
}

NeighborTable nearest_k(const Triangulation& t, std::span<const Point2> queries,
                        std::int32_t k, const RunOptions& run) {
  delaunay::check_num_neighbors(k);
  const auto order = order_along_curve(queries);
  const std::size_t count = num_found(t, k);
  return delaunay::answer_evenly(
      order, t.rows(), count, run, [&] { return Search(Plane(t)); },
      [&](Search& search, std::size_t i, Site near) {
        return search.nearest(queries[i], near, count);
      });
}

NeighborTable nodes_within(const Triangulation& t, std::span<const Point2> queries,
                           double radius, const RunOptions& run) {
  delaunay::check_radius(radius);
  const auto order = order_along_curve(queries);
  return delaunay::answer_unevenly(
      order, t.rows(), run, [&] { return Search(Plane(t)); },
      [&](Search& search, std::size_t i, Site near) {
        return search.within(queries[i], near, radius);
      });
}

NeighborTable nearest_k_of_nodes(const Triangulation& t, std::int32_t k,
                                 const RunOptions& run) {
  delaunay::check_num_neighbors(k);
  if (t.num_sites() == 0) return {};
  const std::size_t count = at(std::min(k, t.num_sites() - 1));
  return delaunay::answer_for_rows(
      t.rows(), t.sites(), count, run, [&] { return Search(Plane(t)); },
      [&](Search& search, Site s) {
        return search.nearest(t.points()[at(s)], s, count + 1).subspan(1);
      });
}

struct NearestNodes::State {
  const Triangulation& t;
  Search search;
  bool has_started = false;
};

NearestNodes::NearestNodes(const Triangulation& t)
    : state_(new State{t, Search(Plane(t))}) {}
NearestNodes::~NearestNodes() = default;
NearestNodes::NearestNodes(NearestNodes&&) noexcept = default;
NearestNodes& NearestNodes::operator=(NearestNodes&&) noexcept = default;

void NearestNodes::start(Point2 p, Node hint) {
  check_query(p);
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

}  // namespace delone::tripack
