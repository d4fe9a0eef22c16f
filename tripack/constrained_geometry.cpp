#include "tripack/constrained_geometry.hpp"

#include "tripack/triangulation.hpp"

namespace delone::tripack {

delaunay::PartialTriangulation SitePlane::triangulate(std::span<const Site> sites) const {
  return delaunay::triangulate_part<Triangulation>(sites,
                                                   [this](Site v) { return at(v); });
}

}  // namespace delone::tripack
