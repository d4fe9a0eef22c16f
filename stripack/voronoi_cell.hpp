#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stripack/back_faces.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/triangulation.hpp"

/// The pieces of Voronoi cells on the sphere. Internal: use stripack/voronoi.hpp.
namespace delone::stripack {

/// For every site all sites that share an edge of its cell, counter-clockwise all round:
/// for boundary sites those joined through the back included, for sites of one great
/// circle the next and the previous around it, also across the gap of an open chain.
class CellNeighbors {
 public:
  CellNeighbors(const Triangulation& t, const BackFaces& back);
  /// Fewer than two only if there are fewer than three sites.
  [[nodiscard]] std::span<const Site> operator()(Site s) const noexcept;

 private:
  const Adjacency* adjacency_;
  std::vector<std::int32_t> place_;  // of each site in own lists, or none
  std::vector<std::int32_t> offsets_{0};
  std::vector<Site> lists_;
};

/// The bisector of the frame's site and another, a great circle, as arcs along it from
/// its foot, the point nearest to the site.
class Bisector {
 public:
  explicit Bisector(const Spoke& spoke) noexcept;

  /// Cosine and sine of the arc from the foot to a point of the bisector, positive
  /// counter-clockwise as seen from the site.
  struct Place {
    double cos = 1, sin = 0;
  };
  [[nodiscard]] Place place(const LocalVector& c) const noexcept;
  [[nodiscard]] LocalVector point(Place place) const noexcept;

  /// Half the area between the site, the foot and a point of the bisector, as a complex
  /// number of that argument.
  struct HalfExcess {
    double re = 1, im = 0;
  };
  [[nodiscard]] HalfExcess half_excess(Place place) const noexcept;

  /// Perpendicular to the circle, on the site's side, of length 1.
  [[nodiscard]] LocalVector inward() const noexcept {
    return {sin_, -cos_ * east_, -cos_ * north_};
  }

 private:
  double cos_, sin_;     // of the distance to the foot
  double east_, north_;  // the direction to it
  double tan_half_;
};

/// Does the way from one place to another go through the point opposite to the foot?
/// Edges of cells are never longer than pi.
[[nodiscard]] bool passes_the_far_side(Bisector::Place from, Bisector::Place to) noexcept;
/// Length in radians, 0 to pi.
[[nodiscard]] double length_between(Bisector::Place from, Bisector::Place to) noexcept;

}  // namespace delone::stripack
