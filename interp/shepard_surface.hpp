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

/// Degree of the nodal functions of the modified Shepard methods.
enum class ShepardDegree : std::uint8_t { quadratic = 2, cubic = 3 };

/// How many nodes the modified Shepard methods look at. 0: the number for the degree,
/// which is that of the papers: 13 and 19 for quadratic, 17 and 30 for cubic. Else 8 to
/// 1000.
struct ShepardOptions {
  ShepardDegree degree = ShepardDegree::cubic;
  std::int32_t fitted_neighbors = 0;    ///< nodes a nodal function is fitted to
  std::int32_t weighted_neighbors = 0;  ///< nodes within the disc of a node
};

/// Modified Shepard interpolation in the plane: at every node a polynomial of degree two
/// or three through its value, fitted to the nodes around by weighted least squares;
/// between the nodes a mean of these polynomials.
///
/// The polynomial of node k has the weight ((R_k - d) / (R_k d))^3 within distance R_k of
/// it and none beyond; R_k is the distance of the first node beyond `weighted_neighbors`
/// others. The third power makes the surface twice continuously differentiable for both
/// degrees (Renka's quadratic method has the second power and is C1).
///
/// Polynomials of the degree are reproduced (to rounding) where nodes determine them,
/// constants exactly; values at nodes bit for bit. Error for smooth functions O(h^3) and
/// O(h^4). What the nodes near a node do not determine, such as slopes across a line of
/// nodes, is damped (nodal_fit.hpp), so that tracks and clusters do not explode.
///
/// Where discs do not reach, in the gaps of clustered nodes, the same surface over every
/// eighth node along the triangulation's curve takes over, and over every eighth of those
/// where that does not reach, at last the mean of their values with the same weights, so
/// that the surface is C2 everywhere. A disc is no wider than ten times the weighted mean
/// distance of what its polynomial was fitted to.
///
/// Gradients are the exact ones of the surface. Outside the convex hull as
/// `SurfaceOptions::outside` says; Outside::linear means the surface's own continuation,
/// which is C2 across the hull but not linear and grows with the third power of the
/// distance. Up to `weighted_neighbors` nodes, or all on a line: the same formulas (on
/// the line, elsewhere as outside). Repeated positions, queries that are NaN, threads
/// and errors as PlaneLinear; Error besides for numbers of neighbours out of range.
///
/// Cost: 15 microseconds a node to fit, 1 microsecond a query. Sources: R. J. Renka, ACM
/// Trans. Math. Softw. 14 (1988) 139-148 (quadratic) and 25 (1999) 70-73 (cubic).
class PlaneShepard {
 public:
  PlaneShepard(std::shared_ptr<const tripack::Triangulation> triangulation,
               std::span<const double> row_values, const ShepardOptions& shepard = {},
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

/// The same on the sphere. Distances are chords; nodal functions are polynomials of the
/// coordinates of Lambert's equal-area projection about their node. Smooth functions are
/// met with the same order; constants exactly, other harmonics not. Outside::linear is
/// refused with Error.
class SphereShepard {
 public:
  SphereShepard(std::shared_ptr<const stripack::Triangulation> triangulation,
                std::span<const double> row_values, const ShepardOptions& shepard = {},
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
