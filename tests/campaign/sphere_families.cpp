#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "campaign/families.hpp"
#include "support/random.hpp"

namespace delone::campaign {

namespace {

using stripack::Direction;
using stripack::LonLat;
using support::SpherePoints;
using support::SplitMix64;

double number(std::size_t i) { return static_cast<double>(i); }

template <class F>
SpherePoints draw(std::size_t n, std::uint64_t seed, F point) {
  SplitMix64 random(seed);
  SpherePoints points;
  while (points.size() < n) points.push_back(point(random));
  return points;
}

SphereVariant from_support(std::string_view name) {
  for (const support::SphereFamily& f : support::sphere_families()) {
    if (name == f.name) return {f.name, f.make};
  }
  throw std::logic_error("no family " + std::string(name));
}

template <class... Names>
std::vector<SphereVariant> variants(std::vector<SphereVariant> own, Names... names) {
  (own.push_back(from_support(names)), ...);
  return own;
}

Direction direction(double x, double y, double z) { return Direction::from(x, y, z); }

// Small whole components: planes through three of them are shared by many.
SpherePoints whole_vectors(std::size_t n, std::uint64_t seed) {
  const std::size_t reach = 1 + SplitMix64(seed).below(4);
  return draw(n, seed + 1, [&](SplitMix64& r) {
    for (;;) {
      const auto any = [&] { return number(r.below(2 * reach + 1)) - number(reach); };
      const double x = any(), y = any(), z = any();
      if (x != 0 || y != 0 || z != 0) return direction(x, y, z);
    }
  });
}

// Nodes 1 to 3 on a great circle, the rest anywhere, in this order but for a shuffle.
SpherePoints first_three_on_a_great_circle(std::size_t n, std::uint64_t seed) {
  SpherePoints points{direction(1, 0, 0), direction(0, 1, 0), direction(3, 4, 0)};
  const SpherePoints rest = support::uniform_directions(n, seed);
  points.insert(points.end(), rest.begin(), rest.end());
  return points;
}

// On one great circle exactly, a plane with small whole coefficients.
SpherePoints one_great_circle(std::size_t n, std::uint64_t seed) {
  const int axis = static_cast<int>(SplitMix64(seed).below(3));
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double a = r.between(-1, 1), b = r.between(-1, 1) + 0x1p-60;
    return axis == 0 ? direction(a, a, b)
                     : (axis == 1 ? direction(b, 0, a) : direction(a, b, -a));
  });
}

SpherePoints random_grid(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const std::size_t rows = 2 + random.below(n / 3 + 1), columns = n / rows + 1;
  const double south = random.between(-90, 60), west = random.between(-400, 400);
  const double dlat = (90 - south) / number(rows), dlon = random.below(2) == 0
                                                              ? 360 / number(columns)
                                                              : random.between(0.1, 9);
  SpherePoints points;
  for (std::size_t i = 0; i < rows * columns; ++i) {
    points.push_back(
        Direction::from(LonLat{west + dlon * number(i % columns),
                               std::min(90.0, south + dlat * number(i / columns))}));
  }
  return points;
}

// Caps of every size, the half sphere's among them.
SpherePoints random_cap(std::size_t n, std::uint64_t seed) {
  SplitMix64 random(seed);
  const double lowest = random.below(4) == 0 ? 0 : random.between(-1, 1);
  return draw(n, seed + 1, [&](SplitMix64& r) {
    const double z = r.below(4) == 0 ? lowest : r.between(lowest, 1),
                 rho = std::sqrt(1 - z * z), a = r.between(0, 6.3);
    return direction(rho * std::cos(a), rho * std::sin(a), z);
  });
}

SpherePoints box_of_any_size(std::size_t n, std::uint64_t seed) {
  const double side = std::pow(10, -SplitMix64(seed).between(0, 16));
  return support::box_directions(n, seed + 1, side);
}

// Fewer than 700 places of a city to five decimals.
SpherePoints streets(std::size_t n, std::uint64_t seed) {
  return draw(n, seed, [](SplitMix64& r) {
    const double lon = 235000 + number(r.below(120)),
                 lat = 4885000 + number(r.below(120));
    return Direction::from(LonLat{lon / 1e5, lat / 1e5});
  });
}

// The axes and opposites of a few whole vectors.
SpherePoints axes_and_opposites(std::size_t n, std::uint64_t seed) {
  SpherePoints points = whole_vectors(n / 2 + 1, seed);
  for (std::size_t i = points.size(); i-- > 0;)
    points.push_back(direction(-points[i].x(), -points[i].y(), -points[i].z()));
  return points;
}

