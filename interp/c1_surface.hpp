#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/c1_options.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/region_integral.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

class PlaneBlend;
class SphereBlend;

/// Value and derivatives in the plane.
struct Derivatives2 {
  double value = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  [[nodiscard]] double laplacian() const noexcept { return xx + yy; }
};

/// Value and derivatives on the unit sphere towards east and north: by radians, second
/// ones along geodesics (the covariant second derivative). At a pole east is the
/// direction of 90 degrees east.
struct DerivativesSphere {
  double value = 0, east = 0, north = 0;
  double east_east = 0, east_north = 0, north_north = 0;
  /// Of the sphere.
  [[nodiscard]] double laplacian() const noexcept { return east_east + north_north; }
};

/// Smooth interpolant in the plane: continuous with its gradient everywhere in the hull.
///
/// About every node a polynomial of degree 3 (or 4) is fitted to the values around it.
/// Along an edge the polynomials of its ends are blended by a smooth step, in a triangle
/// its edges by smooth weights: the surface is, up to a small term that makes it a
/// Hermite cubic along edges, a mean of polynomials with weights that are never negative,
/// however thin the triangle. So it reproduces quadratic functions on sets where they are
/// determined, its error is O(h^4) on smooth data, and it never leaves what the
/// polynomials are kept in: the range of all data widened by a quarter
/// (`C1Options::bounds`: or, strictly, the values around each triangle).
///
/// Made for real data. A polynomial's degree is chosen, node by node, by how well
/// neighbours are predicted that it is not shown; where nothing is predicted (tracks,
/// clusters, noise) it falls back towards the node's value, and the surface towards the
/// linear interpolant by a tension inside triangles. Where fits of single nodes do not
/// see what the data as a whole tell (few nodes for much detail), the gradients of least
/// curvature of all nodes together take their place. Which of both, and the tension of
/// the whole surface, is chosen by leaving out nodes one by one (`fit()` tells).
///
/// As PlaneLinear at nodes (bit for bit), for constants, collinear points, repeats,
/// missing queries and threads: a value depends on the point and the data only. Not
/// linear in the data, because it adapts to them. Outside the hull missing or nearest;
/// Outside::linear means the surface's own continuation: the blend of the nearest hull
/// edge, at a corner its polynomial, continuously differentiable across the hull and
/// everywhere beyond, and levelling off within the same bounds.
///
/// Cost of construction: some 4 microseconds a node; memory 220 bytes a node. Throws
/// Error as PlaneLinear, and for a tension outside 0 .. 1.
class PlaneC1 {
 public:
  PlaneC1(std::shared_ptr<const tripack::Triangulation> triangulation,
          std::span<const double> row_values, const C1Options& options = {},
          const RunOptions& run = {});
  /// With gradients, one a row, that the surface has at the nodes; NaN: not known, there
  /// the polynomial is fitted to the values alone. Rows that share a position: their
  /// mean. The bounds hold all the same. Throws Error, besides, for another number of
  /// gradients than of points and for infinite ones (naming the row).
  PlaneC1(std::shared_ptr<const tripack::Triangulation> triangulation,
          std::span<const double> row_values, std::span<const Gradient2> row_gradients,
          const C1Options& options = {}, const RunOptions& run = {});

  [[nodiscard]] const C1Fit& fit() const noexcept;
  /// NaN: missing.
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  /// Of the surface itself, exact. Second derivatives jump across edges.
  [[nodiscard]] Derivatives2 derivatives(tripack::Point2 p) const;
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Derivatives2> derivatives(
      std::span<const tripack::Point2> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;
  /// Over the hull, as value times area; 0 without triangles. Knows no max_distance.
  /// By a rule of 36 places a triangle that is exact for polynomials of degree 10.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;
  /// Of the part of a region that is triangulated; see region_integral.hpp.
  [[nodiscard]] RegionIntegral integral(const PlaneRegion& region,
                                        const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const PlaneBlend> blend_;
};

/// The same on the sphere. Constants and first-degree harmonics are reproduced (to
/// rounding, where the values around a node determine its polynomial). Coordinates about
/// a node are orthographic; nothing depends on where the poles are.
///
/// Outside::linear, for sites in a hemisphere: with c the cosine of the distance to the
/// nearest place of the rim (the hull's boundary), c^2 (3 - 2 c) of what continues that
/// place as in the plane, and the rest of one value, the mean along the rim by length. So
/// the continuation is continuously differentiable across the hull and all round the
/// globe, is that one value 90 degrees away and beyond, and stays within the same bounds.
/// Sites on one great circle: the value of the nearest place of the chain in the place of
/// its continuation; one position: its value everywhere. Cost: O(sqrt h) for each point
/// outside, h edges of the rim.
class SphereC1 {
 public:
  SphereC1(std::shared_ptr<const stripack::Triangulation> triangulation,
           std::span<const double> row_values, const C1Options& options = {},
           const RunOptions& run = {});
  /// With gradients, one a row, by radians.
  SphereC1(std::shared_ptr<const stripack::Triangulation> triangulation,
           std::span<const double> row_values,
           std::span<const GradientSphere> row_gradients, const C1Options& options = {},
           const RunOptions& run = {});

  [[nodiscard]] const C1Fit& fit() const noexcept;
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
  /// Over the triangulated region, as value times steradians; 0 without triangles. Knows
  /// no max_distance.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;
  /// Of the part of a region that is triangulated; see region_integral.hpp.
  [[nodiscard]] RegionIntegral integral(const SphereRegion& region,
                                        AreaUnit unit = AreaUnit::steradian,
                                        const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const SphereBlend> blend_;
};

}  // namespace delone::interp
