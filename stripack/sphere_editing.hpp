#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/editable_surface.hpp"
#include "stripack/constrained_geometry.hpp"
#include "stripack/direction.hpp"
#include "stripack/predicates.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

/// The sphere for delaunay::EditableSet: the surface is the whole polyhedron, the faces
/// outside of a hemispherical set included. Once an arc has been forced, node 0 stands
/// for the outside, and a face with it lies outside a boundary arc.
struct SphereEditing {
  using Point = Direction;
  using Key = std::array<double, 3>;
  using Triangulation = stripack::Triangulation;
  using Segments = SiteSphere;
  static constexpr bool has_infinity = false;

  static bool sees(std::span<const Direction> points, const std::array<Site, 3>& corner,
                   const Direction& q) noexcept {
    if (corner[0] == 0 || corner[1] == 0 || corner[2] == 0)
      return is_beyond(points, corner, q);
    return in_circle_perturbed(point(points, corner[0]), point(points, corner[1]),
                               point(points, corner[2]), q) > 0;
  }
  static bool is_front(std::span<const Direction> points,
                       const std::array<Site, 3>& corner) noexcept {
    return orientation(point(points, corner[0]), point(points, corner[1]),
                       point(points, corner[2])) > 0;
  }
  static int side(const Direction& a, const Direction& b, const Direction& q) noexcept {
    return orientation(a, b, q);
  }
  static bool is_same(const Direction& p, const Direction& q) noexcept;
  static bool is_flat(std::span<const Direction> points,
                      std::span<const Site> nodes) noexcept;
  /// Rounded quotients: triples of one direction have the same whatever their length.
  static Key key(const Direction& d) noexcept;
  /// One direction may come as triples of lengths an ulp apart; the lowest stands for
  /// all.
  static bool is_preferred(const Direction& p, const Direction& q) noexcept;

  /// Is there one arc between two points?
  static bool has_arc(const Direction& p, const Direction& q) noexcept;

  /// The square that an octahedron unfolds to, for the index of places.
  class Chart {
   public:
    Chart(std::span<const Direction>, const Direction&) noexcept {}
    [[nodiscard]] static bool covers(const Direction&) noexcept { return true; }
    [[nodiscard]] static delaunay::Place place(const Direction& d) noexcept;
  };

  /// The neighbours of a node that goes. The perturbed predicate answers for every four.
  class Star {
   public:
    Star(std::span<const Direction> points, Site, std::span<const Site> rim);
    [[nodiscard]] bool sees(const std::array<Site, 3>& corner, Site q) const noexcept {
      return in_circle_perturbed(point(rim_, corner[0]), point(rim_, corner[1]),
                                 point(rim_, corner[2]), point(rim_, q)) > 0;
    }

   private:
    std::vector<Direction> rim_;
  };

 private:
  /// Does q see, across the boundary arc, the face of the arc and node 0? Between the
  /// ends of the arc it does.
  static bool is_beyond(std::span<const Direction> points,
                        const std::array<Site, 3>& corner, const Direction& q) noexcept;
  static const Direction& point(std::span<const Direction> points, Site v) noexcept {
    return points[static_cast<std::size_t>(v)];
  }
};

}  // namespace delone::stripack
