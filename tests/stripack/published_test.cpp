// Published results: R. J. Renka's driver of STRIPACK and J. Burkardt's STRIPACK_PRB2.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "stripack/triangulation.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SpherePoints;
using Triangles = std::vector<std::array<Node, 3>>;

// Solid angle of a triangle (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30
// (1983) 125-126).
double area(const Direction& a, const Direction& b, const Direction& c) {
  const auto dot = [](const Direction& p, const Direction& q) {
    return p.x() * q.x() + p.y() * q.y() + p.z() * q.z();
  };
  const double volume = a.x() * (b.y() * c.z() - b.z() * c.y()) +
                        a.y() * (b.z() * c.x() - b.x() * c.z()) +
                        a.z() * (b.x() * c.y() - b.y() * c.x());
  return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

// R. J. Renka, ACM Trans. Math. Softw. 23 (1997) 416-434 (Algorithm 772): the north pole
// and eight nodes at 60 degrees.
TEST(Algorithm772, HasRenkasCountsAndArea) {
  SpherePoints points{Direction::from(LonLat{0, 90})};
  for (int i = 0; i < 8; ++i) points.push_back(Direction::from(LonLat{45.0 * i, 60}));
  const Triangulation t(points);
  EXPECT_EQ(t.boundary().size(), 8u);
  EXPECT_EQ(t.adjacency().num_arcs() / 2, 16);
  ASSERT_EQ(t.num_triangles(), 8);
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles()) {
    EXPECT_EQ(a, 0);
    sum += area(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)],
                points[static_cast<std::size_t>(c)]);
  }
  EXPECT_NEAR(sum / (4 * std::numbers::pi), 0.0614689230, 1e-10);
}

// Ten random nodes, printed to six digits; the sixteen triangles as printed.
TEST(StripackPrb2, HasTheSixteenTrianglesPrinted) {
  const std::array<std::array<double, 3>, 10> nodes{{{0.915568, -0.257797, -0.308668},
                                                     {-0.171751, 0.901345, 0.397592},
                                                     {0.541822, 0.447986, -0.711152},
                                                     {-0.620052, -0.745456, 0.244603},
                                                     {0.0262807, -0.894727, 0.445840},
                                                     {0.0167158, -0.591520, 0.806117},
                                                     {0.987108, 0.0846611, 0.135834},
                                                     {-0.220974, 0.974193, 0.0460176},
                                                     {0.679580, -0.416543, -0.603873},
                                                     {0.936980, -0.0375368, 0.347361}}};
  SpherePoints points;
  for (const auto& v : nodes) points.push_back(Direction::from(v[0], v[1], v[2]));
  Triangles printed{{1, 7, 10}, {1, 10, 5}, {1, 5, 9},  {1, 9, 3}, {1, 3, 7}, {2, 8, 4},
                    {2, 4, 6},  {2, 6, 10}, {2, 10, 7}, {2, 7, 8}, {3, 9, 4}, {3, 4, 8},
                    {3, 8, 7},  {4, 9, 5},  {4, 5, 6},  {5, 10, 6}};
  for (auto& t : printed) {
    for (Node& v : t) --v;
  }
  std::sort(printed.begin(), printed.end());
  EXPECT_EQ(Triangulation(points).triangles(), printed);
}

}  // namespace
}  // namespace delone::stripack
