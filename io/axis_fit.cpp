#include "io/axis_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace delone::io {
namespace {

using interp::Axis;

/// `spacing` as length / parts, with parts a power of ten or length one, if it is such a
/// ratio up to rounding.
std::optional<std::pair<double, double>> short_ratio(double spacing) {
  constexpr double rounding = 1e-10;
  for (const double parts : {1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8}) {
    const double length = std::round(spacing * parts);
    if (length >= 1 && std::abs(spacing * parts - length) <= rounding * length)
      return std::pair{length, parts};
  }
  const double parts = std::round(1 / spacing);
  if (!(parts >= 1) || std::abs(spacing * parts - 1) > rounding) return std::nullopt;
  return std::pair{1.0, parts};
}

/// `axis`, whose spacing is set, moved to start at `first`.
Axis anchored(Axis axis, double first) {
  const double steps = first / axis.spacing;
  if (std::abs(steps) < 0x1p53) axis.first_step = std::llround(steps);
  const double offset = first - axis.coordinate(0);
  if (std::abs(offset) > 1e-9 * axis.spacing) axis.offset = offset;
  return axis;
}

FittedAxis compared(const Axis& axis, std::span<const double> coordinates) {
  FittedAxis result{.axis = axis};
  for (std::int64_t i = 0; i < axis.size; ++i) {
    const double deviation =
        std::abs(coordinates[static_cast<std::size_t>(i)] - axis.coordinate(i));
    // Written so that NaN counts as a deviation.
    if (!(deviation <= result.largest_deviation)) result.largest_deviation = deviation;
  }
  return result;
}

FittedAxis fit_rising_axis(std::span<const double> coordinates) {
  Axis plain{.size = std::ssize(coordinates)};
  if (plain.size > 1)
    plain.spacing =
        (coordinates.back() - coordinates.front()) / static_cast<double>(plain.size - 1);
  const FittedAxis with_mean =
      compared(anchored(plain, coordinates.front()), coordinates);
  const auto ratio = short_ratio(plain.spacing);
  if (!ratio) return with_mean;
  Axis rational = plain;
  std::tie(rational.length, rational.parts) = *ratio;
  rational.spacing = rational.length / rational.parts;
  const FittedAxis with_ratio =
      compared(anchored(rational, coordinates.front()), coordinates);
  // Coordinates that were summed up by their author err more than the ratio does, hence a
  // grain of salt.
  const double salt = 1e-9 * plain.spacing;
  return with_ratio.largest_deviation <= with_mean.largest_deviation + salt ? with_ratio
                                                                            : with_mean;
}

}  // namespace

FittedAxis fit_axis(std::span<const double> coordinates) {
  const bool is_usable =
      std::ranges::all_of(coordinates, [](double c) { return std::isfinite(c); }) &&
      (coordinates.size() == 1 || coordinates.front() != coordinates.back()) &&
      std::isfinite(coordinates.back() - coordinates.front());
  FittedAxis result;
  result.largest_deviation = std::numeric_limits<double>::infinity();
  if (!is_usable) return result;
  if (coordinates.front() <= coordinates.back()) return fit_rising_axis(coordinates);
  const std::vector<double> reversed(coordinates.rbegin(), coordinates.rend());
  result = fit_rising_axis(reversed);
  result.is_descending = true;
  return result;
}

}  // namespace delone::io
