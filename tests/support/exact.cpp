#include "support/exact.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

#include "support/random.hpp"

namespace delone::support {

namespace {

using stripack::Direction;
using tripack::Point2;

// A double is mantissa * 2^exponent with a 53-bit integer mantissa.
struct Parts {
  double mantissa;
  int exponent;
};

Parts parts_of(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {std::ldexp(fraction, 53), exponent - 53};
}

// Doubles as integers, all multiplied by the same power of two.
std::vector<mpz_class> integers(std::initializer_list<double> values) {
  int lowest = std::numeric_limits<int>::max();
  for (const double v : values)
    lowest = v == 0 ? lowest : std::min(lowest, parts_of(v).exponent);
  std::vector<mpz_class> result;
  for (const double v : values) {
    const Parts parts = parts_of(v);
    result.emplace_back(parts.mantissa);
    if (v != 0) result.back() <<= static_cast<unsigned>(parts.exponent - lowest);
  }
  return result;
}

mpz_class det2(const mpz_class& a, const mpz_class& b, const mpz_class& c,
               const mpz_class& d) {
  return a * d - b * c;
}

struct Vector {
  mpz_class x, y, z;
};

mpz_class det3(const Vector& a, const Vector& b, const Vector& c) {
  return a.x * det2(b.y, b.z, c.y, c.z) - a.y * det2(b.x, b.z, c.x, c.z) +
         a.z * det2(b.x, b.y, c.x, c.y);
}

mpz_class squared_length(const Vector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

// Signs of sums of square roots, by squaring: each function leaves one root less to the
// last.

// p + q sqrt(r), r >= 0.
int sign_with_root(const mpz_class& p, const mpz_class& q, const mpz_class& r) {
  const int sp = sgn(p), sq = sgn(q) * sgn(r);
  if (sp == 0 || sq == 0 || sp == sq) return sp != 0 ? sp : sq;
  return sgn(mpz_class(p * p - q * q * r)) * sp;
}

// a sqrt(m) + b sqrt(n).
int sign_of_two_roots(const mpz_class& a, const mpz_class& m, const mpz_class& b,
                      const mpz_class& n) {
  const int sa = sgn(a) * sgn(m), sb = sgn(b) * sgn(n);
  if (sa == 0 || sb == 0 || sa == sb) return sa != 0 ? sa : sb;
  return sgn(mpz_class(a * a * m - b * b * n)) * sa;
}

// p + q sqrt(r) + s sqrt(t).
int sign_with_two_roots(const mpz_class& p, const mpz_class& q, const mpz_class& r,
                        const mpz_class& s, const mpz_class& t) {
  const int sp = sgn(p), roots = sign_of_two_roots(q, r, s, t);
  if (sp == 0 || roots == 0 || sp == roots) return sp != 0 ? sp : roots;
  return sp * sign_with_root(p * p - q * q * r - s * s * t, -2 * q * s, r * t);
}

// Sum of c[i] sqrt(n[i]).
int sign_of_four_roots(const std::array<mpz_class, 4>& c,
                       const std::array<mpz_class, 4>& n) {
  const int first = sign_of_two_roots(c[0], n[0], c[1], n[1]);
  const int second = sign_of_two_roots(c[2], n[2], c[3], n[3]);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const mpz_class rest =
      c[0] * c[0] * n[0] + c[1] * c[1] * n[1] - c[2] * c[2] * n[2] - c[3] * c[3] * n[3];
  return first * sign_with_two_roots(rest, 2 * c[0] * c[1], n[0] * n[1], -2 * c[2] * c[3],
                                     n[2] * n[3]);
}

template <class P>
bool is_violated(const P& a, const P& b, const P& c, const P& p) {
  return exact_in_circle(a, b, c, p) > 0;
}

template <class P>
std::vector<Triangle> all_empty_triangles(std::span<const P> points) {
  std::vector<Triangle> found;
  const auto n = static_cast<std::int32_t>(points.size());
  const auto at = [&](std::int32_t i) { return points[static_cast<std::size_t>(i)]; };
  for (std::int32_t a = 0; a < n; ++a) {
    for (std::int32_t b = a + 1; b < n; ++b) {
      for (std::int32_t c = a + 1; c < n; ++c) {
        if (c == b || exact_orientation(at(a), at(b), at(c)) <= 0) continue;
        const auto hits = [&](const P& p) { return is_violated(at(a), at(b), at(c), p); };
        if (std::none_of(points.begin(), points.end(), hits)) found.push_back({a, b, c});
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Points with equal positions made one: site of each row.
template <class P, class Less, class Same>
std::vector<std::int32_t> sites_of(std::span<const P> points, Less less, Same same) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return less(points[i], points[j]);
  });
  std::vector<std::int32_t> sites(points.size());
  std::int32_t site = -1;
  for (std::size_t i = 0; i < order.size(); ++i) {
    site += i == 0 || !same(points[order[i - 1]], points[order[i]]) ? 1 : 0;
    sites[order[i]] = site;
  }
  return sites;
}

struct Side {
  std::int32_t from, to, third;  // sites
  friend auto operator<=>(const Side&, const Side&) = default;
};

struct Sides {
  std::vector<Side> all;  // sorted
  [[nodiscard]] const Side* find(std::int32_t from, std::int32_t to) const {
    const auto at = std::lower_bound(all.begin(), all.end(), Side{from, to, -1});
    return at != all.end() && at->from == from && at->to == to ? &*at : nullptr;
  }
};

std::string show(std::int32_t a, std::int32_t b) {
  return "exact: side " + std::to_string(a) + " -> " + std::to_string(b) + " ";
}

Sides sides_of(std::span<const Triangle> triangles,
               const std::vector<std::int32_t>& sites) {
  Sides sides;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) {
        return sites[static_cast<std::size_t>(t[i % 3])];
      };
      sides.all.push_back({corner(k), corner(k + 1), corner(k + 2)});
    }
  }
  std::sort(sides.all.begin(), sides.all.end());
  return sides;
}

template <class P>
std::vector<P> positions_of(std::span<const P> points,
                            const std::vector<std::int32_t>& sites) {
  const std::int32_t n =
      sites.empty() ? 0 : *std::max_element(sites.begin(), sites.end()) + 1;
  std::vector<P> positions(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    positions[static_cast<std::size_t>(sites[i])] = points[i];
  }
  return positions;
}

// What plane and sphere have in common: sides, use of all positions, circles.
template <class P>
std::optional<std::string> local_defect(const std::vector<P>& at, const Sides& sides) {
  std::vector<bool> is_used(at.size(), false);
  for (std::size_t i = 0; i < sides.all.size(); ++i) {
    const Side& s = sides.all[i];
    const auto point = [&](std::int32_t v) { return at[static_cast<std::size_t>(v)]; };
    is_used[static_cast<std::size_t>(s.from)] = true;
    if (exact_orientation(point(s.from), point(s.to), point(s.third)) <= 0) {
      return show(s.from, s.to) + "has a triangle that is not counter-clockwise";
    }
    if (i > 0 && sides.all[i - 1].from == s.from && sides.all[i - 1].to == s.to) {
      return show(s.from, s.to) + "has two triangles";
    }
    const Side* other = s.from < s.to ? sides.find(s.to, s.from) : nullptr;
    if (other &&
        is_violated(point(s.from), point(s.to), point(s.third), point(other->third))) {
      return show(s.from, s.to) + "is not Delaunay";
    }
  }
  if (std::find(is_used.begin(), is_used.end(), false) == is_used.end())
    return std::nullopt;
  return "exact: a position is in no triangle";
}

// The convex hull with the points on its edges, counter-clockwise (A. M. Andrew 1979);
// `at` sorted by x, then y. Empty for points on one line.
std::vector<std::int32_t> hull_of(const std::vector<Point2>& at) {
  const auto n = static_cast<std::int32_t>(at.size());
  const auto turn = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    return exact_orientation(at[static_cast<std::size_t>(a)],
                             at[static_cast<std::size_t>(b)],
                             at[static_cast<std::size_t>(c)]);
  };
  const auto chain = [&](std::int32_t first, std::int32_t step) {
    std::vector<std::int32_t> hull;
    for (std::int32_t i = first; i >= 0 && i < n; i += step) {
      while (hull.size() > 1 && turn(hull[hull.size() - 2], hull.back(), i) < 0)
        hull.pop_back();
      hull.push_back(i);
    }
    return hull;
  };
  std::vector<std::int32_t> hull = chain(0, 1);
  const std::vector<std::int32_t> upper = chain(n - 1, -1);
  if (hull.size() == at.size() && upper.size() == at.size()) return {};
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

bool is_before(Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

std::vector<std::int32_t> plane_sites(std::span<const Point2> points) {
  return sites_of(points, is_before, [](Point2 a, Point2 b) { return a == b; });
}

Vector integer_vector(const std::vector<mpz_class>& v, std::size_t i) {
  return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
}

bool is_same_ray(const Direction& a, const Direction& b) {
  const auto v = integers({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
  const Vector p = integer_vector(v, 0), q = integer_vector(v, 1);
  return det2(p.y, p.z, q.y, q.z) == 0 && det2(p.z, p.x, q.z, q.x) == 0 &&
         det2(p.x, p.y, q.x, q.y) == 0 &&
         mpz_class(p.x * q.x + p.y * q.y + p.z * q.z) > 0;
}

// Sorted by the quotients of components, which one ray has in common whatever its length;
// rays that are different but have equal quotients stay apart.
std::vector<std::int32_t> sphere_sites(std::span<const Direction> points) {
  const auto key = [](const Direction& d) {
    const double s = std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
    return std::array{d.x() / s, d.y() / s, d.z() / s};
  };
  std::vector<std::int32_t> sites = sites_of(
      points, [&](const Direction& a, const Direction& b) { return key(a) < key(b); },
      [&](const Direction& a, const Direction& b) { return key(a) == key(b); });
  // Within a class of equal quotients, compare every two.
  std::vector<std::vector<std::size_t>> classes(points.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    classes[static_cast<std::size_t>(sites[i])].push_back(i);
  std::int32_t next = 0;
  for (const auto& rows : classes) {
    std::vector<std::size_t> first;
    for (const std::size_t row : rows) {
      const auto same = std::find_if(first.begin(), first.end(), [&](std::size_t other) {
        return points[row] == points[other] || is_same_ray(points[row], points[other]);
      });
      sites[row] = next + static_cast<std::int32_t>(same - first.begin());
      if (same == first.end()) first.push_back(row);
    }
    next += static_cast<std::int32_t>(first.size());
  }
  return sites;
}

// How many triangles hold q; none if q is on a side.
std::optional<int> num_holding(const std::vector<Direction>& at, const Sides& sides,
                               const Direction& q) {
  int num = 0;
  for (const Side& s : sides.all) {
    const Direction &a = at[static_cast<std::size_t>(s.from)],
                    &b = at[static_cast<std::size_t>(s.to)],
                    &c = at[static_cast<std::size_t>(s.third)];
    const int turn = exact_orientation(a, b, q);
    if (turn == 0) return std::nullopt;
    if (s.from > s.to || s.from > s.third || turn < 0) continue;
    num += exact_orientation(b, c, q) > 0 && exact_orientation(c, a, q) > 0 ? 1 : 0;
  }
  return num;
}

// How often triangles without gaps between them cover a direction and its opposite; of
// these at least one is outside a convex region.
struct Cover {
  int least, most;
};
Cover cover_of(const std::vector<Direction>& at, const Sides& sides) {
  SplitMix64 random(1);
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1),
                 z = random.between(-1, 1);
    const auto num = num_holding(at, sides, Direction::from(x, y, z));
    const auto opposite = num_holding(at, sides, Direction::from(-x, -y, -z));
    if (num && opposite) return {std::min(*num, *opposite), std::max(*num, *opposite)};
  }
}

bool is_on_one_circle(const std::vector<Direction>& at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (exact_orientation(at[0], at[j], at[i]) != 0) return false;
    }
  }
  return true;
}

}  // namespace

