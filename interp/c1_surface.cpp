#include "interp/c1_surface.hpp"

#include <utility>
#include <variant>

#include "interp/blend_cells.hpp"
#include "interp/blend_scan.hpp"
#include "interp/blend_values.hpp"
#include "interp/node_gradients.hpp"
#include "interp/region_sum.hpp"
#include "interp/triangle_integral.hpp"

namespace delone::interp {

namespace {

Derivatives2 in_plane(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}
DerivativesSphere on_sphere(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}

/// The cells of either degree.
template <BlendSpace Space>
class Blend {
 public:
  using Triangulation = typename Space::Triangulation;
  using Point = typename Space::Point;

  using Gradients = std::vector<typename Space::Vector>;

  /// `site_gradients`: BlendCells.
  Blend(std::shared_ptr<const Triangulation> triangulation,
        std::span<const double> row_values, Gradients site_gradients,
        const C1Options& options, const RunOptions& run)
      : cells_(make(std::move(triangulation), row_values, std::move(site_gradients),
                    options, run)) {}

  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit([&](const auto& cells) { return f(*cells); }, cells_);
  }
  [[nodiscard]] std::vector<double> values(std::span<const Point> points,
                                           const RunOptions& run) const {
    return visit([&](const auto& cells) { return blend_values(cells, points, run); });
  }
  /// `read(cells, point, cursor)` at every point.
  template <class Result, class Read>
  [[nodiscard]] std::vector<Result> read_all(std::span<const Point> points,
                                             const RunOptions& run, Read read) const {
    return visit([&](const auto& cells) {
      return evaluate_along_curve<Result>(
          points, cells.triangulation().adjacency(), run,
          [&](const Point& p, Cursor& cursor) { return read(cells, p, cursor); });
    });
  }

 private:
  template <int Degree>
  using Cells = std::shared_ptr<const BlendCells<Space, Degree>>;
  using AnyCells = std::variant<Cells<3>, Cells<4>>;

  static AnyCells make(std::shared_ptr<const Triangulation> triangulation,
                       std::span<const double> row_values, Gradients site_gradients,
                       const C1Options& options, const RunOptions& run) {
    std::vector<double> values =
        values_at_sites(triangulation->sites(), triangulation->num_sites(), row_values,
                        options.duplicates);
    if (options.degree == FitDegree::quartic) {
      return std::make_shared<const BlendCells<Space, 4>>(std::move(triangulation),
                                                          std::move(values), options, run,
                                                          std::move(site_gradients));
    }
    return std::make_shared<const BlendCells<Space, 3>>(std::move(triangulation),
                                                        std::move(values), options, run,
                                                        std::move(site_gradients));
  }

  AnyCells cells_;
};

}  // namespace

class PlaneBlend : public Blend<PlaneSpace> {
 public:
  using Blend::Blend;
};
class SphereBlend : public Blend<SphereSpace> {
 public:
  using Blend::Blend;
};

PlaneC1::PlaneC1(std::shared_ptr<const tripack::Triangulation> triangulation,
                 std::span<const double> row_values, const C1Options& options,
                 const RunOptions& run)
    : blend_(std::make_shared<const PlaneBlend>(std::move(triangulation), row_values,
                                                PlaneBlend::Gradients{}, options, run)) {}

PlaneC1::PlaneC1(std::shared_ptr<const tripack::Triangulation> triangulation,
                 std::span<const double> row_values,
                 std::span<const Gradient2> row_gradients, const C1Options& options,
                 const RunOptions& run)
    : blend_(std::make_shared<const PlaneBlend>(
          triangulation, row_values,
          gradients_at_sites<PlaneSpace>(
              *triangulation, coordinate_scale(triangulation->points()), row_gradients),
          options, run)) {}

const C1Fit& PlaneC1::fit() const noexcept {
  return *blend_->visit([](const auto& cells) { return &cells.fit(); });
}

double PlaneC1::value(tripack::Point2 p) const {
  Cursor cursor;
  return blend_->visit([&](const auto& cells) { return cells.value(p, cursor); });
}

Gradient2 PlaneC1::gradient(tripack::Point2 p) const {
  const Derivatives2 d = derivatives(p);
  return {d.x, d.y};
}

