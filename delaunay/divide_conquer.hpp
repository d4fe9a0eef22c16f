#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/edge_rings.hpp"
#include "delaunay/lanes.hpp"
#include "delaunay/site_order.hpp"

namespace delone::delaunay {

/// The sites of a block that are furthest along either chart coordinate.
struct Extremes {
  Site low_u, high_u, low_v, high_v;
};

/// Where blocks are built: half-edges, and the half-edge that leaves each site.
struct RingArrays {
  RingEdge* edges;
  std::int32_t* first;
};

/// Delaunay triangulations of blocks of sites: small ones directly, larger ones by
/// merging their halves.
///
/// The halves are parted by a line (a great circle), so the merge begins at their lower
/// common tangent and rises: see `zip`. Hulls are never walked from end to end: `first`
/// of a hull site is its hull edge, counter-clockwise, and the search for the tangent
/// begins at the two sites that face each other. All of it is topology and exact signs;
/// rounding is the geometry's business, which answers for four candidates at once with
/// bounds
/// (`lanes`, `circle_error`) and exactly for what these leave open.
///
/// `Geometry`: tripack::PlaneLanes, stripack::SphereLanes. No function from the standard
/// library is called here, see instruction_set.hpp. Recursion is as deep as keys have
/// bits (32 a curve, at most 130 curves inside one another).
///
/// Source: L. Guibas, J. Stolfi, ACM Trans. Graph. 4 (1985) 74-123.
template <class Geometry>
class DivideConquer {
 public:
  /// `supply` points at supplies that are used up one after the other.
  DivideConquer(const Geometry& geometry, RingArrays arrays, EdgeSupply* supply)
      : g_(geometry), edges_(arrays.edges), first_(arrays.first), supply_(supply) {}

  /// The sites begin .. end - 1.
  Extremes build(BlockKeys keys, Site begin, Site end) {
    switch (end - begin) {
      case 1:
        return build_one(begin);
      case 2:
        return build_two(begin, begin + 1);
      case 3:
        return build_three(begin);
      default:
        break;
    }
    if (keys[begin] == keys[end - 1]) [[unlikely]]
      keys = keys.inside(begin, end);
    const Site middle = middle_of(keys, begin, end);
    const Extremes left = build(keys, begin, middle);
    const Extremes right = build(keys, middle, end);
    return merge(left, right);
  }

  [[nodiscard]] EdgeSupply* supply() const noexcept { return supply_; }

  /// Two blocks become one.
  Extremes merge(const Extremes& p, const Extremes& q) {
    const std::int32_t last = zip(lower_tangent(facing(p, q)));
    first(target(last)) = last ^ 1;
    first(origin(last)) = next(last);
    return {g_.less_u(q.low_u, p.low_u) ? q.low_u : p.low_u,
            g_.less_u(p.high_u, q.high_u) ? q.high_u : p.high_u,
            g_.less_v(q.low_v, p.low_v) ? q.low_v : p.low_v,
            g_.less_v(p.high_v, q.high_v) ? q.high_v : p.high_v};
  }

  /// What became of two halves of the sphere.
  struct Closed {
    bool is_certain;    ///< false: the start could not be told with rounded numbers
    std::int32_t hull;  ///< a hull edge, or none if the sphere is covered
  };

  /// Joins two blocks, either within an open half of the sphere, that a great circle
  /// parts. They may face each other all round, so that there is no tangent to start
  /// from. The gap is filled upwards and downwards from an edge of the result: one whose
  /// diametral disc holds no site.
  Closed close(Site a, Site b) {
    const EmptyDisc disc = find_empty_disc(a, b);
    if (!disc.is_certain) return {false, none};
    return close_from(disc.a, disc.b);
  }

 private:
  static constexpr std::int32_t unclear = -2;

  Closed close_from(Site a, Site b) {
    const std::int32_t at_a = open_towards(a, b), at_b = open_towards(b, a);
    if (at_a == unclear || at_b == unclear) return {false, none};
    const std::int32_t base = take_edge(a, b);
    put_into_wedge(base, at_a);
    put_into_wedge(base ^ 1, at_b);
    if (first(a) == none) first(a) = base;
    if (first(b) == none) first(b) = base ^ 1;
    const std::int32_t top = zip(base);
    if (is_last_of_gap(top)) return {true, none};
    zip(base ^ 1);
    return {true, top ^ 1};
  }

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  RingEdge& edge(std::int32_t e) const { return edges_[at(e)]; }
  std::int32_t next(std::int32_t e) const { return edge(e).next; }
  std::int32_t previous(std::int32_t e) const { return edge(e).previous; }
  Site origin(std::int32_t e) const { return edge(e).origin; }
  Site target(std::int32_t e) const { return edge(e ^ 1).origin; }
  std::int32_t& first(Site s) const { return first_[at(s)]; }

