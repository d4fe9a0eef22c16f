#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/arc_tension.hpp"
#include "interp/arc_tension_options.hpp"
#include "interp/c1_surface.hpp"
#include "interp/grid.hpp"

namespace delone::interp {

struct PlaneSpace;
struct SphereSpace;
template <class Space>
class ArcTensionSurface;

/// C1 interpolant of Hermite tension splines over the arcs of the triangulation, whose
/// shape along every arc can be asked for.
///
/// Along an arc the surface is the Hermite tension spline of the values and gradients of
/// its ends, with the arc's own tension factor: a cubic with factor 0, next to straight
/// with large ones. Factors are given, or the least ones with which every arc is monotone
/// or convex where its ends are, or stays in a range (`ArcDemand`). Inside triangles it
/// is Nielson's side-vertex blend of such splines (ArcTensionFacet). Gradients at the
/// nodes are those of PlaneC1 with `options.c1`, or given.
///
/// What is guaranteed along all arcs, to rounding: with ArcShape::monotone the surface
/// rises or falls all along each arc whose end slopes do as the values do, with
/// ArcShape::convex it bends one way only besides where the mean slope lies strictly
/// between the slopes; except arcs that would take more than tension_factor_max (`fit()`
/// counts them). With a range it stays in the range on all arcs, without exception:
/// gradients that no factor tames are shortened. Nothing is guaranteed inside triangles.
/// For that take PlaneC1 with Bounds::local, which knows no shape but never leaves the
/// values around a triangle. Steep gradients at nodes make long arcs overshoot; a range
/// keeps them down. (The program takes the data's range widened by a quarter.)
///
/// Value and gradient are continuous in the whole hull. At nodes the value bit for bit
/// and the gradient given; constants and, without tension or with, first-degree functions
/// are reproduced; quadratic ones without tension. Error on smooth data O(h^3), with
/// tension O(h^2): PlaneC1 has O(h^4). Gradients and second derivatives are exact ones of
/// the surface; second derivatives jump across edges; at a node, where they depend on the
/// direction, they are those towards the middle of the triangle with the smallest site
/// numbers (2^-20 of the way). A value depends on the point and the data only, as for
/// PlaneLinear; so do collinear points, single ones, repeats and missing queries.
///
/// Outside the hull missing or nearest. Outside::linear continues along the normals of
/// hull edges with the normal derivative, at corners with the node's plane, continuously
/// differentiable across the hull and everywhere beyond; not bounded.
///
/// Cost: PlaneC1's construction and 0.1 to 5 microseconds an arc; some 0.5 microseconds a
/// value. Memory 120 bytes a node. Throws Error as PlaneC1; for values outside the range
/// (naming the row); for factors that are not in 0 .. tension_factor_max or not one an
/// arc.
///
/// Sources: G. M. Nielson, J. Approx. Theory 25 (1979) 318-336; R. J. Renka, SIAM J. Sci.
/// Stat. Comput. 8 (1987) 393-415.
class PlaneTensionSpline {
 public:
  PlaneTensionSpline(std::shared_ptr<const tripack::Triangulation> triangulation,
                     std::span<const double> row_values,
                     const TensionSplineOptions& options = {},
                     const RunOptions& run = {});
  /// With gradients, one a row, that the surface has at the nodes; NaN: not known, there
  /// PlaneC1's. Repeated rows: the mean.
  PlaneTensionSpline(std::shared_ptr<const tripack::Triangulation> triangulation,
                     std::span<const double> row_values,
                     std::span<const Gradient2> row_gradients,
                     const TensionSplineOptions& options = {},
                     const RunOptions& run = {});

  [[nodiscard]] const TensionSplineFit& fit() const noexcept;
  /// The factors taken, in the order of tension_arcs(). None without triangles.
  [[nodiscard]] std::vector<double> tension_factors() const;
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
  /// Over the hull, as value times area, by a rule of 36 places a triangle; 0 without
  /// triangles. Knows no max_distance.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const ArcTensionSurface<PlaneSpace>> surface_;
};

/// The same on the sphere. Arcs and rays are great circles, splines run in the angle
/// along them, gradients are by radians.
///
/// Everything said of PlaneTensionSpline holds with these differences: constants are
/// reproduced, first-degree harmonics are not (SphereC1 does); there is no
/// Outside::linear (Error).
class SphereTensionSpline {
 public:
  SphereTensionSpline(std::shared_ptr<const stripack::Triangulation> triangulation,
                      std::span<const double> row_values,
                      const TensionSplineOptions& options = {},
                      const RunOptions& run = {});
  SphereTensionSpline(std::shared_ptr<const stripack::Triangulation> triangulation,
                      std::span<const double> row_values,
                      std::span<const GradientSphere> row_gradients,
                      const TensionSplineOptions& options = {},
                      const RunOptions& run = {});

  [[nodiscard]] const TensionSplineFit& fit() const noexcept;
  [[nodiscard]] std::vector<double> tension_factors() const;
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
  /// Over the triangulated region, as value times steradians.
  [[nodiscard]] double integral(const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const ArcTensionSurface<SphereSpace>> surface_;
};

}  // namespace delone::interp
