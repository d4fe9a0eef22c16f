#include "stripack/visible_neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "delaunay/visible_search.hpp"
#include "stripack/distance_order.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

double chord(const Direction& a, const Direction& b) {
  return std::sqrt(squared_chord(a, b));
}

// No point of an arc with the chord c is farther than this, in a straight line, from the
// nearer of its ends.
double chord_of_half(double c) {
  return c / std::sqrt(2 + std::sqrt(std::max(0.0, 4 - c * c)));
}

/// Positions, as delaunay/visible_search.hpp wants them.
class SphereSight {
 public:
  explicit SphereSight(std::span<const Direction> points) : points_(points) {}

  [[nodiscard]] int side(Site a, Site b, Site c) const {
    return orientation(point(a), point(b), point(c));
  }
  [[nodiscard]] double distance(Site a, Site b) const {
    return angle(point(a), point(b));
  }
  // By the triangle inequality in space. Lengths that are not exactly 1 and rounding make
  // up to 2^-50 and some units in the last place, here and in `distance`.
  [[nodiscard]] double least_distance(Site v, Site a, Site b) const {
    const Direction &p = point(v), &q = point(a), &r = point(b);
    const double to_end = std::min(chord(p, q), chord(p, r)) * (1 - 0x1p-48);
    const double least = to_end - chord_of_half(chord(q, r)) * (1 + 0x1p-48) - 0x1p-48;
    return 2 * std::asin(std::clamp(least / 2, 0.0, 1.0));
  }
  [[nodiscard]] bool is_before(Site a, Site b) const {
    return lexicographically_less(point(a), point(b));
  }

 private:
  [[nodiscard]] const Direction& point(Site v) const {
    return points_[static_cast<std::size_t>(v)];
  }

  std::span<const Direction> points_;
};

using Search = delaunay::VisibleSearch<SphereSight>;

Search search_of(const ConstrainedTriangulation& t) {
  return {t.mesh(), t.rows(), t.sites(), SphereSight(t.points())};
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

}  // namespace delone::stripack
