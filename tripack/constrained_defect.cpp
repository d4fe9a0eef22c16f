#include "tripack/constrained_defect.hpp"

#include <vector>

#include "delaunay/constrained_check.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Positions of sites, as delaunay/defect.hpp and constrained_check.hpp want them.
class Plane {
 public:
  static constexpr const char* segment_name = "segment";

  explicit Plane(const ConstrainedTriangulation& t) : t_(t) {}
  [[nodiscard]] Point2 point(Site v) const { return t_.points()[at(v)]; }
  [[nodiscard]] Node row(Site v) const { return t_.rows()[at(v)]; }
  [[nodiscard]] Site ghost() const { return t_.infinity(); }
  [[nodiscard]] int orientation(Site v, Site w, Site x) const {
    return tripack::orientation(point(v), point(w), point(x));
  }
  [[nodiscard]] bool is_ahead(Site v, Site w, Site x) const {
    return lexicographically_less(point(v), point(w)) ==
           lexicographically_less(point(v), point(x));
  }
  [[nodiscard]] bool is_violated(Site v, Site w, Site x, Site y) const {
    return in_circle_perturbed(point(v), point(w), point(x), point(y)) > 0;
  }
  [[nodiscard]] bool is_in_place(const std::vector<Node>& path, std::size_t k) const {
    const Point2 a = t_.point(path.front()), b = t_.point(path.back());
    const Point2 p = t_.point(path[k - 1]), q = t_.point(path[k]);
    return tripack::orientation(a, b, q) == 0 &&
           lexicographically_less(p, q) == lexicographically_less(a, b);
  }

 private:
  const ConstrainedTriangulation& t_;
};

}  // namespace

std::optional<std::string> find_defect(const ConstrainedTriangulation& t) {
  return delaunay::find_constrained_defect(t, Plane(t));
}

}  // namespace delone::tripack
