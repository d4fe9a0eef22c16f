#include "tripack/constrained_list_defect.hpp"

#include "delaunay/constrained_list_check.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

/// Positions of sites, as delaunay/defect.hpp wants them; ties are left open.
class Plane {
 public:
  explicit Plane(const ConstrainedTriangulation& t) : t_(t) {}
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
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle(point(v), point(w), point(x), point(y)) > 0;
  }

 private:
  const ConstrainedTriangulation& t_;
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t,
                                       std::span<const std::array<Node, 3>> triangles) {
  return delaunay::find_constrained_list_defect(t, triangles, Plane(t));
}

}  // namespace delone::tripack
