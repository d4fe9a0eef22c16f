#pragma once

#include <string>
#include <vector>

namespace delone::io {

/// Where an axis is marked, in ascending order, and with which text (UTF-8).
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;  ///< of values / 10^exponent
  int exponent = 0;  ///< a multiple of 3; not 0 only for very large or very small values
};

/// Multiples of 1, 2 or 5 times a power of ten within [low, high] (finite, low <= high):
/// as many as possible, at most `max_count` >= 2. Each value is the double nearest to its
/// label. Where the range holds no round numbers that doubles tell apart, its two ends.
[[nodiscard]] Ticks linear_ticks(double low, double high, int max_count);

/// The same for longitudes, any wrap, at steps that divide 360 where they are whole
/// degrees: "60°W", "0°", "180°".
[[nodiscard]] Ticks longitude_ticks(double west, double east, int max_count);

/// The same for latitudes: "30°S", "0°", "30°N".
[[nodiscard]] Ticks latitude_ticks(double south, double north, int max_count);

/// "10³" for 3; the text by which labels of that exponent are multiplied.
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace delone::io
