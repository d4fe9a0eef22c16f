#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/blend_space.hpp"
#include "interp/index.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

/// A node around another.
struct StencilNode {
  Site site = none;
  double squared_distance = 0;
  bool is_neighbor = false;  ///< joined to it by an edge
};

/// Who is joined to whom, counter-clockwise; at the boundary from one boundary neighbour
/// to the other.
template <class T>
concept NeighborGraph = requires(const T& graph, Site s) {
  { graph.neighbors(s) } -> std::convertible_to<std::span<const Site>>;
  { graph.degree(s) } -> std::convertible_to<std::int32_t>;
};

/// Nodes of a stencil at most.
inline constexpr std::size_t most_stencil_nodes = 64;

/// The nodes around a node that a local fit is made from: two rings of neighbours, and
/// the nearest ones beyond them. Rings alone miss the other points of a cluster; the
/// nearest alone lie all on one side of a node at the edge of a gap.
///
/// A hub contributes the part of its neighbours that faces the node, and at most
/// `most_stencil_nodes` nearest ones are kept, so the cost of a node is bounded.
/// Deterministic; one object a thread, for its memory. The graph is the triangulation's
/// adjacency, or what it becomes without a site.
template <BlendSpace Space, NeighborGraph Graph = Adjacency>
class StencilGatherer {
 public:
  StencilGatherer(const Space& space, const typename Space::Triangulation& triangulation)
      : StencilGatherer(space, triangulation, triangulation.adjacency()) {}
  StencilGatherer(const Space& space, const typename Space::Triangulation& triangulation,
                  const Graph& graph)
      : StencilGatherer(space, triangulation.points(), graph) {}
  StencilGatherer(const Space& space, std::span<const typename Space::Point> points,
                  const Graph& graph)
      : space_(space), points_(points), adjacency_(&graph) {}

  /// At least `num_nearest` nodes if there are as many within three rings. The span is
  /// good until the next call.
  [[nodiscard]] std::span<const StencilNode> around(Site center,
                                                    std::size_t num_nearest) {
    return around_without(none, {}, center, num_nearest);
  }
  /// The same once a site is removed, in whose place lies a triangle or edge of
  /// `joined` sites: neighbours of each other from then on. What else changes in the
  /// hole is left out of account.
  [[nodiscard]] std::span<const StencilNode> around_without(Site removed,
                                                            std::span<const Site> joined,
                                                            Site center,
                                                            std::size_t num_nearest) {
    begin(center);
    if (removed != none) static_cast<void>(is_new(removed));
    for (const Site s : joined) add(s, true);
    add_neighbors(center, none, true);
    keep_nearest(most_stencil_nodes);
    const std::size_t num_first = nodes_.size();
    for (std::size_t k = 0; k < num_first; ++k)
      add_neighbors(nodes_[k].site, center, false);
    add_third_ring(num_first, num_nearest);
    keep_nearest(most_stencil_nodes);
    return nodes_;
  }

 private:
  static constexpr double everywhere = std::numeric_limits<double>::infinity();
  static constexpr std::int32_t whole_list = 32, part_of_list = 12;
  static constexpr std::size_t table_size = 1024;

  void begin(Site center) {
    for (const std::size_t slot : used_) table_[slot] = none;
    used_.clear();
    nodes_.clear();
    center_ = center;
    origin_ = space_.vector(points_[at(center)]);
    static_cast<void>(is_new(center));
  }

  // A small hash table by open addressing; when it is full, nothing is new any more.
  bool is_new(Site s) {
    if (used_.size() * 2 > table_size) return false;
    std::size_t slot = static_cast<std::uint32_t>(s) * 2654435761u >> 22;
    for (; table_[slot] != none; slot = (slot + 1) % table_size)
      if (table_[slot] == s) return false;
    table_[slot] = s;
    used_.push_back(slot);
    return true;
  }

  // What lies beyond the reach (squared) is looked at once and left out.
  void add(Site s, bool is_neighbor, double reach = everywhere) {
    if (!is_new(s)) return;
    const auto d = Space::difference(space_.vector(points_[at(s)]), origin_);
    const double squared_distance = Space::dot(d, d);
    if (squared_distance > reach) return;
    nodes_.push_back({s, squared_distance, is_neighbor});
  }

  // Of a long list the part around the arc back to `facing`.
  void add_neighbors(Site s, Site facing, bool is_neighbor, double reach = everywhere) {
    const auto all = adjacency_->neighbors(s);
    if (facing == none || adjacency_->degree(s) <= whole_list) {
      for (const Site w : all) add(w, is_neighbor, reach);
      return;
    }
    const auto size = static_cast<std::ptrdiff_t>(all.size());
    const auto here = std::find(all.begin(), all.end(), facing) - all.begin();
    for (std::ptrdiff_t k = -part_of_list / 2; k <= part_of_list / 2; ++k)
      add(all[static_cast<std::size_t>((here + k + size) % size)], is_neighbor, reach);
  }

  // Of the third ring only what is among the nearest wanted.
  void add_third_ring(std::size_t num_first, std::size_t num_nearest) {
    const std::size_t num_second = nodes_.size();
    const double reach = distance_of_nearest(num_nearest);
    for (std::size_t k = num_first; k < num_second; ++k) {
      if (nodes_[k].squared_distance < reach)
        add_neighbors(nodes_[k].site, center_, false, reach);
    }
    if (nodes_.size() == num_second) return;
    const double limit = distance_of_nearest(num_nearest);
    const auto is_far = [&](const StencilNode& n) { return n.squared_distance > limit; };
    nodes_.erase(std::remove_if(nodes_.begin() + static_cast<std::ptrdiff_t>(num_second),
                                nodes_.end(), is_far),
                 nodes_.end());
  }

  // Squared, of the nearest so many; infinite if there are fewer.
  [[nodiscard]] double distance_of_nearest(std::size_t count) {
    if (count == 0) return 0;
    if (nodes_.size() < count) return everywhere;
    distances_.clear();
    for (const StencilNode& n : nodes_) distances_.push_back(n.squared_distance);
    const auto last = distances_.begin() + static_cast<std::ptrdiff_t>(count) - 1;
    std::nth_element(distances_.begin(), last, distances_.end());
    return *last;
  }

  void keep_nearest(std::size_t most) {
    if (nodes_.size() <= most) return;
    const auto is_nearer = [](const StencilNode& a, const StencilNode& b) {
      return a.squared_distance < b.squared_distance ||
             (a.squared_distance == b.squared_distance && a.site < b.site);
    };
    std::nth_element(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(most),
                     nodes_.end(), is_nearer);
    nodes_.resize(most);
    std::sort(nodes_.begin(), nodes_.end(), is_nearer);
  }

  Space space_;
  std::span<const typename Space::Point> points_;
  const Graph* adjacency_;
  Site center_ = none;
  typename Space::Vector origin_{};
  std::vector<StencilNode> nodes_;
  std::vector<double> distances_;
  std::vector<std::size_t> used_;
  std::array<Site, table_size> table_ = filled();
  static constexpr std::array<Site, table_size> filled() {
    std::array<Site, table_size> all{};
    all.fill(none);
    return all;
  }
};

}  // namespace delone::interp
