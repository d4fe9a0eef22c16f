// Queries of a million points on one thread and on all: nearest, k nearest, radius,
// location, hashes, near repeats, blocks. Prints one line a measurement.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "stripack/blocks.hpp"
#include "stripack/hash.hpp"
#include "stripack/locate_batch.hpp"
#include "stripack/merge_near.hpp"
#include "stripack/neighbor_search.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/blocks.hpp"
#include "tripack/hash.hpp"
#include "tripack/locate_batch.hpp"
#include "tripack/merge_near.hpp"
#include "tripack/neighbor_search.hpp"

namespace {

using delone::RunOptions;
using delone::stripack::Direction;
using delone::tripack::Point2;
namespace support = delone::support;

constexpr std::size_t num_points = 1'000'000;

// Median of three runs.
double seconds(const std::function<void()>& work) {
  std::vector<double> times;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[1];
}

void report(const std::string& what, const std::function<void()>& work) {
  const double time = seconds(work);
  std::printf("%-56s %8.3f s %8.1f ns each\n", what.c_str(), time,
              1e9 * time / static_cast<double>(num_points));
  std::fflush(stdout);
}

// The same questions in both rooms.
template <class Triangulation, class Point>
void measure(const std::string& name, const std::vector<Point>& points,
             const std::vector<Point>& queries, double radius) {
  report(name + ", triangulate, one thread",
         [&] { const Triangulation built(points, {.num_threads = 1, .progress = {}}); });
  const Triangulation t(points);
  for (const int threads : {1, 0}) {
    const RunOptions run{.num_threads = threads, .progress = {}};
    const std::string with = name + (threads == 1 ? ", one thread: " : ", all threads: ");
    report(with + "8 nearest of every node",
           [&] { static_cast<void>(nearest_k_of_nodes(t, 8, run)); });
    report(with + "8 nearest of queries",
           [&] { static_cast<void>(nearest_k(t, std::span(queries), 8, run)); });
    report(with + "nearest of queries",
           [&] { static_cast<void>(nearest_k(t, std::span(queries), 1, run)); });
    report(with + "within a radius (8 on average)",
           [&] { static_cast<void>(nodes_within(t, std::span(queries), radius, run)); });
    report(with + "locate queries",
           [&] { static_cast<void>(locate_triangles(t, std::span(queries), run)); });
  }
  report(name + ", hash of positions", [&] { static_cast<void>(hash_of_positions(t)); });
  report(name + ", merge near repeats",
         [&] { static_cast<void>(merge_near(std::span(points), radius / 8)); });
}

std::vector<Point2> stretched(std::vector<Point2> points, double factor) {
  for (Point2& p : points) p = {factor * p.x, factor * p.y};
  return points;
}

}  // namespace

int main() {
  using PlaneTriangulation = delone::tripack::Triangulation;
  using SphereTriangulation = delone::stripack::Triangulation;
  const auto queries = support::uniform_points(num_points, 2);
  const double root = 1000;  // points a unit length
  measure<PlaneTriangulation>("plane, uniform", support::uniform_points(num_points, 1),
                              queries, 1.6 / root);
  measure<PlaneTriangulation>("plane, lattice",
                              support::shuffled(support::lattice_points(num_points), 3),
                              stretched(queries, root), 1.6);
  measure<SphereTriangulation>("sphere, uniform",
                               support::uniform_directions(num_points, 1),
                               support::uniform_directions(num_points, 2), 1.6 / 282);
  std::vector<double> values;
  for (const Point2 p : queries) values.push_back(p.x);
  report("plane, block median, 100 x 100 blocks", [&] {
    static_cast<void>(delone::tripack::block_reduce(
        queries, values, {},
        {.dx = 0.01,
         .dy = 0.01,
         .region = {},
         .statistic = delone::tripack::BlockStatistic::median,
         .position = delone::tripack::BlockPosition::reduced}));
  });
}
