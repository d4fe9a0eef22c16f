#include "tripack/visible_neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "delaunay/visible_search.hpp"
#include "tripack/distance_order.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

double beyond(double v, double a, double b) {
  return std::max({0.0, std::min(a, b) - v, v - std::max(a, b)});
}

/// Positions, as delaunay/visible_search.hpp wants them.
class PlaneSight {
 public:
  explicit PlaneSight(std::span<const Point2> points) : points_(points) {}

  [[nodiscard]] int side(Site a, Site b, Site c) const {
    return orientation(point(a), point(b), point(c));
  }
  [[nodiscard]] double distance(Site a, Site b) const {
    return tripack::distance(point(a), point(b));
  }
  // To the box around the edge.
  [[nodiscard]] double least_distance(Site v, Site a, Site b) const {
    const Point2 p = point(v), q = point(a), r = point(b);
    return std::hypot(beyond(p.x, q.x, r.x), beyond(p.y, q.y, r.y)) * (1 - 0x1p-50);
  }
  [[nodiscard]] bool is_before(Site a, Site b) const {
    return lexicographically_less(point(a), point(b));
  }

 private:
  [[nodiscard]] Point2 point(Site v) const {
    return points_[static_cast<std::size_t>(v)];
  }

  std::span<const Point2> points_;
};

using Search = delaunay::VisibleSearch<PlaneSight>;

Search search_of(const ConstrainedTriangulation& t) {
  return {t.mesh(), t.rows(), t.sites(), PlaneSight(t.points())};
}

}  // namespace

struct VisibleNodes::State {
  Search search;
};

VisibleNodes::VisibleNodes(const ConstrainedTriangulation& t)
    : state_(new State{search_of(t)}) {}
VisibleNodes::~VisibleNodes() = default;
VisibleNodes::VisibleNodes(VisibleNodes&&) noexcept = default;
VisibleNodes& VisibleNodes::operator=(VisibleNodes&&) noexcept = default;

void VisibleNodes::start(Node row) { state_->search.start(row); }

std::optional<PathNeighbor> VisibleNodes::next() { return state_->search.next(); }

std::vector<PathNeighbor> nearest_k_visible(const ConstrainedTriangulation& t, Node row,
                                            std::int32_t k) {
  return search_of(t).nearest(row, k);
}

}  // namespace delone::tripack