int exact_orientation(Point2 a, Point2 b, Point2 c) {
  const auto v = integers({a.x, a.y, b.x, b.y, c.x, c.y});
  return sgn(det2(v[2] - v[0], v[3] - v[1], v[4] - v[0], v[5] - v[1]));
}

int exact_in_circle(Point2 a, Point2 b, Point2 c, Point2 p) {
  const auto v = integers({a.x, a.y, b.x, b.y, c.x, c.y, p.x, p.y});
  const auto lifted = [&](std::size_t i) {
    const mpz_class x = v[2 * i] - v[6], y = v[2 * i + 1] - v[7];
    return Vector{x, y, x * x + y * y};
  };
  return sgn(det3(lifted(0), lifted(1), lifted(2)));
}

int exact_orientation(const Direction& a, const Direction& b, const Direction& c) {
  const auto v =
      integers({a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()});
  return sgn(det3(integer_vector(v, 0), integer_vector(v, 1), integer_vector(v, 2)));
}

int exact_in_circle(const Direction& a, const Direction& b, const Direction& c,
                    const Direction& p) {
  const auto v = integers({a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z(),
                           p.x(), p.y(), p.z()});
  const std::array<Vector, 4> r{integer_vector(v, 0), integer_vector(v, 1),
                                integer_vector(v, 2), integer_vector(v, 3)};
  // Expanded by the last column. p is beyond the plane of a, b, c iff the volume a, b, c,
  // p is.
  return sign_of_four_roots({-det3(r[1], r[2], r[3]), det3(r[0], r[2], r[3]),
                             -det3(r[0], r[1], r[3]), det3(r[0], r[1], r[2])},
                            {squared_length(r[0]), squared_length(r[1]),
                             squared_length(r[2]), squared_length(r[3])}) *
         -1;
}

