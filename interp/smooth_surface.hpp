#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/c1_surface.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/smooth_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// Smoothing surface in the plane: near the data, not through them.
///
/// Values and gradients at all nodes are those that make roughness times a parameter plus
/// the weighted sum of squared misfits least; roughness stands for the integral of fxx^2
/// + 2 fxy^2 + fyy^2 (smooth_system.hpp), so this is a thin plate on the triangulation.
/// Between nodes the surface is PlaneC1's with these values and gradients. The parameter
/// is chosen by generalised cross-validation, from the errors of the data, or given as
/// the length of waves of which half is left (SmoothOptions); `fit()` tells what came of
/// it. A length means the same for few data and for many, sure and unsure ones.
///
/// A position that repeats has its rows' weighted mean as value and their weights
/// together (Duplicates::mean), otherwise the value that SmoothOptions::duplicates takes.
/// Linear in the values once the parameter is fixed (between nodes: with fixed choices).
/// Constants are reproduced exactly, linear functions to rounding, whatever the
/// parameter. Coordinates moved or multiplied, values multiplied: the same surface. It
/// depends neither on the order of rows nor on threads.
///
/// Collinear points: the smoothing spline along the chain at its nodes, linear between.
/// Fewer than three positions, and three that are not collinear: through the data.
/// Outside the hull, missing queries, the rest: as PlaneC1.
///
/// Cost: a sparse Cholesky factor a parameter that is tried, about 300 n^1.5
/// multiplications and 500 bytes times log2 n a node; one for a given length, about 7 for
/// a choice (17 up to 4096 nodes, above that mostly of a subset). 100,000 nodes: 4
/// seconds, and 14; on the sphere twice as long. Throws Error as PlaneLinear and
/// check(SmoothOptions). Sources: R. J. Renka, ACM Trans. Math. Softw. 22 (1996) 1-8
/// (there SMSURF); G. Wahba, Spline Models for Observational Data (1990).
class PlaneSmooth {
 public:
  PlaneSmooth(std::shared_ptr<const tripack::Triangulation> triangulation,
              std::span<const double> row_values, const SmoothOptions& options = {},
              const RunOptions& run = {});

  [[nodiscard]] const SmoothFit& fit() const noexcept;
  /// The surface at the data, one a row.
  [[nodiscard]] const std::vector<double>& smoothed_values() const noexcept;
  /// NaN: missing.
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  [[nodiscard]] Derivatives2 derivatives(tripack::Point2 p) const;
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Derivatives2> derivatives(
      std::span<const tripack::Point2> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// The same on the sphere, with lengths in radians: an integral over the sphere of the
/// squared second derivatives along geodesics. Constants are reproduced exactly,
/// first-degree harmonics at the nodes to rounding, whatever the parameter: both cost
/// nothing. Nothing depends on where the poles are.
class SphereSmooth {
 public:
  SphereSmooth(std::shared_ptr<const stripack::Triangulation> triangulation,
               std::span<const double> row_values, const SmoothOptions& options = {},
               const RunOptions& run = {});

  [[nodiscard]] const SmoothFit& fit() const noexcept;
  [[nodiscard]] const std::vector<double>& smoothed_values() const noexcept;
  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] DerivativesSphere derivatives(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<DerivativesSphere> derivatives(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace delone::interp
