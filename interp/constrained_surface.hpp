#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/c1_surface.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::interp {

class PlaneBarrierCells;
class SphereBarrierCells;

/// What lies between the points of a constrained surface.
enum class ConstrainedKind : std::uint8_t {
  linear,  ///< as PlaneLinear
  c1       ///< as PlaneC1
};

/// `outside` must be missing; `max_distance` is meant in a straight line, whatever lies
/// between.
struct ConstrainedOptions : SurfaceOptions {
  ConstrainedKind kind = ConstrainedKind::linear;
  /// Of the values that the vertices of curves get (barrier_values.hpp), and of what
  /// C1Options says.
  Bounds bounds = Bounds::widened;
  // For c1, as in C1Options.
  FitDegree degree = FitDegree::cubic;
  std::optional<double> tension;
};
/// Throws Error as check(SurfaceOptions), for a tension outside 0 .. 1 or NaN, and for
/// another outside than missing.
void check(const ConstrainedOptions& options);

/// Interpolant in the plane that does not reach across curves: coasts, faults, the
/// outline of a domain, ridges.
///
/// Over a constrained Delaunay triangulation. Values are one a row of its input; NaN
/// means a vertex without. Where a curve's vertex has a value, both sides share it: a
/// ridge, across which the surface is continuous and bends. Where it has none, each side
/// has a value of its own, estimated from the data of that side (barrier_values.hpp):
/// a fault, across which the surface jumps. So a value depends on nothing that cannot be
/// reached from it without crossing a curve: changing data beyond a curve that divides
/// the domain changes no bit. Round the open end of a curve its sides are joined.
///
/// Missing outside the domain, and in parts of it without any data; with Domain::hull
/// the domain is the whole hull. Points exactly on a curve count to the side of the
/// triangle with the smallest sites. At a node with data its value, bit for bit; finite
/// elsewhere in the domain; constants exactly, linear functions to rounding as far as the
/// data determine them. A value depends on the point and the data only, not on the order
/// of rows, segments or queries or the number of threads. Collinear points enclose no
/// domain: missing everywhere.
///
/// Kind c1: about every node, on a curve about every side of it, a polynomial is fitted
/// to the nodes that it sees: the straight line to them crosses no curve. Continuous with
/// its gradient within each side, apart from the vertices of curves; where both ends of a
/// piece of a curve have values the surface is continuous across it, with a gradient on
/// either side. The tension is chosen for every connected part of the domain by itself.
///
/// Shares the triangulation, copies the values; thread-safe for reading. Throws Error for
/// what values_at_sites refuses (NaN apart), options out of range, and an `outside` other
/// than missing.
class PlaneConstrained {
 public:
  PlaneConstrained(std::shared_ptr<const tripack::ConstrainedTriangulation> triangulation,
                   std::span<const double> row_values,
                   const ConstrainedOptions& options = {}, const RunOptions& run = {});

  /// NaN: missing. O(sqrt n); for many points use values().
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  /// Of the linear surface the second derivatives are 0.
  [[nodiscard]] Derivatives2 derivatives(tripack::Point2 p) const;
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  /// Triangle by triangle along rows. Throws Error as check(Grid) does.
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const PlaneBarrierCells> cells_;
};

/// The same on the sphere.
class SphereConstrained {
 public:
  SphereConstrained(
      std::shared_ptr<const stripack::ConstrainedTriangulation> triangulation,
      std::span<const double> row_values, const ConstrainedOptions& options = {},
      const RunOptions& run = {});

  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] DerivativesSphere derivatives(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  /// x is longitude in any wrap, y latitude, degrees. Throws Error as check(Grid) does
  /// and for latitudes outside -90..90.
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const SphereBarrierCells> cells_;
};

}  // namespace delone::interp
