// Sparse operators against the memory's speed, one thread: a 2000 x 2000 grid over
// 100,000 nodes, and the 4-weights-a-row matrix of bilinear regridding from 1 to 1/4
// degree, which other libraries are measured with. Prints one line a measurement; the
// last column is relative to reading the bytes of the matrix once.

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "delaunay/huge_pages.hpp"
#include "interp/c1_operator.hpp"
#include "interp/leave_one_out.hpp"
#include "interp/linear_surface.hpp"
#include "interp/natural_operator.hpp"
#include "interp/operator.hpp"
#include "measure.hpp"
#include "random_points.hpp"

namespace {

using delone::RunOptions;
using delone::tripack::Point2;
namespace interp = delone::interp;
namespace bench = delone::bench;

constexpr int repeats = 9;

RunOptions one_thread() { return {.num_threads = 1, .progress = {}}; }

template <class F>
double median_seconds(F f) {
  std::vector<double> times;
  for (int i = 0; i <= repeats; ++i) {
    const double time = bench::seconds(f).wall;
    if (i > 0) times.push_back(time);  // the first one warms up
  }
  return bench::spread(times).median;
}

double matrix_bytes(const interp::Operator& op) {
  return 12.0 * static_cast<double>(op.matrix().nonZeros());
}

// Sums values and columns in four chains each, so that memory is all it waits for.
double read_seconds(const interp::Operator& op) {
  const auto n = static_cast<std::size_t>(op.matrix().nonZeros());
  const double* w = op.matrix().valuePtr();
  const int* c = op.matrix().innerIndexPtr();
  static volatile double sink = 0;
  return median_seconds([&] {
    double sum[8] = {};
    int columns[8] = {};
    for (std::size_t i = 0; i + 8 <= n; i += 8) {
      for (std::size_t k = 0; k < 8; ++k) {
        sum[k] += w[i + k];
        columns[k] ^= c[i + k];
      }
    }
    for (std::size_t k = 0; k < 8; ++k) sink = sink + sum[k] + columns[k];
  });
}

// All the bytes that applying to one field has to move, without looking values up: reads
// weights, columns and where rows begin, and writes a result a row into fresh memory.
double moving_seconds(const interp::Operator& op) {
  const auto& m = op.matrix();
  const double* w = m.valuePtr();
  const int *c = m.innerIndexPtr(), *offsets = m.outerIndexPtr();
  return median_seconds([&] {
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(m.rows()));
    delone::delaunay::prefer_huge_pages(
        out.data(), static_cast<std::size_t>(m.rows()) * sizeof(double));
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      double sum = 0;
      for (int k = offsets[i]; k < offsets[i + 1]; ++k) sum += w[k] * c[k];
      out.push_back(sum);
    }
  });
}

void report(const std::string& what, double time, double reading) {
  std::printf("%-52s %9.3f ms %6.2f x reading\n", what.c_str(), 1e3 * time,
              time / reading);
}

std::vector<double> random_values(std::int64_t n) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> values(static_cast<std::size_t>(n));
  for (double& v : values) v = unit(random);
  return values;
}

void measure_applying(const std::string& name, const interp::Operator& op) {
  const std::int64_t rows = op.matrix().cols(), targets = op.matrix().rows();
  const double reading = read_seconds(op);
  std::printf("%s: %lld targets, %lld weights, read at %.1f GB/s\n", name.c_str(),
              static_cast<long long>(targets),
              static_cast<long long>(op.matrix().nonZeros()),
              1e-9 * matrix_bytes(op) / reading);
  report("moving the bytes of one field", moving_seconds(op), reading);
  const std::vector<double> field = random_values(rows), back = random_values(targets);
  report("one field", median_seconds([&] { (void)op.apply(field, {}, one_thread()); }),
         reading);
  const interp::ApplyOptions renormalise{.missing = interp::MissingRows::renormalise};
  report("one field, renormalised",
         median_seconds([&] { (void)op.apply(field, renormalise, one_thread()); }),
         reading);
  for (const std::int64_t count : {4, 10, 50}) {
    if (targets * count > 60'000'000) continue;
    const interp::Fields fields = interp::Fields::Random(rows, count);
    const double time =
        median_seconds([&] { (void)op.apply_fields(fields, {}, one_thread()); });
    report(std::to_string(count) + " fields at once, each",
           time / static_cast<double>(count), reading);
  }
  report("transposed, on the fly",
         median_seconds([&] { (void)op.apply_transposed(back); }), reading);
  const interp::TransposedOperator transposed = op.transposed();
  report("transposed, stored",
         median_seconds([&] { (void)transposed.apply(back, one_thread()); }), reading);
  report("variances",
         median_seconds([&] { (void)op.propagated_variance(field, one_thread()); }),
         reading);
}

