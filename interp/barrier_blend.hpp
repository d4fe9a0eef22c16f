#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/barrier_cells.hpp"
#include "interp/barrier_facet.hpp"
#include "interp/barrier_stencil.hpp"
#include "interp/blend_fit.hpp"

namespace delone::interp {

/// What a smooth surface with barriers takes.
struct BarrierBlendOptions {
  Bounds bounds = Bounds::widened;
  std::optional<double> tension;  ///< empty: chosen for every part of the domain
};

/// The blended surface over a constrained triangulation: BlendCells with the polynomials
/// of wedges in the place of nodes'.
///
/// About a wedge with data the polynomial is fitted to the data that it sees, if these
/// are enough; from such polynomials wedges without data get their values anew, and then
/// polynomials of their own. Tension and bounds are those of the data of one connected
/// part of the domain.
template <BlendSpace Space, int Degree>
class BarrierBlendCells {
 public:
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Mesh = BarrierMeshIn<Space>;
  using Facet = DomainFacet<BarrierFacet<Space, Degree>>;

  BarrierBlendCells(std::shared_ptr<const ConstrainedIn<Space>> constrained,
                    std::span<const double> row_values, const SurfaceOptions& options,
                    const BarrierBlendOptions& blend, const RunOptions& run);

  [[nodiscard]] const Mesh& triangulation() const noexcept {
    return linear_.triangulation();
  }
  [[nodiscard]] const SurfaceOptions& options() const noexcept {
    return linear_.options();
  }
  [[nodiscard]] const BarrierReach<Space>& reach() const noexcept {
    return linear_.reach();
  }
  [[nodiscard]] double scale() const noexcept { return linear_.scale(); }
  [[nodiscard]] Vector scaled(Point p) const noexcept { return linear_.scaled(p); }

  [[nodiscard]] double value(const Point& p, Cursor& cursor) const;
  [[nodiscard]] SecondOrder derivatives(const Point& p, Cursor& cursor) const;

  // For scanning.

  [[nodiscard]] double site_value(Site s) const { return linear_.site_value(s); }
  [[nodiscard]] double edge_value(Site from, Site to, const Point& p) const;
  [[nodiscard]] Facet facet(Arc arc) const {
    return facet(triangulation().half_edge(arc));
  }
  [[nodiscard]] Facet facet(HalfEdge e) const;

 private:
  using Own = BlendFacet<Space, Degree>;
  using Model = BlendModel<Degree>;

  [[nodiscard]] std::vector<BlendFitOptions> fit_options(const WedgeGraph<Space>& graph,
                                                         const BarrierBlendOptions& blend,
                                                         const RunOptions& run) const;
  [[nodiscard]] BlendFitOptions part_options(std::span<const Wedge> data,
                                             const BarrierBlendOptions& blend,
                                             const RunOptions& run) const;
  void fit_models(const WedgeGraph<Space>& graph,
                  std::span<const BlendFitOptions> options, const RunOptions& run);
  void continue_values();
  void fit_humps(const WedgeGraph<Space>& graph,
                 std::span<const BlendFitOptions> options);
  [[nodiscard]] double continued(Wedge w) const;
  [[nodiscard]] bool has_data(Wedge w) const noexcept {
    return linear_.values().sources[at(w)].empty();
  }
  [[nodiscard]] bool is_shared(HalfEdge e) const noexcept;
  [[nodiscard]] Own own_facet(HalfEdge e) const;
  [[nodiscard]] Vector vector_of(Wedge w) const {
    return linear_.space().vector(triangulation().point_of(w));
  }

  BarrierLinearCells<Space> linear_;
  std::vector<Model> models_;  ///< of wedges
  std::vector<std::uint8_t> is_settled_;
  std::vector<EdgeHump> humps_;  ///< of half-edges, from the origin on
};

template <int Degree>
[[nodiscard]] std::vector<double> scan(const BarrierBlendCells<PlaneSpace, Degree>& cells,
                                       const Grid& grid, const RunOptions& run);
template <int Degree>
[[nodiscard]] std::vector<double> scan(
    const BarrierBlendCells<SphereSpace, Degree>& cells, const Grid& grid,
    const RunOptions& run);

}  // namespace delone::interp
