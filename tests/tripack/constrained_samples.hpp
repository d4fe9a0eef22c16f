#pragma once

#include <string>

#include "tripack/constrained_defect.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack::samples {

inline ConstraintOptions splitting(Domain domain = Domain::hull) {
  return {.domain = domain, .crossings = Crossings::split};
}

inline ConstraintOptions only(Domain domain) { return {.domain = domain}; }

inline std::string defect_of(const ConstrainedTriangulation& t) {
  return find_defect(t).value_or("none");
}

inline double twice_area(const ConstrainedTriangulation& t) {
  double sum = 0;
  for (const auto& [i, j, k] : t.triangles()) {
    const Point2 a = t.point(i), b = t.point(j), c = t.point(k);
    sum += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return sum;
}

}  // namespace delone::tripack::samples
