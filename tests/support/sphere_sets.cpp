#include "support/sphere_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "support/random.hpp"

namespace delone::support {

namespace {

using stripack::Direction;
using stripack::LonLat;
using Limits = std::numeric_limits<double>;
constexpr double radian = std::numbers::pi / 180;

double number(std::size_t i) { return static_cast<double>(i); }

template <class F>
SpherePoints draw(std::size_t n, std::uint64_t seed, F point) {
  SplitMix64 random(seed);
  SpherePoints points;
  points.reserve(n);
  while (points.size() < n) points.push_back(point(random));
  return points;
}

template <class F>
SpherePoints count(std::size_t n, F point) {
  SpherePoints points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(point(i));
  return points;
}

SpherePoints directions(const std::vector<LonLat>& places) {
  SpherePoints points;
  points.reserve(places.size());
  for (const LonLat& p : places) points.push_back(Direction::from(p));
  return points;
}

Direction midpoint(const Direction& a, const Direction& b) {
  return Direction::from(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
}

// A step such that the global grid has about n rows.
double grid_step(std::size_t n) {
  const double rows = std::max(2.0, std::floor(std::sqrt(number(n) / 2)));
  return 180 / rows;
}

std::vector<LonLat> without_repeated_poles(std::vector<LonLat> grid) {
  std::erase_if(grid,
                [](LonLat p) { return std::abs(p.lat_deg) == 90 && p.lon_deg != -180; });
  return grid;
}

// Uniform in the cap of `radius` degrees around a point that is nothing special.
SpherePoints cap(std::size_t n, std::uint64_t seed, double radius) {
  return draw(n, seed, [&](SplitMix64& r) {
    const double z = r.between(std::cos(radius * radian), 1),
                 a = r.between(0, 2 * std::numbers::pi);
    const double rho = std::sqrt(1 - z * z), x = rho * std::cos(a), y = rho * std::sin(a);
    return Direction::from(0.6 * x - 0.8 * z, y, 0.8 * x + 0.6 * z);
  });
}

// The upper half, its boundary included.
SpherePoints closed_hemisphere(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double lat = r.below(3) == 0 ? 0 : r.between(0, 90);
    return Direction::from(LonLat{r.between(-180, 180), lat});
  });
}

// Orbits of the octahedral group, as in Lebedev's quadratures: all signs and
// permutations.
SpherePoints octahedral_orbits(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  SpherePoints points;
  for (std::size_t orbit = 0; points.size() < n; ++orbit) {
    std::array<double, 3> v{0, 0, 1};
    if (orbit == 1) v = {1, 1, 1};
    if (orbit == 2) v = {0, 1, 1};
    if (orbit > 2) v = {random.uniform(), random.uniform(), random.uniform()};
    if (orbit > 2 && orbit % 2 == 0) v[1] = v[0];
    std::set<std::array<double, 3>> images;
    std::sort(v.begin(), v.end());
    do {
      for (int s = 0; s < 8; ++s) {
        images.insert({(s & 1 ? -v[0] : v[0]) + 0.0, (s & 2 ? -v[1] : v[1]) + 0.0,
                       (s & 4 ? -v[2] : v[2]) + 0.0});
      }
    } while (std::next_permutation(v.begin(), v.end()));
    for (const auto& w : images) points.push_back(Direction::from(w[0], w[1], w[2]));
  }
  return points;
}

SpherePoints cubed_sphere(std::size_t n, std::uint64_t) {
  const auto side = static_cast<std::size_t>(std::max(1.0, std::sqrt(number(n) / 6)));
  SpherePoints points;
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto tangent = [&](std::size_t k) {
        return std::tan(((2 * number(k) + 1) / number(side) - 1) * std::numbers::pi / 4);
      };
      std::array<double, 3> v{};
      v[face % 3] = face < 3 ? 1 : -1;
      v[(face + 1) % 3] = tangent(i % side);
      v[(face + 2) % 3] = tangent(i / side);
      points.push_back(Direction::from(v[0], v[1], v[2]));
    }
  }
  return points;
}

