#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/blend_operator_node.hpp"
#include "interp/blend_operator_surroundings.hpp"
#include "interp/c1_choices.hpp"
#include "interp/least_curvature.hpp"

namespace delone::interp {

/// What a node whose polynomial is partly constant gets.
[[nodiscard]] inline double tension_of(double constant_part, double least) {
  return std::min(most_tension, least + (1 - least) * std::sqrt(constant_part));
}

/// Global gradients of random fields: what they make of independent errors.
template <BlendSpace Space>
class GradientSamples {
 public:
  GradientSamples(const Space& space, const typename Space::Triangulation& t,
                  Gradients gradients, const RunOptions& run)
      : space_(space), t_(&t) {
    if (gradients != Gradients::global || t.dimension() < 2) return;
    const RunOptions quiet{run.num_threads, {}};
    for (std::uint64_t field = 0; field < num_fields; ++field) {
      std::vector<double>& signs = signs_.emplace_back(at(t.num_sites()));
      for (std::size_t s = 0; s < signs.size(); ++s)
        signs[s] = sign_of(s * num_fields + field);
      gradients_.push_back(least_curvature_gradients(space, t, signs, quiet));
    }
  }

  /// The choice, and where it amplifies errors the gradient alone or the constant.
  template <int Degree>
  [[nodiscard]] C1NodeChoice tempered(const BlendSurroundings<Space, Degree>& around,
                                      Site s, std::span<const StencilNode> stencil,
                                      const C1NodeChoice& choice,
                                      double least_tension) const {
    if (signs_.empty() || around.per_radius() == 0) return choice;
    const double whole = trust(around, s, stencil, choice);
    if (whole == 1) return choice;
    C1NodeChoice result = choice;
    result.parts = {0, 1};
    const double of_gradient = (1 - whole) * trust(around, s, stencil, result);
    for (std::size_t d = 0; d < result.parts.size(); ++d)
      result.parts[d] = whole * choice.parts[d];
    result.parts[1] += of_gradient;
    result.parts[0] += 1 - whole - of_gradient;
    result.tension = tension_of(result.parts[0], least_tension);
    return result;
  }

 private:
  static constexpr std::size_t num_fields = 16;

  /// 0 .. 1, by the root mean square of the polynomial over the fields.
  template <int Degree>
  [[nodiscard]] double trust(const BlendSurroundings<Space, Degree>& around, Site s,
                             std::span<const StencilNode> stencil,
                             const C1NodeChoice& choice) const {
    constexpr double full = 12, most = 24;
    const BlendNode<Degree> node =
        blend_node<Space, Degree>(space_, *t_, s, stencil, choice, Gradients::global);
    const auto axes = Space::axes(space_.vector(t_->points()[at(s)]));
    std::vector<BlendModel<Degree>> models;
    for (std::size_t k = 0; k < num_fields; ++k) {
      const auto slope = Space::local(axes, Space::position(gradients_[k][at(s)]), 1);
      models.push_back(node.model(s, signs_[k], {slope.u, slope.v}));
    }
    double largest = 0;
    around.for_each_place([&](const auto& terms) {
      double sum = 0;
      for (const BlendModel<Degree>& model : models) {
        double rise = 0;
        for (std::size_t c = 0; c < terms.size(); ++c)
          rise += model.coefficients[c] * terms[c];
        sum += rise * rise;
      }
      if (!(sum <= largest)) largest = sum;  // not a number counts as too large
    });
    const double magnitude = std::sqrt(largest / static_cast<double>(num_fields));
    if (!(magnitude < most)) return 0;
    return std::min(1.0, (most - magnitude) / (most - full));
  }

  // Splitmix64.
  static double sign_of(std::uint64_t number) {
    std::uint64_t z = (number + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return ((z ^ (z >> 31)) >> 32) % 2 == 0 ? 1 : -1;
  }

  Space space_;
  const typename Space::Triangulation* t_;
  std::vector<std::vector<double>> signs_;
  std::vector<std::vector<typename Space::Vector>> gradients_;
};

}  // namespace delone::interp
