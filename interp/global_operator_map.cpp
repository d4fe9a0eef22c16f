#include "interp/global_operator_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "interp/index.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Tangent = CurvatureNetwork::Tangent;
using End = CurvatureNetwork::End;

/// Rows of the transpose, one after the other, over the nodes around.
class NearbyTranspose {
 public:
  NearbyTranspose(const CurvatureNetwork& network,
                  std::span<const double> inverse_lengths, std::span<const Site> targets)
      : network_(network),
        inverse_lengths_(inverse_lengths),
        targets_(targets),
        numbers_(network.num_nodes(), none) {}

  NodalTerms operator()(const NodalTerms& of_unknowns) {
    NodalTerms row;
    for (std::size_t i = 0; i < of_unknowns.sites().size(); ++i) {
      const Site unknown = of_unknowns.sites()[i];
      const double weight = of_unknowns.weights()[i];
      if (unknown % 3 == 0) {
        row.add(unknown / 3, weight);
      } else if (weight != 0) {
        add_right_side(unknown / 3, at(unknown % 3 - 1), weight);
      }
    }
    add_rings();
    iterate();
    add_slopes(row);
    forget();
    return row;
  }

 private:
  void add_right_side(Site s, std::size_t component, double weight) {
    residual_[at(number(s))][component] += weight;
  }
  std::int32_t number(Site s) {
    std::int32_t& n = numbers_[at(s)];
    if (n == none) {
      n = static_cast<std::int32_t>(nodes_.size());
      nodes_.push_back(s);
      residual_.emplace_back();
    }
    return n;
  }
  [[nodiscard]] std::size_t first_end(Site s) const {
    return at(network_.offsets()[at(s)]);
  }
  [[nodiscard]] std::size_t last_end(Site s) const {
    return at(network_.offsets()[at(s) + 1]);
  }

  // A step of the iteration reaches one ring further.
  void add_rings() {
    ring_ends_.assign(1, nodes_.size());
    std::size_t begin = 0;
    for (int ring = 0; ring < num_curvature_steps; ++ring) {
      const std::size_t end = nodes_.size();
      for (std::size_t i = begin; i < end; ++i) {
        const Site s = nodes_[i];
        for (std::size_t k = first_end(s); k < last_end(s); ++k)
          static_cast<void>(number(targets_[k]));
      }
      begin = end;
      ring_ends_.push_back(nodes_.size());
    }
  }

  [[nodiscard]] Tangent product(std::size_t i) const {
    Tangent y = step_[i];
    const Site s = nodes_[i];
    for (std::size_t k = first_end(s); k < last_end(s); ++k) {
      const std::int32_t other = numbers_[at(targets_[k])];
      if (other == none) continue;
      const End& end = network_.ends()[k];
      const Tangent& back = network_.ends()[at(end.reverse)].direction;
      const Tangent& x = step_[at(other)];
      const double along = 2 * (back[0] * x[0] + back[1] * x[1]);
      y[0] -= along * end.direction[0];
      y[1] -= along * end.direction[1];
    }
    return y;
  }

  // CurvatureNetwork::iterated, as far as a step has come.
  void iterate() {
    for (std::size_t i = 0; i < ring_ends_[0]; ++i)
      residual_[i] = network_.to_unit_weights(at(nodes_[i]), residual_[i]);
    x_.assign(nodes_.size(), {});
    step_ = residual_;
    change_.assign(nodes_.size(), {});
    constexpr double half_width = 0.5;
    double factor = half_width;
    for (std::size_t i = 0; i < at(num_curvature_steps); ++i) {
      const std::size_t reached = ring_ends_[i + 1];
      for (std::size_t v = 0; v < reached; ++v) change_[v] = product(v);
      const double next = 1 / (2 / half_width - factor);
      for (std::size_t v = 0; v < reached; ++v) {
        for (std::size_t c = 0; c < 2; ++c) {
          x_[v][c] += step_[v][c];
          residual_[v][c] -= change_[v][c];
          step_[v][c] =
              next * factor * step_[v][c] + 2 * next / half_width * residual_[v][c];
        }
      }
      factor = next;
    }
  }