void measure_linear() {
  const auto t =
      std::make_shared<delone::tripack::Triangulation>(bench::plane_points(100'000, 1));
  const auto nodes = interp::plane_nodes(
      interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{2000, 2000}));
  const double time =
      median_seconds([&] { (void)interp::linear_operator(t, nodes, {}, one_thread()); });
  std::printf("linear operator, 4,000,000 targets: assembled in %.3f s\n", time);
  measure_applying("linear", interp::linear_operator(t, nodes));
}

// Targets of a grid, so that many share their nodes.
void measure_assembling() {
  const auto t =
      std::make_shared<delone::tripack::Triangulation>(bench::plane_points(100'000, 1));
  const auto nodes = interp::plane_nodes(
      interp::plane_grid({0, 1, 0, 1}, interp::NodeCounts{1000, 1000}));
  const auto report_assembly = [&](const char* name, auto assemble) {
    std::int64_t num_weights = 0;
    const double time =
        bench::seconds([&] { num_weights = assemble().matrix().nonZeros(); }).wall;
    std::printf("%s operator, 1,000,000 targets, %lld weights: assembled in %.3f s\n",
                name, static_cast<long long>(num_weights), time);
  };
  interp::NaturalOptions smooth;
  smooth.kind = interp::NaturalKind::sibson_c1;
  report_assembly("natural",
                  [&] { return interp::natural_operator(t, nodes, {}, one_thread()); });
  report_assembly("natural-c1", [&] {
    return interp::natural_operator(t, nodes, smooth, one_thread());
  });
  report_assembly("c1", [&] { return interp::c1_operator(t, nodes, {}, one_thread()); });
}

// Four weights a row, neighbouring cells of a 360 x 180 grid, as regridding has them.
interp::Operator regridding() {
  constexpr int nx = 360, ny = 180, mx = 1440, my = 720;
  interp::Operator::Matrix matrix(mx * my, nx * ny);
  matrix.reserve(4 * mx * my);
  for (int j = 0; j < my; ++j) {
    for (int i = 0; i < mx; ++i) {
      const int x = std::min((i + 2) / 4, nx - 2), y = std::min((j + 2) / 4, ny - 2);
      matrix.startVec(j * mx + i);
      for (const int column :
           {y * nx + x, y * nx + x + 1, (y + 1) * nx + x, (y + 1) * nx + x + 1})
        matrix.insertBack(j * mx + i, column) = 0.25;
    }
  }
  matrix.finalize();
  return interp::Operator(matrix.markAsRValue());
}

void measure_leaving_out() {
  const auto t =
      std::make_shared<delone::tripack::Triangulation>(bench::plane_points(1'000'000, 1));
  const std::vector<double> values = random_values(1'000'000);
  const double time = median_seconds(
      [&] { (void)interp::leave_out_linear(t, values, {}, one_thread()); });
  std::printf("leave-one-out residuals, linear, 1,000,000 nodes: %.3f s\n", time);
}

}  // namespace

int main() {
  measure_linear();
  measure_assembling();
  measure_applying("regridding 1 to 1/4 degree", regridding());
  measure_leaving_out();
}
