// Time of Voronoi areas, cells with centroids, and whole diagrams.
//
//   voronoi_bench [--points N] [--repeats R] [--threads T]
//
// Medians of R runs (5) on triangulations built beforehand, by the clock and of processor
// time, and how far the areas' sum is from what they cover.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "stripack/voronoi.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/voronoi.hpp"

namespace delone::bench {
namespace {

struct Settings {
  std::size_t num_points = 1000000;
  int repeats = 5;
  int num_threads = 1;
};

void time(const Settings& s, const std::string& what, std::int64_t num_points,
          const std::function<void()>& run) {
  std::vector<double> wall, cpu;
  for (int i = 0; i < s.repeats; ++i) {
    const Seconds t = seconds(run);
    wall.push_back(1e3 * t.wall);
    cpu.push_back(1e3 * t.cpu);
  }
  std::printf("%-42s %9lld %9.1f %8.1f %8.1f %9.1f\n", what.c_str(),
              static_cast<long long>(num_points), spread(wall).median, spread(wall).min,
              spread(wall).max, spread(cpu).median);
  std::fflush(stdout);
}

void print_error(const std::vector<double>& areas, double whole) {
  long double sum = 0;
  for (const double area : areas) sum += area;
  std::printf("%-42s %.1e\n", "  sum / whole - 1", static_cast<double>(sum / whole - 1));
}

void plane(const Settings& s, const std::string& name,
           const support::PlanePoints& points) {
  const RunOptions run{.num_threads = s.num_threads, .progress = {}};
  const auto t = std::make_shared<const tripack::Triangulation>(points, run);
  const auto region = tripack::Region::box({0.001, 0.001}, {0.999, 0.999});
  std::vector<double> areas;
  time(s, name + ", areas in a box", t->num_sites(),
       [&] { areas = tripack::voronoi_areas(*t, region, run); });
  print_error(areas, region.area());
  time(s, name + ", areas and centroids", t->num_sites(),
       [&] { (void)tripack::voronoi_measures(*t, region, run); });
  time(s, name + ", diagram", t->num_sites(), [&] { tripack::Voronoi(t, run); });
}

void sphere(const Settings& s, const std::string& name,
            const support::SpherePoints& points) {
  const RunOptions run{.num_threads = s.num_threads, .progress = {}};
  const auto t = std::make_shared<const stripack::Triangulation>(points, run);
  std::vector<double> areas;
  time(s, name + ", areas", t->num_sites(),
       [&] { areas = stripack::voronoi_areas(*t, run); });
  print_error(areas, 4 * std::numbers::pi);
  time(s, name + ", areas and centroids", t->num_sites(),
       [&] { (void)stripack::voronoi_measures(*t, run); });
  time(s, name + ", diagram", t->num_sites(), [&] { stripack::Voronoi(t, run); });
}

Settings parse(int argc, char** argv) {
  Settings s;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--points") s.num_points = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--repeats") s.repeats = std::atoi(argv[i + 1]);
    if (option == "--threads") s.num_threads = std::atoi(argv[i + 1]);
  }
  return s;
}

void run(const Settings& s) {
  std::printf("%-42s %9s %9s %8s %8s %9s\n", "", "sites", "median ms", "min", "max",
              "cpu");
  support::PlanePoints lattice =
      support::shuffled(support::lattice_points(s.num_points), 1);
  const double side = std::sqrt(static_cast<double>(s.num_points));
  for (tripack::Point2& p : lattice) p = {p.x / side, p.y / side};
  plane(s, "uniform", support::uniform_points(s.num_points, 1));
  plane(s, "clusters", support::clustered_points(s.num_points, 1));
  plane(s, "lattice", lattice);
  sphere(s, "sphere", support::uniform_directions(s.num_points, 1));
  sphere(s, "tracks", support::track_directions(s.num_points));
  sphere(s, "0.5-degree grid", support::radian_grid_directions(0.5));
}

}  // namespace
}  // namespace delone::bench

int main(int argc, char** argv) {
  const delone::bench::Settings settings = delone::bench::parse(argc, argv);
  if (settings.repeats < 1) return 2;
  delone::bench::run(settings);
}
