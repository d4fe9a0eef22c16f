// The sphere agrees with the plane: stereographic projection from a node maps circles
// through that node to lines and other circles to circles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "stripack/triangulation.hpp"
#include "support/exact.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

// Seen from the pole at z = 1 the plane is mirrored; x and y are exchanged to mend that.
tripack::Point2 project(const Direction& d) {
  return {d.y() / (1 - d.z()), d.x() / (1 - d.z())};
}

// Triangles of the sphere that do not have the pole as a corner are the Delaunay
// triangles of the projected points; the neighbours of the pole are their hull.
TEST(SphereTriangulation, AgreesWithThePlaneUnderStereographicProjection) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    auto points = support::uniform_directions(80, seed);
    std::vector<tripack::Point2> projected;
    for (const Direction& d : points) projected.push_back(project(d));
    points.push_back(Direction::from(LonLat{0, 90}));
    const auto pole = static_cast<Node>(points.size() - 1);
    const Triangulation t(points);
    auto triangles = t.triangles();
    std::erase_if(triangles, [&](const auto& corners) {
      return std::find(corners.begin(), corners.end(), pole) != corners.end();
    });
    EXPECT_EQ(support::exact_defect(projected, triangles).value_or("none"), "none")
        << "seed " << seed;
    EXPECT_EQ(triangles.size(), 2 * projected.size() - 2 - t.neighbors(pole).size());
  }
}

}  // namespace
}  // namespace delone::stripack
