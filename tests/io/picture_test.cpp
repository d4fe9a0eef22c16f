#include "io/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "io/picture_layers.hpp"
#include "io/picture_projection.hpp"

namespace delone::io {
namespace {

Mesh two_triangles(Mesh::Space space = Mesh::Space::plane) {
  return triangle_mesh(space, std::vector{0.0, 40.0, 40.0, 2.0},
                       std::vector{0.0, 0.0, 30.0, 30.0},
                       std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST(MakePicture, ShowsPointsAndTrianglesUnlessToldOtherwise) {
  const Picture picture = make_picture(two_triangles());
  EXPECT_EQ(picture.dots.size(), 4U);
  ASSERT_EQ(picture.layers.size(), 1U);
  EXPECT_EQ(picture.layers[0].lines.size(), 5U);
  EXPECT_TRUE(picture.labels.empty());
}

TEST(MakePicture, VoronoiEdgesCrossEverySideOnce) {
  ShownParts parts;
  parts.triangles = false;
  parts.voronoi = true;
  const Picture picture = make_picture(two_triangles(), parts);
  ASSERT_EQ(picture.layers.size(), 1U);
  // One edge between the two circumcentres, four rays.
  EXPECT_EQ(picture.layers[0].lines.size(), 5U);
  EXPECT_NEAR(picture.layers[0].lines[0][0][0], 20, 1e-12);
  EXPECT_NEAR(picture.layers[0].lines[0][0][1], 15, 1e-12);
}

TEST(MakePicture, RaysLeaveTheHull) {
  ShownParts parts;
  parts.triangles = false;
  parts.voronoi = true;
  const Picture picture = make_picture(two_triangles(), parts);
  // The side from (0, 0) to (40, 0): straight down from the circumcentre.
  const PictureLine& ray = picture.layers[0].lines[0];
  EXPECT_NEAR(ray[1][0], 20, 1e-9);
  EXPECT_LT(ray[1][1], -100);
}

TEST(MakePicture, RaysLeaveTheHullOfClockwiseTrianglesToo) {
  ShownParts parts;
  parts.triangles = false;
  parts.voronoi = true;
  const Mesh mesh =
      triangle_mesh(Mesh::Space::plane, std::vector{0.0, 40.0, 40.0},
                    std::vector{0.0, 0.0, 30.0}, std::vector<Triangle>{{0, 2, 1}});
  double lowest = 0;
  const Picture picture = make_picture(mesh, parts);
  for (const PictureLine& ray : picture.layers[0].lines)
    lowest = std::min(lowest, ray[1][1]);
  EXPECT_LT(lowest, -100);
}

TEST(MakePicture, CirclesGoThroughTheCorners) {
  ShownParts parts;
  parts.circles = true;
  const Picture picture = make_picture(two_triangles(), parts);
  for (const PicturePoint& p : picture.layers[0].lines[0])
    EXPECT_NEAR(std::hypot(p[0] - 20, p[1] - 15), 25, 1e-9);
}

TEST(MakePicture, GlobeCirclesAreAsFarFromTheirCentreAsTheCorners) {
  ShownParts parts;
  parts.circles = parts.spokes = true;
  const Picture picture = make_picture(two_triangles(Mesh::Space::globe), parts);
  const auto& circle = picture.layers[0].lines[0];
  const auto at = [](const PicturePoint& p) {
    return stripack::Direction::from({p[0], p[1]});
  };
  const PicturePoint centre = picture.layers[1].lines[0][1];
  for (const PicturePoint& p : circle)
    EXPECT_NEAR(angle(at(centre), at(p)), angle(at(centre), at({0, 0})), 1e-12);
}

TEST(MakePicture, TrianglesWithoutAreaHaveNoDual) {
  const Mesh flat =
      triangle_mesh(Mesh::Space::plane, std::vector{0.0, 1.0, 2.0},
                    std::vector{0.0, 0.0, 0.0}, std::vector<Triangle>{{0, 1, 2}});
  ShownParts parts;
  parts.voronoi = parts.circles = parts.spokes = true;
  const Picture picture = make_picture(flat, parts);
  EXPECT_TRUE(picture.layers[0].lines.empty());
}

TEST(MakePicture, NumbersNodesAndTrianglesFromTheBase) {
  ShownParts parts;
  parts.node_labels = parts.cell_labels = true;
  parts.base = 1;
  const Picture picture = make_picture(two_triangles(), parts);
  ASSERT_EQ(picture.labels.size(), 6U);
  EXPECT_EQ(picture.labels[0].text, "1");
  EXPECT_EQ(picture.labels[5].text, "2");
  EXPECT_EQ(picture.labels[5].kind, PictureLabel::Kind::cell);
}

class PictureFormats : public testing::TestWithParam<PictureFormat> {};

TEST_P(PictureFormats, DependOnTheArgumentsAlone) {
  ShownParts parts;
  parts.voronoi = parts.circles = parts.node_labels = true;
  for (const auto space : {Mesh::Space::plane, Mesh::Space::globe}) {
    const Picture picture = make_picture(two_triangles(space), parts);
    PictureOptions options;
    options.title = "two triangles";
    if (space == Mesh::Space::globe) options.view = stripack::LonLat{20, 15};
    const std::string bytes = render_picture(picture, options, GetParam());
    EXPECT_FALSE(bytes.empty());
    EXPECT_EQ(bytes, render_picture(picture, options, GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(All, PictureFormats,
                         testing::Values(PictureFormat::png, PictureFormat::svg,
                                         PictureFormat::pdf, PictureFormat::eps));

TEST(RenderPicture, TakesOnePointAndNone) {
  for (const auto space : {Mesh::Space::plane, Mesh::Space::globe}) {
    Picture picture;
    picture.space = space;
    EXPECT_FALSE(render_picture(picture, {}, PictureFormat::png).empty());
    picture.dots = {{3, 4}};
    EXPECT_FALSE(render_picture(picture, {}, PictureFormat::png).empty());
  }
}

TEST(RenderPicture, RefusesWhatCannotBeDrawn) {
  Picture picture;
  picture.dots = {{std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_THROW(static_cast<void>(render_picture(picture, {}, PictureFormat::png)), Error);
  picture.dots = {{1e308, 0}, {-1e308, 0}};
  EXPECT_THROW(static_cast<void>(render_picture(picture, {}, PictureFormat::png)), Error);
  picture.dots = {{0, 0}};
  PictureOptions options;
  options.window = PictureWindow{1, 1, 0, 1};
  EXPECT_THROW(static_cast<void>(render_picture(picture, options, PictureFormat::png)),
               Error);
}

constexpr CanvasBox unit_box{0, 0, 100, 100};

TEST(Projection, CutsLinesThatAreLongerThanAnyWindow) {
  const Projection plane(Projection::Kind::plane, {0, 0, 1, 1, false}, unit_box);
  const auto parts = plane.visible({{-1e300, 0.5}, {1e300, 0.5}, {1e300, 7}, {0.5, 0.5}});
  ASSERT_EQ(parts.size(), 2U);
  for (const CanvasLine& part : parts) {
    for (const CanvasPoint& p : part) {
      EXPECT_LE(std::abs(p.x - 50), 60);
      EXPECT_LE(std::abs(p.y - 50), 60);
    }
  }
}

TEST(Projection, DrawsAnArcOverTheDateLineOnBothSidesOfAMap) {
  const Projection map(Projection::Kind::map, {-180, -90, 180, 90, true}, unit_box);
  const auto parts = map.visible({{170, 10}, {-170, 10}});
  ASSERT_EQ(parts.size(), 2U);
  for (const CanvasLine& part : parts)
    for (const CanvasPoint& p : part) EXPECT_TRUE(p.x < 5 || p.x > 95) << p.x;
}

TEST(Projection, DrawsGreatCirclesAsCurves) {
  const Projection map(Projection::Kind::map, {-180, -90, 180, 90, true}, unit_box);
  const auto parts = map.visible({{-50, 45}, {50, 45}});
  ASSERT_EQ(parts.size(), 1U);
  // The arc's highest latitude: tan = tan(45) / cos(50).
  constexpr double degree = std::numbers::pi / 180;
  double top = 100;
  for (const CanvasPoint& p : parts[0]) top = std::min(top, p.y);
  const double latitude = std::atan(1 / std::cos(50 * degree)) / degree;
  EXPECT_NEAR(top, 100 * (90 - latitude) / 180, 0.05);
}

TEST(Projection, HidesTheFarSideOfTheGlobe) {
  const Projection globe({0, 0}, unit_box);
  EXPECT_FALSE(globe.place({120, 0}));
  ASSERT_TRUE(globe.place({0, 90}));
  EXPECT_NEAR(globe.place({0, 90})->y, 0, 1e-9);
  EXPECT_NEAR(globe.place({90, 0})->x, 100, 1e-9);
  EXPECT_TRUE(globe.visible({{100, 0}, {170, 10}}).empty());
  // A line that leaves ends on the rim.
  const auto parts = globe.visible({{0, 0}, {130, 20}});
  ASSERT_EQ(parts.size(), 1U);
  const CanvasPoint end = parts[0].back();
  EXPECT_NEAR(std::hypot(end.x - 50, end.y - 50), 50, 1e-9);
}

TEST(Projection, EndsForAnyPoints) {
  const Projection globe({10, 20}, unit_box);
  const Projection map(Projection::Kind::map, {-180, -90, 180, 90, true}, unit_box);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> lon(-6, 6), lat(-3, 3);
  for (int i = 0; i < 2000; ++i) {
    // Poles, repeated and opposite places among them.
    const PictureLine line = {{30.0 * lon(random), 30.0 * lat(random)},
                              {30.0 * lon(random), 30.0 * lat(random)},
                              {30.0 * lon(random), 30.0 * lat(random)}};
    for (const auto& parts : {globe.visible(line), map.visible(line)})
      for (const CanvasLine& part : parts)
        for (const CanvasPoint& p : part) ASSERT_TRUE(std::isfinite(p.x + p.y));
  }
}

}  // namespace
}  // namespace delone::io
