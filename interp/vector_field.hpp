#pragma once

#include <array>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/c1_surface.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/natural_surface.hpp"
#include "stripack/triangulation.hpp"

namespace delone::interp {

using stripack::EastNorth;

/// A tangent vector of the unit sphere and its covariant derivative: `north_by_east` is
/// how the northward component changes towards east, by radian, once the turn of the
/// meridians is taken out. At a pole east is the direction of 90 degrees east. NaN:
/// missing.
///
/// With components in metres a second, divided by the radius of the Earth in metres
/// (1000 stripack::earth_radius_km) these are rates in 1/s.
struct VectorDerivatives {
  double east = 0, north = 0;
  double east_by_east = 0, east_by_north = 0, north_by_east = 0, north_by_north = 0;

  [[nodiscard]] double divergence() const noexcept {
    return east_by_east + north_by_north;
  }
  /// The component of the curl along the outward normal: vorticity, positive
  /// counter-clockwise.
  [[nodiscard]] double curl() const noexcept { return north_by_east - east_by_north; }
};

/// Both components on one grid.
struct VectorGrid {
  Field east, north;
};

/// Components at a position given as longitude and latitude, counted towards east and
/// north of that longitude, as those of its Direction. They differ at the poles only,
/// where a table may hold one wind in as many ways as there are longitudes, but a
/// Direction has no longitude and counts from that of Greenwich.
[[nodiscard]] EastNorth without_longitude(EastNorth v, stripack::LonLat where);
/// The way back.
[[nodiscard]] EastNorth with_longitude(EastNorth v, stripack::LonLat where);

/// A tangent vector field on the sphere through vectors at nodes: winds, currents,
/// velocities.
///
/// The vectors are taken as vectors of space, their three components are interpolated by
/// one of the surfaces over the same triangulation, and the result is projected on the
/// tangent plane at the query. So poles and the date line are places like any other,
/// although east and north turn about them; projection only lessens the error. The
/// components are those along the principal axes of the data, so the field does not
/// depend on the axes of the coordinates: turned nodes with turned vectors give the
/// turned field (to rounding; where two principal axes are equally long, only as far as a
/// surface that adapts to its data, C1, adapts to both alike).
///
/// Flows of a rigid rotation, omega x r, have components that are first-degree harmonics:
/// C1 with local gradients, which it chooses for them itself, reproduces them to rounding
/// wherever it reproduces those (SphereC1); linear and natural to O(h^2). The order of
/// the error is that of the surface.
///
/// At a node its vector, bit for bit (of repeated rows the mean, or the first or last;
/// the other policies look at single components and are refused but for `error`).
/// `Bounds`, outside, `max_distance`, degenerate sets, threads and missing queries as in
/// the surface taken. East at a pole: see without_longitude.
///
/// Derivatives are exact, of the projected field itself: continuous over C1; over linear
/// they jump across edges, over natural at the nodes, where they are those of linear. The
/// divergence of a flow that has none (or its curl) comes out small of the order of the
/// derivatives, not zero.
///
/// Cost: three times that of the surface. Shares the triangulation; thread-safe for
/// reading. Throws Error as the surface does: a number of vectors unlike that of the
/// rows, components that are not finite (naming the row).
class SphereVectorField {
 public:
  using Triangulation = std::shared_ptr<const stripack::Triangulation>;

  /// Over SphereLinear, SphereC1, SphereNatural.
  [[nodiscard]] static SphereVectorField linear(Triangulation triangulation,
                                                std::span<const EastNorth> row_vectors,
                                                const SurfaceOptions& options = {});
  [[nodiscard]] static SphereVectorField c1(Triangulation triangulation,
                                            std::span<const EastNorth> row_vectors,
                                            const C1Options& options = {},
                                            const RunOptions& run = {});
  [[nodiscard]] static SphereVectorField natural(Triangulation triangulation,
                                                 std::span<const EastNorth> row_vectors,
                                                 const NaturalOptions& options = {});

  /// How the three components were fitted; zeros but for C1.
  [[nodiscard]] std::array<C1Fit, 3> fits() const noexcept;
  /// NaN, NaN: missing. O(sqrt n); for many points use values().
  [[nodiscard]] EastNorth value(const stripack::Direction& p) const;
  [[nodiscard]] VectorDerivatives derivatives(const stripack::Direction& p) const;
  /// In the order of `points`, which may be any. The same bits as value().
  [[nodiscard]] std::vector<EastNorth> values(std::span<const stripack::Direction> points,
                                              const RunOptions& run = {}) const;
  [[nodiscard]] std::vector<VectorDerivatives> derivatives(
      std::span<const stripack::Direction> points, const RunOptions& run = {}) const;
  /// At a pole each node counts from its own longitude: one vector, other components in
  /// every column. Throws Error as check_globe does.
  [[nodiscard]] VectorGrid grid(const Grid& lonlat_grid,
                                const RunOptions& run = {}) const;

 private:
  using Surfaces = std::variant<std::array<SphereLinear, 3>, std::array<SphereC1, 3>,
                                std::array<SphereNatural, 3>>;
  struct Nodes;  ///< triangulation, vectors, axes
  SphereVectorField(std::shared_ptr<const Nodes> nodes, Surfaces surfaces)
      : nodes_(std::move(nodes)), surfaces_(std::move(surfaces)) {}
  template <class Make>
  static SphereVectorField over(Triangulation triangulation,
                                std::span<const EastNorth> row_vectors,
                                Duplicates duplicates, Make make);

  std::shared_ptr<const Nodes> nodes_;
  Surfaces surfaces_;
};

}  // namespace delone::interp
