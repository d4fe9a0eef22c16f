#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/box_tree.hpp"
#include "interp/radial_system.hpp"
#include "interp/rbf_surface.hpp"
#include "interp/scatter_nodes.hpp"
#include "interp/scatter_surface.hpp"

namespace delone::interp {

inline int least_degree(RadialKernel kernel) {
  return with_kernel(kernel, [](auto k) { return decltype(k)::order - 1; });
}

/// Throws Error for options out of range.
inline void check(const RadialOptions& o) {
  if (o.degree != -1 && (o.degree < least_degree(o.kernel) || o.degree > 2)) {
    throw Error("the degree of the polynomial is " + std::to_string(o.degree) +
                "; this kernel takes " + std::to_string(least_degree(o.kernel)) +
                " to 2, or -1 for the least");
  }
  if (!(o.smoothing >= 0 && std::isfinite(o.smoothing)))
    throw Error("smoothing must not be negative or infinite");
  if (o.most_at_once < 12 || o.most_at_once > 4096) {
    throw Error("the most nodes at once are " + std::to_string(o.most_at_once) +
                "; take 12 to 4096");
  }
  if (o.neighbors < 12 || o.neighbors > 512)
    throw Error("the number of neighbours is " + std::to_string(o.neighbors) +
                "; take 12 to 512");
}

/// Wendland's C2 function of the distance in radii.
template <Number T>
T bell(const T& r) {
  const T inside = 1.0 - r, squared = inside * inside;
  return squared * squared * (4.0 * r + 1.0);
}

/// A disc and the nodes in it.
template <std::size_t D>
struct Disc {
  std::array<double, D> center{};
  double radius = std::numeric_limits<double>::infinity();  ///< of its weight
  std::vector<std::int32_t> nodes{};                        ///< ascending
};

/// A local spline in coordinates about its centre, `per_length` long.
template <std::size_t D>
class Patch {
 public:
  Patch() = default;
  Patch(const Disc<D>& disc, const ScatterNodes<D>& nodes, const RadialOptions& options,
        double scale)
      : center_(disc.center), radius_(disc.radius) {
    take_nodes(disc, nodes);
    with_kernel(options.kernel, [&](auto kernel) {
      // Lengths of the data were scaled twice.
      const double unit = std::pow(per_length_ * scale, decltype(kernel)::power);
      const double smoothing =
          options.smoothing == 0 ? 0 : std::min(options.smoothing * unit, 0x1p300);
      fit(kernel, options, smoothing);
      rises_ = {};
    });
  }

  [[nodiscard]] Box<D> box() const { return ball_box(center_, radius_); }
  [[nodiscard]] bool is_held() const noexcept { return is_held_; }
  [[nodiscard]] double origin() const noexcept { return origin_; }

  /// The weight at p; 0 beyond the disc.
  template <Number T>
  [[nodiscard]] T weight(const std::array<T, D>& p) const {
    if (std::isinf(radius_)) return T(1.0);
    using std::sqrt;
    const T r = sqrt(squared_length(difference(p, center_))) / radius_;
    return value_of(r) < 1 ? bell(r) : T(0.0);
  }

  /// How much the spline differs from origin().
  template <Number T, class Kernel>
  [[nodiscard]] T rise(const std::array<T, D>& p, Kernel kernel) const {
    std::array<T, D> local = difference(p, center_);
    for (T& x : local) x = x * per_length_;
    return local_rise(local, kernel);
  }

 private:
  template <Number T, class Kernel>
  [[nodiscard]] T local_rise(const std::array<T, D>& local, Kernel kernel) const {
    const auto terms = monomials(local, degree_);
    T sum = kernel_sum(local, kernel);
    for (std::size_t i = 0; i < num_monomials(D, degree_); ++i)
      sum += polynomial_[i] * terms[i];
    return sum;
  }

  void take_nodes(const Disc<D>& disc, const ScatterNodes<D>& nodes) {
    double farthest = 0;
    for (const std::int32_t k : disc.nodes) {
      const auto d = difference(nodes.points[at(k)], center_);
      for (std::size_t i = 0; i < D; ++i) local_[i].push_back(d[i]);
      farthest = std::max(farthest, squared_length(d));
      rises_.push_back(nodes.values[at(k)] - nodes.values[at(disc.nodes[0])]);
    }
    origin_ = nodes.values[at(disc.nodes[0])];
    const double widest =
        std::max(std::sqrt(farthest), std::isinf(radius_) ? 0 : 0.5 * radius_);
    per_length_ = widest > 0 ? 1 / widest : 1;
    for (auto& coordinates : local_) {
      for (double& x : coordinates) x *= per_length_;
    }
  }

