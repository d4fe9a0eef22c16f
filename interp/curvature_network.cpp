#include "interp/curvature_network.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/parallel.hpp"
#include "interp/index.hpp"

namespace delone::interp {

namespace {

using Tangent = CurvatureNetwork::Tangent;

double dot(const Tangent& a, const Tangent& b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

template <class Body>
void CurvatureNetwork::for_each_node(const RunOptions& run, Body body) const {
  constexpr std::int64_t chunk = 4096;
  RunOptions quiet = run;
  quiet.progress = {};
  delaunay::parallel_chunks(static_cast<std::int64_t>(num_nodes()), chunk, quiet,
                            [&](std::int64_t first, std::int64_t last) {
                              for (std::int64_t v = first; v < last; ++v)
                                body(at(v), at(offsets_[at(v)]), at(offsets_[at(v) + 1]));
                            });
}

// The directions become those of the coordinates in which the sum of 4 d d^T over the
// ends of a node is the unit matrix. A trace of the block on its diagonal keeps
// directions that no edge has at slope 0.
void CurvatureNetwork::make_blocks_unit(const RunOptions& run) {
  constexpr double ridge = 1e-12;
  factors_.resize(num_nodes());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const auto [x, y] = ends_[k].direction;
      const double w = 4 * ends_[k].weight;
      xx += w * x * x, xy += w * x * y, yy += w * y * y;
    }
    const double more = ridge * (xx + yy);
    if (!(more > 0)) return;
    Factor& f = factors_[v];
    f.first = std::sqrt(xx + more);
    f.cross = xy / f.first;
    f.second = std::sqrt(std::max(yy - f.cross * f.cross, 0.0) + more);
    for (std::size_t k = begin; k < end; ++k) {
      Tangent& d = ends_[k].direction;
      const double root = std::sqrt(ends_[k].weight);
      d[0] *= root / f.first;
      d[1] = (root * d[1] - f.cross * d[0]) / f.second;
    }
  });
}

std::vector<Tangent> CurvatureNetwork::right_side(const RunOptions& run) const {
  std::vector<Tangent> b(num_nodes());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const End& e = ends_[k];
      const double pull = 6 * std::sqrt(e.weight) * (e.slope / unit_);
      b[v][0] += pull * e.direction[0];
      b[v][1] += pull * e.direction[1];
    }
  });
  return b;
}

// The derivative along an edge at its other end is that of the other end, turned round.
std::vector<Tangent> CurvatureNetwork::product(const std::vector<Tangent>& x,
                                               const RunOptions& run) const {
  std::vector<double> along(ends_.size());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) along[k] = dot(ends_[k].direction, x[v]);
  });
  std::vector<Tangent> y(num_nodes());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    y[v] = x[v];
    for (std::size_t k = begin; k < end; ++k) {
      const double other = 2 * along[at(ends_[k].reverse)];
      y[v][0] -= other * ends_[k].direction[0];
      y[v][1] -= other * ends_[k].direction[1];
    }
  });
  return y;
}

// Chebyshev's iteration for eigenvalues in 1 +- 1/2.
std::vector<Tangent> CurvatureNetwork::iterated(std::vector<Tangent> right, int num_steps,
                                                const RunOptions& run) const {
  std::vector<Tangent> x(num_nodes()), residual = std::move(right), step = residual;
  constexpr double half_width = 0.5;
  double factor = half_width;
  for (int i = 0; i < num_steps; ++i) {
    const std::vector<Tangent> change = product(step, run);
    const double next = 1 / (2 / half_width - factor);
    for_each_node(run, [&](std::size_t v, std::size_t, std::size_t) {
      for (std::size_t c = 0; c < 2; ++c) {
        x[v][c] += step[v][c];
        residual[v][c] -= change[v][c];
        step[v][c] = next * factor * step[v][c] + 2 * next / half_width * residual[v][c];
      }
    });
    factor = next;
  }
  return x;
}

std::vector<Tangent> CurvatureNetwork::out_of_unit_coordinates(
    std::vector<Tangent> x, double unit, const RunOptions& run) const {
  for_each_node(run, [&](std::size_t v, std::size_t, std::size_t) {
    const Factor& f = factors_[v];
    const double second = f.second > 0 ? x[v][1] / f.second : 0;
    const double first = f.first > 0 ? (x[v][0] - f.cross * second) / f.first : 0;
    x[v] = {unit * first, unit * second};
  });
  return x;
}

std::vector<Tangent> CurvatureNetwork::solve(int num_steps, const RunOptions& run) && {
  unit_ = 0;
  for (const End& e : ends_) unit_ = std::max(unit_, std::abs(e.slope));
  if (!(unit_ > 0)) return std::vector<Tangent>(num_nodes());
  make_blocks_unit(run);
  return out_of_unit_coordinates(iterated(right_side(run), num_steps, run), unit_, run);
}

CurvatureNetwork CurvatureNetwork::in_unit_coordinates(const RunOptions& run) && {
  make_blocks_unit(run);
  return std::move(*this);
}

std::vector<Tangent> CurvatureNetwork::gradients(std::span<const double> slopes,
                                                 int num_steps,
                                                 const RunOptions& run) const {
  std::vector<Tangent> right(num_nodes());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double pull = 6 * std::sqrt(ends_[k].weight) * slopes[k];
      right[v][0] += pull * ends_[k].direction[0];
      right[v][1] += pull * ends_[k].direction[1];
    }
  });
  return out_of_unit_coordinates(iterated(std::move(right), num_steps, run), 1, run);
}

std::vector<double> CurvatureNetwork::slope_weights(std::vector<Tangent> gradient_weights,
                                                    int num_steps,
                                                    const RunOptions& run) const {
  for_each_node(run, [&](std::size_t v, std::size_t, std::size_t) {
    gradient_weights[v] = to_unit_weights(v, gradient_weights[v]);
  });
  const std::vector<Tangent> x = iterated(std::move(gradient_weights), num_steps, run);
  std::vector<double> weights(ends_.size());
  for_each_node(run, [&](std::size_t v, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      weights[k] = 6 * std::sqrt(ends_[k].weight) * dot(ends_[k].direction, x[v]);
  });
  return weights;
}

}  // namespace delone::interp
