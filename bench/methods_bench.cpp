// Every interpolation method on one thread: fitting, a million unsorted queries and a
// grid of four million nodes. Prints one line a measurement.
//
//   methods_bench [METHOD]    linear, c1, natural, natural-c1, idw, shepard, rbf; all

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interp/c1_surface.hpp"
#include "interp/idw_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/natural_surface.hpp"
#include "interp/rbf_surface.hpp"
#include "interp/shepard_surface.hpp"
#include "random_points.hpp"

namespace {

using delone::RunOptions;
using delone::bench::plane_points;
using delone::bench::sphere_points;
using delone::stripack::Direction;
using delone::tripack::Point2;
namespace interp = delone::interp;

RunOptions one_thread() { return {.num_threads = 1, .progress = {}}; }

// The least of three runs: what the machine can do, whatever else it does.
template <class F>
double seconds(F f) {
  double least = 1e300;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    f();
    least = std::min(
        least,
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

double value_at(Point2 p) { return std::sin(9 * p.x) * std::cos(7 * p.y); }
double value_at(const Direction& p) { return p.x() * p.y() + std::sin(5 * p.z()); }

template <class Points>
std::vector<double> values_at(const Points& points) {
  std::vector<double> values;
  for (const auto& p : points) values.push_back(value_at(p));
  return values;
}

template <class Points, class Make>
void measure(const char* name, const Points& points, const Points& queries,
             const std::optional<interp::Grid>& grid, Make make) {
  const std::vector<double> values = values_at(points);
  const double fit = seconds([&] { static_cast<void>(make(values)); });
  const auto surface = make(values);
  const double ask =
      seconds([&] { static_cast<void>(surface.values(queries, one_thread())); });
  std::printf("%-32s %8zu nodes: fit %7.4f s, 1,000,000 queries %7.4f s", name,
              points.size(), fit, ask);
  if (grid) {
    std::printf(", grid %7.4f s",
                seconds([&] { static_cast<void>(surface.grid(*grid, one_thread())); }));
  }
  std::printf("\n");
  std::fflush(stdout);
}

struct Plane {
  static constexpr const char* name = "plane";
  using Triangulation = delone::tripack::Triangulation;
  using Linear = interp::PlaneLinear;
  using C1 = interp::PlaneC1;
  using Natural = interp::PlaneNatural;
  using InverseDistance = interp::PlaneInverseDistance;
  using Shepard = interp::PlaneShepard;
  using Radial = interp::PlaneRadial;
  static auto points(std::size_t n, unsigned seed) { return plane_points(n, seed); }
  static interp::Grid grid() {
    return interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{2000, 2000});
  }
};

struct Sphere {
  static constexpr const char* name = "sphere";
  using Triangulation = delone::stripack::Triangulation;
  using Linear = interp::SphereLinear;
  using C1 = interp::SphereC1;
  using Natural = interp::SphereNatural;
  using InverseDistance = interp::SphereInverseDistance;
  using Shepard = interp::SphereShepard;
  using Radial = interp::SphereRadial;
  static auto points(std::size_t n, unsigned seed) { return sphere_points(n, seed); }
  static interp::Grid grid() {
    return interp::globe_grid({-180, 180, -90, 90}, interp::Spacing{0.125, 0.125});
  }
};

template <class Space>
void measure_space(const std::string& method, std::size_t n) {
  const auto points = Space::points(n, 1), queries = Space::points(1'000'000, 2);
  const auto t = std::make_shared<const typename Space::Triangulation>(points);
  const std::optional<interp::Grid> grid =
      n == 100'000 ? std::optional(Space::grid()) : std::nullopt;
  const auto run = [&](const char* name, auto make) {
    if (!method.empty() && method != name) return;
    measure((std::string(Space::name) + " " + name).c_str(), points, queries, grid, make);
  };
  using Values = std::vector<double>;
  run("linear", [&](const Values& v) { return typename Space::Linear(t, v); });
  run("c1", [&](const Values& v) { return typename Space::C1(t, v, {}, one_thread()); });
  run("natural", [&](const Values& v) { return typename Space::Natural(t, v); });
  run("natural-c1", [&](const Values& v) {
    return typename Space::Natural(t, v, {.kind = interp::NaturalKind::sibson_c1});
  });
  if (n > 100'000) return;
  run("idw", [&](const Values& v) { return typename Space::InverseDistance(t, v); });
  run("shepard", [&](const Values& v) {
    return typename Space::Shepard(t, v, {}, {}, one_thread());
  });
  run("rbf", [&](const Values& v) {
    return typename Space::Radial(t, v, {}, {}, one_thread());
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string method = argc > 1 ? argv[1] : "";
  for (const std::size_t n : {std::size_t{100'000}, std::size_t{1'000'000}}) {
    measure_space<Plane>(method, n);
    measure_space<Sphere>(method, n);
  }
}
