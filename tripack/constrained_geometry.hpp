#pragma once

#include <span>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"
#include "delaunay/segment_cavity.hpp"
#include "tripack/predicate_filters.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

/// Sites of the plane as segments want them (delaunay::SegmentGeometry). Points may be
/// added while it is in use.
class SitePlane {
 public:
  using Site = delaunay::Site;

  explicit SitePlane(const delaunay::Buffer<Point2>& points) : points_(&points) {}

  [[nodiscard]] Point2 at(Site v) const noexcept {
    return (*points_)[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] int orientation(Site a, Site b, Site c) const noexcept {
    const int certain = orientation_filter(at(a), at(b), at(c));
    return certain != 0 ? certain : tripack::orientation(at(a), at(b), at(c));
  }
  [[nodiscard]] bool is_ahead(Site a, Site b, Site c) const noexcept {
    return lexicographically_less(at(a), at(b)) == lexicographically_less(at(a), at(c));
  }
  [[nodiscard]] bool is_inside(Site a, Site b, Site c, Site d) const noexcept {
    const int certain = in_circle_filter(at(a), at(b), at(c), at(d));
    return (certain != 0 ? certain : in_circle_perturbed(at(a), at(b), at(c), at(d))) > 0;
  }

  [[nodiscard]] delaunay::PartialTriangulation triangulate(
      std::span<const Site> sites) const;

 private:
  const delaunay::Buffer<Point2>* points_;
};

}  // namespace delone::tripack
