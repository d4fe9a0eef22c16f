#pragma once

#include <cstdint>

#include "delaunay/choose.hpp"
#include "delaunay/lanes.hpp"
#include "delaunay/site_order.hpp"
#include "delaunay/twofold_lanes.hpp"

namespace delone::delaunay {

/// The first by u of two sites.
template <class Geometry>
[[gnu::always_inline]] inline Site lower_u(const Geometry& g, Site s, Site t) {
  return choose(g.less_u(t, s), t, s);
}

/// What to do with the gap above a base (DivideConquer::zip): nothing more, to make the
/// triangle with the first candidate of the left or of the right, or to remove the edge
/// to it.
enum class ZipAction : unsigned { done, take_left, take_right, drop_left, drop_right };

/// Decides a step of a zip from the signs of four crosses and three determinants: with
/// errors that hold for the whole block, for nearly all steps; with those of the
/// candidates at hand; with twice the precision; exactly.
template <class Geometry>
class ZipStep {
 public:
  explicit ZipStep(const Geometry& geometry) : g_(geometry) {}

  /// `s`: two candidates of a, the nearer to b first, and two of b.
  [[gnu::always_inline]] ZipAction decide(const typename Geometry::Corner& at_a,
                                          const typename Geometry::Corner& at_b, Site a,
                                          Site b, const Site (&s)[4]) const {
    const auto lanes = g_.lanes(at_a, at_b, s);
    const unsigned above = bits_of(lanes.cross > g_.cross_error());
    const unsigned below = bits_of((lanes.cross <= -g_.cross_error()) | lanes.is_end);
    const Double4 det = determinants(lanes.cross, lanes.dot);
    const unsigned inside = bits_of(det > g_.circle_error());
    const unsigned outside = bits_of(det < -g_.circle_error());
    const unsigned asked = questions(above);
    if ((((above | below) ^ 15u) | (asked & ~(inside | outside))) == 0) [[likely]]
      return act(above, asked & inside);
    return g_.is_exact()
               ? decide_ties(a, b, s[0], s[1], s[2], s[3], above, inside, outside)
               : decide_closely(a, b, s[0], s[1], s[2], s[3]);
  }

 private:
  /// Of candidates 0 and 1, 2 and 3, 0 and 2, in lanes 0 to 2: > 0 where the second is
  /// inside the circle through the base and the first.
  [[gnu::always_inline]] static Double4 determinants(const Double4& cross,
                                                     const Double4& dot) {
    return of_first(dot) * of_second(cross) - of_second(dot) * of_first(cross);
  }
  [[gnu::always_inline]] static Double4 of_first(const Double4& v) {
    return __builtin_shufflevector(v, v, 0, 2, 0, 0);
  }
  [[gnu::always_inline]] static Double4 of_second(const Double4& v) {
    return __builtin_shufflevector(v, v, 1, 3, 2, 2);
  }

  /// Where no sign has an error: what is neither inside nor outside is a tie.
  [[gnu::noinline]] ZipAction decide_ties(Site a, Site b, Site s0, Site s1, Site s2,
                                          Site s3, unsigned above, unsigned inside,
                                          unsigned outside) const {
    return act(above, questions(above) &
                          (inside | (broken_ties(a, b, {s0, s1, s2, s3}) & ~outside)));
  }

  /// The answers to the three questions if all were ties: the lowest of the four points,
  /// by u, is outside of the circle of the others (tripack::in_circle_perturbed). The
  /// order of four points on a circle is known: a and b, then around a from b the
  /// candidates of a, the reverse for those of b, and those of b before those of a.
  unsigned broken_ties(Site a, Site b, const Site (&s)[4]) const {
    const Site low_a0 = lower_u(g_, a, s[0]), low_b1 = lower_u(g_, b, s[1]);
    const Site low_b2 = lower_u(g_, b, s[2]), low_a3 = lower_u(g_, a, s[3]);
    const Site low_b0 = lower_u(g_, b, s[0]), low_a2 = lower_u(g_, a, s[2]);
    return static_cast<unsigned>(g_.less_u(low_a0, low_b1)) |
           static_cast<unsigned>(g_.less_u(low_b2, low_a3)) << 1 |
           static_cast<unsigned>(g_.less_u(low_b0, low_a2)) << 2;
  }

