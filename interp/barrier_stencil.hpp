#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "interp/barrier_space.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

/// Wedges joined by edges of the domain, counter-clockwise from one barrier of each to
/// the other: a NeighborGraph with a number for every wedge.
template <BlendSpace Space>
class WedgeGraph {
 public:
  explicit WedgeGraph(const BarrierMeshIn<Space>& mesh);

  [[nodiscard]] std::span<const Wedge> neighbors(Wedge w) const noexcept {
    return std::span(neighbors_)
        .subspan(static_cast<std::size_t>(offsets_[at(w)]),
                 static_cast<std::size_t>(degree(w)));
  }
  [[nodiscard]] std::int32_t degree(Wedge w) const noexcept {
    return offsets_[at(w) + 1] - offsets_[at(w)];
  }
  /// Positions of all wedges.
  [[nodiscard]] std::span<const typename Space::Point> points() const noexcept {
    return points_;
  }
  /// Does a curve (or the end of the domain) go through its site?
  [[nodiscard]] bool is_on_barrier(Wedge w) const noexcept { return on_barrier_[at(w)]; }
  /// The connected part of the domain that a wedge belongs to, from 0.
  [[nodiscard]] std::int32_t part(Wedge w) const noexcept { return parts_[at(w)]; }
  [[nodiscard]] std::int32_t num_parts() const noexcept { return num_parts_; }

  /// Does a wedge on a barrier hold the direction to `p`, its two barriers included?
  [[nodiscard]] bool holds_direction(Wedge w,
                                     const typename Space::Point& p) const noexcept;

 private:
  void number_parts();

  std::vector<std::int32_t> offsets_;
  std::vector<Wedge> neighbors_;
  std::vector<typename Space::Point> points_;
  std::vector<bool> on_barrier_;
  std::vector<std::int32_t> parts_;
  std::int32_t num_parts_ = 0;
};

/// The nodes around a wedge that a local fit is made from: a StencilGatherer's over the
/// graph of wedges, of these only what the wedge sees. The straight line to a node may
/// touch barriers but not cross one; judged, exactly, by the barriers at the stencil's
/// own nodes.
template <BlendSpace Space>
class WedgeStencils {
 public:
  WedgeStencils(const Space& space, const WedgeGraph<Space>& graph)
      : graph_(graph), gatherer_(space, graph.points(), graph), space_(space) {}

  /// The span is good until the next call.
  [[nodiscard]] std::span<const StencilNode> around(Wedge center,
                                                    std::size_t num_nearest);

 private:
  using Point = typename Space::Point;

  [[nodiscard]] bool sees(Wedge from, Wedge to) const;
  [[nodiscard]] bool is_blocked(Wedge from, Wedge to, Wedge by) const;
  [[nodiscard]] bool is_between(const Point& p, const Point& a, const Point& b) const;
  [[nodiscard]] const Point& point(Wedge w) const noexcept {
    return graph_.points()[at(w)];
  }

  const WedgeGraph<Space>& graph_;
  StencilGatherer<Space, WedgeGraph<Space>> gatherer_;
  Space space_;
  std::vector<StencilNode> seen_;
  std::vector<Wedge> barriers_;
};

extern template class WedgeGraph<PlaneSpace>;
extern template class WedgeGraph<SphereSpace>;
extern template class WedgeStencils<PlaneSpace>;
extern template class WedgeStencils<SphereSpace>;

}  // namespace delone::interp
