#include "tripack/constrained_defect.hpp"

#include <vector>

#include "delaunay/constrained_check.hpp"
#include "tripack/constrained_sites.hpp"

namespace delone::tripack {

namespace {

/// What delaunay/constrained_check.hpp wants.
class Plane : public ConstrainedSites {
 public:
  static constexpr const char* segment_name = "segment";

  using ConstrainedSites::ConstrainedSites;

  [[nodiscard]] Site ghost() const { return t_.infinity(); }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] bool is_in_place(const std::vector<Node>& path, std::size_t k) const {
    const Point2 a = t_.point(path.front()), b = t_.point(path.back());
    const Point2 p = t_.point(path[k - 1]), q = t_.point(path[k]);
    return tripack::orientation(a, b, q) == 0 &&
           lexicographically_less(p, q) == lexicographically_less(a, b);
  }
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  return delaunay::find_constrained_defect(t, Plane(t));
}

}  // namespace delone::tripack
