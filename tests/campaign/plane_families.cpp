#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "campaign/families.hpp"
#include "support/random.hpp"

namespace delone::campaign {

namespace {

using support::PlanePoints;
using support::SplitMix64;
using tripack::Point2;

double number(std::size_t i) { return static_cast<double>(i); }

template <class F>
PlanePoints draw(std::size_t n, std::uint64_t seed, F point) {
  SplitMix64 random(seed);
  PlanePoints points;
  while (points.size() < n) points.push_back(point(random));
  return points;
}

template <class F>
PlanePoints count(std::size_t n, F point) {
  PlanePoints points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(point(i));
  return points;
}

// A family of tests/support by its name.
PlaneVariant from_support(std::string_view name) {
  for (const support::PlaneFamily& f : support::plane_families()) {
    if (name == f.name) return {f.name, f.make};
  }
  throw std::logic_error("no family " + std::string(name));
}

template <class... Names>
std::vector<PlaneVariant> variants(std::vector<PlaneVariant> own, Names... names) {
  (own.push_back(from_support(names)), ...);
  return own;
}

double integer(SplitMix64& r, std::size_t reach) {
  return number(r.below(2 * reach + 1)) - number(reach);
}

double moved_by_ulps(double value, int ulps) {
  const double towards = ulps > 0 ? std::numeric_limits<double>::infinity()
                                  : -std::numeric_limits<double>::infinity();
  for (int i = std::abs(ulps); i > 0; --i) value = std::nextafter(value, towards);
  return value;
}
int few_ulps(SplitMix64& r) { return static_cast<int>(r.below(5)) - 2; }
Point2 moved(SplitMix64& r, Point2 p) {
  const double x = moved_by_ulps(p.x, few_ulps(r));
  return {x, moved_by_ulps(p.y, few_ulps(r))};
}

// Points of a line with an integer direction, some of them doubled by chance.
PlanePoints integer_line(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const Point2 origin{integer(random, 1000), integer(random, 1000)};
  const Point2 step{integer(random, 30), integer(random, 30)};
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double t = integer(r, 2 * n + 4);
    return Point2{origin.x + t * step.x, origin.y + t * step.y};
  });
}

// Collinear in decimals, in doubles only nearly.
PlanePoints decimal_line(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double slope = integer(random, 99) / 10, offset = integer(random, 99) / 10;
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double x = integer(r, 1000) / 100;
    return Point2{x, slope * x + offset};
  });
}

PlanePoints turned_lattice_anywhere(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double degrees = random.between(0, 360), size = std::exp(random.between(-9, 9));
  const Point2 shift{random.between(-1e3, 1e3), random.between(-1e3, 1e3)};
  PlanePoints points = support::rotated_lattice_points(n, degrees);
  for (Point2& p : points) p = {shift.x + size * p.x, shift.y + size * p.y};
  return points;
}

// Rows and columns of a lattice with oblong or sheared integer cells.
PlanePoints integer_lattice(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double dx = 1 + number(random.below(5)), dy = 1 + number(random.below(5)),
               shear = random.below(2) == 0 ? 0 : number(random.below(3));
  const std::size_t columns = 2 + random.below(n / 2 + 1);
  return count(n, [&](std::size_t i) {
    const double row = number(i / columns);
    return Point2{dx * number(i % columns) + shear * row, dy * row};
  });
}

// The integer points of one to three circles about one centre.
PlanePoints integer_circles(std::size_t n, std::uint64_t seed) {
  constexpr std::array<int, 6> radii{5, 25, 65, 85, 325, 1105};
  SplitMix64 random(seed);
  PlanePoints all;
  for (std::size_t k = 1 + random.below(3); k > 0; --k) {
    const int r = radii[random.below(radii.size())];
    for (int x = -r; x <= r; ++x) {
      const int y = static_cast<int>(std::lround(std::sqrt(r * r - x * x)));
      if (x * x + y * y != r * r) continue;
      all.push_back({static_cast<double>(x), static_cast<double>(y)});
      all.push_back({static_cast<double>(x), static_cast<double>(-y)});
    }
  }
  all = support::shuffled(all, seed);
  all.resize(std::min(all.size(), n));
  return all;
}

// A line of equal steps as in delaunator's issue 43, then a few points beside it.
PlanePoints almost_collinear_hull(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const Point2 start{random.between(-600, 600), random.between(-600, 600)},
      step{random.between(-70, 70), random.between(-70, 70)};
  const std::size_t num_beside = random.below(3);
  PlanePoints points = count(n, [&](std::size_t i) {
    return Point2{start.x + number(i) * step.x, start.y + number(i) * step.y};
  });
  for (std::size_t i = 0; i < num_beside; ++i)
    points.push_back({start.x + random.between(-9, 9), start.y + random.between(-9, 9)});
  return points;
}