std::optional<std::string> exact_defect(std::span<const Point2> points,
                                        std::span<const Triangle> triangles) {
  const auto sites = plane_sites(points);
  const auto at = positions_of(points, sites);
  const auto hull = hull_of(at);
  if (triangles.empty()) {
    return hull.empty() ? std::optional<std::string>() : "exact: triangles are missing";
  }
  const Sides sides = sides_of(triangles, sites);
  if (auto defect = local_defect(at, sides)) return defect;
  std::size_t num_boundary = 0;
  for (const Side& s : sides.all) num_boundary += sides.find(s.to, s.from) ? 0 : 1;
  if (num_boundary != hull.size()) return "exact: the boundary is not the convex hull";
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const std::int32_t a = hull[i], b = hull[(i + 1) % hull.size()];
    if (!sides.find(a, b) || sides.find(b, a))
      return show(a, b) + "is not a boundary edge";
  }
  if (triangles.size() == 2 * at.size() - 2 - hull.size()) return std::nullopt;
  return "exact: wrong number of triangles";
}

std::optional<std::string> exact_defect(std::span<const Direction> points,
                                        std::span<const Triangle> triangles) {
  const auto sites = sphere_sites(points);
  const auto at = positions_of(points, sites);
  if (triangles.empty()) {
    return is_on_one_circle(at) ? std::optional<std::string>()
                                : "exact: triangles are missing";
  }
  const Sides sides = sides_of(triangles, sites);
  if (auto defect = local_defect(at, sides)) return defect;
  std::size_t num_boundary = 0;
  for (const Side& s : sides.all) {
    if (sides.find(s.to, s.from)) continue;
    ++num_boundary;
    const Direction a = at[static_cast<std::size_t>(s.from)],
                    b = at[static_cast<std::size_t>(s.to)];
    const auto is_right = [&](const Direction& p) {
      return exact_orientation(a, b, p) < 0;
    };
    if (std::any_of(at.begin(), at.end(), is_right))
      return show(s.from, s.to) + "cuts points off";
  }
  const std::size_t expected = 2 * at.size() - (num_boundary == 0 ? 4 : 2 + num_boundary);
  if (triangles.size() != expected) return "exact: wrong number of triangles";
  const Cover cover = cover_of(at, sides);
  const bool is_once = cover.most <= 1 && cover.least == (num_boundary == 0 ? 1 : 0);
  return is_once ? std::optional<std::string>()
                 : "exact: the sphere is covered more than once";
}

std::vector<Triangle> empty_circle_triangles(std::span<const Point2> points) {
  return all_empty_triangles(points);
}

std::vector<Triangle> empty_circle_triangles(std::span<const Direction> points) {
  return all_empty_triangles(points);
}

double exact_hull_area2(std::span<const Point2> points) {
  const auto at = positions_of(points, plane_sites(points));
  const auto hull = hull_of(at);
  mpq_class area = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2 a = at[static_cast<std::size_t>(hull[i])];
    const Point2 b = at[static_cast<std::size_t>(hull[(i + 1) % hull.size()])];
    area += mpq_class(a.x) * mpq_class(b.y) - mpq_class(b.x) * mpq_class(a.y);
  }
  return area.get_d();
}

}  // namespace delone::support
