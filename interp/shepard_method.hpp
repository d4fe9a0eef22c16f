#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/box_tree.hpp"
#include "interp/nodal_fit.hpp"
#include "interp/scatter_nodes.hpp"
#include "interp/scatter_surface.hpp"
#include "interp/shepard_surface.hpp"

namespace delone::interp {

/// How many nodes are looked at.
struct ShepardCounts {
  std::size_t degree = 3, fitted = 17, weighted = 30;
};

/// Throws Error for numbers out of range.
inline ShepardCounts shepard_counts(const ShepardOptions& o) {
  for (const std::int32_t count : {o.fitted_neighbors, o.weighted_neighbors}) {
    if (count == 0 || (count >= 8 && count <= 1000)) continue;
    throw Error("the number of neighbours is " + std::to_string(count) +
                "; take 8 to 1000, or 0 for the usual number");
  }
  const bool is_cubic = o.degree == ShepardDegree::cubic;
  ShepardCounts counts{is_cubic ? 3u : 2u, is_cubic ? 17u : 13u, is_cubic ? 30u : 19u};
  if (o.fitted_neighbors > 0) counts.fitted = at(o.fitted_neighbors);
  if (o.weighted_neighbors > 0) counts.weighted = at(o.weighted_neighbors);
  return counts;
}

/// Coordinates about a node: x and y.
template <std::size_t D>
struct NodalChart {
  explicit NodalChart(const std::array<double, D>&) {}
  template <Number T>
  [[nodiscard]] std::array<T, 2> operator()(const std::array<T, 2>& from_node) const {
    return from_node;
  }
};

/// On the sphere Lambert's projection: as long as the chord, in its direction seen from
/// the node.
template <>
struct NodalChart<3> {
  explicit NodalChart(const std::array<double, 3>& n) {
    const Vector3 up{n[0], n[1], n[2]};
    const bool is_flat = std::abs(up.z) < 0.8;
    const Vector3 side = cross(is_flat ? Vector3{0, 0, 1} : Vector3{1, 0, 0}, up);
    east = (1 / length(side)) * side;
    north = cross(up, east);
  }
  template <Number T>
  [[nodiscard]] std::array<T, 2> operator()(const std::array<T, 3>& d) const {
    using std::sqrt;
    const T stretch = 1.0 / sqrt(1.0 - 0.25 * squared_length(d));
    return {(d[0] * east.x + d[1] * east.y + d[2] * east.z) * stretch,
            (d[0] * north.x + d[1] * north.y + d[2] * north.z) * stretch};
  }
  Vector3 east, north;
};

/// A node with its disc and its polynomial, in units of `per_length`.
template <std::size_t D>
struct NodalFunction {
  std::array<double, D> position{};
  double radius = 0;
  double value = 0;
  double per_length = 1;
  NodalPolynomial terms{};
  NodalChart<D> chart;

