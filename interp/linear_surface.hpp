#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/grid.hpp"
#include "interp/operator.hpp"
#include "interp/region_integral.hpp"
#include "interp/surface_options.hpp"
#include "interp/values.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

class PlaneCells;
class SphereCells;

/// Derivatives by x and y.
struct Gradient2 {
  double x = 0, y = 0;
  friend bool operator==(const Gradient2&, const Gradient2&) = default;
};

/// Derivatives towards east and north in units of the value per radian on the unit
/// sphere. At a pole east is the direction of 90 degrees east.
struct GradientSphere {
  double east = 0, north = 0;
  friend bool operator==(const GradientSphere&, const GradientSphere&) = default;
};

/// Piecewise linear interpolant in the plane.
///
/// At a node the value of the node, bit for bit; finite on the closed convex hull; within
/// the range of the corner values in every triangle; constants reproduced exactly, linear
/// functions to rounding. A value depends on the point and the data only: not on the
/// order of rows or queries, the number of threads, or the way it was asked for: value,
/// values and grid give the same bits. Error for twice differentiable functions: O(h^2).
///
/// Outside the hull as `SurfaceOptions::outside` says: NaN, the nearest observation's
/// value (of several the one first along the triangulation's curve), or linear: the
/// planes of the triangles at the hull continued along its normals, in the wedges at its
/// corners by the sum of the two normal derivatives; continuous, and exact for linear
/// functions.
///
/// Collinear points: linear along the chain, for points exactly on it; others count as
/// outside. One position: its value, there. No points: missing everywhere. Queries that
/// are NaN or infinite: missing.
///
/// Gradients are constant in each triangle; on an edge or at a node that of the adjoining
/// triangle with the smallest site numbers; outside 0 (nearest) or that of the
/// continuation.
///
/// Shares the triangulation, copies the values; thread-safe for reading. Throws Error for
/// what values_at_sites refuses and for a negative or NaN max_distance.
class PlaneLinear {
 public:
  PlaneLinear(std::shared_ptr<const tripack::Triangulation> triangulation,
              std::span<const double> row_values, const SurfaceOptions& options = {});

  /// NaN: missing. O(sqrt n); for many points use values().
  [[nodiscard]] double value(tripack::Point2 p) const;
  /// NaN, NaN: missing.
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  /// In the order of `points`, which may be any: they are visited along a space-filling
  /// curve.
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  /// Triangle by triangle along rows, without searching. Throws Error as check(Grid)
  /// does.
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;
  /// Over the hull, as value times area; 0 without triangles. Knows no max_distance.
  /// By a rule of 36 places a triangle that is exact for polynomials of degree 10.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;
  /// Of the part of a region that is triangulated; see region_integral.hpp.
  [[nodiscard]] RegionIntegral integral(const PlaneRegion& region,
                                        const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const PlaneCells> cells_;
};

/// Piecewise linear interpolant on the sphere: linear on the flat triangle through three
/// directions, taken where the ray through the query meets it.
///
/// Everything said of PlaneLinear holds, with these differences. Points whose
/// triangulation covers the sphere have no outside. Outside::linear is refused with
/// Error. Points on one great circle: linear along the chords of its arcs. Source of the
/// method: R. J. Renka, ACM Trans. Math. Softw. 23 (1997) 435-442 (there called INTRC0).
class SphereLinear {
 public:
  SphereLinear(std::shared_ptr<const stripack::Triangulation> triangulation,
               std::span<const double> row_values, const SurfaceOptions& options = {});

  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  /// x is longitude in any wrap, y latitude, degrees. A row at a pole has one value.
  /// Throws Error as check(Grid) does and for latitudes outside -90..90.
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;
  /// Over the triangulated region, as value times steradians; 0 without triangles. Knows
  /// no max_distance.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;
  /// Of the part of a region that is triangulated; see region_integral.hpp.
  [[nodiscard]] RegionIntegral integral(const SphereRegion& region,
                                        AreaUnit unit = AreaUnit::steradian,
                                        const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const SphereCells> cells_;
};

}  // namespace delone::interp
