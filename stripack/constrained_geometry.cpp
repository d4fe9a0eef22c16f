#include "stripack/constrained_geometry.hpp"

#include "stripack/triangulation.hpp"

namespace delone::stripack {

delaunay::PartialTriangulation SiteSphere::triangulate(
    std::span<const Site> sites) const {
  return delaunay::triangulate_part<Triangulation>(sites,
                                                   [this](Site v) { return at(v); });
}

}  // namespace delone::stripack
