#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace delone::interp {

/// Parts of the degrees in a nodal polynomial, summing to one, by the inverse cube of how
/// well each predicts neighbours that it is not shown. `errors`: by degree from the
/// constant on, squared, the constant's above 0. `doubt`: see Stiffness.
template <std::size_t Size>
[[nodiscard]] std::array<double, Size> mix_degrees(std::array<double, Size> errors,
                                                   double doubt) noexcept {
  // The degrees below which a mix prefers the higher and above which the lower one, by
  // the part of the neighbours' rises that is not predicted.
  constexpr double smooth = 0.05, rough = 0.15;
  // Of degrees 3 and 4 the lower one looks better by chance more often, and costs more.
  constexpr double trust_in_smooth = Size > 4 ? 10 : 3;
  const double total = errors[0], best = *std::min_element(errors.begin(), errors.end());
  const double unpredicted = std::sqrt(best / total);
  const double roughness =
      std::clamp((unpredicted - smooth) / (rough - smooth), 0.0, 1.0);
  const double handicap = roughness * (doubt + trust_in_smooth) - trust_in_smooth;
  for (std::size_t d = 0; d < Size; ++d)
    errors[d] *= std::exp(handicap * static_cast<double>(d));
  const double least = *std::min_element(errors.begin(), errors.end());
  std::array<double, Size> parts{};
  double sum = 0;
  for (std::size_t d = 0; d < Size; ++d) {
    const double ratio = errors[d] > least ? least / errors[d] : 1;
    parts[d] = ratio * std::sqrt(ratio);
    sum += parts[d];
  }
  for (double& part : parts) part /= sum;
  return parts;
}

}  // namespace delone::interp
