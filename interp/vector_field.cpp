#include "interp/vector_field.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/cursor.hpp"
#include "interp/row_walk.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/spot.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

using stripack::Direction;
using stripack::LonLat;
using Axes = std::array<Vector3, 3>;

/// The tangent plane at a direction.
struct TangentPlane {
  Vector3 east, north, up;
  explicit TangentPlane(const Direction& p)
      : east(east_at(p)), north(cross(vector(p), east)), up(vector(p)) {}
  [[nodiscard]] Vector3 in_space(EastNorth v) const noexcept {
    return v.east * east + v.north * north;
  }
  [[nodiscard]] EastNorth projected(Vector3 v) const noexcept {
    return {dot(v, east), dot(v, north)};
  }
};

Vector3 along(const Axes& axes, double a, double b, double c) {
  return a * axes[0] + (b * axes[1] + c * axes[2]);
}

/// A component of the vector in space and its derivatives.
struct Component {
  double value = 0, east = 0, north = 0;
};

VectorDerivatives covariant(const Axes& axes, const TangentPlane& plane,
                            const std::array<Component, 3>& c) {
  const Vector3 v = along(axes, c[0].value, c[1].value, c[2].value),
                by_east = along(axes, c[0].east, c[1].east, c[2].east),
                by_north = along(axes, c[0].north, c[1].north, c[2].north);
  const EastNorth value = plane.projected(v), e = plane.projected(by_east),
                  n = plane.projected(by_north);
  // The part along the normal is projected away; what is left of it turns with the
  // normal.
  const double height = dot(v, plane.up);
  return {value.east, value.north, e.east - height, n.east, e.north, n.north - height};
}

RunOptions part_of(const RunOptions& run, std::size_t part, std::size_t count) {
  RunOptions result{run.num_threads, {}};
  if (!run.progress) return result;
  const double width = 1 / static_cast<double>(count),
               begin = static_cast<double>(part) * width;
  result.progress = [&run, begin, width](double fraction) {
    return run.progress(begin + width * fraction);
  };
  return result;
}

Component component_at(const auto& surface, const Direction& p) {
  const GradientSphere g = surface.gradient(p);
  return {surface.value(p), g.east, g.north};
}
Component component_at(const SphereC1& surface, const Direction& p) {
  const DerivativesSphere d = surface.derivatives(p);
  return {d.value, d.east, d.north};
}