  void add_slopes(NodalTerms& row) {
    sums_.assign(nodes_.size(), 0);
    for (std::size_t v = 0; v < ring_ends_[at(num_curvature_steps - 1)]; ++v) {
      for (std::size_t k = first_end(nodes_[v]); k < last_end(nodes_[v]); ++k) {
        const End& end = network_.ends()[k];
        const double weight =
            6 * std::sqrt(end.weight) *
            (end.direction[0] * x_[v][0] + end.direction[1] * x_[v][1]) *
            inverse_lengths_[k];
        sums_[at(numbers_[at(targets_[k])])] += weight;
        sums_[v] -= weight;
      }
    }
    for (std::size_t v = 0; v < nodes_.size(); ++v)
      if (sums_[v] != 0) row.add(nodes_[v], sums_[v]);
  }

  void forget() {
    for (const Site s : nodes_) numbers_[at(s)] = none;
    nodes_.clear();
    residual_.clear();
  }

  const CurvatureNetwork& network_;
  std::span<const double> inverse_lengths_;
  std::span<const Site> targets_;
  std::vector<std::int32_t> numbers_;  ///< of the nodes around, by site
  std::vector<Site> nodes_;            ///< ring by ring
  std::vector<std::size_t> ring_ends_;
  std::vector<Tangent> residual_, step_, change_, x_;
  std::vector<double> sums_;
};

}  // namespace

MatrixXd CurvatureMap::unknowns(const MatrixXd& site_values,
                                const RunOptions& run) const {
  MatrixXd result(3 * site_values.rows(), site_values.cols());
  const auto num_sites = static_cast<std::size_t>(site_values.rows());
  std::vector<double> slopes(targets_.size());
  for (Index field = 0; field < site_values.cols(); ++field) {
    const double* const values = site_values.col(field).data();
    for (std::size_t v = 0; v < num_sites; ++v) {
      const auto begin = at(network_.offsets()[v]), end = at(network_.offsets()[v + 1]);
      for (std::size_t k = begin; k < end; ++k)
        slopes[k] = (values[targets_[k]] - values[v]) * inverse_lengths_[k];
    }
    const std::vector<Tangent> gradients =
        network_.gradients(slopes, num_curvature_steps, run);
    for (std::size_t v = 0; v < num_sites; ++v) {
      result.col(field).segment<3>(3 * static_cast<Index>(v)) << values[v],
          gradients[v][0], gradients[v][1];
    }
  }
  return result;
}

MatrixXd CurvatureMap::site_weights(const MatrixXd& unknown_weights,
                                    const RunOptions& run) const {
  MatrixXd result(unknown_weights.rows() / 3, unknown_weights.cols());
  std::vector<Tangent> of_gradients(network_.num_nodes());
  for (Index field = 0; field < unknown_weights.cols(); ++field) {
    const double* const weights = unknown_weights.col(field).data();
    double* const sums = result.col(field).data();
    for (std::size_t v = 0; v < of_gradients.size(); ++v) {
      sums[v] = weights[3 * v];
      of_gradients[v] = {weights[3 * v + 1], weights[3 * v + 2]};
    }
    const std::vector<double> of_slopes =
        network_.slope_weights(of_gradients, num_curvature_steps, run);
    for (std::size_t v = 0; v < of_gradients.size(); ++v) {
      const auto begin = at(network_.offsets()[v]), end = at(network_.offsets()[v + 1]);
      for (std::size_t k = begin; k < end; ++k) {
        const double weight = of_slopes[k] * inverse_lengths_[k];
        sums[targets_[k]] += weight;
        sums[v] -= weight;
      }
    }
  }
  return result;
}

std::vector<NodalTerms> CurvatureMap::rows(
    std::span<const NodalTerms> of_unknowns) const {
  NearbyTranspose transpose(network_, inverse_lengths_, targets_);
  std::vector<NodalTerms> result;
  result.reserve(of_unknowns.size());
  for (const NodalTerms& row : of_unknowns) result.push_back(transpose(row));
  return result;
}

template <BlendSpace Space>
CurvatureMap curvature_map(const Space& space,
                           const typename Space::Triangulation& triangulation,
                           const RunOptions& run) {
  const Adjacency& t = triangulation.adjacency();
  std::vector<Site> targets(at(t.num_arcs()));
  for (Site v = 0; v < t.num_sites(); ++v) {
    Arc a = t.first_arc(v);
    for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a))
      targets[at(a.index)] = t.target(a);
  }
  return {curvature_network_of(space, triangulation, run), std::move(targets)};
}

template CurvatureMap curvature_map<PlaneSpace>(const PlaneSpace&,
                                                const tripack::Triangulation&,
                                                const RunOptions&);
template CurvatureMap curvature_map<SphereSpace>(const SphereSpace&,
                                                 const stripack::Triangulation&,
                                                 const RunOptions&);

}  // namespace delone::interp
