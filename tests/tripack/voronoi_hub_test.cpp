// Cells with very many neighbours, cut by a region.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/polygon_clip.hpp"
#include "tripack/voronoi.hpp"
#include "tripack/voronoi_cell.hpp"

namespace delone::tripack {
namespace {

using support::PlanePoints;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// A point and many around it, at distances between 1 and 1 + depth.
PlanePoints hub(int num_spokes, double depth, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  PlanePoints points{{0, 0}};
  for (int k = 0; k < num_spokes; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random.uniform()) / num_spokes,
                 r = 1 + depth * random.uniform();
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

Region star() {
  Polygon corners;
  for (int k = 0; k < 10; ++k) {
    const double angle = std::numbers::pi * k / 5, r = k % 2 == 0 ? 0.7 : 0.25;
    corners.push_back({0.05 + r * std::cos(angle), 0.02 + r * std::sin(angle)});
  }
  return Region::polygon(corners);
}

double area_of(const std::vector<Polygon>& parts) {
  double area = 0;
  for (const Polygon& part : parts) area += signed_area(part);
  return area;
}

// One neighbour after another, whatever their number.
double area_by_clips(const Triangulation& t, Site s, const Region& region) {
  const Point2 p = t.points()[at(s)];
  Polygon corners = region.corners();
  for (Point2& corner : corners) corner = {corner.x - p.x, corner.y - p.y};
  std::vector<Polygon> parts{corners};
  for (const Site w : t.adjacency().neighbors(s)) {
    const Point2 q = t.points()[at(w)];
    parts = clip(parts, nearer_to_origin({q.x - p.x, q.y - p.y}));
  }
  return area_of(parts);
}

std::vector<Region> regions() {
  return {Region::box({-0.4, -0.4}, {0.4, 0.4}),
          Region::box({-0.45, -2}, {3, 0.1}),
          Region::box({-0.01, -0.01}, {0.02, 0.01}),
          Region::box({0.3, 0.3}, {0.45, 0.9}),
          Region::box({0.6, 0.6}, {0.9, 0.9}),
          star(),
          Region::polygon(
              PlanePoints{{-1, -1}, {1, -1}, {1, 0}, {0.1, 0}, {0.1, 1}, {-1, 1}})};
}

TEST(VoronoiHub, CellCutByARegionIsWhatAllBisectorsLeave) {
  for (const double depth : {0.0, 1e-9, 1e-3, 0.3}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Triangulation t(hub(500, depth, seed));
      for (const Region& region : regions()) {
        for (Site s = 0; s < t.num_sites(); ++s) {
          if (t.adjacency().degree(s) < 32) continue;
          EXPECT_NEAR(area_of(cut_cell(t, s, region)), area_by_clips(t, s, region), 1e-14)
              << depth << " " << seed << " " << s;
        }
      }
    }
  }
}

// On an arc the hub is on the boundary, so its neighbours do not go all round.
TEST(VoronoiHub, OnTheBoundaryIsCutAsWell) {
  PlanePoints points{{0, 0}};
  for (int k = 0; k <= 300; ++k) {
    const double angle = std::numbers::pi * (0.1 + 0.6 * k / 300);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  const Triangulation t(points);
  const Site s = t.sites()[0];
  ASSERT_EQ(t.adjacency().degree(s), 301);
  ASSERT_TRUE(t.adjacency().is_boundary(s));
  for (const Region& region : regions())
    EXPECT_NEAR(area_of(cut_cell(t, s, region)), area_by_clips(t, s, region), 1e-14);
}

// A circle's points and its centre: sides of the cell are shorter than roundings of their
// places.
TEST(VoronoiHub, OfPointsUlpsApartIsCutAsWell) {
  PlanePoints points{{0, 0}};
  for (int k = 0; k < 400; ++k) {
    const double angle = 2 * std::numbers::pi * k / 400;
    points.push_back({std::cos(angle), std::sin(angle)});
    points.push_back({std::cos(angle + 4e-16), std::sin(angle + 4e-16)});
  }
  const Triangulation t(points);
  const Site s = t.sites()[0];
  for (const Region& region : regions())
    EXPECT_NEAR(area_of(cut_cell(t, s, region)), area_by_clips(t, s, region), 1e-13);
}

// One ring after the other would take 10^10 steps.
TEST(VoronoiHub, OfAHundredThousandSpokesIsCutInLinearTime) {
  const Triangulation t(hub(100000, 0, 3));
  const Region box = Region::box({-0.4, -0.4}, {0.4, 0.4});
  const std::vector<double> areas = voronoi_areas(t, box);
  double sum = 0;
  for (const double a : areas) sum += a;
  EXPECT_NEAR(sum / box.area(), 1, 1e-12);
  // Disc and square: four triangles to the square's sides, four sectors between them.
  const double half = std::acos(0.8),
               exact = 4 * (0.4 * 0.3 + (std::numbers::pi / 4 - half) * 0.25);
  EXPECT_NEAR(areas[at(t.sites()[0])], exact, 1e-8);
  const Voronoi v(std::make_shared<const Triangulation>(t));
  EXPECT_NEAR(area_of(v.clipped(t.sites()[0], box)), exact, 1e-8);
}

}  // namespace
}  // namespace delone::tripack
