#include "support/plane_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/random.hpp"

namespace delone::support {

namespace {

using tripack::Point2;
using Limits = std::numeric_limits<double>;

double number(std::size_t i) { return static_cast<double>(i); }

// n points, each a function of the stream.
template <class F>
PlanePoints draw(std::size_t n, std::uint64_t seed, F point) {
  SplitMix64 random(seed);
  PlanePoints points;
  points.reserve(n);
  while (points.size() < n) points.push_back(point(random));
  return points;
}

// n points, each a function of its number.
template <class F>
PlanePoints count(std::size_t n, F point) {
  PlanePoints points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(point(i));
  return points;
}

template <class F>
PlanePoints mapped(PlanePoints points, F map) {
  for (Point2& p : points) p = map(p);
  return points;
}

double moved_by_ulps(double value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, Limits::infinity());
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -Limits::infinity());
  return value;
}

int small_step(SplitMix64& random, int reach) {
  return static_cast<int>(random.below(static_cast<std::size_t>(2 * reach + 1))) - reach;
}

PlanePoints sorted(PlanePoints points) {
  std::sort(points.begin(), points.end(),
            [](Point2 a, Point2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  return points;
}

// Several copies of nearly the same points, 0 to 4 ulps apart.
PlanePoints near_repeats(std::size_t n, std::uint64_t seed) {
  const PlanePoints bases = draw(n / 5 + 1, seed, [](SplitMix64& r) {
    return Point2{45802.27 + r.uniform(), 169208.54 + r.uniform()};
  });
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const Point2 base = bases[r.below(bases.size())];
    return Point2{moved_by_ulps(base.x, small_step(r, 4)),
                  moved_by_ulps(base.y, small_step(r, 4))};
  });
}

// Points of a line in doubles: on it, or a few ulps off.
PlanePoints almost_collinear(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double x = r.between(-1, 1);
    return Point2{x, moved_by_ulps(x / 3 + 0.1, small_step(r, 2))};
  });
}

// Every exponent of a double, both signs.
PlanePoints all_scales(std::size_t n, std::uint64_t seed) {
  const auto any = [](SplitMix64& r) {
    const int exponent = static_cast<int>(r.below(2046)) - 1022;
    return std::ldexp(r.between(1, 2), exponent) * (r.below(2) == 0 ? 1 : -1);
  };
  return draw(n, seed, [&](SplitMix64& r) {
    const double x = any(r), y = any(r);
    return Point2{x, y};
  });
}

// Two points close together and others far away, nearly on their line.
PlanePoints short_hull_edge(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double angle = random.between(0, 6.28), c = std::cos(angle), s = std::sin(angle);
  const double length = std::pow(10, -random.between(6, 14));
  const Point2 start{random.uniform(), random.uniform()};
  PlanePoints points{start, {start.x + length * c, start.y + length * s}};
  while (points.size() < n) {
    const double along = random.between(-1, 1),
                 off = random.between(-1, 1) * 1e-16 / length;
    points.push_back({start.x + along * c - off * s, start.y + along * s + off * c});
    if (points.size() % 4 == 0)
      points.push_back({start.x - along * s, start.y + along * c});
  }
  return points;
}

PlanePoints one_far_away(std::size_t n, std::uint64_t seed) {
  PlanePoints points = mapped(almost_collinear(n, seed), [](Point2 p) {
    return Point2{p.x * 1e-3, p.y * 1e-3};
  });
  points.push_back({2.8e8, 2.8e8});
  return points;
}

// Largest finite doubles among others: differences overflow.
PlanePoints largest(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const std::array<double, 7> values{
        Limits::max(),           -Limits::max(), Limits::max() / 2, 1e300, -1e300, 0,
        1e308 * r.between(-1, 1)};
    const double x = values[r.below(7)], y = values[r.below(7)];
    return Point2{x, y};
  });
}

