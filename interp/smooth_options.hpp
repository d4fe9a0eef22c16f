#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "interp/surface_options.hpp"

namespace delone::interp {

struct C1Choices;

/// What decides how smooth a surface is.
enum class SmoothBy : std::uint8_t {
  cross_validation,  ///< generalised: what would predict left-out data best
  errors,            ///< misfits as large as the given errors
  wavelength         ///< a given length
};

struct SmoothOptions : SurfaceOptions {
  SmoothBy by = SmoothBy::cross_validation;
  /// For SmoothBy::wavelength: waves of this length keep half of their height, shorter
  /// ones little, longer ones nearly all (1 / (1 + (wavelength / length)^4)). In the
  /// units of the coordinates, on the sphere radians. 0: interpolates; infinite: the
  /// plane (on the sphere the first-degree harmonic and constant) of least squares.
  double wavelength = 0;
  /// Standard deviations of the values, one a row: their inverse squares are the weights
  /// of the misfits. Empty: all alike. Seen during construction only.
  std::span<const double> errors;
  /// Fixed beforehand (c1_choices.hpp, for Gradients::given) how the surface goes on
  /// between the smoothed values and gradients of the nodes: with a given wavelength it
  /// is then linear in the data everywhere. Empty: chosen, as by PlaneC1.
  std::shared_ptr<const C1Choices> choices;
};

/// How a surface was smoothed. Misfits are data less surface, weights have a mean of one.
struct SmoothFit {
  /// As in SmoothOptions: given or chosen; infinite for the plane of least squares.
  double wavelength = 0;
  /// The factor of the integral of fxx^2 + 2 fxy^2 + fyy^2 against the sum of squared
  /// misfits (over squared errors, where there are errors), in the units of the data.
  double parameter = 0;
  /// Numbers that the surface has drawn from the data: the trace of the linear map from
  /// values to smoothed values. From 3 (on the sphere 4) to the number of positions.
  double degrees_of_freedom = 0;
  double rms_misfit = 0;  ///< weighted
  /// Root mean square of misfits over errors; 0 without errors.
  double rms_misfit_over_errors = 0;
  /// Root of the generalised cross-validation score: the error at which a left-out datum
  /// of mean weight would be predicted, its own error included.
  double predicted_rms = 0;
  /// Estimated standard deviation of a datum of mean weight.
  double noise = 0;
};

/// Throws Error, naming the row at fault, for errors that are not as many as
/// `num_rows`, not positive or not finite, for SmoothBy::errors without errors, for a
/// wavelength that is negative or NaN, and as check(SurfaceOptions).
void check(const SmoothOptions& options, std::size_t num_rows);

}  // namespace delone::interp
