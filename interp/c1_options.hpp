#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "interp/surface_options.hpp"

namespace delone::interp {

/// What a smooth surface may do between its nodes.
enum class Bounds : std::uint8_t {
  widened,  ///< leave the range of all data by a quarter of it at most
  local     ///< stay, in each triangle, within the values of its corners and their
            ///< neighbours
};

/// Highest degree of the polynomials fitted about the nodes.
enum class FitDegree : std::uint8_t {
  cubic,   ///< error O(h^4)
  quartic  ///< error O(h^5) on smooth data; not better than cubic on rough data
};

struct C1Options : SurfaceOptions {
  FitDegree degree = FitDegree::cubic;
  Bounds bounds = Bounds::widened;
  /// 0 (smooth) .. 1 (next to linear), of the whole surface. Empty: chosen by
  /// leave-one-out errors. Must lie in 0 .. 1.
  std::optional<double> tension;
};

/// How a surface was fitted.
struct C1Fit {
  double tension = 0;           ///< given or chosen
  std::int64_t num_tested = 0;  ///< nodes that were left out to choose it; 0: none
  /// Root mean square errors at these nodes: of this surface, and of the linear one.
  double left_out_rms = 0, linear_left_out_rms = 0;
};

/// Throws Error if the tension is outside 0 .. 1 or NaN, and as check(SurfaceOptions).
void check(const C1Options& options);

}  // namespace delone::interp
