#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// A function of the distance r that splines are sums of.
enum class RadialKernel : std::uint8_t {
  thin_plate,  ///< r^2 log r: least bending energy; C1, smooth off the nodes
  cubic,       ///< r^3: C2
  quintic      ///< -r^5: C4; more accurate on smooth data, more easily ill-conditioned
};

struct RadialOptions {
  RadialKernel kernel = RadialKernel::thin_plate;
  /// Degree of the polynomial that is added; -1: the least that the kernel allows, 1 for
  /// thin_plate and cubic, 2 for quintic. At most 2.
  int degree = -1;
  /// 0: through the values. Above: the sum of squared misfits may be traded against
  /// roughness; the number on the diagonal of the system, as in SciPy's RBFInterpolator,
  /// in units of the kernel (lengths squared, cubed, to the fifth; on the sphere chords).
  double smoothing = 0;
  /// Sets of at most this many nodes (12 to 4096) are one spline; larger ones are local
  /// splines.
  std::int32_t most_at_once = 512;
  /// Nodes of a local spline, 12 to 512.
  std::int32_t neighbors = 50;
};

/// Radial basis functions (polyharmonic, thin-plate splines) in the plane.
///
/// Up to `most_at_once` nodes: the spline through all of them. More: local splines
/// through `neighbors` nodes each, centred so that every node lies in the inner 0.6 of
/// the disc of one; between them their mean, with Wendland's C2 weight (1 - d)^4 (4 d +
/// 1) of the distance in radii. A partition of unity: as smooth as the kernel where it is
/// less than C2, else C2, which the k nearest of every query are not. Where discs do not
/// reach, in the gaps of clustered nodes, the same surface over every eighth node along
/// the triangulation's curve takes over, blended C2.
///
/// Values at nodes bit for bit unless `smoothing` is set; constants exactly; polynomials
/// of the degree to rounding, where the nodes of a local spline determine them: a
/// direction in which they extend less than about a hundredth of the others is held
/// back, so that slopes across a track are not made up.
///
/// A system that is not positive definite or well conditioned in doubles, or whose spline
/// leaves the range of its values by more than half of it midway between nodes, is
/// solved again with a number on its diagonal, from 1e-12 of the kernel's size upwards;
/// what is then missing at the nodes is put back by bumps no wider than half the distance
/// to the next node. So near-duplicates with different values make a small spike, not a
/// large wave.
///
/// Gradients are the exact ones of the surface (thin_plate: finite at nodes). Outside the
/// convex hull as `SurfaceOptions::outside` says; Outside::linear means the surface's own
/// continuation. Degenerate and repeated positions, queries that are NaN, threads and
/// errors as PlaneLinear; Error besides for options out of range.
///
/// Cost of local splines: 10 microseconds a node to fit, 2 to 4 a query; of one spline
/// n^3 / 3 operations and 8 n^2 bytes, then n kernels a query. Sources: J. Duchon, Lect.
/// Notes Math. 571 (1977) 85-100; H. Wendland, Scattered Data Approximation (2005),
/// chapter 15 (partition of unity).
class PlaneRadial {
 public:
  PlaneRadial(std::shared_ptr<const tripack::Triangulation> triangulation,
              std::span<const double> row_values, const RadialOptions& radial = {},
              const SurfaceOptions& options = {}, const RunOptions& run = {});
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// The same on the sphere: kernels of chords in space, with polynomials of x, y and z, so
/// that one spline reproduces harmonics of first degree too. Outside::linear is refused
/// with Error.
class SphereRadial {
 public:
  SphereRadial(std::shared_ptr<const stripack::Triangulation> triangulation,
               std::span<const double> row_values, const RadialOptions& radial = {},
               const SurfaceOptions& options = {}, const RunOptions& run = {});
  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace delone::interp