// Every point beside another, one unit in the last place or a millionth away.
PlanePoints close_pairs(std::size_t n, std::uint64_t seed) {
  PlanePoints points = draw(n / 2 + 1, seed, [](SplitMix64& r) {
    const double x = 400 * r.uniform();
    return Point2{x, 400 * r.uniform()};
  });
  SplitMix64 random(seed + 1);
  for (std::size_t i = points.size(); i-- > 0;) {
    const bool is_ulp = random.below(2) == 0;
    points.push_back(is_ulp ? moved(random, points[i])
                            : Point2{points[i].x + 1e-6, points[i].y});
  }
  return points;
}

// A ring whose last point is its first, and so on round again.
PlanePoints closed_rings(std::size_t n, std::uint64_t seed) {
  const PlanePoints ring =
      support::polygon_points(3 + n / 3, 1 + SplitMix64(seed).uniform());
  return count(n, [&](std::size_t i) { return ring[i % ring.size()]; });
}

// Coordinates from a handful of extremes beside small numbers.
PlanePoints extremes(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const auto any = [&] {
      const std::array<double, 10> values{0,      1,     1e38,    -1e38, 1e300,
                                          1e-300, 1e154, 1.5e154, 2,     r.uniform()};
      return values[r.below(values.size())];
    };
    const double x = any();
    return Point2{x, any()};
  });
}

PlanePoints products_underflow(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const auto any = [&] {
      const std::array<double, 6> sizes{1e-150, 1e-160, 1e-170, 1e-300, 5e-324, 0};
      return integer(r, 3) * sizes[r.below(sizes.size())];
    };
    const double x = any();
    return Point2{x, any()};
  });
}

// Distances that grow by a constant factor along a curve.
PlanePoints exponential(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double base = random.between(1.01, 3);
  const double exponent = std::min(600 / std::log2(base), 4.0 * number(n) + 20);
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double t = r.between(-exponent / 2, exponent / 2), x = std::pow(base, t);
    return Point2{x, r.below(2) == 0 ? 1 / x : -x * r.uniform()};
  });
}

// A survey line in UTM metres, in whole tenths.
PlanePoints survey_line(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double t = number(r.below(400)), off = number(r.below(2));
    return Point2{(5842000 + 7 * t) / 10, (75495000 + 4 * t + off) / 10};
  });
}

// One axis within a millionth, the other over four decades.
PlanePoints axes_of_different_scale(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double x = 0.9635 + 1e-6 * number(r.below(100));
    return Point2{x, std::pow(10, 2 + number(r.below(5)))};
  });
}

// a x + b y = c in decimals: areas of an ulp and less.
PlanePoints areas_of_an_ulp(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double tenth = 1 + number(random.below(9));
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double x = integer(r, 20) / 10;
    return Point2{x, (tenth - 10 * x) / 10};
  });
}

PlanePoints thin_triangles(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double t = number(r.below(11)) / 10, off = r.below(4) == 0 ? 0.008016 : 0;
    return Point2{3 * t, -2 * t + off};
  });
}

PlanePoints very_few(std::size_t, std::uint64_t seed) {
  return draw(seed % 5, seed, [](SplitMix64& r) {
    const double x = integer(r, 1) + 0.0 * integer(r, 1);
    return Point2{x, -0.0 * integer(r, 1) + integer(r, 1)};
  });
}

PlanePoints clusters_of_clusters(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    Point2 p{0, 0};
    for (double size = 1; size > 1e-12; size /= 1000) {
      p.x += size * number(r.below(3));
      p.y += size * number(r.below(3));
    }
    return p;
  });
}

PlanePoints sorted_lattice_backwards(std::size_t n, std::uint64_t) {
  PlanePoints points = support::lattice_points(n);
  std::reverse(points.begin(), points.end());
  return points;
}

// Determinants of about one rounding: what a compiler that contracts to fused
// multiply-add or reorders gets wrong.
PlanePoints cocircular_within_ulps(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double radius = std::exp(random.between(-3, 3));
  const Point2 center{integer(random, 9), integer(random, 9)};
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double a = 2 * std::numbers::pi * r.uniform();
    return moved(r, {center.x + radius * std::cos(a), center.y + radius * std::sin(a)});
  });
}

PlanePoints lattice_within_ulps(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  PlanePoints points = support::lattice_points(n);
  for (Point2& p : points) p = moved(random, {0.1 * p.x + 0.7, 0.1 * p.y + 0.3});
  return points;
}

