#pragma once

#include <span>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"
#include "delaunay/segment_cavity.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicate_filters.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

/// Sites of the sphere as segments want them (delaunay::SegmentGeometry). Points may be
/// added while it is in use.
class SiteSphere {
 public:
  using Site = delaunay::Site;

  explicit SiteSphere(const delaunay::Buffer<Direction>& points) : points_(&points) {}

  [[nodiscard]] const Direction& at(Site v) const noexcept {
    return (*points_)[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] int orientation(Site a, Site b, Site c) const noexcept {
    const int certain = orientation_filter(at(a), at(b), at(c));
    return certain != 0 ? certain : stripack::orientation(at(a), at(b), at(c));
  }
  /// On the half of the great circle that begins at a and goes towards b.
  [[nodiscard]] bool is_ahead(Site a, Site b, Site c) const noexcept {
    return b == c || is_inside_arc(at(a), at(b), at(c)) ||
           is_inside_arc(at(a), at(c), at(b));
  }
  [[nodiscard]] bool is_inside(Site a, Site b, Site c, Site d) const noexcept {
    const int certain = in_circle_filter(at(a), at(b), at(c), at(d));
    return (certain != 0 ? certain : in_circle_perturbed(at(a), at(b), at(c), at(d))) > 0;
  }

  [[nodiscard]] delaunay::PartialTriangulation triangulate(
      std::span<const Site> sites) const;

 private:
  const delaunay::Buffer<Direction>* points_;
};

}  // namespace delone::stripack
