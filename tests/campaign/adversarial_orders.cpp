// How long the families that make other codes slow take against a uniform set of the same
// size. A table: nanoseconds a point, and how many times the uniform set's.
//
//   adversarial_orders [POINTS] [REPEATS]     200000, 5: the median counts
//
// One thread, processor time; times of one run are compared with each other only.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/families.hpp"
#include "stripack/triangulation.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/triangulation.hpp"

namespace {

using namespace delone;

template <class Triangulation, class Points>
double nanoseconds_a_point(const Points& points, int repeats) {
  // Processor time: one thread, and the machine may have other work.
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t begin = std::clock();
    const Triangulation t(points, {.num_threads = 1, .progress = {}});
    times.push_back(1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (t.num_rows() != static_cast<std::int64_t>(points.size())) std::abort();
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[static_cast<std::size_t>(repeats / 2)] /
         static_cast<double>(points.size());
}

// The uniform set again for every family: the machine's speed changes with the hour.
template <class Triangulation, class Points, class Families>
void print_table(const char* room, const Points& uniform, const Families& families,
                 std::size_t n, int repeats) {
  std::printf("%-36s %10s %12s %12s\n", room, "points", "ns a point", "x uniform");
  for (const auto& family : families) {
    const Points points = family.make(n, 1);
    const double base = nanoseconds_a_point<Triangulation>(uniform, repeats);
    const double time = nanoseconds_a_point<Triangulation>(points, repeats);
    std::printf("%-36s %10zu %12.1f %12.2f\n", family.name, points.size(), time,
                time / base);
    std::fflush(stdout);
  }
}

template <class Variant, class Families>
void add_named(std::vector<Variant>& chosen, const Families& families,
               std::initializer_list<std::string_view> names) {
  for (const auto& family : families) {
    if (std::find(names.begin(), names.end(), family.name) != names.end())
      chosen.push_back({family.name, family.make});
  }
}

std::vector<campaign::PlaneVariant> plane_variants() {
  std::vector<campaign::PlaneVariant> chosen;
  add_named(chosen, support::plane_families(),
            {"uniform",
             "clusters",
             "lattice",
             "lattice_shuffled",
             "lattice_tenths",
             "circle",
             "circle_shuffled",
             "polygon",
             "two_lines",
             "spiral",
             "sorted",
             "sorted_backwards",
             "kuzmin",
             "line_clustered",
             "star",
             "wheel",
             "collinear_and_one",
             "integers_few",
             "needles",
             "stretched",
             "lattice_turned_25",
             "far_from_origin",
             "repeats"});
  for (const campaign::Family& family : campaign::plane_families()) {
    add_named(chosen, family.plane,
              {"clusters_of_clusters", "exponential", "sorted_lattice_backwards"});
  }
  return chosen;
}

std::vector<campaign::SphereVariant> sphere_variants() {
  std::vector<campaign::SphereVariant> chosen;
  add_named(chosen, support::sphere_families(),
            {"uniform",
             "uniform_by_latitude",
             "global_grid",
             "global_grid_shuffled",
             "radian_grid",
             "northern_grid",
             "regional_grid",
             "tracks",
             "fibonacci",
             "cubed_sphere",
             "healpix",
             "reduced_grid",
             "octahedral_orbits",
             "equator_and_poles",
             "equator_and_one_pole",
             "lune",
             "meridian_and_one",
             "circle_of_latitude_and_pole",
             "antipodal_pairs",
             "hemisphere_closed",
             "box_of_micro_radians",
             "box_of_nano_radians",
             "cap_1"});
  return chosen;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::stoull(argv[1]) : 200000;
  const int repeats = argc > 2 ? std::stoi(argv[2]) : 5;
  print_table<tripack::Triangulation>("plane", support::uniform_points(n, 2),
                                      plane_variants(), n, repeats);
  print_table<stripack::Triangulation>("sphere", support::uniform_directions(n, 2),
                                       sphere_variants(), n, repeats);
}
