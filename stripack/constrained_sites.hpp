#pragma once

#include "stripack/constrained_triangulation.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

/// Sites of a constrained triangulation, as delaunay/defect.hpp wants them; how ties are
/// judged is left to each check. Internal.
class ConstrainedSites {
 public:
  explicit ConstrainedSites(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] const Direction& point(Site v) const {
    return t_.points()[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return stripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return is_inside_arc(point(v), point(w), point(x)) ||
           is_inside_arc(point(v), point(x), point(w));
  }

 protected:
  const ConstrainedTriangulation& t_;
};

}  // namespace delone::stripack