  [[nodiscard]] std::vector<std::array<double, D>> local_points() const {
    std::vector<std::array<double, D>> points(local_[0].size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (std::size_t i = 0; i < D; ++i) points[k][i] = local_[i][k];
    }
    return points;
  }

  template <class Kernel>
  void fit(Kernel kernel, const RadialOptions& options, double smoothing) {
    degree_ = options.degree < 0 ? Kernel::order - 1 : options.degree;
    const auto points = local_points();
    if (points.size() <= 2) degree_ = std::min(degree_, 1);
    for (double extra = 0; extra < 2; extra = extra == 0 ? 1e-12 : extra * 100) {
      is_held_ = extra > 0;
      RadialSolution s =
          solve_radial<D>(points, rises_, {options.kernel, degree_, smoothing + extra});
      weights_ = std::move(s.weights);
      polynomial_ = s.polynomial;
      if (!weights_.empty() && stays_in_range(points, kernel)) return;
    }
    take_mean();
  }

  // Splines in space say what they like off the sphere.
  [[nodiscard]] std::array<double, D> on_domain(std::array<double, D> p) const {
    if constexpr (D == 3) {
      for (std::size_t i = 0; i < D; ++i) p[i] = center_[i] + p[i] / per_length_;
      const double norm = std::sqrt(squared_length(p));
      if (!(norm > 0)) return {};
      for (std::size_t i = 0; i < D; ++i) p[i] = (p[i] / norm - center_[i]) * per_length_;
    }
    return p;
  }

  // Where nothing else will do.
  void take_mean() {
    weights_.assign(rises_.size(), 0);
    polynomial_ = {};
    for (const double r : rises_)
      polynomial_[0] += r / static_cast<double>(rises_.size());
  }

  // Midway between nodes that follow one another closely along the curve; and, more
  // generously, out in the disc, where nodes may be on one side only.
  template <class Kernel>
  [[nodiscard]] bool stays_in_range(const std::vector<std::array<double, D>>& points,
                                    Kernel kernel) const {
    const auto [low, high] = std::minmax_element(rises_.begin(), rises_.end());
    const double range = *high - *low;
    const auto is_within = [&, low = *low, high = *high](const auto& p, double slack) {
      const double v = local_rise(on_domain(p), kernel);
      return v >= low - slack && v <= high + slack;
    };
    for (std::size_t k = 1; k < points.size(); ++k) {
      for (const std::size_t step : {1u, 2u, 5u}) {
        if (k < step) continue;
        std::array<double, D> middle;
        for (std::size_t i = 0; i < D; ++i)
          middle[i] = 0.5 * (points[k - step][i] + points[k][i]);
        if (!is_within(middle, 0.5 * range)) return false;
      }
    }
    if (std::isinf(radius_)) return true;
    for (std::size_t i = 0; i < 2 * D; ++i) {
      std::array<double, D> aside{};
      aside[i / 2] = i % 2 == 0 ? 0.9 : -0.9;
      if (!is_within(aside, 4 * range)) return false;
    }
    for (std::size_t corner = 0; corner < std::size_t{1} << D; ++corner) {
      std::array<double, D> aside{};
      for (std::size_t i = 0; i < D; ++i) aside[i] = (corner >> i & 1) != 0 ? 0.5 : -0.5;
      if (!is_within(aside, 2 * range)) return false;
    }
    return true;
  }

  static constexpr std::size_t lanes = 16;

  // Sixteen at a time: the terms in vector registers, then their sum.
  template <class Kernel>
  [[nodiscard]] double kernel_sum(const std::array<double, D>& p, Kernel) const {
    std::array<double, lanes> sums{};
    const std::size_t count = weights_.size();
    for (std::size_t begin = 0; begin < count; begin += lanes) {
      const std::size_t size = std::min(lanes, count - begin);
      std::array<double, lanes> q{};
      for (std::size_t i = 0; i < D; ++i) {
        const double* x = local_[i].data() + begin;
        for (std::size_t k = 0; k < size; ++k) q[k] += (p[i] - x[k]) * (p[i] - x[k]);
      }
      for (std::size_t k = 0; k < lanes; ++k) q[k] = Kernel::value(q[k]);
      for (std::size_t k = 0; k < size; ++k) sums[k] += weights_[begin + k] * q[k];
    }
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum;
  }

