#include "stripack/constrained_defect.hpp"

#include <vector>

#include "delaunay/constrained_check.hpp"
#include "stripack/constrained_sites.hpp"

namespace delone::stripack {

namespace {

/// What delaunay/constrained_check.hpp wants.
class Sphere : public ConstrainedSites {
 public:
  static constexpr const char* segment_name = "arc";

  using ConstrainedSites::ConstrainedSites;

  [[nodiscard]] Site ghost() const { return t_.ghost(); }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] bool is_in_place(const std::vector<Node>& path, std::size_t k) const {
    if (k + 1 == path.size()) return true;  // the end of the arc itself
    const Direction &a = t_.point(path.front()), &b = t_.point(path.back());
    const Direction &p = t_.point(path[k - 1]), &q = t_.point(path[k]);
    return is_inside_arc(a, b, q) && (k == 1 || is_inside_arc(p, b, q));
  }
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  return delaunay::find_constrained_defect(t, Sphere(t));
}

}  // namespace delone::stripack
