#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "interp/blend_model.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

// What fits of all kinds share: the radius of a stencil beside its farthest node, the
// least distance (of the radius) in weights, and the most tension of a node.
template <int Degree>
inline constexpr double radius_factor = Degree == 4 ? 1.02 : 1.05;
inline constexpr double least_distance = 0.001, most_tension = 0.98;

/// First of the terms that a degree adds.
[[nodiscard]] constexpr std::size_t first_blend_term(int degree) noexcept {
  return degree == 0 ? 0 : num_blend_terms(degree - 1);
}

/// By terms and samples: how much a coefficient takes from the rise of a sample.
template <int Degree>
using BlendInfluence =
    std::array<std::array<double, most_stencil_nodes>, num_blend_terms(Degree)>;

/// The weighted samples of a stencil, by columns, and their normal equations. A ridge of
/// 1e-10 with one step of refinement leaves coefficients that the positions do not
/// determine at zero and others exact.
template <int Degree>
class BlendSamples {
 public:
  static constexpr std::size_t num_columns = num_blend_terms(Degree);
  static constexpr std::size_t most_rows = most_stencil_nodes;

  using Coefficients = std::array<double, num_columns>;

  void add(const Coefficients& terms, double rise, double weight, bool is_neighbor) {
    for (std::size_t c = 0; c < num_columns; ++c) columns_[c][size_] = weight * terms[c];
    rises_[size_] = weight * rise;
    weights_[size_] = weight;
    is_neighbor_[size_] = is_neighbor;
    ++size_;
  }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  // G + ridge = L L^T, L and y = L^-1 A^T b by columns: the leading parts of both belong
  // to the lower degrees.
  void factor() {
    for (std::size_t i = 0; i < num_columns; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        lower_[i][j] = product(columns_[i], columns_[j]);
      lower_[i][i] *= 1 + ridge;
    }
    for (std::size_t i = 0; i < num_columns; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = lower_[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= lower_[i][k] * lower_[j][k];
        if (j < i) {
          lower_[i][j] = sum * inverse_[j];
        } else {
          // Rounding of a column that the others span: no more than the ridge.
          inverse_[i] = lower_[i][i] > 0
                            ? 1 / std::sqrt(std::max(sum, 0.5 * ridge * lower_[i][i]))
                            : 0;
        }
      }
    }
    Coefficients right{};
    for (std::size_t c = 0; c < num_columns; ++c) right[c] = product(columns_[c], rises_);
    half_solution_ = forward(right, num_columns);
  }

  // With the first `num` terms; refined once, which takes the ridge's bias away from all
  // that the samples determine.
  [[nodiscard]] Coefficients solve(std::size_t num) const {
    Coefficients x = backward(half_solution_, num);
    Row residual = rises_;
    for (std::size_t c = 0; c < num; ++c) {
      for (std::size_t r = 0; r < size_; ++r) residual[r] -= x[c] * columns_[c][r];
    }
    Coefficients right{};
    for (std::size_t c = 0; c < num; ++c) right[c] = product(columns_[c], residual);
    const Coefficients more = backward(forward(right, num), num);
    for (std::size_t c = 0; c < num; ++c) x[c] += more[c];
    return x;
  }

  /// By degree, the sum of squared errors at the neighbours when each is left out.
  [[nodiscard]] std::array<double, Degree + 1> errors() const {
    std::array<double, Degree + 1> sums{};
    for (std::size_t r = 0; r < size_; ++r) {
      if (!is_neighbor_[r]) continue;
      Coefficients row{};
      for (std::size_t c = 0; c < num_columns; ++c) row[c] = columns_[c][r];
      row = forward(row, num_columns);
      double residual = rises_[r], leverage = 0;
      for (int degree = 0; degree <= Degree; ++degree) {
        for (std::size_t c = first_blend_term(degree); c < end_term(degree); ++c) {
          residual -= row[c] * half_solution_[c];
          leverage += row[c] * row[c];
        }
        sums[static_cast<std::size_t>(degree)] += squared_error(r, residual, leverage);
      }
    }
    return sums;
  }