  /// The same with errors of these four candidates instead of the worst ones in the
  /// block, then with numbers of twice the precision, and exactly where these leave a
  /// sign open.
  [[gnu::noinline]] ZipAction decide_closely(Site a, Site b, Site s0, Site s1, Site s2,
                                             Site s3) const {
    const Site s[4] = {s0, s1, s2, s3};
    const auto at_a = g_.corner(a), at_b = g_.corner(b);
    const auto lanes = g_.lanes(at_a, at_b, s);
    const Double4 size = g_.sizes(a, b, lanes);
    const Double4 circle_error = g_.circle_error(of_first(size), of_second(size));
    Verdict v = verdict(lanes.cross, g_.cross_error(size),
                        determinants(lanes.cross, lanes.dot), circle_error);
    v.below |= bits_of(lanes.is_end);
    v.is_exact = questions(v.above) & bits_of(circle_error == Double4{});
    if (v.is_open()) v.add(look_twice(at_a, at_b, s, size));
    if (v.is_open()) settle(a, b, s, v);
    const unsigned ties = v.is_exact == 0 ? 0 : broken_ties(a, b, s) & v.is_exact;
    return act(v.above, questions(v.above) & (v.inside | (ties & ~v.outside)));
  }

  /// Signs of a step, a bit for each: of the four crosses, and of the three determinants.
  struct Verdict {
    unsigned above, below, inside, outside;
    unsigned is_exact = 0;  // determinants that have no error: neither sign is a tie

    [[gnu::always_inline]] bool is_open() const {
      return (above | below) != 15u ||
             (questions(above) & ~(inside | outside | is_exact)) != 0;
    }
    [[gnu::always_inline]] void add(const Verdict& v) {
      above |= v.above, below |= v.below, inside |= v.inside, outside |= v.outside;
    }
  };

  // A determinant is trusted only if its crosses are certain: they might have vanished
  // below the least of numbers.
  [[gnu::always_inline]] static Verdict verdict(const Double4& cross,
                                                const Double4& cross_error,
                                                const Double4& det,
                                                const Double4& circle_error) {
    const unsigned above = bits_of(cross > cross_error);
    const unsigned asked = questions(above);
    return {above, bits_of(cross <= -cross_error), asked & bits_of(det > circle_error),
            asked & bits_of(det < -circle_error)};
  }

  [[gnu::always_inline]] Verdict look_twice(const typename Geometry::Corner& at_a,
                                            const typename Geometry::Corner& at_b,
                                            const Site (&s)[4],
                                            const Double4& size) const {
    using Arithmetic = typename Geometry::Arithmetic;
    const auto lanes = g_.twofold_lanes(at_a, at_b, g_.corners(s));
    const Twofold4 det = Arithmetic::difference(
        Arithmetic::product(of_first(lanes.dot), of_second(lanes.cross)),
        Arithmetic::product(of_second(lanes.dot), of_first(lanes.cross)));
    return verdict(lanes.cross.rounded(), g_.twofold_cross_error(size), det.rounded(),
                   g_.twofold_circle_error(of_first(size), of_second(size)));
  }
  [[gnu::always_inline]] static Twofold4 of_first(const Twofold4& v) {
    return {of_first(v.high), of_first(v.low)};
  }
  [[gnu::always_inline]] static Twofold4 of_second(const Twofold4& v) {
    return {of_second(v.high), of_second(v.low)};
  }

  // Bits 0 and 1: the left and the right candidate have a rival; bit 2: both sides have a
  // candidate. From a table of 3 bits for each of the 16 sets of candidates.
  [[gnu::always_inline]] static unsigned questions(unsigned above) {
    return static_cast<unsigned>(question_table >> 3 * above) & 7u;
  }
  static constexpr std::uint64_t question_table = [] {
    std::uint64_t table = 0;
    for (unsigned above = 0; above < 16; ++above) {
      const unsigned asked = (above & above >> 1 & 1u) | (above >> 1 & above >> 2 & 2u) |
                             (above & above << 2 & 4u);
      table |= std::uint64_t{asked} << 3 * above;
    }
    return table;
  }();
  [[gnu::always_inline]] static ZipAction act(unsigned above, unsigned yes) {
    if (yes & 1u) return ZipAction::drop_left;
    if (yes & 2u) return ZipAction::drop_right;
    if ((above & 5u) == 0) return ZipAction::done;
    return (yes & 4u) != 0 || (above & 1u) == 0 ? ZipAction::take_right
                                                : ZipAction::take_left;
  }

  /// What is open, exactly.
  [[gnu::noinline]] void settle(Site a, Site b, const Site (&s)[4], Verdict& v) const {
    for (unsigned i = 0; i < 4; ++i) {
      if (((v.above | v.below) >> i & 1u) == 0 && g_.orientation(a, b, s[i]) > 0)
        v.above |= 1u << i;
    }
    constexpr unsigned x[3] = {0, 2, 0}, y[3] = {1, 3, 2};
    const unsigned open = questions(v.above) & ~(v.inside | v.outside | v.is_exact);
    for (unsigned i = 0; i < 3; ++i) {
      if ((open >> i & 1u) != 0 && g_.in_circle(a, b, s[x[i]], s[y[i]]) > 0)
        v.inside |= 1u << i;
    }
  }

  const Geometry& g_;
};

}  // namespace delone::delaunay