  /// How much it differs from the node's value.
  template <Number T>
  [[nodiscard]] T rise(const std::array<T, D>& from_node, std::size_t degree) const {
    const std::array<T, 2> uv = chart(from_node);
    const T u = uv[0] * per_length, v = uv[1] * per_length;
    T high_u = u * terms[2] + v * terms[3], high_v = v * terms[4];
    if (degree == 3) {
      high_u += (u * terms[5] + v * terms[6]) * u + v * v * terms[7];
      high_v += v * v * terms[8];
    }
    return u * (high_u + terms[0]) + v * (high_v + terms[1]);
  }
};

/// The surface over some of the nodes.
template <std::size_t D>
struct ShepardLevel {
  std::vector<NodalFunction<D>> nodes;
  BoxTree<D> discs;
};

// A disc wider than the sphere ends at the antipode, where a chart has no direction.
constexpr double widest(std::size_t dimension) {
  return dimension == 3 ? 2 : std::numeric_limits<double>::infinity();
}

// Samples nearer than this part of the reach weigh no more: a slope between two nodes
// that all but coincide would have the whole say.
constexpr double nearest_part = 1.0 / 16;
// Nodes all round make discs 5 units of their fits wide. Where scales mix, the next node
// may be at a thousand, and polynomials would be read far beyond what they know.
constexpr double widest_in_units = 10;

/// A node's function and how far away a node may be that it depends on.
template <std::size_t D>
struct FittedNode {
  NodalFunction<D> function;
  double influence = 0;
};

/// That of node k over all nodes but `without` (none: over all).
template <std::size_t D>
FittedNode<D> fitted(const ScatterNodes<D>& nodes, const BoxTree<D>& tree, std::size_t k,
                     const ShepardCounts& counts, std::int32_t without = none) {
  using Found = typename BoxTree<D>::Found;
  NodalFunction<D> f{.position = nodes.points[k],
                     .value = nodes.values[k],
                     .chart = NodalChart<D>(nodes.points[k])};
  const std::size_t most = std::max(counts.fitted, counts.weighted) + num_spare_nodes + 1;
  std::vector<Found> near = tree.nearest(f.position, most + (without == none ? 0 : 1));
  std::erase_if(near,
                [&](const Found& n) { return at(n.item) == k || n.item == without; });
  const std::span<const Found> others(near);
  const auto within = [&](std::size_t count) {
    return radius_beyond(others.first(std::min(others.size(), count + num_spare_nodes)),
                         count);
  };
  const double weighted = within(counts.weighted), end = within(counts.fitted);
  f.radius = std::min(weighted, widest(D));
  const double farthest = others.empty() ? 1 : std::sqrt(others.back().squared);
  const double reach = std::isinf(end) ? std::max(farthest, least_radius) : end;
  f.per_length = 1 / reach;
  std::vector<NodalSample> samples;
  for (const Found& n : others) {
    const double d = std::sqrt(n.squared);
    if (!(d < std::min(end, widest(D))) || d == 0) continue;
    const auto uv = f.chart(difference(nodes.points[at(n.item)], f.position));
    samples.push_back(
        {uv[0] * f.per_length, uv[1] * f.per_length, nodes.values[at(n.item)] - f.value,
         (std::isinf(end) ? 1 : (end - d) / end) / std::max(d / reach, nearest_part)});
  }
  f.terms = fit_polynomial(samples, counts.degree);
  f.radius = std::min(f.radius, widest_in_units * unit_length(samples) * reach);
  return {f, std::max(weighted, end)};
}

template <std::size_t D>
ShepardLevel<D> indexed(std::vector<NodalFunction<D>> nodes) {
  std::vector<Box<D>> boxes;
  boxes.reserve(nodes.size());
  for (const NodalFunction<D>& f : nodes) boxes.push_back(ball_box(f.position, f.radius));
  return {std::move(nodes), BoxTree<D>(std::move(boxes))};
}

template <std::size_t D>
ShepardLevel<D> fitted_level(const ScatterNodes<D>& nodes, const ShepardCounts& counts,
                             const RunOptions& run) {
  const auto tree = point_tree<D>(nodes.points);
  const auto count = static_cast<std::int64_t>(nodes.points.size());
  std::vector<NodalFunction<D>> functions(nodes.points.size(),
                                          {.chart = NodalChart<D>({})});
  delaunay::parallel_chunks(count, 256, run, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t k = first; k < last; ++k)
      functions[at(k)] = fitted(nodes, tree, at(k), counts).function;
  });
  return indexed(std::move(functions));
}

// What there is where nothing else reaches: a mean of the values.
template <std::size_t D>
ShepardLevel<D> constant_level(const ScatterNodes<D>& nodes) {
  std::vector<NodalFunction<D>> functions;
  for (std::size_t k = 0; k < nodes.points.size(); ++k) {
    functions.push_back({.position = nodes.points[k],
                         .radius = widest(D),
                         .value = nodes.values[k],
                         .chart = NodalChart<D>(nodes.points[k])});
  }
  return indexed(std::move(functions));
}

// The sum of (1 - d / R)^3 over discs above which only they have a say. Nodes all round
// make it about 3, a node alone 1.
constexpr double full_disc_cover = 0.5;

/// The mean at a point of the functions whose discs hold it.
template <Number T, std::size_t D>
class ShepardMean {
 public:
  ShepardMean(const std::array<T, D>& p, std::size_t degree) : p_(p), degree_(degree) {}

