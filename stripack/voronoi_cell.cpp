#include "stripack/voronoi_cell.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace delone::stripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

CellNeighbors::CellNeighbors(const Triangulation& t, const BackFaces& back)
    : adjacency_(&t.adjacency()) {
  const Site n = t.num_sites();
  const bool is_chain = t.dimension() < 2;
  if (!is_chain && back.faces().empty()) return;
  place_.assign(at(n), none);
  for (Site s = 0; s < n; ++s) {
    if (!is_chain && !adjacency_->is_boundary(s)) continue;
    place_[at(s)] = static_cast<std::int32_t>(offsets_.size()) - 1;
    if (is_chain) {
      if (n > 1) lists_.push_back((s + 1) % n);
      if (n > 2) lists_.push_back((s + n - 1) % n);
    } else {
      const auto front = adjacency_->neighbors(s), behind = back.neighbors(s);
      lists_.insert(lists_.end(), front.begin(), front.end());
      lists_.insert(lists_.end(), behind.begin(), behind.end());
    }
    offsets_.push_back(static_cast<std::int32_t>(lists_.size()));
  }
}

std::span<const Site> CellNeighbors::operator()(Site s) const noexcept {
  const std::int32_t place = place_.empty() ? none : place_[at(s)];
  if (place == none) return adjacency_->neighbors(s);
  const std::int32_t begin = offsets_[at(place)];
  return {lists_.data() + begin, at(offsets_[at(place) + 1] - begin)};
}

// rise = 2 sin^2 of half the distance. Towards a site opposite to this one every way is
// as good as another.
Bisector::Bisector(const Spoke& spoke) noexcept {
  constexpr double underflow = 0x1p-900;
  const bool is_tiny = spoke.rise < underflow;
  const double tangential =
      is_tiny ? std::hypot(spoke.x, spoke.y) : std::sqrt(spoke.square);
  sin_ = is_tiny ? tangential / 2 : std::sqrt(spoke.rise / 2);
  cos_ = spoke.rise > 1 ? tangential / (2 * sin_) : std::sqrt(1 - spoke.rise / 2);
  east_ = tangential > 0 ? spoke.x / tangential : 1;
  north_ = tangential > 0 ? spoke.y / tangential : 0;
  tan_half_ = sin_ / (1 + cos_);
}

Bisector::Place Bisector::place(const LocalVector& c) const noexcept {
  const double along = c.up * cos_ + (c.x * east_ + c.y * north_) * sin_,
               across = c.y * east_ - c.x * north_;
  const double length = std::hypot(along, across);
  return length > 0 ? Place{along / length, across / length} : Place{};
}

LocalVector Bisector::point(Place place) const noexcept {
  return {place.cos * cos_, place.cos * sin_ * east_ - place.sin * north_,
          place.cos * sin_ * north_ + place.sin * east_};
}

// A right triangle with legs p (to the foot) and q: tan(E/2) = tan(p/2) tan(q/2).
Bisector::HalfExcess Bisector::half_excess(Place place) const noexcept {
  if (place.cos >= 0) return {1 + place.cos, tan_half_ * place.sin};
  const double sign = place.sin >= 0 ? 1 : -1;
  return {std::abs(place.sin), sign * tan_half_ * (1 - place.cos)};
}

// Two ends of an edge that are one point but for rounding may also come in the wrong
// order.
bool passes_the_far_side(Bisector::Place from, Bisector::Place to) noexcept {
  const auto is_up = [](Bisector::Place p) {
    return p.sin > 0 || (p.sin == 0 && p.cos < 0);
  };
  if (is_up(from) == is_up(to)) return false;
  const double sin_of_way = to.sin * from.cos - to.cos * from.sin,
               cos_of_way = to.cos * from.cos + to.sin * from.sin;
  const bool goes_forward = sin_of_way > 0 || cos_of_way < 0;
  return is_up(from) == goes_forward;
}

double length_between(Bisector::Place from, Bisector::Place to) noexcept {
  const double length = std::atan2(to.sin * from.cos - to.cos * from.sin,
                                   to.cos * from.cos + to.sin * from.sin);
  if (length < -std::numbers::pi / 2) return length + 2 * std::numbers::pi;
  return std::max(length, 0.0);
}

}  // namespace delone::stripack