  template <class Kernel>
  [[nodiscard]] ScatterJet<D> kernel_sum(const std::array<ScatterJet<D>, D>& p,
                                         Kernel kernel) const {
    std::array<double, D> at_point;
    for (std::size_t i = 0; i < D; ++i) at_point[i] = p[i].value;
    ScatterJet<D> sum(kernel_sum(at_point, kernel));
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      double q = 0;
      for (std::size_t i = 0; i < D; ++i)
        q += (at_point[i] - local_[i][k]) * (at_point[i] - local_[i][k]);
      const double rate = 2 * weights_[k] * Kernel::rate(q) * per_length_;
      for (std::size_t i = 0; i < D; ++i)
        sum.slope[i] += rate * (at_point[i] - local_[i][k]);
    }
    return sum;
  }

  std::array<double, D> center_{};
  double radius_ = 0, per_length_ = 1, origin_ = 0;
  int degree_ = 1;
  bool is_held_ = false;
  std::array<std::vector<double>, D> local_;
  std::vector<double> weights_, rises_;
  std::array<double, most_monomials> polynomial_{};
};

/// The splines over some of the nodes.
template <std::size_t D>
struct RadialLevel {
  std::vector<Patch<D>> patches;
  BoxTree<D> discs;
};

// Nodes within this part of a disc's radius are its own: others begin discs.
constexpr double inner_disc_part = 0.6;
// The sum of weights above which only local splines have a say: less than a node has that
// is as far out as inner_disc_part, bell(0.6) = 0.087.
constexpr double full_spline_cover = 0.08;

/// The mean at a point of the splines whose discs hold it.
template <Number T, std::size_t D, class Kernel>
class RadialMean {
 public:
  explicit RadialMean(const std::array<T, D>& p) : p_(p) {}

  void add(const Patch<D>& patch) {
    const T weight = patch.weight(p_);
    if (!(value_of(weight) > 0)) return;
    if (is_empty_) origin_ = patch.origin();
    is_empty_ = false;
    weights_ += weight;
    sum_ += weight * (patch.rise(p_, Kernel{}) + (patch.origin() - origin_));
  }

  [[nodiscard]] bool is_empty() const noexcept { return is_empty_; }
  [[nodiscard]] bool is_covered() const noexcept {
    return value_of(weights_) >= full_spline_cover;
  }
  [[nodiscard]] T value() const { return sum_ / weights_ + origin_; }
  /// With `coarse` where discs hardly reach.
  [[nodiscard]] T completed(const T& coarse) const {
    const T open = 1.0 - weights_ / full_spline_cover, fine = value();
    return fine + open * open * open * (coarse - fine);
  }

 private:
  std::array<T, D> p_;
  T weights_ = 0.0, sum_ = 0.0;
  double origin_ = 0;
  bool is_empty_ = true;
};

template <std::size_t D>
std::vector<Disc<D>> covering_discs(const ScatterNodes<D>& nodes, std::size_t count) {
  const auto tree = point_tree<D>(nodes.points);
  std::vector<bool> is_inner(nodes.points.size());
  std::vector<Disc<D>> discs;
  for (std::size_t k = 0; k < nodes.points.size(); ++k) {
    if (is_inner[k]) continue;
    Disc<D> disc{.center = nodes.points[k]};
    const auto near = tree.nearest(disc.center, count + num_spare_nodes);
    // Where scales mix, the next node may be far beyond what the spline knows.
    const double known = std::sqrt(near[std::min(count, near.size()) - 1].squared);
    disc.radius = std::min(radius_beyond(std::span(near), count),
                           std::max(2 * known, least_radius));
    for (const auto& n : near) {
      const double d = std::sqrt(n.squared);
      if (d < disc.radius) disc.nodes.push_back(n.item);
      if (d <= inner_disc_part * disc.radius) is_inner[at(n.item)] = true;
    }
    std::sort(disc.nodes.begin(), disc.nodes.end());
    discs.push_back(std::move(disc));
  }
  return discs;
}

template <std::size_t D>
Disc<D> disc_of_all(const ScatterNodes<D>& nodes) {
  Disc<D> disc{.center = nodes.points[nodes.points.size() / 2]};
  for (std::size_t k = 0; k < nodes.points.size(); ++k)
    disc.nodes.push_back(static_cast<std::int32_t>(k));
  return disc;
}

template <std::size_t D>
RadialLevel<D> make_level(const ScatterNodes<D>& nodes, const std::vector<Disc<D>>& discs,
                          const RadialOptions& options, double scale,
                          const RunOptions& run) {
  RadialLevel<D> level;
  level.patches.resize(discs.size());
  delaunay::parallel_chunks(static_cast<std::int64_t>(discs.size()), 16, run,
                            [&](std::int64_t first, std::int64_t last) {
                              for (std::int64_t k = first; k < last; ++k) {
                                level.patches[at(k)] =
                                    Patch<D>(discs[at(k)], nodes, options, scale);
                              }
                            });
  std::vector<Box<D>> boxes;
  for (const Patch<D>& p : level.patches) boxes.push_back(p.box());
  level.discs = BoxTree<D>(std::move(boxes));
  return level;
}