  /// What solve(num) takes from the rise of every sample, by terms and samples.
  [[nodiscard]] BlendInfluence<Degree> influence(std::size_t num) const {
    BlendInfluence<Degree> x;
    for (std::size_t c = 0; c < num; ++c) x[c] = columns_[c];
    solve_rows(x, num);
    BlendInfluence<Degree> more{};
    for (std::size_t r = 0; r < size_; ++r) {
      Row residual{};
      residual[r] = 1;
      for (std::size_t c = 0; c < num; ++c) subtract(residual, columns_[c][r], x[c]);
      for (std::size_t c = 0; c < num; ++c) subtract(more[c], -columns_[c][r], residual);
    }
    solve_rows(more, num);
    for (std::size_t c = 0; c < num; ++c) {
      for (std::size_t r = 0; r < size_; ++r)
        x[c][r] = (x[c][r] + more[c][r]) * weights_[r];
    }
    return x;
  }

  /// Of the terms that a degree adds the least part, 0 .. 1, of its square that the terms
  /// before it do not span on these samples.
  [[nodiscard]] double independence(int degree) const {
    double least = 1;
    for (std::size_t c = first_blend_term(degree); c < end_term(degree); ++c) {
      const double pivot = 1 / (inverse_[c] * inverse_[c]);
      least = std::min(least, inverse_[c] > 0 ? pivot / lower_[c][c] : 0);
    }
    return least;
  }

  [[nodiscard]] static std::size_t end_term(int degree) {
    return degree == 0 ? 0 : num_blend_terms(degree);
  }

 private:
  static constexpr double ridge = 1e-10;
  using Row = std::array<double, most_rows>;

  [[nodiscard]] double product(const Row& a, const Row& b) const {
    std::array<double, 4> sums{};
    std::size_t r = 0;
    for (; r + 4 <= size_; r += 4) {
      for (std::size_t k = 0; k < 4; ++k) sums[k] += a[r + k] * b[r + k];
    }
    for (; r < size_; ++r) sums[0] += a[r] * b[r];
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
  }

  [[nodiscard]] Coefficients forward(Coefficients b, std::size_t num) const {
    for (std::size_t i = 0; i < num; ++i) {
      for (std::size_t k = 0; k < i; ++k) b[i] -= lower_[i][k] * b[k];
      b[i] *= inverse_[i];
    }
    return b;
  }
  [[nodiscard]] Coefficients backward(const Coefficients& y, std::size_t num) const {
    Coefficients x{};
    for (std::size_t i = num; i-- > 0;) {
      double sum = y[i];
      for (std::size_t k = i + 1; k < num; ++k) sum -= lower_[k][i] * x[k];
      x[i] = sum * inverse_[i];
    }
    return x;
  }

  void subtract(Row& from, double factor, const Row& row) const {
    for (std::size_t r = 0; r < size_; ++r) from[r] -= factor * row[r];
  }
  // Both halves of the solution for many right sides at once.
  void solve_rows(BlendInfluence<Degree>& b, std::size_t num) const {
    const auto scale = [&](std::size_t i) {
      for (std::size_t r = 0; r < size_; ++r) b[i][r] *= inverse_[i];
    };
    for (std::size_t i = 0; i < num; ++i) {
      for (std::size_t k = 0; k < i; ++k) subtract(b[i], lower_[i][k], b[k]);
      scale(i);
    }
    for (std::size_t i = num; i-- > 0;) {
      for (std::size_t k = i + 1; k < num; ++k) subtract(b[i], lower_[k][i], b[k]);
      scale(i);
    }
  }

  // A sample that alone determines a coefficient tells nothing when left out: its whole
  // rise counts as the error.
  [[nodiscard]] double squared_error(std::size_t r, double residual,
                                     double leverage) const {
    constexpr double least_share = 1e-12;
    const double share = std::max(1 - leverage, least_share);
    const double error = share > 1e-6
                             ? std::abs(residual) / share
                             : std::max(std::abs(rises_[r]), std::abs(residual) / share);
    const double unweighted = error / weights_[r];
    return unweighted * unweighted;
  }

  std::array<Row, num_columns> columns_;
  Row rises_{}, weights_{};
  std::array<bool, most_rows> is_neighbor_{};
  std::size_t size_ = 0;
  std::array<Coefficients, num_columns> lower_{};
  Coefficients inverse_{}, half_solution_{};
};

}  // namespace delone::interp
