#include "tripack/constrained_list_defect.hpp"

#include "delaunay/constrained_list_check.hpp"
#include "tripack/constrained_sites.hpp"

namespace delone::tripack {

namespace {

/// Ties are left open.
class Plane : public ConstrainedSites {
 public:
  using ConstrainedSites::ConstrainedSites;

  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle(point(v), point(w), point(x), point(y)) > 0;
  }
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t,
                                       std::span<const std::array<Node, 3>> triangles) {
  return delaunay::find_constrained_list_defect(t, triangles, Plane(t));
}

}  // namespace delone::tripack
