#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/choose.hpp"
#include "delaunay/four_corners.hpp"
#include "delaunay/lanes.hpp"
#include "delaunay/ring_mesh.hpp"
#include "delaunay/site_order.hpp"
#include "delaunay/zip_step.hpp"

namespace delone::delaunay {

/// The sites of a block that are furthest along either chart coordinate.
struct Extremes {
  Site low_u, high_u, low_v, high_v;
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
class DivideConquer : public RingMesh<Geometry> {
 public:
  DivideConquer(const Geometry& geometry, RingArrays arrays, EdgeSupply* supply)
      : Mesh(arrays, supply), g_(geometry), step_(geometry) {}

  /// The sites begin .. end - 1.
  Extremes build(BlockKeys keys, Site begin, Site end) {
    switch (end - begin) {
      case 1:
        return build_one(begin);
      case 2:
        return build_two(begin, begin + 1);
      case 3:
        return build_three(begin);
      case 4: {
        const FourCorners four = four_corners(begin);
        if (four.shape != FourShape::unclear) [[likely]]
          return build_four(begin, four);
        break;
      }
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

  /// Two blocks become one.
  Extremes merge(const Extremes& p, const Extremes& q) {
    const std::int32_t last = zip(lower_tangent(facing(p, q)));
    first(target(last)) = last ^ 1;
    first(origin(last)) = next(last);
    return {lower_u(p.low_u, q.low_u), higher_u(p.high_u, q.high_u),
            lower_v(p.low_v, q.low_v), higher_v(p.high_v, q.high_v)};
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
  using Mesh = RingMesh<Geometry>;
  using Mesh::connect_alone, Mesh::pair, Mesh::put_before, Mesh::put_between;
  using Mesh::first, Mesh::next, Mesh::origin, Mesh::previous, Mesh::target;
  using Mesh::put_into_wedge, Mesh::remove, Mesh::ring, Mesh::set_alone, Mesh::take_edge;

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

  Site lower_u(Site s, Site t) const { return delaunay::lower_u(g_, s, t); }
  Site higher_u(Site s, Site t) const { return choose(g_.less_u(s, t), t, s); }
  Site lower_v(Site s, Site t) const { return choose(g_.less_v(t, s), t, s); }
  Site higher_v(Site s, Site t) const { return choose(g_.less_v(s, t), t, s); }

  // Leaves.

  Extremes build_one(Site s) {
    first(s) = none;
    return {s, s, s, s};
  }
  Extremes build_two(Site a, Site b) {
    const std::int32_t e = connect_alone(a, b);
    first(a) = e;
    first(b) = e ^ 1;
    return with({a, a, a, a}, b);
  }
  Extremes with(const Extremes& x, Site s) const {
    return {lower_u(x.low_u, s), higher_u(x.high_u, s), lower_v(x.low_v, s),
            higher_v(x.high_v, s)};
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
  void chain(Site p, Site q, Site r) {
    const std::int32_t pq = take_edge(p, q), qr = take_edge(q, r);
    set_alone(pq);
    pair(pq ^ 1, qr);
    set_alone(qr ^ 1);
    first(p) = pq;
    first(q) = qr;
    first(r) = qr ^ 1;
  }

  // Which of a, a + 1, a + 2, a + 3 are the corners p0, p1, p2, p3.
  FourCorners four_corners(Site a) const {
    const Site p[4] = {a + 1, a, a, a}, q[4] = {a + 2, a + 2, a + 1, a + 1},
               r[4] = {a + 3, a + 3, a + 3, a + 2};
    const Double4 cross = g_.lanes(g_.corners(p), g_.corners(q), g_.corners(r)).cross;
    unsigned left = bits_of(cross > g_.cross_error());
    const unsigned right = bits_of(cross < -g_.cross_error());
    if ((left | right) != 15u) [[unlikely]] {
      for (unsigned i = 0; i < 4; ++i) {
        if (((left | right) >> i & 1u) != 0) continue;
        const int side = g_.orientation(p[i], q[i], r[i]);
        if (side == 0) return {};
        left |= (side > 0 ? 1u : 0u) << i;
      }
    }
    return four_corner_table[left];
  }

  Extremes build_four(Site a, const FourCorners& four) {
    const Site p[4] = {a + four.corner[0], a + four.corner[1], a + four.corner[2],
                       a + four.corner[3]};
    if (four.shape == FourShape::triangle) {
      build_star(p[0], p[1], p[2], p[3]);
    } else {
      const unsigned turn = is_in_circle(p[0], p[1], p[2], p[3]) ? 1 : 0;
      build_quad(p[turn], p[turn + 1], p[turn + 2], p[(turn + 3) % 4]);
    }
    return with(with(with({a, a, a, a}, a + 1), a + 2), a + 3);
  }
  // Of the corners of a convex quadrilateral: is the last one inside the circle of the
  // others? A tie is broken as in broken_ties.
  [[nodiscard]] bool is_in_circle(Site p, Site q, Site r, Site s) const {
    const auto lanes = g_.lanes(g_.corner(p), g_.corner(q), {r, s, r, s});
    const double det = lanes.dot[0] * lanes.cross[1] - lanes.dot[1] * lanes.cross[0];
    const double error = g_.circle_error()[0];
    const bool is_certain = (bits_of(lanes.cross > g_.cross_error()) & 3u) == 3u;
    if (is_certain && (det > error || det < -error)) [[likely]]
      return det > 0;
    if (is_certain && g_.is_exact()) return g_.less_u(lower_u(p, r), lower_u(q, s));
    return g_.in_circle(p, q, r, s) > 0;
  }
  // The quadrilateral pqrs with the diagonal pr.
  void build_quad(Site p, Site q, Site r, Site s) {
    const std::int32_t pq = take_edge(p, q), qr = take_edge(q, r), rs = take_edge(r, s),
                       sp = take_edge(s, p), pr = take_edge(p, r);
    ring(pq, pr, sp ^ 1);
    pair(qr, pq ^ 1);
    ring(rs, pr ^ 1, qr ^ 1);
    pair(sp, rs ^ 1);
    first(p) = pq, first(q) = qr, first(r) = rs, first(s) = sp;
  }
  // The triangle pqr with s inside.
  void build_star(Site p, Site q, Site r, Site s) {
    const std::int32_t pq = take_edge(p, q), qr = take_edge(q, r), rp = take_edge(r, p),
                       sp = take_edge(s, p), sq = take_edge(s, q), sr = take_edge(s, r);
    ring(pq, sp ^ 1, rp ^ 1);
    ring(qr, sq ^ 1, pq ^ 1);
    ring(rp, sr ^ 1, qr ^ 1);
    ring(sp, sq, sr);
    first(p) = pq, first(q) = qr, first(r) = rp, first(s) = sp;
  }

  // Merging.

  /// Sites on the hulls of the two blocks that face each other.
  struct Facing {
    Site left, right;
  };
  Facing facing(const Extremes& p, const Extremes& q) const {
    const auto prefer = [](bool holds, Facing f, Facing g) {
      return Facing{choose(holds, f.left, g.left), choose(holds, f.right, g.right)};
    };
    Facing f{p.low_v, q.high_v};
    f = prefer(g_.less_u(q.high_u, p.low_u), {p.low_u, q.high_u}, f);
    f = prefer(g_.less_v(p.high_v, q.low_v), {p.high_v, q.low_v}, f);
    return prefer(g_.less_u(p.high_u, q.low_u), {p.high_u, q.low_u}, f);
  }

  std::int32_t lower_tangent(Facing f) {
    auto [l, r] = f;
    std::int32_t left = first(l), right = first(r);
    // The left end stands as soon as the right one does not move on after it.
    for (bool has_moved = true; has_moved;) {
      has_moved = false;
      while (left != none) {
        const std::int32_t to = previous(left);  // l -> its clockwise hull neighbour
        if (g_.orientation(l, r, target(to)) >= 0) break;
        l = target(to);
        left = to ^ 1;  // hull edge u -> l; hull edge leaving u
      }
      while (right != none) {
        const Site w = target(right);
        if (g_.orientation(l, r, w) >= 0) break;
        right = next(right ^ 1);
        r = w;
        has_moved = true;
      }
    }
    const std::int32_t base = take_edge(l, r);
    put_into_wedge(base, left);
    put_into_wedge(base ^ 1, right);
    first(l) = base;
    first(r) = right == none ? base ^ 1 : right;
    return base;
  }

  /// Fills the gap above the base a -> b between a block on its left and one on its
  /// right: of the circles through a and b and a site of either block above the base, the
  /// one that holds no other site makes a triangle, whose third edge is the next base.
  /// Edges in its way go. Gives the last base: above it is nothing but the outside, or,
  /// if the blocks go round the sphere, the triangle that closes the gap.
  std::int32_t zip(std::int32_t base) {
    Site a = origin(base), b = target(base);
    std::int32_t c = next(base), d = previous(base ^ 1);
    typename Geometry::Corner at_a = g_.corner(a), at_b = g_.corner(b);
    for (;;) {
      const std::int32_t c_next = next(c), d_next = previous(d);
      const Site s[4] = {target(c), target(c_next), target(d), target(d_next)};
      const ZipAction action = step_.decide(at_a, at_b, a, b, s);
      if (action == ZipAction::take_right) {
        if (Geometry::can_close && s[0] == s[2]) break;
        const std::int32_t e = take_edge(a, s[2]);
        const std::int32_t to_b = d ^ 1;
        d = previous(to_b);
        put_between(e, base, c);
        put_between(e ^ 1, d, to_b);
        base = e;
        b = s[2];
        at_b = g_.corner(b);
      } else if (action == ZipAction::take_left) {
        if (Geometry::can_close && s[0] == s[2]) break;
        const std::int32_t e = take_edge(s[0], b);
        const std::int32_t to_a = c ^ 1;
        c = next(to_a);
        put_between(e, to_a, c);
        put_between(e ^ 1, d, base ^ 1);
        base = e;
        a = s[0];
        at_a = g_.corner(a);
      } else if (action == ZipAction::drop_left) {
        remove(c);
        c = c_next;
      } else if (action == ZipAction::drop_right) {
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

  const Geometry& g_;
  ZipStep<Geometry> step_;
};

}  // namespace delone::delaunay