std::vector<Component> components_at(const auto& surface,
                                     std::span<const Direction> points,
                                     const RunOptions& run) {
  const std::vector<double> values = surface.values(points, part_of(run, 0, 2));
  const std::vector<GradientSphere> gradients =
      surface.gradients(points, part_of(run, 1, 2));
  std::vector<Component> result(points.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {values[i], gradients[i].east, gradients[i].north};
  return result;
}
std::vector<Component> components_at(const SphereC1& surface,
                                     std::span<const Direction> points,
                                     const RunOptions& run) {
  const std::vector<DerivativesSphere> derivatives = surface.derivatives(points, run);
  std::vector<Component> result(points.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {derivatives[i].value, derivatives[i].east, derivatives[i].north};
  return result;
}

/// Axes along which the vectors are longest and shortest. Divided by the largest
/// component first: squares neither overflow nor vanish.
Axes principal_axes(std::span<const Vector3> vectors) {
  double largest = 0;
  for (const Vector3& v : vectors) largest = std::max(largest, largest_component(v));
  if (largest == 0) return {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  const int exponent = -std::ilogb(largest);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& v : vectors) {
    const Eigen::Vector3d scaled(std::scalbn(v.x, exponent), std::scalbn(v.y, exponent),
                                 std::scalbn(v.z, exponent));
    moments += scaled * scaled.transpose();
  }
  const Eigen::Matrix3d vectors_of =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors();
  Axes axes;
  for (int k = 0; k < 3; ++k) {
    axes[at(k)] = {vectors_of(0, k), vectors_of(1, k), vectors_of(2, k)};
  }
  return axes;
}

void check(Duplicates policy) {
  if (policy == Duplicates::median || policy == Duplicates::min ||
      policy == Duplicates::max) {
    throw Error(
        "vectors have no median, least or greatest; of repeated positions take the mean, "
        "the first or the last");
  }
}

std::vector<EastNorth> vectors_at_sites(const stripack::Triangulation& t,
                                        std::span<const EastNorth> row_vectors,
                                        Duplicates policy) {
  check(policy);
  std::vector<double> component(row_vectors.size());
  const auto of_sites = [&](double EastNorth::*part) {
    std::ranges::transform(row_vectors, component.begin(),
                           [part](const EastNorth& v) { return v.*part; });
    return values_at_sites(t.sites(), t.num_sites(), component, policy);
  };
  const std::vector<double> east = of_sites(&EastNorth::east),
                            north = of_sites(&EastNorth::north);
  std::vector<EastNorth> result(east.size());
  for (std::size_t s = 0; s < result.size(); ++s) result[s] = {east[s], north[s]};
  return result;
}

bool is_pole(LonLat p) { return std::abs(p.lat_deg) == 90; }

/// By the turn of a vector's components when its longitude is counted from 0.
EastNorth turned(EastNorth v, double cosine, double sine) {
  return {cosine * v.east - sine * v.north, sine * v.east + cosine * v.north};
}

struct Turn {
  double cosine, sine;
  explicit Turn(LonLat where) {
    const Direction meridian = Direction::from(LonLat{where.lon_deg, 0});
    cosine = meridian.x();
    sine = where.lat_deg > 0 ? meridian.y() : -meridian.y();
  }
};

}  // namespace

EastNorth without_longitude(EastNorth v, LonLat where) {
  if (!is_pole(where)) return v;
  const Turn turn(where);
  return turned(v, turn.cosine, turn.sine);
}

EastNorth with_longitude(EastNorth v, LonLat where) {
  if (!is_pole(where)) return v;
  const Turn turn(where);
  return turned(v, turn.cosine, -turn.sine);
}

struct SphereVectorField::Nodes {
  Triangulation triangulation;
  std::vector<EastNorth> vectors;  ///< of the sites
  Axes axes;

  /// The site that the query is, or none.
  [[nodiscard]] Site site_at(const Direction& p, Cursor& cursor) const {
    if (triangulation->num_sites() == 0) return none;
    const Spot spot = find_spot(*triangulation, p, cursor.arc);
    return spot.kind == Spot::Kind::node ? spot.sites[0] : none;
  }
  /// From the components along the axes. At a node the data, bit for bit.
  [[nodiscard]] EastNorth vector_at(const Direction& p, double a, double b, double c,
                                    Cursor& cursor) const {
    if (const Site site = site_at(p, cursor); site != none && !std::isnan(a))
      return vectors[at(site)];
    return TangentPlane(p).projected(along(axes, a, b, c));
  }
  /// Component k of every row.
  [[nodiscard]] std::vector<double> component(std::size_t k,
                                              std::span<const Vector3> in_space) const {
    const std::span<const Site> sites = triangulation->sites();
    std::vector<double> result(sites.size());
    for (std::size_t row = 0; row < result.size(); ++row)
      result[row] = dot(in_space[at(sites[row])], axes[k]);
    return result;
  }
};

template <class Make>
SphereVectorField SphereVectorField::over(Triangulation triangulation,
                                          std::span<const EastNorth> row_vectors,
                                          Duplicates duplicates, Make make) {
  auto nodes = std::make_shared<Nodes>();
  nodes->vectors = vectors_at_sites(*triangulation, row_vectors, duplicates);
  nodes->triangulation = std::move(triangulation);
  std::vector<Vector3> in_space(nodes->vectors.size());
  for (std::size_t s = 0; s < in_space.size(); ++s) {
    in_space[s] =
        TangentPlane(nodes->triangulation->points()[s]).in_space(nodes->vectors[s]);
  }
  nodes->axes = principal_axes(in_space);
  const auto surface = [&](std::size_t k) {
    return make(nodes->triangulation, nodes->component(k, in_space), k);
  };
  return {nodes, std::array{surface(0), surface(1), surface(2)}};
}

SphereVectorField SphereVectorField::linear(Triangulation triangulation,
                                            std::span<const EastNorth> row_vectors,
                                            const SurfaceOptions& options) {
  return over(std::move(triangulation), row_vectors, options.duplicates,
              [&](const Triangulation& t, const std::vector<double>& values,
                  std::size_t) { return SphereLinear(t, values, options); });
}

SphereVectorField SphereVectorField::c1(Triangulation triangulation,
                                        std::span<const EastNorth> row_vectors,
                                        const C1Options& options, const RunOptions& run) {
  return over(
      std::move(triangulation), row_vectors, options.duplicates,
      [&](const Triangulation& t, const std::vector<double>& values, std::size_t k) {
        return SphereC1(t, values, options, part_of(run, k, 3));
      });
}

SphereVectorField SphereVectorField::natural(Triangulation triangulation,
                                             std::span<const EastNorth> row_vectors,
                                             const NaturalOptions& options) {
  return over(std::move(triangulation), row_vectors, options.duplicates,
              [&](const Triangulation& t, const std::vector<double>& values,
                  std::size_t) { return SphereNatural(t, values, options); });
}

std::array<C1Fit, 3> SphereVectorField::fits() const noexcept {
  const auto* c1 = std::get_if<std::array<SphereC1, 3>>(&surfaces_);
  if (c1 == nullptr) return {};
  return {(*c1)[0].fit(), (*c1)[1].fit(), (*c1)[2].fit()};
}

EastNorth SphereVectorField::value(const Direction& p) const {
  Cursor cursor;
  return std::visit(
      [&](const auto& s) {
        return nodes_->vector_at(p, s[0].value(p), s[1].value(p), s[2].value(p), cursor);
      },
      surfaces_);
}

VectorDerivatives SphereVectorField::derivatives(const Direction& p) const {
  return std::visit(
      [&](const auto& s) {
        return covariant(
            nodes_->axes, TangentPlane(p),
            {component_at(s[0], p), component_at(s[1], p), component_at(s[2], p)});
      },
      surfaces_);
}

std::vector<EastNorth> SphereVectorField::values(std::span<const Direction> points,
                                                 const RunOptions& run) const {
  std::array<std::vector<double>, 3> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts[k] =
        std::visit([&](const auto& s) { return s[k].values(points, part_of(run, k, 4)); },
                   surfaces_);
  }
  return evaluate_along_curve<EastNorth>(
      points, nodes_->triangulation->adjacency(), part_of(run, 3, 4),
      [&](const Direction& p, Cursor& cursor) {
        const auto i = static_cast<std::size_t>(&p - points.data());
        return nodes_->vector_at(p, parts[0][i], parts[1][i], parts[2][i], cursor);
      });
}

