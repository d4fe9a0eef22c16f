// Time of constraining: points with segments between them, beside the same points without
// segments; medians of R builds of each in turn, one thread.
//
//   taskset -c 0 constraint_bench [--points N] [--segments S] [--repeats R] [FILE.poly]
//
// Without a file: N uniform points (1,000,000), the unit square cut into S cells
// (200,000), and in each cell a segment between two of its points; these cannot cross.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "io/poly_file.hpp"
#include "support/plane_sets.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::bench {
namespace {

struct Settings {
  std::size_t num_points = 1000000, num_segments = 200000;
  int repeats = 5;
  std::string path;
};

tripack::PlanarGraph cell_graph(const Settings& settings) {
  tripack::PlanarGraph graph;
  graph.points = support::uniform_points(settings.num_points, 1);
  const double side = std::floor(std::sqrt(static_cast<double>(settings.num_segments)));
  std::vector<std::int32_t> last(static_cast<std::size_t>(side * side), -1);
  for (std::size_t i = 0; i < graph.points.size(); ++i) {
    const auto [x, y] = graph.points[i];
    const auto cell =
        static_cast<std::size_t>(std::floor(y * side) * side + std::floor(x * side));
    const auto row = static_cast<std::int32_t>(i);
    if (last[cell] >= 0) graph.segments.push_back({last[cell], row});
    last[cell] = last[cell] == -1 ? row : -2;
  }
  return graph;
}

double median_ms(std::vector<double> seconds) {
  return spread(std::move(seconds)).median * 1e3;
}

void run(const Settings& settings) {
  const tripack::PlanarGraph graph =
      settings.path.empty() ? cell_graph(settings) : io::read_poly(settings.path).graph;
  const RunOptions one{.num_threads = 1, .progress = {}};
  std::vector<double> plain, constrained;
  std::int64_t num_triangles = 0;
  for (int i = 0; i < settings.repeats; ++i) {
    plain.push_back(
        seconds([&] { const tripack::Triangulation t(graph.points, one); }).cpu);
    constrained.push_back(seconds([&] {
                            const tripack::ConstrainedTriangulation t(
                                graph, {.domain = tripack::Domain::hull}, one);
                            num_triangles = t.num_triangles();
                          }).cpu);
  }
  const double before = median_ms(plain), after = median_ms(constrained);
  std::printf(
      "%zu points, %zu segments, %lld triangles: %.1f ms, without segments %.1f ms, "
      "ratio %.2f\n",
      graph.points.size(), graph.segments.size(), static_cast<long long>(num_triangles),
      after, before, after / before);
}

}  // namespace
}  // namespace delone::bench

int main(int argc, char** argv) {
  delone::bench::Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const char* const value = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--points") {
      settings.num_points = std::strtoull(value, nullptr, 10), ++i;
    } else if (word == "--segments") {
      settings.num_segments = std::strtoull(value, nullptr, 10), ++i;
    } else if (word == "--repeats") {
      settings.repeats = std::atoi(value), ++i;
    } else {
      settings.path = word;
    }
  }
  delone::bench::run(settings);
}
