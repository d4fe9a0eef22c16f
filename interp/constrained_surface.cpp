#include "interp/constrained_surface.hpp"

#include <utility>
#include <variant>

#include "delaunay/error.hpp"
#include "interp/barrier_blend.hpp"

namespace delone::interp {

namespace {

Derivatives2 in_plane(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}
DerivativesSphere on_sphere(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}

/// The cells of either kind.
template <BlendSpace Space>
class Barriers {
 public:
  using Point = typename Space::Point;
  using Constrained = std::shared_ptr<const ConstrainedIn<Space>>;

  Barriers(Constrained constrained, std::span<const double> row_values,
           const ConstrainedOptions& options, const RunOptions& run)
      : cells_(make(std::move(constrained), row_values, options, run)) {}

  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit([&](const auto& cells) { return f(*cells); }, cells_);
  }
  [[nodiscard]] double value(const Point& p) const {
    Cursor cursor;
    return visit([&](const auto& cells) { return cells.value(p, cursor); });
  }
  [[nodiscard]] SecondOrder derivatives(const Point& p) const {
    Cursor cursor;
    return visit([&](const auto& cells) { return cells.derivatives(p, cursor); });
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
  [[nodiscard]] Field grid(const Grid& grid, const RunOptions& run) const {
    return {grid, visit([&](const auto& cells) { return scan(cells, grid, run); })};
  }

 private:
  template <class Cells>
  using Shared = std::shared_ptr<const Cells>;
  using Linear = BarrierLinearCells<Space>;
  using Cubic = BarrierBlendCells<Space, 3>;
  using Quartic = BarrierBlendCells<Space, 4>;
  using AnyCells = std::variant<Shared<Linear>, Shared<Cubic>, Shared<Quartic>>;

  static AnyCells make(Constrained constrained, std::span<const double> row_values,
                       const ConstrainedOptions& options, const RunOptions& run) {
    check(options);
    if (options.kind == ConstrainedKind::linear) {
      return std::make_shared<const Linear>(std::move(constrained), row_values, options,
                                            options.bounds);
    }
    const BarrierBlendOptions blend{options.bounds, options.tension};
    if (options.degree == FitDegree::quartic) {
      return std::make_shared<const Quartic>(std::move(constrained), row_values, options,
                                             blend, run);
    }
    return std::make_shared<const Cubic>(std::move(constrained), row_values, options,
                                         blend, run);
  }

  AnyCells cells_;
};

constexpr auto read_value = [](const auto& cells, const auto& p, Cursor& cursor) {
  return cells.value(p, cursor);
};

}  // namespace

void check(const ConstrainedOptions& options) {
  check(static_cast<const SurfaceOptions&>(options));
  if (options.tension && !(*options.tension >= 0 && *options.tension <= 1))
    throw Error("the tension must lie between 0 and 1");
  if (options.outside != Outside::missing) {
    throw Error(
        "a constrained surface ends at its domain and has no continuation; leave the "
        "outside missing, or add points there");
  }
}

class PlaneBarrierCells : public Barriers<PlaneSpace> {
 public:
  using Barriers::Barriers;
};
class SphereBarrierCells : public Barriers<SphereSpace> {
 public:
  using Barriers::Barriers;
};

PlaneConstrained::PlaneConstrained(
    std::shared_ptr<const tripack::ConstrainedTriangulation> triangulation,
    std::span<const double> row_values, const ConstrainedOptions& options,
    const RunOptions& run)
    : cells_(std::make_shared<const PlaneBarrierCells>(std::move(triangulation),
                                                       row_values, options, run)) {}

double PlaneConstrained::value(tripack::Point2 p) const { return cells_->value(p); }

Derivatives2 PlaneConstrained::derivatives(tripack::Point2 p) const {
  return in_plane(cells_->derivatives(p));
}

Gradient2 PlaneConstrained::gradient(tripack::Point2 p) const {
  const SecondOrder d = cells_->derivatives(p);
  return {d.x, d.y};
}

std::vector<double> PlaneConstrained::values(std::span<const tripack::Point2> points,
                                             const RunOptions& run) const {
  return cells_->read_all<double>(points, run, read_value);
}

std::vector<Gradient2> PlaneConstrained::gradients(
    std::span<const tripack::Point2> points, const RunOptions& run) const {
  return cells_->read_all<Gradient2>(
      points, run, [](const auto& cells, const Point2& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return Gradient2{d.x, d.y};
      });
}

Field PlaneConstrained::grid(const Grid& grid, const RunOptions& run) const {
  return cells_->grid(grid, run);
}

SphereConstrained::SphereConstrained(
    std::shared_ptr<const stripack::ConstrainedTriangulation> triangulation,
    std::span<const double> row_values, const ConstrainedOptions& options,
    const RunOptions& run)
    : cells_(std::make_shared<const SphereBarrierCells>(std::move(triangulation),
                                                        row_values, options, run)) {}

double SphereConstrained::value(const stripack::Direction& p) const {
  return cells_->value(p);
}

DerivativesSphere SphereConstrained::derivatives(const stripack::Direction& p) const {
  return on_sphere(cells_->derivatives(p));
}

GradientSphere SphereConstrained::gradient(const stripack::Direction& p) const {
  const SecondOrder d = cells_->derivatives(p);
  return {d.x, d.y};
}

std::vector<double> SphereConstrained::values(std::span<const stripack::Direction> points,
                                              const RunOptions& run) const {
  return cells_->read_all<double>(points, run, read_value);
}

std::vector<GradientSphere> SphereConstrained::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return cells_->read_all<GradientSphere>(
      points, run, [](const auto& cells, const Direction& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return GradientSphere{d.x, d.y};
      });
}

Field SphereConstrained::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return cells_->grid(lonlat_grid, run);
}

}  // namespace delone::interp