// Centres of HEALPix cells, ring by ring (Gorski et al., Astrophys. J. 622 (2005), eqs. 4
// to 9).
SpherePoints healpix(std::size_t n, std::uint64_t) {
  const double sides = std::max(1.0, std::floor(std::sqrt(number(n) / 12)));
  SpherePoints points;
  for (double i = 1; i < 4 * sides; ++i) {
    const double k = std::min({i, 4 * sides - i, sides});
    const bool is_cap = k < sides;
    const double z = !is_cap ? 4.0 / 3 - 2 * i / (3 * sides)
                             : (i < sides ? 1 : -1) * (1 - k * k / (3 * sides * sides));
    const double shift = is_cap || std::fmod(i - sides, 2) == 0 ? 0.5 : 1;
    const double rho = std::sqrt(1 - z * z);
    for (double j = 1; j <= 4 * k; ++j) {
      const double lon = std::numbers::pi / (2 * k) * (j - shift);
      points.push_back(Direction::from(rho * std::cos(lon), rho * std::sin(lon), z));
    }
  }
  return points;
}

// Latitude rows with 20, 24, 28, ... points towards the equator.
SpherePoints reduced_grid(std::size_t n, std::uint64_t) {
  const auto rows = static_cast<std::size_t>(std::max(2.0, std::sqrt(number(n) / 4)));
  SpherePoints points;
  for (std::size_t j = 0; j < rows; ++j) {
    const double lat = -90 + (number(j) + 0.5) * 180 / number(rows);
    const std::size_t columns = 4 * (std::min(j, rows - 1 - j) + 1) + 4;
    for (std::size_t i = 0; i < columns; ++i) {
      points.push_back(Direction::from(LonLat{360 * number(i) / number(columns), lat}));
    }
  }
  return points;
}

SpherePoints antipodal_pairs(std::size_t n, std::uint64_t seed) {
  SpherePoints points = uniform_directions(n / 2, seed);
  for (std::size_t i = 0; i < n / 2; ++i) {
    points.push_back(Direction::from(-points[i].x(), -points[i].y(), -points[i].z()));
  }
  return points;
}

double moved_by_ulps(double value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, 2);
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -2);
  return value;
}

// Groups of points an ulp apart in some components; some are one direction at two
// lengths.
SpherePoints ulps_apart(std::size_t n, std::uint64_t seed) {
  const SpherePoints bases = octahedral_orbits(n / 5 + 1, seed);
  return draw(n, seed, [&](SplitMix64& r) {
    const Direction& base = bases[r.below(bases.size())];
    const auto step = [&] { return static_cast<int>(r.below(3)) - 1; };
    const double x = moved_by_ulps(base.x(), step()), y = moved_by_ulps(base.y(), step());
    return Direction::from(x, y, moved_by_ulps(base.z(), step()));
  });
}

// Components down to the smallest doubles beside the axes.
SpherePoints tiny_components(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    std::array<double, 3> v{};
    for (double& c : v) {
      const int exponent = -static_cast<int>(r.below(1070));
      c = std::ldexp(r.between(-1, 1), exponent);
    }
    v[r.below(3)] = r.below(2) == 0 ? 1 : -1;
    return Direction::from(v[0], v[1], v[2]);
  });
}

// Vectors of all lengths, which are directions all the same.
SpherePoints any_length(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed + 1);
  SpherePoints points;
  for (const Direction& d : uniform_directions(n, seed)) {
    const std::array<double, 5> lengths{1, 1 + 1e-9, 1e-200, 1e200, 3};
    const double s = lengths[random.below(5)];
    points.push_back(Direction::from(s * d.x(), s * d.y(), s * d.z()));
  }
  return points;
}

SpherePoints meridian(std::size_t n, std::uint64_t seed, double low, double high) {
  return draw(n, seed, [&](SplitMix64& r) {
    return Direction::from(LonLat{0, r.between(low, high)});
  });
}

template <class F>
SpherePoints with(SpherePoints points, F extra) {
  for (const LonLat& p : extra) points.push_back(Direction::from(p));
  return points;
}

SpherePoints circle_of_latitude(std::size_t n, double lat_deg) {
  return count(n, [&](std::size_t i) {
    return Direction::from(LonLat{360 * number(i) / number(n), lat_deg});
  });
}

SpherePoints city(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double lon = 2.35 + 0.01 * std::floor(r.uniform() * 1000) / 100;
    return Direction::from(
        LonLat{lon, 48.85 + 0.01 * std::floor(r.uniform() * 1000) / 100});
  });
}

constexpr std::array<LonLat, 2> both_poles{{{0, 90}, {0, -90}}};

