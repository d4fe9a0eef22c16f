#pragma once

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

/// The value of the nearest observation, in the plane.
///
/// Of several at the same distance the one that comes first along the triangulation's
/// curve, whatever the order of rows. Outside the convex hull missing unless
/// `SurfaceOptions::outside` is `nearest`; Outside::linear is refused with Error. Other
/// options, errors and guarantees as PlaneLinear. Gradients are zero.
class PlaneNearest {
 public:
  PlaneNearest(std::shared_ptr<const tripack::Triangulation> triangulation,
               std::span<const double> row_values, const SurfaceOptions& options = {});
  [[nodiscard]] double value(tripack::Point2 p) const;
  [[nodiscard]] Gradient2 gradient(tripack::Point2 p) const;
  [[nodiscard]] std::vector<double> values(std::span<const tripack::Point2> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<Gradient2> gradients(std::span<const tripack::Point2> points,
                                                 const RunOptions& run = {}) const;
  /// Walks along rows: some 40 ns a node.
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const tripack::Triangulation> triangulation_;
  std::vector<double> values_;
  SurfaceOptions options_;
};

/// The same on the sphere: nearest by angle. Missing outside the triangulated region
/// unless `SurfaceOptions::outside` is `nearest`.
class SphereNearest {
 public:
  SphereNearest(std::shared_ptr<const stripack::Triangulation> triangulation,
                std::span<const double> row_values, const SurfaceOptions& options = {});
  [[nodiscard]] double value(const stripack::Direction& p) const;
  [[nodiscard]] GradientSphere gradient(const stripack::Direction& p) const;
  [[nodiscard]] std::vector<double> values(std::span<const stripack::Direction> points,
                                           const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<GradientSphere> gradients(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  [[nodiscard]] Field grid(const Grid& lonlat_grid, const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const stripack::Triangulation> triangulation_;
  std::vector<double> values_;
  SurfaceOptions options_;
};

}  // namespace delone::interp
