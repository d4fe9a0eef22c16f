#pragma once

#include <cstdint>
#include <limits>
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

/// How inverse distances are weighted.
struct InverseDistanceOptions {
  /// Weights are the inverse distance to this power. Above 0, at most 64.
  double power = 2;
  /// The number of nearest nodes that have a say; at least 1.
  std::int32_t neighbors = 12;
  /// If finite, all nodes nearer than this have a say, however many: data units in the
  /// plane, kilometres along great circles on the globe. Above 0.
  double radius = std::numeric_limits<double>::infinity();
};

/// Inverse-distance weighting in the plane: a mean of the values of near nodes.
///
/// Node i at distance d has the weight ((R - d) / (R d))^power, where R is the distance
/// of the first node that has no say (the one after `neighbors`, or `radius`). So a node
/// loses its say as it becomes that node, and the surface is continuous, which 1 /
/// d^power over the k nearest is not. Where there is no such node (`neighbors` or fewer
/// in all) R is infinite.
///
/// Within the range of the values it is made from; constants exact; at a node its value,
/// bit for bit. Gradients are those of the surface; at a node 0 (what a power above 1
/// gives; for others the surface has a cusp there). Where all near nodes are equally far,
/// as in the centre of a circle, their mean: the surface has no limit there. With a
/// radius, missing where no node is nearer.
///
/// Order of the error for twice differentiable functions: 1 between nodes; the surface
/// is flat at every node. A method for those who are asked for it; PlaneShepard is the
/// one that this became.
///
/// Outside the convex hull as `SurfaceOptions::outside` says; Outside::linear means that
/// the mean is taken there too. Repeated and degenerate positions, queries that are NaN,
/// threads and errors as PlaneLinear; Error besides for options out of range.
///
/// Cost: 1 to 2 microseconds a query. Sources: D. Shepard, Proc. 23rd ACM Nat. Conf.
/// (1968) 517-524; weights: R. Franke, G. Nielson, Int. J. Numer. Methods Eng. 15 (1980)
/// 1691-1704 (there credited to F. Little).
class PlaneInverseDistance {
 public:
  PlaneInverseDistance(std::shared_ptr<const tripack::Triangulation> triangulation,
                       std::span<const double> row_values,
                       const InverseDistanceOptions& weights = {},
                       const SurfaceOptions& options = {});
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

/// The same on the sphere, distances along great circles. Outside::linear is refused with
/// Error.
class SphereInverseDistance {
 public:
  SphereInverseDistance(std::shared_ptr<const stripack::Triangulation> triangulation,
                        std::span<const double> row_values,
                        const InverseDistanceOptions& weights = {},
                        const SurfaceOptions& options = {});
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