std::vector<Family> make_families() {
  using Variants = std::vector<PlaneVariant>;
  return {
      {"P1", "all collinear, or all but one", Extra::none,
       variants(Variants{{"integer_line", integer_line}, {"decimal_line", decimal_line}},
                "collinear", "collinear_hundredths", "collinear_vertical",
                "collinear_and_one")},
      {"P2", "square lattice turned by an angle", Extra::none,
       variants(Variants{{"turned_lattice_anywhere", turned_lattice_anywhere}},
                "lattice_turned", "lattice_turned_25", "lattice_turned_45",
                "lattice_turned_302")},
      {"P3", "exact lattice, integer and decimal", Extra::none,
       variants(Variants{{"integer_lattice", integer_lattice}}, "lattice",
                "lattice_shuffled", "lattice_quarters", "lattice_tenths",
                "lattice_far_from_origin", "integers_few", "integers_many")},
      {"P4", "cocircular", Extra::none,
       variants(Variants{{"integer_circles", integer_circles}}, "circle",
                "circle_shuffled", "circle_of_integers", "polygon", "arc_of_degrees",
                "wheel")},
      {"P5", "almost collinear hull", Extra::none,
       variants(Variants{{"almost_collinear_hull", almost_collinear_hull}},
                "collinear_almost", "short_hull_edge")},
      {"P6", "near repeats", Extra::none,
       variants(Variants{{"close_pairs", close_pairs}}, "repeats_near")},
      {"P7", "exact repeats", Extra::none,
       variants(Variants{{"closed_rings", closed_rings}}, "repeats", "all_the_same")},
      {"P8", "huge", Extra::none,
       variants(Variants{{"extremes", extremes}}, "huge", "largest", "polygon_huge")},
      {"P9", "tiny", Extra::none,
       variants(Variants{{"products_underflow", products_underflow}}, "tiny",
                "tiny_products", "tiniest")},
      {"P10", "mixed scale", Extra::none,
       variants(Variants{{"exponential", exponential}}, "one_far_away", "all_scales")},
      {"P11", "far from the origin", Extra::none,
       variants(Variants{{"survey_line", survey_line}}, "far_from_origin")},
      {"P12", "axes of different scale, needles", Extra::none,
       variants(Variants{{"axes_of_different_scale", axes_of_different_scale}},
                "stretched", "needles")},
      {"P13", "areas of an ulp", Extra::none,
       variants(Variants{{"areas_of_an_ulp", areas_of_an_ulp}}, "sum_to_one")},
      {"P14", "queries on edges and nodes", Extra::queries,
       variants(Variants{{"thin_triangles", thin_triangles}}, "uniform", "integers_many",
                "needles", "lattice")},
      {"P15", "not finite, signed zeros, none, one, two", Extra::refusals,
       variants(Variants{{"very_few", very_few}}, "signed_zeros")},
      {"P16", "orders and distributions", Extra::none,
       variants(Variants{{"clusters_of_clusters", clusters_of_clusters},
                         {"sorted_lattice_backwards", sorted_lattice_backwards}},
                "uniform", "uniform_in_corners", "clusters", "sorted", "sorted_backwards",
                "spiral", "kuzmin", "line_clustered", "star", "two_lines")},
      {"P17", "few points in symmetry, built by threads", Extra::threads,
       variants(Variants{}, "symmetric", "lattice", "uniform")},
      {"P18", "ties but for roundings: contraction, reordering", Extra::none,
       variants(Variants{{"cocircular_within_ulps", cocircular_within_ulps},
                         {"lattice_within_ulps", lattice_within_ulps}},
                "polygon")},
  };
}

// Exact for all coordinates that do not leave the range of normal numbers.
double power_for(const PlanePoints& points, SplitMix64& random) {
  const int exponent = static_cast<int>(random.below(41)) - 20;
  const auto is_safe = [](double v) {
    return v == 0 || (std::abs(v) > 1e-290 && std::abs(v) < 1e290);
  };
  const bool all_safe = std::all_of(points.begin(), points.end(), [&](Point2 p) {
    return is_safe(p.x) && is_safe(p.y);
  });
  return all_safe ? std::ldexp(1.0, exponent) : 1;
}

void move_exactly(PlanePoints& points, SplitMix64& random) {
  const std::uint64_t bits = random.next();
  const double power = power_for(points, random);
  for (Point2& p : points) {
    if ((bits & 1) != 0) std::swap(p.x, p.y);
    p = {(bits & 2) != 0 ? -p.x * power : p.x * power,
         (bits & 4) != 0 ? -p.y * power : p.y * power};
  }
}

}  // namespace

const std::vector<Family>& plane_families() {
  static const std::vector<Family> families = make_families();
  return families;
}

PlaneSet make_plane_set(const Family& family, std::uint64_t seed, std::size_t n) {
  SplitMix64 random(seed);
  const PlaneVariant& variant = family.plane[random.below(family.plane.size())];
  PlanePoints points = variant.make(n, random.next());
  if (random.below(2) == 0) {
    const double kept = random.between(0.5, 1);
    std::erase_if(points, [&](Point2) { return random.uniform() > kept; });
  }
  if (random.below(2) == 0) move_exactly(points, random);
  for (std::size_t i = random.below(8) == 0 ? points.size() / 4 : 0; i > 0; --i)
    points.push_back(points[random.below(points.size())]);
  if (random.below(2) == 0) points = support::shuffled(points, random.next());
  return {variant.name, std::move(points)};
}

}  // namespace delone::campaign
