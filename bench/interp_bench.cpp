// Interpolation on one thread: grids, scattered queries and operators. Prints one line a
// measurement.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

#include "interp/linear_surface.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/operator.hpp"
#include "random_points.hpp"

namespace {

using delone::RunOptions;
using delone::bench::plane_points;
using delone::bench::sphere_points;
using delone::stripack::Direction;
using delone::stripack::LonLat;
using delone::tripack::Point2;
namespace interp = delone::interp;

RunOptions one_thread() { return {.num_threads = 1, .progress = {}}; }

// Median of five runs, in seconds of processor time: one thread, so that a busy machine
// disturbs least.
template <class F>
double seconds(F f) {
  std::vector<double> times;
  for (int run = 0; run < 5; ++run) {
    const std::clock_t start = std::clock();
    f();
    times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  return times[2];
}

void report(const char* what, double time, std::int64_t count) {
  std::printf("%-58s %8.4f s %8.2f ns each\n", what, time,
              1e9 * time / static_cast<double>(count));
}

std::vector<double> values_at(const std::vector<Point2>& points) {
  std::vector<double> values;
  for (const Point2 p : points) values.push_back(std::sin(9 * p.x) * std::cos(7 * p.y));
  return values;
}

std::vector<double> values_at(const std::vector<Direction>& points) {
  std::vector<double> values;
  for (const Direction& p : points) values.push_back(p.x() * p.y() + std::sin(5 * p.z()));
  return values;
}

void measure_plane() {
  const auto points = plane_points(100'000, 1);
  const auto t = std::make_shared<delone::tripack::Triangulation>(points);
  const interp::PlaneLinear surface(t, values_at(points));
  const interp::Grid grid =
      interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{2000, 2000});
  report("plane linear grid 2000 x 2000, 100,000 nodes",
         seconds([&] { (void)surface.grid(grid, one_thread()); }), grid.size());
  const interp::PlaneLinear continued(t, values_at(points),
                                      {.outside = interp::Outside::linear});
  const interp::Grid wide =
      interp::plane_grid({-0.2, 1.2, -0.2, 1.2}, interp::NodeCounts{2000, 2000});
  report("the same on a wider region, continued linearly",
         seconds([&] { (void)continued.grid(wide, one_thread()); }), wide.size());
  const interp::PlaneLinear masked(t, values_at(points), {.max_distance = 0.002});
  report("the same, max_distance 0.002",
         seconds([&] { (void)masked.grid(grid, one_thread()); }), grid.size());
  const interp::PlaneNearest nearest(t, values_at(points),
                                     {.outside = interp::Outside::nearest});
  report("plane nearest grid 2000 x 2000",
         seconds([&] { (void)nearest.grid(grid, one_thread()); }), grid.size());
  const auto nodes = interp::plane_nodes(
      interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{1000, 1000}));
  report("plane linear operator, 1,000,000 targets",
         seconds([&] { (void)interp::linear_operator(t, nodes, {}, one_thread()); }),
         1'000'000);
}

void measure_plane_queries() {
  const auto points = plane_points(1'000'000, 2), queries = plane_points(1'000'000, 3);
  const auto t = std::make_shared<delone::tripack::Triangulation>(points);
  const interp::PlaneLinear surface(t, values_at(points));
  report("plane linear, 1,000,000 unsorted queries, 1,000,000 nodes",
         seconds([&] { (void)surface.values(queries, one_thread()); }), 1'000'000);
  const interp::Grid grid =
      interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{2000, 2000});
  report("plane linear grid 2000 x 2000, 1,000,000 nodes",
         seconds([&] { (void)surface.grid(grid, one_thread()); }), grid.size());
}

void measure_sphere() {
  const auto points = sphere_points(100'000, 4);
  const auto t = std::make_shared<delone::stripack::Triangulation>(points);
  const interp::SphereLinear surface(t, values_at(points));
  const interp::Grid grid =
      interp::globe_grid({-180, 180, -90, 90}, interp::Spacing{0.125, 0.125});
  report("sphere linear grid 2880 x 1441, 100,000 nodes",
         seconds([&] { (void)surface.grid(grid, one_thread()); }), grid.size());
  const interp::SphereNearest nearest(t, values_at(points));
  report("sphere nearest grid 2880 x 1441",
         seconds([&] { (void)nearest.grid(grid, one_thread()); }), grid.size());
  const auto many = sphere_points(1'000'000, 5), queries = sphere_points(1'000'000, 6);
  const auto large = std::make_shared<delone::stripack::Triangulation>(many);
  const interp::SphereLinear fine(large, values_at(many));
  report("sphere linear, 1,000,000 unsorted queries, 1,000,000 nodes",
         seconds([&] { (void)fine.values(queries, one_thread()); }), 1'000'000);
}

}  // namespace

int main() {
  measure_plane();
  measure_plane_queries();
  measure_sphere();
}
