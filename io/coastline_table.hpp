#pragma once

#include <cstdint>
#include <span>

namespace delone::io {

/// A row of data/coastline/ne_110m_coastline.csv: points of one line stand one behind the
/// other.
struct CoastPoint {
  std::int16_t line;
  float lon_deg, lat_deg;
};

/// The whole file, compiled into the library so that no path is needed at run time.
[[nodiscard]] std::span<const CoastPoint> coast_points() noexcept;

}  // namespace delone::io