  /// `f` stays where it is.
  void add(const NodalFunction<D>& f) {
    const std::array<T, D> from_node = difference(p_, f.position);
    using std::sqrt;
    const T distance = sqrt(squared_length(from_node));
    if (!(value_of(distance) < f.radius)) return;
    if (value_of(distance) < 0x1p-300) {
      at_node_ = &f;
      return;
    }
    const T inside = 1.0 - distance / f.radius, root = inside / distance;
    const T weight = root * root * root;
    if (first_ == nullptr) first_ = &f;
    weights_ += weight;
    sum_ += weight * (f.rise(from_node, degree_) + (f.value - first_->value));
    cover_ += inside * inside * inside;
  }

  [[nodiscard]] bool is_at_node() const noexcept { return at_node_ != nullptr; }
  [[nodiscard]] bool is_empty() const noexcept { return first_ == nullptr; }
  [[nodiscard]] bool is_covered() const noexcept {
    return value_of(cover_) >= full_disc_cover;
  }
  [[nodiscard]] T value() const {
    if (at_node_ != nullptr)
      return at_node_->rise(difference(p_, at_node_->position), degree_) +
             at_node_->value;
    return sum_ / weights_ + first_->value;
  }
  /// With `coarse` where discs hardly reach.
  [[nodiscard]] T completed(const T& coarse) const {
    const T open = 1.0 - cover_ / full_disc_cover, fine = value();
    return fine + open * open * open * (coarse - fine);
  }

 private:
  std::array<T, D> p_;
  std::size_t degree_;
  T weights_ = 0.0, sum_ = 0.0, cover_ = 0.0;
  const NodalFunction<D>* first_ = nullptr;
  const NodalFunction<D>* at_node_ = nullptr;
};

/// Only opposite to a node of the sphere that stands alone.
template <std::size_t D>
double nearest_value(std::span<const NodalFunction<D>> nodes,
                     const std::array<double, D>& position) {
  const auto distance = [&](const NodalFunction<D>& f) {
    return squared_length(difference(position, f.position));
  };
  return std::min_element(
             nodes.begin(), nodes.end(),
             [&](const auto& a, const auto& b) { return distance(a) < distance(b); })
      ->value;
}

/// The modified Shepard method (a Method of ScatterSurface).
template <class Domain>
class Shepard {
 public:
  static constexpr std::size_t D = Domain::dimension;
  using Point = typename Domain::Point;

  Shepard(Domain domain, ScatterNodes<D> nodes, const ShepardCounts& counts,
          const RunOptions& run)
      : domain_(std::move(domain)), degree_(counts.degree) {
    while (!nodes.points.empty()) {
      levels_.push_back(fitted_level(nodes, counts, run));
      if (nodes.points.size() <= counts.weighted + 1) {
        levels_.push_back(constant_level(nodes));
        return;
      }
      nodes = every_eighth(nodes);
    }
  }

  [[nodiscard]] static bool is_exact() noexcept { return true; }

  template <Number T>
  [[nodiscard]] T evaluate(const Point& p, Cursor&) const {
    const auto position = domain_.position(p);
    return blend(0, position, variables<T>(position));
  }

 private:
  template <Number T>
  [[nodiscard]] T blend(std::size_t level, const std::array<double, D>& position,
                        const std::array<T, D>& p) const {
    const ShepardLevel<D>& here = levels_[level];
    ShepardMean<T, D> mean(p, degree_);
    here.discs.for_each_holding(position,
                                [&](std::int32_t k) { mean.add(here.nodes[at(k)]); });
    if (mean.is_at_node()) return mean.value();
    const bool is_last = level + 1 == levels_.size();
    if (mean.is_empty())
      return is_last ? T(nearest_value<D>(levels_.back().nodes, position))
                     : blend(level + 1, position, p);
    if (is_last || mean.is_covered()) return mean.value();
    return mean.completed(blend(level + 1, position, p));
  }

  Domain domain_;
  std::size_t degree_;
  std::vector<ShepardLevel<D>> levels_;
};

}  // namespace delone::interp
