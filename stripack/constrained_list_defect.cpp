#include "stripack/constrained_list_defect.hpp"

#include <cmath>

#include "delaunay/constrained_list_check.hpp"
#include "stripack/constrained_sites.hpp"
#include "stripack/measures.hpp"

namespace delone::stripack {

namespace {

/// Ties are left open.
class Sphere : public ConstrainedSites {
 public:
  using ConstrainedSites::ConstrainedSites;

  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] double area(Site v, Site w, Site x) const {
    return std::abs(signed_area(point(v), point(w), point(x)));
  }
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t,
                                       std::span<const std::array<Node, 3>> triangles) {
  return delaunay::find_constrained_list_defect(t, triangles, Sphere(t));
}

}  // namespace delone::stripack
