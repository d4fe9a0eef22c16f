#include "stripack/constrained_defect.hpp"

#include <vector>

#include "delaunay/constrained_check.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Positions of sites, as delaunay/defect.hpp and constrained_check.hpp want them.
class Sphere {
 public:
  static constexpr const char* segment_name = "arc";

  explicit Sphere(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] const Direction& point(Site v) const { return t_.points()[at(v)]; }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[at(v)]; }
  [[nodiscard]] Site ghost() const { return t_.ghost(); }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return stripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return is_inside_arc(point(v), point(w), point(x)) ||
           is_inside_arc(point(v), point(x), point(w));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] bool is_in_place(const std::vector<Node>& path, std::size_t k) const {
    if (k + 1 == path.size()) return true;  // the end of the arc itself
    const Direction &a = t_.point(path.front()), &b = t_.point(path.back());
    const Direction &p = t_.point(path[k - 1]), &q = t_.point(path[k]);
    return is_inside_arc(a, b, q) && (k == 1 || is_inside_arc(p, b, q));
  }

 private:
  const ConstrainedTriangulation& t_;
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  return delaunay::find_constrained_defect(t, Sphere(t));
}

}  // namespace delone::stripack