Derivatives2 PlaneC1::derivatives(tripack::Point2 p) const {
  Cursor cursor;
  return blend_->visit(
      [&](const auto& cells) { return in_plane(cells.derivatives(p, cursor)); });
}

std::vector<double> PlaneC1::values(std::span<const tripack::Point2> points,
                                    const RunOptions& run) const {
  return blend_->values(points, run);
}

std::vector<Gradient2> PlaneC1::gradients(std::span<const tripack::Point2> points,
                                          const RunOptions& run) const {
  return blend_->read_all<Gradient2>(
      points, run, [](const auto& cells, const Point2& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return Gradient2{d.x, d.y};
      });
}

std::vector<Derivatives2> PlaneC1::derivatives(std::span<const tripack::Point2> points,
                                               const RunOptions& run) const {
  return blend_->read_all<Derivatives2>(
      points, run, [](const auto& cells, const Point2& p, Cursor& cursor) {
        return in_plane(cells.derivatives(p, cursor));
      });
}

Field PlaneC1::grid(const Grid& grid, const RunOptions& run) const {
  return {grid, blend_->visit([&](const auto& cells) { return scan(cells, grid, run); })};
}

double PlaneC1::integral(const RunOptions& run) const {
  return blend_->visit([&](const auto& cells) {
    return integral_over_triangles(PlaneSpace{cells.scale()}, cells, run);
  });
}

RegionIntegral PlaneC1::integral(const PlaneRegion& region, const RunOptions& run) const {
  return blend_->visit([&](const auto& cells) {
    return integral_over_region(PlaneSpace{cells.scale()}, cells, region, PlaneArea{},
                                run);
  });
}

SphereC1::SphereC1(std::shared_ptr<const stripack::Triangulation> triangulation,
                   std::span<const double> row_values, const C1Options& options,
                   const RunOptions& run)
    : blend_(std::make_shared<const SphereBlend>(
          std::move(triangulation), row_values, SphereBlend::Gradients{}, options, run)) {
}

SphereC1::SphereC1(std::shared_ptr<const stripack::Triangulation> triangulation,
                   std::span<const double> row_values,
                   std::span<const GradientSphere> row_gradients,
                   const C1Options& options, const RunOptions& run)
    : blend_(std::make_shared<const SphereBlend>(
          triangulation, row_values,
          gradients_at_sites<SphereSpace>(*triangulation, 1, row_gradients), options,
          run)) {}

const C1Fit& SphereC1::fit() const noexcept {
  return *blend_->visit([](const auto& cells) { return &cells.fit(); });
}

double SphereC1::value(const stripack::Direction& p) const {
  Cursor cursor;
  return blend_->visit([&](const auto& cells) { return cells.value(p, cursor); });
}

GradientSphere SphereC1::gradient(const stripack::Direction& p) const {
  const DerivativesSphere d = derivatives(p);
  return {d.east, d.north};
}

DerivativesSphere SphereC1::derivatives(const stripack::Direction& p) const {
  Cursor cursor;
  return blend_->visit(
      [&](const auto& cells) { return on_sphere(cells.derivatives(p, cursor)); });
}

std::vector<double> SphereC1::values(std::span<const stripack::Direction> points,
                                     const RunOptions& run) const {
  return blend_->values(points, run);
}

std::vector<GradientSphere> SphereC1::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return blend_->read_all<GradientSphere>(
      points, run, [](const auto& cells, const Direction& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return GradientSphere{d.x, d.y};
      });
}

std::vector<DerivativesSphere> SphereC1::derivatives(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return blend_->read_all<DerivativesSphere>(
      points, run, [](const auto& cells, const Direction& p, Cursor& cursor) {
        return on_sphere(cells.derivatives(p, cursor));
      });
}

Field SphereC1::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return {lonlat_grid, blend_->visit([&](const auto& cells) {
            return scan(cells, lonlat_grid, run);
          })};
}

double SphereC1::integral(const RunOptions& run) const {
  return blend_->visit([&](const auto& cells) {
    return integral_over_triangles(SphereSpace{}, cells, run);
  });
}

RegionIntegral SphereC1::integral(const SphereRegion& region, AreaUnit unit,
                                  const RunOptions& run) const {
  return blend_->visit([&](const auto& cells) {
    return integral_over_region(SphereSpace{}, cells, region, SphereArea(unit), run);
  });
}

}  // namespace delone::interp