std::vector<VectorDerivatives> SphereVectorField::derivatives(
    std::span<const Direction> points, const RunOptions& run) const {
  std::array<std::vector<Component>, 3> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts[k] = std::visit(
        [&](const auto& s) { return components_at(s[k], points, part_of(run, k, 3)); },
        surfaces_);
  }
  std::vector<VectorDerivatives> result(points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = covariant(nodes_->axes, TangentPlane(points[i]),
                          {parts[0][i], parts[1][i], parts[2][i]});
  }
  return result;
}

VectorGrid SphereVectorField::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  std::array<Field, 3> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts[k] = std::visit(
        [&](const auto& s) { return s[k].grid(lonlat_grid, part_of(run, k, 4)); },
        surfaces_);
  }
  const GlobeTable table(lonlat_grid);
  const AxisTable lon(lonlat_grid.x), lat(lonlat_grid.y);
  VectorGrid result{parts[0], {lonlat_grid, std::vector<double>(parts[0].values.size())}};
  result.east.values =
      walk_rows(table.rows(), table.columns(), part_of(run, 3, 4),
                [&](std::int64_t i, std::int64_t j, Cursor& cursor) {
                  const std::size_t n = at(j * table.columns() + i);
                  const EastNorth v = with_longitude(
                      nodes_->vector_at(table.node(i, j), parts[0].values[n],
                                        parts[1].values[n], parts[2].values[n], cursor),
                      {lon[i], lat[j]});
                  result.north.values[n] = v.north;
                  return v.east;
                });
  return result;
}

}  // namespace delone::interp