// Symmetric about both axes and both diagonals: orbits of eight around the centre.
PlanePoints symmetric(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  PlanePoints points{{0, 0}};
  while (points.size() < n) {
    const double a = random.uniform(), b = random.below(3) == 0 ? 0 : random.uniform();
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-1.0, 1.0}) {
        points.push_back({s * a, t * b});
        points.push_back({t * b, s * a});
      }
    }
  }
  return points;
}

// Blelloch, Hardwick, Miller, Talmor: Algorithmica 24 (1999).
PlanePoints kuzmin(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double u = r.uniform(), angle = 2 * std::numbers::pi * r.uniform();
    const double radius = std::sqrt(1 / ((1 - u) * (1 - u)) - 1);
    return Point2{radius * std::cos(angle), radius * std::sin(angle)};
  });
}

PlanePoints near_line(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double u = r.uniform(), b = 0.001;
    return Point2{b / (u - b * u + b), r.uniform()};
  });
}

PlanePoints star(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double angle = 2 * std::numbers::pi * number(r.below(7)) / 7,
                 radius = r.uniform();
    return Point2{radius * std::cos(angle), radius * std::sin(angle)};
  });
}

PlanePoints spiral(std::size_t n, std::uint64_t) {
  return count(n, [](std::size_t i) {
    const double t = std::sqrt(number(i)), angle = 3.8832220774509327 * number(i);
    return Point2{t * std::cos(angle), t * std::sin(angle)};
  });
}

PlanePoints two_lines(std::size_t n, std::uint64_t seed) {
  return shuffled(count(n,
                        [](std::size_t i) {
                          return Point2{number(i / 2), number(i % 2)};
                        }),
                  seed);
}

