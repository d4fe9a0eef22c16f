#include "interp/barrier_stencil.hpp"

#include <algorithm>

namespace delone::interp {

using delaunay::none;

template <BlendSpace Space>
WedgeGraph<Space>::WedgeGraph(const BarrierMeshIn<Space>& mesh) {
  offsets_.push_back(0);
  for (Wedge w = 0; w < mesh.num_wedges(); ++w) {
    mesh.for_each_neighbor(w, [&](Wedge v) { neighbors_.push_back(v); });
    offsets_.push_back(static_cast<std::int32_t>(neighbors_.size()));
    points_.push_back(mesh.point_of(w));
    const HalfEdge first = mesh.first_edge(w);
    on_barrier_.push_back(first != none && mesh.is_barrier(first));
  }
  number_parts();
}

template <BlendSpace Space>
void WedgeGraph<Space>::number_parts() {
  parts_.assign(points_.size(), none);
  std::vector<Wedge> open;
  for (Wedge w = 0; w < static_cast<Wedge>(points_.size()); ++w) {
    if (parts_[at(w)] != none || degree(w) == 0) continue;
    parts_[at(w)] = num_parts_;
    open.push_back(w);
    while (!open.empty()) {
      const Wedge next = open.back();
      open.pop_back();
      for (const Wedge v : neighbors(next)) {
        if (parts_[at(v)] != none) continue;
        parts_[at(v)] = num_parts_;
        open.push_back(v);
      }
    }
    ++num_parts_;
  }
}

template <BlendSpace Space>
bool WedgeGraph<Space>::holds_direction(Wedge w,
                                        const typename Space::Point& p) const noexcept {
  const auto around = neighbors(w);
  const auto &center = points_[at(w)], &first = points_[at(around.front())],
             &last = points_[at(around.back())];
  const int turn = orientation(center, first, last);
  const bool is_after_first = orientation(center, first, p) >= 0,
             is_before_last = orientation(center, last, p) <= 0;
  if (turn > 0) return is_after_first && is_before_last;
  if (turn < 0) return is_after_first || is_before_last;
  // Straight through, or the end of a curve, which sees all round.
  return first == last || is_after_first;
}

template <BlendSpace Space>
std::span<const StencilNode> WedgeStencils<Space>::around(Wedge center,
                                                          std::size_t num_nearest) {
  const std::span<const StencilNode> all = gatherer_.around(center, num_nearest);
  barriers_.clear();
  for (const StencilNode& n : all)
    if (graph_.is_on_barrier(n.site)) barriers_.push_back(n.site);
  if (graph_.is_on_barrier(center)) barriers_.push_back(center);
  if (barriers_.empty()) return all;
  seen_.clear();
  std::copy_if(
      all.begin(), all.end(), std::back_inserter(seen_),
      [&](const StencilNode& n) { return n.is_neighbor || sees(center, n.site); });
  return seen_;
}

template <BlendSpace Space>
bool WedgeStencils<Space>::sees(Wedge from, Wedge to) const {
  const Point &a = point(from), &b = point(to);
  if (a == b) return false;  // another side of the same vertex
  if (graph_.is_on_barrier(from) && !graph_.holds_direction(from, b)) return false;
  if (graph_.is_on_barrier(to) && !graph_.holds_direction(to, a)) return false;
  return std::none_of(barriers_.begin(), barriers_.end(),
                      [&](Wedge by) { return is_blocked(from, to, by); });
}

// At `by` itself, or across one of the two barriers that leave it.
template <BlendSpace Space>
bool WedgeStencils<Space>::is_blocked(Wedge from, Wedge to, Wedge by) const {
  const Point &a = point(from), &b = point(to), &p = point(by);
  if (p == a || p == b) return false;
  const int side = orientation(a, b, p);
  if (side == 0) {
    return is_between(p, a, b) &&
           !(graph_.holds_direction(by, a) && graph_.holds_direction(by, b));
  }
  const auto around = graph_.neighbors(by);
  for (const Wedge end : {around.front(), around.back()}) {
    const Point& q = point(end);
    if (q == a || q == b || orientation(a, b, q) != -side) continue;
    if (orientation(p, q, a) * orientation(p, q, b) < 0) return true;
  }
  return false;
}

// Of points in line.
template <BlendSpace Space>
bool WedgeStencils<Space>::is_between(const Point& p, const Point& a,
                                      const Point& b) const {
  const auto along = [&](const Point& from, const Point& to) {
    const auto origin = space_.vector(from);
    return Space::dot(Space::difference(space_.vector(p), origin),
                      Space::difference(space_.vector(to), origin)) > 0;
  };
  return along(a, b) && along(b, a);
}

template class WedgeGraph<PlaneSpace>;
template class WedgeGraph<SphereSpace>;
template class WedgeStencils<PlaneSpace>;
template class WedgeStencils<SphereSpace>;

}  // namespace delone::interp