// Components whose products, or whose products' rounding errors, underflow.
SpherePoints underflowing(std::size_t n, std::uint64_t seed) {
  constexpr std::array<double, 9> sizes{1,      1,      1,      7.49e-80, 1.95e-90,
                                        1e-162, 1e-300, 5e-324, 0};
  return draw(n, seed, [&](SplitMix64& r) {
    for (;;) {
      const auto any = [&] {
        return (number(r.below(5)) - 2) * sizes[r.below(sizes.size())];
      };
      const double x = any(), y = any(), z = any();
      if (x != 0 || y != 0 || z != 0) return direction(x, y, z);
    }
  });
}

std::vector<Family> make_families() {
  using Variants = std::vector<SphereVariant>;
  const auto family = [](const char* id, const char* title, Variants sphere) {
    return Family{id, title, Extra::none, {}, std::move(sphere)};
  };
  return {
      family("S1", "octahedral symmetry, as in Lebedev's rules",
             variants(Variants{{"whole_vectors", whole_vectors}}, "octahedral_orbits",
                      "octahedral_orbits_shuffled")),
      family("S2", "first three or all on a great circle",
             variants(Variants{{"first_three", first_three_on_a_great_circle},
                               {"one_great_circle", one_great_circle}},
                      "equator", "meridian", "meridian_and_one", "meridian_pole_to_pole",
                      "equator_and_poles", "equator_and_one_pole", "lune")),
      family("S3", "longitude-latitude grid",
             variants(Variants{{"random_grid", random_grid}}, "global_grid",
                      "global_grid_shuffled", "radian_grid")),
      family("S4", "grid with one point a pole and both +-180",
             variants(Variants{}, "global_grid_one_row_a_pole", "northern_grid",
                      "global_grid")),
      family("S5", "hemispheres and caps",
             variants(Variants{{"random_cap", random_cap}}, "cap_40", "cap_1", "cap_170",
                      "hemisphere_open", "hemisphere_closed", "regional_grid",
                      "circle_of_latitude", "circle_of_latitude_and_pole")),
      family("S6", "one city",
             variants(Variants{{"streets", streets}}, "city", "box_of_micro_radians")),
      family(
          "S7", "closer than 2^-25, down to an ulp",
          variants(Variants{{"box_of_any_size", box_of_any_size}}, "box_of_nano_radians",
                   "box_of_pico_radians", "box_of_femto_radians", "ulps_apart")),
      family("S8", "opposite pairs, axes, cube, poles many times",
             variants(Variants{{"axes_and_opposites", axes_and_opposites}},
                      "antipodal_pairs", "poles_many_times")),
      family("S9", "components that underflow",
             variants(Variants{{"underflowing", underflowing}}, "tiny_components")),
      family("S10", "vectors of any length", variants(Variants{}, "any_length")),
      family("S11", "grids of models: nothing but ties",
             variants(Variants{}, "icosahedral", "cubed_sphere", "healpix",
                      "reduced_grid", "fibonacci", "tracks", "uniform",
                      "uniform_by_latitude", "all_the_same")),
  };
}

// Exact: the rotations and reflections of the cube.
SpherePoints turned_exactly(const SpherePoints& points, std::uint64_t bits) {
  const std::size_t shift = bits % 3;
  const auto sign = [&](std::size_t k) {
    return (bits >> (8 + k) & 1) != 0 ? -1.0 : 1.0;
  };
  SpherePoints turned;
  for (const Direction& d : points) {
    const std::array<double, 3> v{d.x(), d.y(), d.z()};
    turned.push_back(direction(sign(0) * v[shift], sign(1) * v[(shift + 1) % 3],
                               sign(2) * v[(shift + 2) % 3]));
  }
  return turned;
}

}  // namespace

const std::vector<Family>& sphere_families() {
  static const std::vector<Family> families = make_families();
  return families;
}

SphereSet make_sphere_set(const Family& family, std::uint64_t seed, std::size_t n) {
  SplitMix64 random(seed);
  const SphereVariant& variant = family.sphere[random.below(family.sphere.size())];
  SpherePoints points = variant.make(n, random.next());
  if (random.below(2) == 0) {
    const double kept = random.between(0.5, 1);
    std::erase_if(points, [&](const Direction&) { return random.uniform() > kept; });
  }
  if (random.below(2) == 0) points = turned_exactly(points, random.next());
  for (std::size_t i = random.below(8) == 0 ? points.size() / 4 : 0; i > 0; --i)
    points.push_back(points[random.below(points.size())]);
  if (random.below(2) == 0) points = support::shuffled(points, random.next());
  return {variant.name, std::move(points)};
}

std::vector<Family> all_families() {
  std::vector<Family> all = plane_families();
  all.insert(all.end(), sphere_families().begin(), sphere_families().end());
  return all;
}

std::size_t size_of(std::uint64_t seed, std::size_t largest) {
  constexpr double smallest = 3;
  const double u = SplitMix64(~seed).uniform();
  return static_cast<std::size_t>(smallest / (1 - u * (1 - smallest / number(largest))));
}

}  // namespace delone::campaign