PlanePoints square_corners_and_uniform(std::size_t n, std::uint64_t seed) {
  PlanePoints points{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const PlanePoints inside = uniform_points(n > 4 ? n - 4 : 0, seed);
  points.insert(points.end(), inside.begin(), inside.end());
  return points;
}

PlanePoints small_integers(std::size_t n, std::uint64_t seed, std::size_t range) {
  return draw(n, seed, [=](SplitMix64& r) {
    const double x = number(r.below(range)), y = number(r.below(range));
    return Point2{x, y};
  });
}

constexpr double tiniest = Limits::denorm_min();

constexpr PlaneFamily families[] = {
    {"uniform", uniform_points},
    {"uniform_in_corners", square_corners_and_uniform},
    {"clusters", clustered_points},
    {"lattice", [](std::size_t n, std::uint64_t) { return lattice_points(n); }},
    {"lattice_shuffled",
     [](std::size_t n, std::uint64_t s) { return shuffled(lattice_points(n), s); }},
    {"lattice_turned_302",
     [](std::size_t n, std::uint64_t) { return rotated_lattice_points(n, 302.328); }},
    {"lattice_turned_25",
     [](std::size_t n, std::uint64_t) { return rotated_lattice_points(n, 25); }},
    {"lattice_turned_45",
     [](std::size_t n, std::uint64_t) { return rotated_lattice_points(n, 45); }},
    {"lattice_turned",
     [](std::size_t n, std::uint64_t s) {
       return rotated_lattice_points(n, SplitMix64(s).between(0, 360));
     }},
    {"lattice_quarters",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(mapped(lattice_points(n),
                              [](Point2 p) {
                                return Point2{0.25 + 0.25 * p.x, 0.5 + 0.25 * p.y};
                              }),
                       s);
     }},
    {"lattice_tenths",
     [](std::size_t n, std::uint64_t) {
       return mapped(lattice_points(n), [](Point2 p) {
         return Point2{0.1 * p.x, 0.1 * p.y};
       });
     }},
    {"lattice_far_from_origin",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(mapped(lattice_points(n),
                              [](Point2 p) {
                                return Point2{p.x + 0x1p52, p.y - 0x1p52};
                              }),
                       s);
     }},
    {"integers_few",
     [](std::size_t n, std::uint64_t s) { return small_integers(n, s, 6); }},
    {"integers_many",
     [](std::size_t n, std::uint64_t s) { return small_integers(n, s, 40); }},
    {"circle", [](std::size_t n, std::uint64_t) { return circle_points(n); }},
    {"circle_shuffled",
     [](std::size_t n, std::uint64_t s) { return shuffled(circle_points(n), s); }},
    {"circle_of_integers",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(integer_circle_points(n), s);
     }},
    {"polygon", [](std::size_t n, std::uint64_t) { return polygon_points(n, 1); }},
    {"polygon_huge",
     [](std::size_t n, std::uint64_t) { return polygon_points(n, 1e300); }},
    {"arc_of_degrees",
     [](std::size_t n, std::uint64_t) {
       return count(n, [](std::size_t i) {
         const double a = number(i) * std::numbers::pi / 180 / 20;
         return Point2{100 * std::cos(a), 100 * std::sin(a)};
       });
     }},
    {"wheel", [](std::size_t n, std::uint64_t) { return wheel_points(n); }},
    {"collinear",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(count(n,
                             [](std::size_t i) {
                               return Point2{number(i), 3 * number(i)};
                             }),
                       s);
     }},
    {"collinear_hundredths",
     [](std::size_t n, std::uint64_t) {
       return count(n, [](std::size_t i) {
         return Point2{0.01 * number(i), 0.01 * number(i)};
       });
     }},
    {"collinear_vertical",
     [](std::size_t n, std::uint64_t s) {
       return draw(n, s, [](SplitMix64& r) { return Point2{0.1, r.uniform()}; });
     }},
    {"collinear_and_one",
     [](std::size_t n, std::uint64_t s) {
       PlanePoints points = count(n, [](std::size_t i) {
         return Point2{number(i), -2 * number(i)};
       });
       points.push_back({0.5, 7});
       return shuffled(points, s);
     }},
    {"collinear_almost", almost_collinear},
    {"sum_to_one",
     [](std::size_t n, std::uint64_t s) {
       return draw(n, s, [](SplitMix64& r) {
         const double x = number(r.below(101)) / 100;
         return Point2{x, 1 - x};
       });
     }},
    {"two_lines", two_lines},
    {"repeats",
     [](std::size_t n, std::uint64_t s) {
       const PlanePoints few = uniform_points(n / 4 + 1, s);
       return draw(n, s + 1, [&](SplitMix64& r) { return few[r.below(few.size())]; });
     }},
    {"repeats_near", near_repeats},
    {"all_the_same",
     [](std::size_t n, std::uint64_t) {
       return PlanePoints(n, {0.1, 0.2});
     }},
    {"huge",
     [](std::size_t n, std::uint64_t s) {
       return mapped(uniform_points(n, s), [](Point2 p) {
         return Point2{p.x * 1e300, p.y * 1e300};
       });
     }},
    {"largest", largest},
    {"tiny",
     [](std::size_t n, std::uint64_t s) {
       return mapped(uniform_points(n, s), [](Point2 p) {
         return Point2{p.x * 1e-300, p.y * 1e-300};
       });
     }},
    {"tiny_products",
     [](std::size_t n, std::uint64_t s) {
       return mapped(uniform_points(n, s), [](Point2 p) {
         return Point2{p.x * 1e-170, p.y * 1e-170};
       });
     }},
    {"tiniest",
     [](std::size_t n, std::uint64_t s) {
       return mapped(small_integers(n, s, 40), [](Point2 p) {
         return Point2{p.x * tiniest, p.y * tiniest};
       });
     }},
    {"all_scales", all_scales},
    {"one_far_away", one_far_away},
    {"short_hull_edge", short_hull_edge},
    {"far_from_origin",
     [](std::size_t n, std::uint64_t s) {
       return mapped(uniform_points(n, s), [](Point2 p) {
         return Point2{5.1e6 + p.x, 5.1e6 + p.y};
       });
     }},
    {"stretched",
     [](std::size_t n, std::uint64_t s) {
       return mapped(uniform_points(n, s), [](Point2 p) {
         return Point2{p.x * 1e-6, p.y * 1e6};
       });
     }},
    {"needles",
     [](std::size_t n, std::uint64_t s) {
       return draw(n, s, [](SplitMix64& r) {
         const double x = number(r.below(2)) * 1e-6;
         return Point2{x, 53 * r.uniform()};
       });
     }},
    {"sorted",
     [](std::size_t n, std::uint64_t s) { return sorted(uniform_points(n, s)); }},
    {"sorted_backwards",
     [](std::size_t n, std::uint64_t s) {
       PlanePoints points = sorted(uniform_points(n, s));
       std::reverse(points.begin(), points.end());
       return points;
     }},
    {"spiral", spiral},
    {"kuzmin", kuzmin},
    {"line_clustered", near_line},
    {"star", star},
    {"symmetric", symmetric},
    {"signed_zeros",
     [](std::size_t n, std::uint64_t s) {
       return draw(n, s, [](SplitMix64& r) {
         const std::array<double, 5> values{0.0, -0.0, 1, -1, 0.5};
         const double x = values[r.below(5)], y = values[r.below(5)];
         return Point2{x, y};
       });
     }},
};

}  // namespace

