#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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

/// Where the gradients at the nodes come from.
enum class Gradients : std::uint8_t {
  automatic,  ///< local or global: whichever predicts nodes that are left out better
  local,      ///< polynomials fitted to the values around each node
  global,     ///< those of least curvature of all curves over the edges together, from
              ///< which the polynomials of the nodes go on
  given       ///< by the caller; no option
};

struct C1Choices;

struct C1Options : SurfaceOptions {
  FitDegree degree = FitDegree::cubic;
  Bounds bounds = Bounds::widened;
  /// 0 (smooth) .. 1 (next to linear), of the whole surface. Empty: chosen by
  /// leave-one-out errors. Must lie in 0 .. 1.
  std::optional<double> tension;
  /// Of a set that is dense for what it shows local ones are the better by an order, of
  /// one that leaves gaps in it global ones.
  Gradients gradients = Gradients::automatic;
  /// Fixed beforehand (c1_choices.hpp) what the surface otherwise chooses by its values:
  /// it is then linear in them, and kept in no bounds. Of the same degree, without
  /// tension and local bounds besides. Empty: chosen.
  std::shared_ptr<const C1Choices> choices;
};

/// How a surface was fitted.
struct C1Fit {
  double tension = 0;                      ///< given or chosen
  Gradients gradients = Gradients::local;  ///< not automatic
  std::int64_t num_tested = 0;             ///< nodes left out to choose; 0: none
  /// Root mean square errors at these nodes: of this surface, and of the linear one.
  double left_out_rms = 0, linear_left_out_rms = 0;
};

/// Throws Error if the tension is outside 0 .. 1 or NaN, and as check(SurfaceOptions).
void check(const C1Options& options);

}  // namespace delone::interp