constexpr SphereFamily families[] = {
    {"uniform", uniform_directions},
    {"uniform_by_latitude",
     [](std::size_t n, std::uint64_t s) {
       SpherePoints points = uniform_directions(n, s);
       std::sort(points.begin(), points.end(),
                 [](const Direction& a, const Direction& b) { return a.z() < b.z(); });
       return points;
     }},
    {"global_grid",
     [](std::size_t n, std::uint64_t) { return directions(global_grid(grid_step(n))); }},
    {"global_grid_shuffled",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(directions(global_grid(grid_step(n))), s);
     }},
    {"global_grid_one_row_a_pole",
     [](std::size_t n, std::uint64_t) {
       return directions(without_repeated_poles(global_grid(grid_step(n))));
     }},
    {"radian_grid",
     [](std::size_t n, std::uint64_t) { return radian_grid_directions(grid_step(n)); }},
    {"northern_grid",
     [](std::size_t n, std::uint64_t) {
       auto grid = global_grid(grid_step(2 * n));
       std::erase_if(grid, [](LonLat p) { return p.lat_deg < 0; });
       return directions(grid);
     }},
    {"regional_grid",
     [](std::size_t n, std::uint64_t) {
       const auto side = static_cast<std::size_t>(std::max(2.0, std::sqrt(number(n))));
       return count(side * side, [&](std::size_t i) {
         return Direction::from(
             LonLat{5 + 0.1 * number(i % side), 40 + 0.1 * number(i / side)});
       });
     }},
    {"tracks", [](std::size_t n, std::uint64_t) { return track_directions(n); }},
    {"fibonacci", [](std::size_t n, std::uint64_t) { return fibonacci_directions(n); }},
    {"icosahedral",
     [](std::size_t n, std::uint64_t) {
       int level = 0;
       while (level < 9 && 10u * (std::size_t{4} << (2 * level)) + 2 <= n) ++level;
       return icosahedral_directions(level);
     }},
    {"cubed_sphere", cubed_sphere},
    {"healpix", healpix},
    {"reduced_grid", reduced_grid},
    {"octahedral_orbits", octahedral_orbits},
    {"octahedral_orbits_shuffled",
     [](std::size_t n, std::uint64_t s) { return shuffled(octahedral_orbits(n, s), s); }},
    {"antipodal_pairs", antipodal_pairs},
    {"cap_40", [](std::size_t n, std::uint64_t s) { return cap(n, s, 40); }},
    {"cap_1", [](std::size_t n, std::uint64_t s) { return cap(n, s, 1); }},
    {"cap_170", [](std::size_t n, std::uint64_t s) { return cap(n, s, 170); }},
    {"hemisphere_open", [](std::size_t n, std::uint64_t s) { return cap(n, s, 89.9); }},
    {"hemisphere_closed", closed_hemisphere},
    {"box_of_micro_radians",
     [](std::size_t n, std::uint64_t s) { return box_directions(n, s, 1e-6); }},
    {"box_of_nano_radians",
     [](std::size_t n, std::uint64_t s) { return box_directions(n, s, 1e-9); }},
    {"box_of_pico_radians",
     [](std::size_t n, std::uint64_t s) { return box_directions(n, s, 1e-12); }},
    {"box_of_femto_radians",
     [](std::size_t n, std::uint64_t s) { return box_directions(n, s, 1e-15); }},
    {"city", city},
    {"equator", [](std::size_t n, std::uint64_t) { return circle_of_latitude(n, 0); }},
    {"equator_and_poles",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(with(circle_of_latitude(n, 0), both_poles), s);
     }},
    {"equator_and_one_pole",
     [](std::size_t n, std::uint64_t s) {
       return shuffled(with(circle_of_latitude(n, 0), std::array<LonLat, 1>{{{0, 90}}}),
                       s);
     }},
    {"meridian", [](std::size_t n, std::uint64_t s) { return meridian(n, s, -80, 70); }},
    {"meridian_and_one",
     [](std::size_t n, std::uint64_t s) {
       return with(meridian(n, s, -80, 70), std::array<LonLat, 1>{{{20, 5}}});
     }},
    {"meridian_pole_to_pole",
     [](std::size_t n, std::uint64_t s) {
       return with(meridian(n, s, -90, 90), both_poles);
     }},
    {"lune",
     [](std::size_t n, std::uint64_t s) {
       return with(draw(n, s,
                        [](SplitMix64& r) {
                          const double lon = r.below(2) == 0 ? 0 : 30;
                          return Direction::from(LonLat{lon, r.between(-85, 85)});
                        }),
                   both_poles);
     }},
    {"circle_of_latitude",
     [](std::size_t n, std::uint64_t) { return circle_of_latitude(n, 60); }},
    {"circle_of_latitude_and_pole",
     [](std::size_t n, std::uint64_t) {
       return with(circle_of_latitude(n, 60), std::array<LonLat, 1>{{{0, 90}}});
     }},
    {"poles_many_times",
     [](std::size_t n, std::uint64_t s) {
       return draw(n, s, [](SplitMix64& r) {
         const double lat =
             r.below(2) == 0 ? (r.below(2) == 0 ? 90 : -90) : r.between(-90, 90);
         return Direction::from(LonLat{r.between(-720, 720), lat});
       });
     }},
    {"ulps_apart", ulps_apart},
    {"tiny_components", tiny_components},
    {"any_length", any_length},
    {"all_the_same",
     [](std::size_t n, std::uint64_t) {
       return SpherePoints(n, Direction::from(LonLat{12, 34}));
     }},
};

}  // namespace

