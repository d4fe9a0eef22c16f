#include "delaunay/polyhedron.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "delaunay/error.hpp"

namespace delone::delaunay {
namespace {

std::vector<Position> box(double x, double y, double z, double far) {
  std::vector<Position> corners;
  for (const double k : {0.0, 1.0}) {
    for (const double j : {0.0, 1.0}) {
      for (const double i : {0.0, 1.0})
        corners.push_back({far + i * x, far + j * y, far + k * z});
    }
  }
  return corners;
}

const std::vector<PolyhedronFace> box_faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

TEST(Polyhedron, BoxHasItsVolumeAndCentroid) {
  for (const double far : {0.0, 1024.0, 0x1p40}) {
    const auto corners = box(2, 3, 5, far);
    EXPECT_EQ(polyhedron_volume(corners, box_faces), 30);
    EXPECT_EQ(polyhedron_centroid(corners, box_faces),
              (Position{far + 1, far + 1.5, far + 2.5}));
  }
}

TEST(Polyhedron, FacesTurnedInwardsHaveANegativeVolume) {
  auto faces = box_faces;
  for (PolyhedronFace& face : faces) face = PolyhedronFace(face.rbegin(), face.rend());
  EXPECT_EQ(polyhedron_volume(box(1, 1, 1, 0), faces), -1);
}

TEST(Polyhedron, WithoutFacesHasNoCentroid) {
  EXPECT_EQ(polyhedron_volume(box(1, 1, 1, 0), {}), 0);
  EXPECT_TRUE(std::isnan(polyhedron_centroid(box(1, 1, 1, 0), {})[0]));
}

TEST(Polyhedron, NamesTheFaceWhoseCornerIsMissing) {
  const std::vector<PolyhedronFace> faces{{0, 1, 2}, {0, 1, 8}};
  try {
    (void)polyhedron_volume(box(1, 1, 1, 0), faces);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows()[0], 1);
  }
}

TEST(Circumsphere, OfACubesCornersIsTheCubes) {
  const Ball ball = tetrahedron_circumsphere({1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {1, 1, 3});
  EXPECT_EQ(ball.center, (Position{2, 2, 2}));
  EXPECT_NEAR(ball.radius, std::sqrt(3.0), 4e-16);
}

TEST(Circumsphere, OfAFlatTetrahedronHasNoCentre) {
  const Ball ball = tetrahedron_circumsphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0});
  EXPECT_TRUE(std::isnan(ball.center[0]));
  EXPECT_EQ(ball.radius, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace delone::delaunay
