#include "interp/c1_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "delaunay/error.hpp"
#include "interp/blend_cells.hpp"
#include "interp/blend_scan.hpp"
#include "interp/triangle_integral.hpp"

namespace delone::interp {

namespace {

Derivatives2 in_plane(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}
DerivativesSphere on_sphere(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}

/// A tangent vector by scaled length.
Point2 scaled_gradient(const tripack::Triangulation&, double scale, Site,
                       const Gradient2& g) {
  return {g.x / scale, g.y / scale};
}
Vector3 scaled_gradient(const stripack::Triangulation& t, double, Site s,
                        const GradientSphere& g) {
  const stripack::Direction& p = t.points()[at(s)];
  const Vector3 east = east_at(p);
  return g.east * east + g.north * cross(vector(p), east);
}

std::array<double, 2> parts(const Gradient2& g) { return {g.x, g.y}; }
std::array<double, 2> parts(const GradientSphere& g) { return {g.east, g.north}; }

bool is_known(const auto& gradient) {
  return std::ranges::none_of(parts(gradient), [](double a) { return std::isnan(a); });
}

bool is_usable(const Point2& g) { return std::isfinite(g.x) && std::isfinite(g.y); }
bool is_usable(const Vector3& g) { return std::isfinite(dot(g, g)); }

Point2 sum_of(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
Vector3 sum_of(Vector3 a, Vector3 b) { return a + b; }
Point2 part_of(Point2 a, double part) { return {part * a.x, part * a.y}; }
Vector3 part_of(Vector3 a, double part) { return part * a; }

void check_gradients(std::size_t num_rows, std::size_t num_gradients) {
  if (num_rows == num_gradients) return;
  throw Error("there are " + std::to_string(num_gradients) + " gradients for " +
              std::to_string(num_rows) + " points; give one gradient a point");
}

/// Of every site the mean of its rows' gradients; NaN where none is known.
template <BlendSpace Space, class Gradient>
std::vector<typename Space::Vector> gradients_at_sites(
    const typename Space::Triangulation& t, double scale,
    std::span<const Gradient> row_gradients) {
  check_gradients(t.sites().size(), row_gradients.size());
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const RowsOfSites rows = rows_of_sites(t.sites(), t.num_sites());
  std::vector<typename Space::Vector> result(at(t.num_sites()));
  for (Site s = 0; s < t.num_sites(); ++s) {
    typename Space::Vector sum{};
    int count = 0;
    // Summed in an order that is not that of the rows.
    std::vector<delaunay::Node> known(rows.of(s).begin(), rows.of(s).end());
    std::erase_if(known, [&](auto row) { return !is_known(row_gradients[at(row)]); });
    std::ranges::sort(known, {}, [&](auto row) { return parts(row_gradients[at(row)]); });
    for (const delaunay::Node row : known) {
      const auto g = scaled_gradient(t, scale, s, row_gradients[at(row)]);
      if (!is_usable(g)) {
        throw Error("row " + std::to_string(row) +
                        ": the gradient is not a finite number; give NaN where it is "
                        "not known",
                    {row});
      }
      sum = sum_of(sum, g);
      ++count;
    }
    result[at(s)] = part_of(sum, count == 0 ? unknown : 1.0 / count);
  }
  return result;
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

constexpr auto read_value = [](const auto& cells, const auto& p, Cursor& cursor) {
  return cells.value(p, cursor);
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
  return blend_->read_all<double>(points, run, read_value);
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
  return blend_->read_all<double>(points, run, read_value);
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

}  // namespace delone::interp