std::span<const PlaneFamily> plane_families() { return families; }

PlanePoints uniform_points(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double x = r.uniform(), y = r.uniform();
    return Point2{x, y};
  });
}

PlanePoints clustered_points(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::array<Point2, 32> centers;
  for (Point2& c : centers) {
    c.x = random.uniform();
    c.y = random.uniform();
  }
  const auto bell = [&] {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return 0.01 * (sum - 6.0);
  };
  return count(n, [&](std::size_t) {
    const Point2 center = centers[static_cast<std::size_t>(random.next() >> 59)];
    const double x = center.x + bell(), y = center.y + bell();
    return Point2{x, y};
  });
}

PlanePoints lattice_points(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(number(n))));
  return count(side * side, [&](std::size_t i) {
    return Point2{number(i % side), number(i / side)};
  });
}

PlanePoints circle_points(std::size_t n) {
  const std::size_t quarter = n / 4;
  return count(4 * quarter, [&](std::size_t i) {
    const double t = (number(i % quarter) + 0.5) / number(quarter), d = 1 + t * t;
    const double c = (1 - t * t) / d, s = 2 * t / d;
    const std::array<Point2, 4> turned{{{c, s}, {-s, c}, {-c, -s}, {s, -c}}};
    return turned[i / quarter];
  });
}

PlanePoints polygon_points(std::size_t n, double radius) {
  return count(n, [&](std::size_t i) {
    const double angle = 2 * std::numbers::pi * number(i) / number(n);
    return Point2{radius * std::cos(angle), radius * std::sin(angle)};
  });
}

PlanePoints integer_circle_points(std::size_t n) {
  constexpr int radius = 5 * 13 * 17;
  PlanePoints points;
  for (int x = -radius; x <= radius; ++x) {
    const int y = static_cast<int>(std::lround(std::sqrt(radius * radius - x * x)));
    if (x * x + y * y != radius * radius) continue;
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y > 0) points.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  points.resize(std::min(n, points.size()));
  return points;
}

PlanePoints wheel_points(std::size_t n) {
  PlanePoints points = polygon_points(n > 0 ? n - 1 : 0, 1);
  points.push_back({0, 0});
  return points;
}

PlanePoints rotated_lattice_points(std::size_t n, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  return mapped(lattice_points(n), [&](Point2 p) {
    return Point2{c * p.x - s * p.y, s * p.x + c * p.y};
  });
}

}  // namespace delone::support
