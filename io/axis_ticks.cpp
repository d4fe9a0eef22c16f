#include "io/axis_ticks.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "io/label_text.hpp"

namespace delone::io {
namespace {

/// The length mantissa * 10^exponent between ticks. Ticks are counted in units of
/// 10^exponent, as whole numbers, so that labels and values are exact decimals.
struct Step {
  std::int64_t mantissa = 1;
  int exponent = 0;
};

/// The double nearest to units * 10^exponent.
double decimal(std::int64_t units, int exponent) {
  const std::string text = std::to_string(units) + "e" + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// First and last tick, as numbers of steps.
struct StepRange {
  std::int64_t first, last;
  [[nodiscard]] std::int64_t count() const { return last - first + 1; }
};

/// Nothing if the numbers of steps are too large to be whole numbers in a double.
std::optional<StepRange> steps_within(double low, double high, Step step) {
  const double length = decimal(step.mantissa, step.exponent);
  // An end of the axis that is a round number but for rounding gets its tick.
  const double slack = 1e-9 * (high / length - low / length);
  const double first = std::ceil(low / length - slack);
  const double last = std::floor(high / length + slack);
  constexpr double largest = 1e14;
  // Written so that NaN (from a length of zero) fails too.
  if (!(std::abs(first) <= largest && std::abs(last) <= largest)) return std::nullopt;
  return StepRange{static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

std::string digits(std::int64_t units, int decimals) {
  std::string text = std::to_string(std::abs(units));
  if (decimals <= 0)
    return units == 0 ? text
                      : text + std::string(static_cast<std::size_t>(-decimals), '0');
  const auto num_decimals = static_cast<std::size_t>(decimals);
  if (text.size() <= num_decimals) text.insert(0, num_decimals + 1 - text.size(), '0');
  text.insert(text.size() - num_decimals, 1, '.');
  return text;
}

std::string signed_digits(std::int64_t units, int decimals) {
  return (units < 0 ? minus_sign : std::string()) + digits(units, decimals);
}

int shared_exponent(double low, double high) {
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest == 0 || (largest >= 1e-3 && largest < 1e7)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

Ticks ends_of(double low, double high) {
  Ticks ticks;
  for (const double value : {low, high}) {
    if (!ticks.values.empty() && value == ticks.values.front()) break;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    ticks.values.push_back(value);
    ticks.labels.emplace_back(text.data(), end);
  }
  return ticks;
}

/// The shortest step of 1, 2 or 5 times a power of ten with at most `max_count` ticks.
std::optional<Step> round_step(double low, double high, int max_count) {
  const double shortest = high / max_count - low / max_count;
  if (!(shortest > 0)) return std::nullopt;
  const int exponent = static_cast<int>(std::floor(std::log10(shortest)));
  for (int e = exponent; e <= exponent + 1; ++e) {
    for (const std::int64_t mantissa : {1, 2, 5}) {
      const auto steps = steps_within(low, high, {mantissa, e});
      if (steps && steps->count() <= max_count) return Step{mantissa, e};
    }
  }
  return std::nullopt;
}

Step degree_step(double low, double high, int max_count,
                 std::span<const std::int64_t> whole_degrees) {
  const auto round = round_step(low, high, max_count);
  if (round && round->exponent < 0) return *round;
  for (const std::int64_t degrees : whole_degrees) {
    const auto steps = steps_within(low, high, {degrees, 0});
    if (steps && steps->count() <= max_count) return {degrees, 0};
  }
  return {whole_degrees.back(), 0};
}

/// Ticks at the multiples of `step`; `label` gives the text from units of
/// 10^step.exponent.
template <typename Label>
requires std::invocable<Label, std::int64_t> Ticks ticks_at(double low, double high,
                                                            Step step,
                                                            const Label& label) {
  Ticks ticks;
  const auto steps = steps_within(low, high, step);
  if (!steps) return ticks;
  for (std::int64_t i = steps->first; i <= steps->last; ++i) {
    ticks.values.push_back(decimal(i * step.mantissa, step.exponent));
    ticks.labels.push_back(label(i * step.mantissa));
  }
  return ticks;
}

bool are_distinct(const Ticks& ticks) {
  return ticks.values.size() >= 2 &&
         std::adjacent_find(ticks.values.begin(), ticks.values.end()) ==
             ticks.values.end();
}

std::int64_t power(int exponent) {
  std::int64_t result = 1;
  for (int i = 0; i < exponent; ++i) result *= 10;
  return result;
}

std::string hemisphere_label(std::int64_t units, int decimals, const char* positive,
                             const char* negative) {
  const std::string degrees = digits(units, decimals) + "°";
  return units == 0 ? "0°" : degrees + (units > 0 ? positive : negative);
}

std::string longitude_label(std::int64_t units, int decimals) {
  const std::int64_t turn = 360 * power(decimals);
  std::int64_t wrapped = units % turn;
  if (wrapped <= -turn / 2) wrapped += turn;
  if (wrapped > turn / 2) wrapped -= turn;
  if (wrapped == turn / 2) return "180°";
  return hemisphere_label(wrapped, decimals, "E", "W");
}

}  // namespace

Ticks linear_ticks(double low, double high, int max_count) {
  const auto step = round_step(low, high, max_count);
  if (!step) return ends_of(low, high);
  const int exponent = shared_exponent(low, high);
  Ticks ticks = ticks_at(low, high, *step, [&](std::int64_t units) {
    return signed_digits(units, exponent - step->exponent);
  });
  ticks.exponent = exponent;
  return are_distinct(ticks) ? ticks : ends_of(low, high);
}

Ticks longitude_ticks(double west, double east, int max_count) {
  static constexpr std::array<std::int64_t, 9> steps{1, 2, 5, 10, 15, 30, 60, 90, 180};
  const Step step = degree_step(west, east, max_count, steps);
  return ticks_at(west, east, step, [&](std::int64_t units) {
    return longitude_label(units, -step.exponent);
  });
}

Ticks latitude_ticks(double south, double north, int max_count) {
  static constexpr std::array<std::int64_t, 8> steps{1, 2, 5, 10, 15, 30, 45, 90};
  const Step step = degree_step(south, north, max_count, steps);
  return ticks_at(south, north, step, [&](std::int64_t units) {
    return hemisphere_label(units, -step.exponent, "N", "S");
  });
}

std::string power_of_ten(int exponent) { return "10" + superscript(exponent); }

}  // namespace delone::io