  // Edges.

  std::int32_t take_edge(Site from, Site to) {
    while (supply_->freed == none && supply_->unused == supply_->end) ++supply_;
    std::int32_t e = supply_->freed;
    if (e != none) {
      supply_->freed = edge(e).next;
    } else {
      e = supply_->unused;
      supply_->unused += 2;
    }
    edge(e).origin = from;
    edge(e ^ 1).origin = to;
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
    const RingEdge gone = edge(e);
    edge(gone.next).previous = gone.previous;
    edge(gone.previous).next = gone.next;
    if (first(gone.origin) == e) first(gone.origin) = gone.next == e ? none : gone.next;
  }
  void remove(std::int32_t e) {
    unlink(e);
    unlink(e ^ 1);
    e &= ~1;
    edge(e).origin = edge(e ^ 1).origin = none;
    edge(e).next = supply_->freed;
    supply_->freed = e;
  }

  // Leaves.

  Extremes build_one(Site s) {
    first(s) = none;
    return {s, s, s, s};
  }
  std::int32_t connect_alone(Site a, Site b) {
    const std::int32_t e = take_edge(a, b);
    set_alone(e);
    set_alone(e ^ 1);
    return e;
  }
  Extremes build_two(Site a, Site b) {
    const std::int32_t e = connect_alone(a, b);
    first(a) = e;
    first(b) = e ^ 1;
    return with({a, a, a, a}, b);
  }
  Extremes with(Extremes x, Site s) const {
    if (g_.less_u(s, x.low_u)) x.low_u = s;
    if (g_.less_u(x.high_u, s)) x.high_u = s;
    if (g_.less_v(s, x.low_v)) x.low_v = s;
    if (g_.less_v(x.high_v, s)) x.high_v = s;
    return x;
  }

  Extremes build_three(Site a) {
    Site b = a + 1, c = a + 2;
    const Extremes x = with(with({a, a, a, a}, b), c);
    const int side = g_.orientation(a, b, c);
    if (side == 0) {
      const Site p = x.low_u, r = x.high_u;  // the ends of the line
      const Site q = a + b + c - p - r;
      chain(p, q, r);
      return x;
    }
    if (side < 0) {
      const Site t = b;
      b = c;
      c = t;
    }
    const std::int32_t ab = take_edge(a, b), bc = take_edge(b, c), ca = take_edge(c, a);
    pair(ab, ca ^ 1);
    pair(bc, ab ^ 1);
    pair(ca, bc ^ 1);
    first(a) = ab;
    first(b) = bc;
    first(c) = ca;
    return x;
  }
  void pair(std::int32_t e, std::int32_t f) {
    edge(e).next = edge(e).previous = f;
    edge(f).next = edge(f).previous = e;
  }
  void chain(Site p, Site q, Site r) {
    const std::int32_t pq = take_edge(p, q), qr = take_edge(q, r);
    set_alone(pq);
    pair(pq ^ 1, qr);
    set_alone(qr ^ 1);
    first(p) = pq;
    first(q) = qr;
    first(r) = qr ^ 1;
  }

  // Merging.

  /// Sites on the hulls of the two blocks that face each other.
  struct Facing {
    Site left, right;
  };
  Facing facing(const Extremes& p, const Extremes& q) const {
    if (g_.less_u(p.high_u, q.low_u)) return {p.high_u, q.low_u};
    if (g_.less_v(p.high_v, q.low_v)) return {p.high_v, q.low_v};
    if (g_.less_u(q.high_u, p.low_u)) return {p.low_u, q.high_u};
    return {p.low_v, q.high_v};
  }

  std::int32_t lower_tangent(Facing f) {
    auto [l, r] = f;
    std::int32_t left = first(l), right = first(r);
    for (bool moved = true; moved;) {
      moved = false;
      while (left != none) {
        const std::int32_t to = previous(left);  // l -> its clockwise hull neighbour
        if (g_.orientation(l, r, target(to)) >= 0) break;
        l = target(to);
        left = to ^ 1;  // hull edge u -> l; hull edge leaving u
        moved = true;
      }
      while (right != none) {
        const Site w = target(right);
        if (g_.orientation(l, r, w) >= 0) break;
        right = next(right ^ 1);
        r = w;
        moved = true;
      }
    }
    const std::int32_t base = take_edge(l, r);
    put_into_wedge(base, left);
    put_into_wedge(base ^ 1, right);
    first(l) = base;
    first(r) = right == none ? base ^ 1 : right;
    return base;
  }

