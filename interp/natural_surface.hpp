#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/natural_weights.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// Which natural-neighbour surface.
enum class NaturalKind : std::uint8_t {
  sibson,    ///< weights are the areas that a new cell takes from the old ones
  laplace,   ///< weights are lengths of the new cell's edges over distances
  sibson_c1  ///< Farin's cubic over Sibson's weights: gradients are continuous too
};

/// What keeps the fitted gradients of sibson_c1 from growing steep.
enum class SlopeLimit : std::uint8_t {
  /// The values around the node: no steeper than four times the steepest way to a
  /// neighbour. Gradients are as good as the fit wherever the values allow it.
  values,
  /// The places of the neighbours alone: where they could make the gradient four times as
  /// steep as that for some values, it is shortened for all. The surface is linear in the
  /// data
  /// (natural_operator); linear functions are not reproduced beside nodes
  /// whose neighbours are badly placed.
  positions
};

struct NaturalOptions {
  NaturalKind kind = NaturalKind::sibson;
  SlopeLimit slope_limit = SlopeLimit::values;
  // As in SurfaceOptions.
  Duplicates duplicates = Duplicates::mean;
  Outside outside = Outside::missing;
  double max_distance = std::numeric_limits<double>::infinity();
  GlobeDistance distance = GlobeDistance::great_circle;

  [[nodiscard]] SurfaceOptions surface() const noexcept {
    return {duplicates, outside, max_distance, distance};
  }
};

/// Throws Error as check(SurfaceOptions), and for Outside::linear.
void check_natural(const NaturalOptions& options);

class PlaneView;
class SphereView;
template <class View>
class NaturalCells;

/// Natural-neighbour interpolant in the plane.
///
/// A new site at the query would take pieces from the Voronoi cells of some sites, its
/// natural neighbours. Their values are averaged with weights that are not negative and
/// sum to one: the areas of the pieces (sibson), or the length of the edge between the
/// new cell and the neighbour's over the distance to it (laplace). Both reproduce linear
/// functions to rounding, constants exactly, and stay within the range of the neighbours'
/// values. `sibson` has continuous gradients except at the nodes; `laplace` is
/// continuous, its gradients jump across circumcircles. `sibson_c1` joins values and
/// gradients at the nodes with a cubic Bezier simplex over Sibson's weights: its gradient
/// is continuous everywhere inside the hull, and it is exact for quadratics whose
/// gradients are given.
///
/// At a node the value of the node, bit for bit. Towards a hull edge all kinds tend to
/// what they are there: linear between its ends (sibson_c1: cubic). Finite on the closed
/// hull. Outside it missing or the nearest observation's value; Outside::linear is
/// refused with Error. Fewer than three points, and points on a line: as PlaneLinear. A
/// value depends on the point and the data only: value, values and grid give the same
/// bits, for every order of rows and queries.
///
/// Gradients are exact derivatives of the surface. sibson and laplace have none at nodes,
/// and where the point is on a hull edge there is none beyond it: there, as outside, it
/// is that of PlaneLinear (sibson_c1 at a node: the node's). At the distance e from a
/// node of cells of size h, e far below h, they are good to 1e-16 h / e of themselves.
///
/// Accuracy: weights to some 1e-13; where triangles are flatter than one part in a
/// thousand they are found in double-double arithmetic, at some ten times the cost. Cost:
/// O(k) for k natural neighbours, usually 6; no memory is allocated for up to 24.
///
/// Error for twice differentiable functions: O(h^2); sibson_c1 with given gradients
/// O(h^3).
///
/// Shares the triangulation, copies the values; thread-safe for reading. Throws Error for
/// what values_at_sites refuses and for a negative or NaN max_distance.
///
/// Sources: R. Sibson, in: Interpreting Multivariate Data (1981) 21-36; V. V. Belikov et
/// al., Comput. Math. Math. Phys. 37 (1997) 9-15; G. Farin, Comput. Aided Geom. Des. 7
/// (1990) 281-292.
class PlaneNatural {
 public:
  PlaneNatural(std::shared_ptr<const tripack::Triangulation> triangulation,
               std::span<const double> row_values, const NaturalOptions& options = {});
  /// With the gradients at the nodes, one a row (of repeated rows the first one counts),
  /// for sibson_c1. Without, they are fitted to the values of the natural neighbours of
  /// each node by least squares, weighted with the areas that its removal would give them
  /// over the squared distance (Sibson 1981), and never steeper than four times the
  /// steepest way to a neighbour. Throws Error besides unless there is one finite
  /// gradient a row.
  PlaneNatural(std::shared_ptr<const tripack::Triangulation> triangulation,
               std::span<const double> row_values,
               std::span<const Gradient2> row_gradients,
               const NaturalOptions& options = {});

  /// NaN: missing. O(sqrt n); for many points use values().
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  /// In the order of `points`, which may be any.
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;
  /// The sites and weights whose sum the value is, to rounding; for sibson_c1, which is
  /// not such a sum, Sibson's. No weights: missing.
  [[nodiscard]] NaturalWeights weights(tripack::Point2 p) const;
  [[nodiscard]] std::vector<NaturalWeights> weights(
      std::span<const tripack::Point2> points, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const NaturalCells<PlaneView>> cells_;
};

/// The same on the sphere, with true spherical cells: areas of pieces of the sphere,
/// lengths of arcs of great circles.
///
/// Everything said of PlaneNatural holds with these differences. Weights sum to one, but
/// functions that are linear in space are not reproduced exactly: the error is O(h^2).
/// The cell of a point on the edge of a hemispherical set still reaches beyond it, so on
/// the edge other sites than its two ends have some weight. `sibson_c1` takes Sibson's
/// weights of the sites' stereographic images in the tangent plane at the query, which
/// have the same natural neighbours and reproduce linear functions of that plane; without
/// this it would not have the given gradients at the nodes. On a boundary edge it is the
/// cubic between its ends.
///
/// Weights to some 1e-13 with the usual triangles, however small; slivers of the flatness
/// f cost 1e-16 / f.
class SphereNatural {
 public:
  SphereNatural(std::shared_ptr<const stripack::Triangulation> triangulation,
                std::span<const double> row_values, const NaturalOptions& options = {});
  /// Gradients towards east and north per radian.
  SphereNatural(std::shared_ptr<const stripack::Triangulation> triangulation,
                std::span<const double> row_values,
                std::span<const GradientSphere> row_gradients,
                const NaturalOptions& options = {});

  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;
  [[nodiscard]] NaturalWeights weights(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<NaturalWeights> weights(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const NaturalCells<SphereView>> cells_;
};

}  // namespace delone::interp
