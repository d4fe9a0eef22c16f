// Time and memory of building, beside CGAL on the same points in the same run.
//
//   taskset -c 0 build_bench [--json] [--points N] [--repeats R] [--only SET] [--threads
//   T] [--series S]
//
// A series is S different sets of N points, each built and dropped before the next: small
// sets are what processors learn by heart, branches and all, if one is built again and
// again.
//
// Medians of R builds (5), by the clock and of processor time; memory of a first one.
// CGAL is compiled with -march=native, delone as it ships. Every measurement runs in a
// process of its own.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/cgal_peer.hpp"
#include "bench/measure.hpp"
#include "stripack/triangulation.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/triangulation.hpp"

namespace delone::bench {
namespace {

using support::PlanePoints;
using support::shuffled;
using support::SpherePoints;

struct Settings {
  bool is_json = false;
  std::size_t num_points = 1000000;
  int repeats = 5;
  int num_threads = 1;
  std::uint64_t series = 0;  ///< 0: no series
  std::string only;
};

// A set by name, and the ways to triangulate it.
struct Case {
  std::string name;
  std::function<Job()> ours;
  std::vector<std::pair<std::string, std::function<Job()>>> peers;
};

template <class Triangulation, class Points>
Builder ours(std::shared_ptr<const Points> points, int num_threads) {
  return [=] {
    auto built = std::make_shared<Triangulation>(
        *points, RunOptions{.num_threads = num_threads, .progress = {}});
    return Built{built, built->num_triangles()};
  };
}

template <class Points>
std::int64_t num(const Points& points) {
  return static_cast<std::int64_t>(points.size());
}

Builder in_turn(std::vector<Builder> builders) {
  return [builders = std::move(builders)] {
    Built all;
    for (const Builder& build : builders) all.num_triangles += build().num_triangles;
    return all;
  };
}

// Different uniform sets, one after the other.
Case series_case(const Settings& s) {
  const auto job = [=](const std::function<Builder(const PlanePoints&)>& builder) {
    std::vector<Builder> builders;
    for (std::uint64_t k = 1; k <= s.series; ++k)
      builders.push_back(builder(support::uniform_points(s.num_points, k)));
    return Job{static_cast<std::int64_t>(s.num_points * s.series),
               in_turn(std::move(builders))};
  };
  return {"uniform, series",
          [=] {
            return job([&](const PlanePoints& points) {
              return ours<tripack::Triangulation>(
                  std::make_shared<const PlanePoints>(points), s.num_threads);
            });
          },
          {{"Delaunay_triangulation_2", [=] {
              return job([](const PlanePoints& points) { return cgal_plane(points); });
            }}}};
}

Case plane_case(const std::string& name, std::function<PlanePoints()> make,
                const Settings& s) {
  return {name,
          [=] {
            const auto points = std::make_shared<const PlanePoints>(make());
            return Job{num(*points), ours<tripack::Triangulation>(points, s.num_threads)};
          },
          {{"Delaunay_triangulation_2", [=] {
              const PlanePoints points = make();
              return Job{num(points), cgal_plane(points)};
            }}}};
}

Case sphere_case(const std::string& name, std::function<SpherePoints()> make,
                 const Settings& s) {
  const auto peer = [=](Builder (*builder)(std::span<const stripack::Direction>)) {
    return [=] {
      const SpherePoints points = make();
      return Job{num(points), builder(points)};
    };
  };
  return {
      name,
      [=] {
        const auto points = std::make_shared<const SpherePoints>(make());
        return Job{num(*points), ours<stripack::Triangulation>(points, s.num_threads)};
      },
      {{"on_sphere_2, sphere traits", peer(cgal_sphere)},
       {"on_sphere_2, projection", peer(cgal_sphere_projected)}}};
}

std::vector<Case> cases(const Settings& s) {
  const std::size_t n = s.num_points;
  if (s.series > 0) return {series_case(s)};
  return {plane_case(
              "uniform", [=] { return support::uniform_points(n, 1); }, s),
          plane_case(
              "clusters", [=] { return support::clustered_points(n, 1); }, s),
          plane_case(
              "lattice, shuffled",
              [=] { return shuffled(support::lattice_points(n), 1); }, s),
          plane_case(
              "circle, shuffled",
              [=] { return shuffled(support::circle_points(n / 10), 1); }, s),
          sphere_case(
              "sphere", [=] { return support::uniform_directions(n, 1); }, s),
          sphere_case(
              "tracks", [=] { return support::track_directions(n); }, s),
          sphere_case(
              "0.5-degree grid", [] { return support::radian_grid_directions(0.5); }, s)};
}

void print_heading() {
  std::printf("%-18s %9s  %-30s %9s %8s %8s %8s  %6s %9s %9s %10s\n", "set", "points", "",
              "median ms", "min", "max", "cpu", "ratio", "peak B/pt", "kept B/pt",
              "triangles");
}

// How much longer than ours; of processor time where there is one thread.
double ratio(const Settings& s, const Measurement& m, const Measurement& ours) {
  return s.num_threads == 1 ? m.cpu_seconds / ours.cpu_seconds
                            : m.seconds.median / ours.seconds.median;
}

void print(const Settings& s, const Case& c, const std::string& who, const Measurement& m,
           const Measurement& ours) {
  const double points = static_cast<double>(m.num_points);
  const char* format =
      s.is_json
          ? "{\"set\":\"%s\",\"points\":%lld,\"who\":\"%s\",\"median_ms\":%.3f,\"min_"
            "ms\":%.3f,"
            "\"max_ms\":%.3f,\"cpu_ms\":%.3f,\"ratio\":%.3f,\"peak_bytes_per_point\":%."
            "1f,"
            "\"kept_bytes_per_point\":%.1f,\"triangles\":%lld}\n"
          : "%-18s %9lld  %-30s %9.1f %8.1f %8.1f %8.1f  %6.2f %9.1f %9.1f %10lld\n";
  std::printf(format, c.name.c_str(), static_cast<long long>(m.num_points), who.c_str(),
              1e3 * m.seconds.median, 1e3 * m.seconds.min, 1e3 * m.seconds.max,
              1e3 * m.cpu_seconds, ratio(s, m, ours), m.peak_bytes / points,
              m.kept_bytes / points, static_cast<long long>(m.num_triangles));
  std::fflush(stdout);
}

bool run(const Settings& s, const Case& c) {
  const Measurement mine = measure(c.ours, s.repeats);
  if (!mine.is_valid) return false;
  print(s, c, "delone", mine, mine);
  for (const auto& [name, make] : c.peers) {
    const Measurement theirs = measure(make, s.repeats);
    if (!theirs.is_valid) return false;
    print(s, c, "CGAL " + name, theirs, mine);
  }
  return true;
}

Settings parse(int argc, char** argv) {
  Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (option == "--json") {
      s.is_json = true;
      continue;
    }
    if (option == "--points") s.num_points = std::strtoull(value, nullptr, 10);
    if (option == "--repeats") s.repeats = std::atoi(value);
    if (option == "--threads") s.num_threads = std::atoi(value);
    if (option == "--series") s.series = std::strtoull(value, nullptr, 10);
    if (option == "--only") s.only = value;
    ++i;
  }
  return s;
}

}  // namespace
}  // namespace delone::bench

int main(int argc, char** argv) {
  using namespace delone::bench;
  const Settings settings = parse(argc, argv);
  if (settings.repeats < 1) return 2;
  if (!settings.is_json) print_heading();
  for (const Case& c : cases(settings)) {
    if (c.name.find(settings.only) == std::string::npos) continue;
    if (!run(settings, c)) {
      std::fprintf(stderr, "build_bench: %s did not finish\n", c.name.c_str());
      return 1;
    }
  }
}
