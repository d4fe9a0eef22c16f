#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/choose.hpp"
#include "delaunay/edge_rings.hpp"

namespace delone::delaunay {

/// Where blocks are built: half-edges, and the half-edge that leaves each site.
struct RingArrays {
  RingEdge* edges;
  std::int32_t* first;
};

/// The half-edges of a part of the sites while it is built: taken from a supply, put into
/// the rings around their origins, and given back. No branch depends on what nothing
/// foretells. `Tag` tells versions for different instruction sets apart.
template <class Tag>
class RingMesh {
 public:
  /// `supply` points at supplies that are used up one after the other.
  RingMesh(RingArrays arrays, EdgeSupply* supply)
      : edges_(arrays.edges), first_(arrays.first), supply_(supply) {}

  [[nodiscard]] EdgeSupply* supply() const noexcept { return supply_; }

 protected:
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  RingEdge& edge(std::int32_t e) const { return edges_[at(e)]; }
  std::int32_t next(std::int32_t e) const { return edge(e).next; }
  std::int32_t previous(std::int32_t e) const { return edge(e).previous; }
  Site origin(std::int32_t e) const { return edge(e ^ 1).target; }
  Site target(std::int32_t e) const { return edge(e).target; }
  std::int32_t& first(Site s) const { return first_[at(s)]; }

  std::int32_t take_edge(Site from, Site to) {
    if (next_edge() == supply_->end) [[unlikely]]
      skip_empty_supplies();
    const std::int32_t e = next_edge(), is_new = mask(supply_->freed == none);
    supply_->unused -= 2 * is_new;
    supply_->freed = next(e) | is_new;  // none where there was none
    edge(e).target = to;
    edge(e ^ 1).target = from;
    return e;
  }

  void set_alone(std::int32_t e) { edge(e).next = edge(e).previous = e; }
  // Into the ring just before `after`.
  void put_before(std::int32_t e, std::int32_t after) {
    put_between(e, previous(after), after);
  }
  void put_into_wedge(std::int32_t e, std::int32_t hull_edge) {
    if (hull_edge == none) {
      set_alone(e);
    } else {
      put_before(e, hull_edge);
    }
  }

  void unlink(std::int32_t e) {
    const std::int32_t after = next(e), before = previous(e);
    const Site from = origin(e);
    edge(after).previous = before;
    edge(before).next = after;
    const std::int32_t left = after | mask(after == e);
    first(from) = choose(first(from) == e, left, first(from));
  }
  void remove(std::int32_t e) {
    unlink(e);
    unlink(e ^ 1);
    e &= ~1;
    edge(e).target = edge(e ^ 1).target = none;
    edge(e).next = supply_->freed;
    supply_->freed = e;
  }

  void put_between(std::int32_t e, std::int32_t before, std::int32_t after) {
    edge(e).next = after;
    edge(e).previous = before;
    edge(before).next = e;
    edge(after).previous = e;
  }
  std::int32_t connect_alone(Site a, Site b) {
    const std::int32_t e = take_edge(a, b);
    set_alone(e);
    set_alone(e ^ 1);
    return e;
  }
  void pair(std::int32_t e, std::int32_t f) {
    edge(e).next = edge(e).previous = f;
    edge(f).next = edge(f).previous = e;
  }
  void ring(std::int32_t e, std::int32_t f, std::int32_t g) {
    edge(e).next = f, edge(f).next = g, edge(g).next = e;
    edge(e).previous = g, edge(f).previous = e, edge(g).previous = f;
  }

 private:
  // A freed one, if there is any, or else the first that was never used, which may be the
  // end.
  [[nodiscard]] std::int32_t next_edge() const {
    return choose(supply_->freed == none, supply_->unused, supply_->freed);
  }
  void skip_empty_supplies() {
    while (supply_->freed == none && supply_->unused == supply_->end) ++supply_;
  }

  RingEdge* edges_;
  std::int32_t* first_;
  EdgeSupply* supply_;
};

}  // namespace delone::delaunay
