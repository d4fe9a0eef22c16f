#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/buffer.hpp"

namespace delone::delaunay {

/// Row of the caller's arrays, counted from 0.
using Node = std::int32_t;

/// A different position, numbered along a space-filling curve: 0 .. num_sites - 1.
/// Neighbours in space are neighbours in memory, and the numbering depends on the set of
/// positions only.
using Site = std::int32_t;

inline constexpr std::int32_t none = -1;

/// A directed arc: slot `index` of the neighbour array, in the list of `origin`.
struct Arc {
  Site origin = none;
  std::int32_t index = none;
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// A triangulation as adjacency lists: for every site its neighbours in counter-clockwise
/// order.
///
/// A boundary site's list runs from one boundary neighbour to the other, so that the
/// region lies between consecutive neighbours and the outside after the last one. An
/// interior site's list is cyclic and begins with its smallest neighbour. Knows no
/// coordinates.
///
/// The triangle on the left of the arc v -> w is (v, w, x), x the neighbour of v after w.
/// Memory: 5 bytes a directed arc (4 neighbour, 1 place of the reverse arc) and 4 a site.
class Adjacency {
 public:
  /// Positions from here on do not fit into a byte and are kept apart.
  static constexpr std::int32_t far_reverse = 255;

  Adjacency() = default;

  /// From lists: `offsets` (num_sites + 1) into `neighbors`; `is_boundary` one flag a
  /// site. Throws Error if the lists are not symmetric.
  Adjacency(const std::vector<std::int32_t>& offsets, const std::vector<Site>& neighbors,
            std::vector<bool> is_boundary);

  /// Lists together with the place of every reverse arc, as a builder has them at hand.
  struct Lists {
    Buffer<std::int32_t> offsets;
    Buffer<Site> neighbors;
    std::vector<bool> is_boundary;
    Buffer<std::uint8_t>
        reverse;  ///< position of the origin in the target's list, at most 255
  };
  explicit Adjacency(Lists lists);

  /// Sites 0, 1, 2, ... joined in a row (`closed`: the last to the first as well), no
  /// triangles: the form of collinear points and of points on one great circle. All are
  /// boundary.
  enum class Chain : std::uint8_t { open, closed };
  [[nodiscard]] static Adjacency chain(Site num_sites, Chain kind);

  [[nodiscard]] Site num_sites() const noexcept {
    return offsets_.empty() ? 0 : static_cast<Site>(offsets_.size() - 1);
  }
  /// Directed arcs: twice the number of edges.
  [[nodiscard]] std::int32_t num_arcs() const noexcept {
    return static_cast<std::int32_t>(neighbors_.size());
  }
  [[nodiscard]] std::int32_t degree(Site v) const noexcept {
    return offsets_[index(v) + 1] - offsets_[index(v)];
  }
  [[nodiscard]] std::span<const Site> neighbors(Site v) const noexcept {
    return {neighbors_.data() + offsets_[index(v)], static_cast<std::size_t>(degree(v))};
  }
  [[nodiscard]] bool is_boundary(Site v) const noexcept { return is_boundary_[index(v)]; }

  /// The first arc of v's list; v must have a neighbour.
  [[nodiscard]] Arc first_arc(Site v) const noexcept { return {v, offsets_[index(v)]}; }
  [[nodiscard]] Site target(Arc a) const noexcept { return neighbors_[index(a.index)]; }
  /// Next arc counter-clockwise around the same origin, cyclically.
  [[nodiscard]] Arc next(Arc a) const noexcept {
    const std::int32_t i = a.index + 1;
    return {a.origin, i == offsets_[index(a.origin) + 1] ? offsets_[index(a.origin)] : i};
  }
  /// Next arc clockwise around the same origin, cyclically.
  [[nodiscard]] Arc previous(Arc a) const noexcept {
    const bool first = a.index == offsets_[index(a.origin)];
    return {a.origin, (first ? offsets_[index(a.origin) + 1] : a.index) - 1};
  }
  /// The same edge seen from its other end. Constant time.
  [[nodiscard]] Arc reverse(Arc a) const noexcept {
    const Site w = target(a);
    const std::int32_t position = reverse_[index(a.index)];
    return position != far_reverse ? Arc{w, offsets_[index(w)] + position}
                                   : find_far_reverse(a);
  }
  [[nodiscard]] bool is_chain() const noexcept { return is_chain_; }
  /// Is there a triangle on the left of `a`? False for the last arc of a boundary site,
  /// and in chains.
  [[nodiscard]] bool has_left(Arc a) const noexcept {
    return !is_boundary(a.origin) ||
           (a.index + 1 != offsets_[index(a.origin) + 1] && !is_chain_);
  }
  /// Corners of the triangle on the left of `a`, counter-clockwise, `a.origin` first.
  [[nodiscard]] std::array<Site, 3> left(Arc a) const noexcept {
    return {a.origin, target(a), target(next(a))};
  }
  /// Number of triangles, counted from the lists.
  [[nodiscard]] std::int64_t num_triangles() const noexcept;

  /// Calls `f(arc)` once a triangle, with the arc that leaves its smallest site and has
  /// the triangle on its left, in the order of sites.
  template <class F>
  void for_each_triangle(F f) const {
    for (Site v = 0; v < num_sites(); ++v) {
      for (std::int32_t i = offsets_[index(v)]; i < offsets_[index(v) + 1]; ++i) {
        const Arc a{v, i};
        if (neighbors_[index(i)] > v && has_left(a) && target(next(a)) > v) f(a);
      }
    }
  }

  friend bool operator==(const Adjacency&, const Adjacency&) = default;

 private:
  static std::size_t index(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] Arc find_far_reverse(Arc a) const noexcept;

  void note_far_reverses();

  Buffer<std::int32_t> offsets_;
  Buffer<Site> neighbors_;
  std::vector<bool> is_boundary_;
  bool is_chain_ = false;
  Buffer<std::uint8_t> reverse_;  // position in the target's list; 255: in far_
  // Reverses at position 255 and beyond (hubs), sorted by arc: (arc, index of its
  // reverse).
  std::vector<std::pair<std::int32_t, std::int32_t>> far_;
};

/// Renka's TRIPACK/STRIPACK form, 1-based as in Fortran: for node k, LEND(k) points at
/// its last neighbour, LPTR gives the next one cyclically, LIST(LEND(k)) < 0 marks a
/// boundary node.
struct RenkaLists {
  std::vector<std::int32_t> list, lptr, lend;
  std::int32_t lnew = 1;
};
[[nodiscard]] RenkaLists to_renka(const Adjacency& adjacency);
/// Throws Error if the pointers do not form lists.
[[nodiscard]] Adjacency from_renka(const RenkaLists& lists);

/// Where a query point lies, in the caller's rows.
struct Location {
  enum class Kind : std::uint8_t {
    node,      ///< at nodes[0]
    edge,      ///< strictly between nodes[0] and nodes[1]
    triangle,  ///< strictly inside nodes[0], nodes[1], nodes[2], counter-clockwise
    outside    ///< outside the triangulated region; nodes are `none`
  };
  Kind kind = Kind::outside;
  std::array<Node, 3> nodes{none, none, none};
};

}  // namespace delone::delaunay
