#include "stripack/constrained_list_defect.hpp"

#include <cmath>

#include "delaunay/constrained_list_check.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/measures.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

/// Positions of sites, as delaunay/defect.hpp wants them; ties are left open.
class Sphere {
 public:
  explicit Sphere(const ConstrainedTriangulation& t) : t_(t) {}
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
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] double area(Site v, Site w, Site x) const {
    return std::abs(signed_area(point(v), point(w), point(x)));
  }

 private:
  const ConstrainedTriangulation& t_;
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t,
                                       std::span<const std::array<Node, 3>> triangles) {
  return delaunay::find_constrained_list_defect(t, triangles, Sphere(t));
}

}  // namespace delone::stripack