/// What is missing at a node, put back close to it.
template <std::size_t D>
struct Bump {
  std::array<double, D> center;
  double radius = 0, height = 0;
};

/// Local splines and their mean (a Method of ScatterSurface).
template <class Domain>
class Radial {
 public:
  static constexpr std::size_t D = Domain::dimension;
  using Point = typename Domain::Point;
  using Position = std::array<double, D>;

  Radial(Domain domain, ScatterNodes<D> nodes, const RadialOptions& options,
         const RunOptions& run)
      : domain_(std::move(domain)),
        kernel_(options.kernel),
        is_exact_(options.smoothing == 0) {
    if (nodes.points.empty()) return;
    ScatterNodes<D> rest = nodes;
    while (rest.points.size() > at(options.most_at_once)) {
      levels_.push_back(make_level(rest, covering_discs(rest, at(options.neighbors)),
                                   options, domain_.scale(), run));
      rest = every_eighth(rest);
    }
    levels_.push_back(
        make_level(rest, {disc_of_all(rest)}, options, domain_.scale(), run));
    if (is_exact_ && has_held_patch()) put_back(nodes, run);
  }

  [[nodiscard]] bool is_exact() const noexcept { return is_exact_; }

  template <Number T>
  [[nodiscard]] T evaluate(const Point& p, Cursor&) const {
    const Position position = domain_.position(p);
    return with_bumps(position, variables<T>(position));
  }

 private:
  [[nodiscard]] bool has_held_patch() const {
    return std::any_of(levels_[0].patches.begin(), levels_[0].patches.end(),
                       [](const Patch<D>& p) { return p.is_held(); });
  }

  void put_back(const ScatterNodes<D>& nodes, const RunOptions& run) {
    const auto count = static_cast<std::int64_t>(nodes.points.size());
    const auto tree = point_tree<D>(nodes.points);
    std::vector<Bump<D>> bumps(at(count));
    delaunay::parallel_chunks(
        count, 256, run, [&](std::int64_t first, std::int64_t last) {
          for (std::int64_t k = first; k < last; ++k) {
            const Position& p = nodes.points[at(k)];
            const auto near = tree.nearest(p, 2);
            bumps[at(k)] = {p, near.size() < 2 ? 0 : 0.5 * std::sqrt(near[1].squared),
                            nodes.values[at(k)] - blend(0, p, variables<double>(p))};
          }
        });
    std::erase_if(bumps, [](const Bump<D>& b) { return b.height == 0 || b.radius == 0; });
    std::vector<Box<D>> boxes;
    for (const Bump<D>& b : bumps) boxes.push_back(ball_box(b.center, b.radius));
    bumps_ = std::move(bumps);
    bump_tree_ = BoxTree<D>(std::move(boxes));
  }

  template <Number T>
  [[nodiscard]] T with_bumps(const Position& position, const std::array<T, D>& p) const {
    T value = blend(0, position, p);
    bump_tree_.for_each_holding(position, [&](std::int32_t k) {
      using std::sqrt;
      const Bump<D>& b = bumps_[at(k)];
      const T r = sqrt(squared_length(difference(p, b.center))) / b.radius;
      if (value_of(r) < 1) value += b.height * bell(r);
    });
    return value;
  }

  template <Number T>
  [[nodiscard]] T blend(std::size_t level, const Position& position,
                        const std::array<T, D>& p) const {
    return with_kernel(
        kernel_, [&](auto kernel) { return blend_with(kernel, level, position, p); });
  }

  template <Number T, class Kernel>
  [[nodiscard]] T blend_with(Kernel kernel, std::size_t level, const Position& position,
                             const std::array<T, D>& p) const {
    const RadialLevel<D>& here = levels_[level];
    RadialMean<T, D, Kernel> mean(p);
    here.discs.for_each_holding(position,
                                [&](std::int32_t k) { mean.add(here.patches[at(k)]); });
    if (mean.is_empty()) return blend_with(kernel, level + 1, position, p);
    if (level + 1 == levels_.size() || mean.is_covered()) return mean.value();
    return mean.completed(blend_with(kernel, level + 1, position, p));
  }

  Domain domain_;
  RadialKernel kernel_;
  bool is_exact_;
  std::vector<RadialLevel<D>>
      levels_;  // the last is one spline, which reaches everywhere
  std::vector<Bump<D>> bumps_;
  BoxTree<D> bump_tree_;
};

}  // namespace delone::interp