std::span<const SphereFamily> sphere_families() { return families; }

SpherePoints uniform_directions(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    double u = 0, v = 0, s = 1;
    while (s >= 1) {
      u = 2 * r.uniform() - 1;
      v = 2 * r.uniform() - 1;
      s = u * u + v * v;
    }
    const double q = std::sqrt(1 - s);
    return Direction::from(2 * u * q, 2 * v * q, 1 - 2 * s);
  });
}

SpherePoints track_directions(std::size_t n) {
  const double inclination = 66 * radian;
  return count(n, [&](std::size_t i) {
    const double revolution = 127.0 * number(i) / number(n);
    const double u = 2 * std::numbers::pi * (revolution - std::floor(revolution));
    const double turn = -2 * std::numbers::pi * revolution * 10.0 / 127.0;
    const double x = std::cos(u), y = std::sin(u) * std::cos(inclination);
    return Direction::from(x * std::cos(turn) - y * std::sin(turn),
                           x * std::sin(turn) + y * std::cos(turn),
                           std::sin(u) * std::sin(inclination));
  });
}

std::vector<LonLat> global_grid(double step_deg) {
  const auto columns = std::lround(360 / step_deg), rows = std::lround(180 / step_deg);
  std::vector<LonLat> grid;
  for (long j = 0; j <= rows; ++j) {
    for (long i = 0; i <= columns; ++i) {
      const double lon = i == columns ? 180 : -180 + static_cast<double>(i) * step_deg;
      grid.push_back({lon, j == rows ? 90 : -90 + static_cast<double>(j) * step_deg});
    }
  }
  return grid;
}

SpherePoints radian_grid_directions(double step_deg) {
  const auto columns = std::lround(360 / step_deg), rows = std::lround(180 / step_deg);
  SpherePoints points{Direction::from(0, 0, -1)};
  for (long j = 1; j < rows; ++j) {
    const double lat = (-90 + static_cast<double>(j) * step_deg) * radian;
    const double c = std::cos(lat), s = std::sin(lat);
    for (long i = 0; i < columns; ++i) {
      const double lon = static_cast<double>(i) * step_deg * radian;
      points.push_back(Direction::from(c * std::cos(lon), c * std::sin(lon), s));
    }
  }
  points.push_back(Direction::from(0, 0, 1));
  return points;
}

SpherePoints box_directions(std::size_t n, std::uint64_t seed, double side) {
  return draw(n, seed, [&](SplitMix64& r) {
    const double lon = 0.3 + side * r.uniform(), lat = 0.7 + side * r.uniform();
    return Direction::from(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon),
                           std::sin(lat));
  });
}

SpherePoints fibonacci_directions(std::size_t n) {
  return count(n, [&](std::size_t i) {
    const double z = 1 - (2 * number(i) + 1) / number(n), rho = std::sqrt(1 - z * z);
    const double lon = number(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    return Direction::from(rho * std::cos(lon), rho * std::sin(lon), z);
  });
}

SpherePoints icosahedral_directions(int level) {
  const double g = std::numbers::phi;
  SpherePoints points;
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-g, g}) {
      points.push_back(Direction::from(0, s, t));
      points.push_back(Direction::from(s, t, 0));
      points.push_back(Direction::from(t, 0, s));
    }
  }
  // Edges are the pairs at the smallest distance; halving them halves the distance,
  // nearly.
  double edge = 1.2;
  for (int l = 0; l < level; ++l, edge *= 0.56) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (angle(points[i], points[j]) < edge)
          points.push_back(midpoint(points[i], points[j]));
      }
    }
  }
  return points;
}

}  // namespace delone::support