  enum Action : unsigned { done, take_left, take_right, drop_left, drop_right };

  /// Fills the gap above the base a -> b between a block on its left and one on its
  /// right: of the circles through a and b and a site of either block above the base, the
  /// one that holds no other site makes a triangle, whose third edge is the next base.
  /// Edges in its way go. Gives the last base: above it is nothing but the outside, or,
  /// if the blocks go round the sphere, the triangle that closes the gap.
  std::int32_t zip(std::int32_t base) {
    Site a = origin(base), b = target(base);
    std::int32_t c = next(base), d = previous(base ^ 1);
    typename Geometry::Base line = g_.base(a, b);
    for (;;) {
      const std::int32_t c_next = next(c), d_next = previous(d);
      const Site s[4] = {target(c), target(c_next), target(d), target(d_next)};
      const Action action = decide(line, a, b, s);
      if (action == take_right) {
        if (Geometry::can_close && s[0] == s[2]) break;
        const std::int32_t e = take_edge(a, s[2]);
        const std::int32_t to_b = d ^ 1;
        d = previous(to_b);
        put_between(e, base, c);
        put_between(e ^ 1, d, to_b);
        base = e;
        b = s[2];
        line = g_.base(a, b);
      } else if (action == take_left) {
        if (Geometry::can_close && s[0] == s[2]) break;
        const std::int32_t e = take_edge(s[0], b);
        const std::int32_t to_a = c ^ 1;
        c = next(to_a);
        put_between(e, to_a, c);
        put_between(e ^ 1, d, base ^ 1);
        base = e;
        a = s[0];
        line = g_.base(a, b);
      } else if (action == drop_left) {
        remove(c);
        c = c_next;
      } else if (action == drop_right) {
        remove(d);
        d = d_next;
      } else {
        break;
      }
    }
    return base;
  }

  // Is there a triangle on the left of a half-edge?
  [[nodiscard]] bool is_last_of_gap(std::int32_t e) const {
    const std::int32_t on = previous(e ^ 1), back = previous(on ^ 1);
    return target(back) == origin(e) &&
           g_.orientation(origin(e), target(e), target(on)) > 0;
  }

  struct EmptyDisc {
    Site a, b;
    bool is_certain;
  };
  /// Moves a and b nearer to one another until the disc with diameter ab holds no site.
  /// If it holds one, it holds one next to a or next to b, and that is nearer to the
  /// other. Uncertain if rounding lets them go round in circles.
  EmptyDisc find_empty_disc(Site a, Site b) const {
    constexpr int patience = 1 << 14;
    for (int moves = 0; moves < patience; ++moves) {
      const Site near_b = nearer(a, b), near_a = nearer(b, a);
      if (near_b == a && near_a == b) return {a, b, true};
      if (near_b != a) {
        a = near_b;
      } else {
        b = near_a;
      }
    }
    return {a, b, false};
  }
  // A neighbour of a that is not certainly outside of the disc; a if there is none.
  [[nodiscard]] Site nearer(Site a, Site b) const {
    const std::int32_t start = first(a);
    if (start == none) return a;
    std::int32_t e = start;
    do {
      if (!g_.is_outside_disc(a, b, target(e))) return target(e);
      e = next(e);
    } while (e != start);
    return a;
  }

  /// Removes what the arc from a to b, which lies outside of a's block, crosses on its
  /// way out, and gives the half-edge of a before which a -> b belongs; none if a is
  /// alone.
  std::int32_t open_towards(Site a, Site b) {
    const std::int32_t e = wedge_towards(a, b);
    if (e == none || e == unclear) return e;
    const std::int32_t after = next(e);
    std::int32_t across = previous(e ^ 1);  // p -> q, opposite to a
    if (target(across) != target(after) ||
        g_.orientation(a, target(e), target(after)) <= 0)
      return after;
    for (bool is_inside = true; is_inside;) {
      const Site p = origin(across), q = target(across);
      const std::int32_t to_r = previous(across), on = previous(to_r ^ 1);
      const Site r = target(to_r);
      is_inside = target(on) == q && g_.orientation(p, r, q) > 0;
      remove(across);
      across = g_.orientation(a, b, r) > 0 ? to_r : on;
    }
    return after;
  }

