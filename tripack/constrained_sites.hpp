#pragma once

#include "tripack/constrained_triangulation.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

/// Sites of a constrained triangulation, as delaunay/defect.hpp wants them; how ties are
/// judged is left to each check. Internal.
class ConstrainedSites {
 public:
  explicit ConstrainedSites(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] Point2 point(Site v) const {
    return t_.points()[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return tripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return lexicographically_less(point(v), point(w)) ==
           lexicographically_less(point(v), point(x));
  }

 protected:
  const ConstrainedTriangulation& t_;
};

}  // namespace delone::tripack