  // The half-edge e of a such that a -> b comes between e and the next one.
  std::int32_t wedge_towards(Site a, Site b) const {
    const std::int32_t start = first(a);
    if (start == none) return none;
    std::int32_t e = start;
    do {
      if (is_between(a, target(e), b, target(next(e)))) return e;
      e = next(e);
    } while (e != start);
    return unclear;
  }
  [[nodiscard]] bool is_between(Site a, Site p, Site b, Site q) const {
    if (p == q) return true;
    if (g_.orientation(a, p, q) > 0)
      return g_.orientation(a, p, b) > 0 && g_.orientation(a, b, q) > 0;
    return g_.orientation(a, q, b) < 0 || g_.orientation(a, b, p) < 0;
  }

  void put_between(std::int32_t e, std::int32_t before, std::int32_t after) {
    edge(e).next = after;
    edge(e).previous = before;
    edge(before).next = e;
    edge(after).previous = e;
  }

  [[gnu::always_inline]] Action decide(const typename Geometry::Base& line, Site a,
                                       Site b, const Site (&s)[4]) const {
    const auto lanes = g_.lanes(line, s);
    const unsigned same =
        static_cast<unsigned>(s[0] == b) | static_cast<unsigned>(s[1] == b) << 1 |
        static_cast<unsigned>(s[2] == a) << 2 | static_cast<unsigned>(s[3] == a) << 3;
    const unsigned above = bits_of(lanes.cross > lanes.cross_error) & ~same;
    const unsigned below = bits_of(lanes.cross < -lanes.cross_error) | same;
    const Double4 cross_x = __builtin_shufflevector(lanes.cross, lanes.cross, 0, 2, 0, 0);
    const Double4 dot_x = __builtin_shufflevector(lanes.dot, lanes.dot, 0, 2, 0, 0);
    const Double4 size_x = __builtin_shufflevector(lanes.size, lanes.size, 0, 2, 0, 0);
    const Double4 cross_y = __builtin_shufflevector(lanes.cross, lanes.cross, 1, 3, 2, 2);
    const Double4 dot_y = __builtin_shufflevector(lanes.dot, lanes.dot, 1, 3, 2, 2);
    const Double4 size_y = __builtin_shufflevector(lanes.size, lanes.size, 1, 3, 2, 2);
    const Double4 det = dot_x * cross_y - dot_y * cross_x;  // > 0: y in circle(a, b, x)
    const Double4 error = g_.circle_error(size_x, size_y);
    const unsigned inside = bits_of(det > error), outside = bits_of(det < -error);
    const Verdict v{above, below, inside, outside, bits_of(error == Double4{})};
    const unsigned asked = questions(above);
    if ((above | below) != 15u || (asked & ~(inside | outside)) != 0) [[unlikely]]
      return decide_exactly(a, b, s, v);
    return act(above, asked & inside);
  }

  /// Signs of a step, a bit for each: of the four crosses, and of the three determinants.
  struct Verdict {
    unsigned above, below, inside, outside;
    unsigned is_exact;  // determinants that have no error: neither sign is a tie
  };

  // Bits 0 and 1: the left and the right candidate have a rival; bit 2: both sides have a
  // candidate.
  [[gnu::always_inline]] static unsigned questions(unsigned above) {
    return (above & above >> 1 & 1u) | (above >> 1 & above >> 2 & 2u) |
           (above & above << 2 & 4u);
  }
  [[gnu::always_inline]] static Action act(unsigned above, unsigned yes) {
    if (yes & 1u) return drop_left;
    if (yes & 2u) return drop_right;
    if ((above & 5u) == 0) return done;
    return (yes & 4u) != 0 || (above & 1u) == 0 ? take_right : take_left;
  }

  [[gnu::noinline]] Action decide_exactly(Site a, Site b, const Site (&s)[4],
                                          Verdict v) const {
    for (unsigned i = 0; i < 4; ++i) {
      if (((v.above | v.below) >> i & 1u) == 0 && g_.orientation(a, b, s[i]) > 0)
        v.above |= 1u << i;
    }
    constexpr unsigned x[3] = {0, 2, 0}, y[3] = {1, 3, 2};
    const unsigned asked = questions(v.above);
    for (unsigned i = 0; i < 3; ++i) {
      if ((asked >> i & 1u) == 0 || ((v.inside | v.outside) >> i & 1u) != 0) continue;
      const int sign = (v.is_exact >> i & 1u) != 0 ? g_.break_tie(a, b, s[x[i]], s[y[i]])
                                                   : g_.in_circle(a, b, s[x[i]], s[y[i]]);
      if (sign > 0) v.inside |= 1u << i;
    }
    return act(v.above, asked & v.inside);
  }

  const Geometry& g_;
  RingEdge* edges_;
  std::int32_t* first_;
  EdgeSupply* supply_;
};

}  // namespace delone::delaunay
