#include "tripack/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/predicates.hpp"
#include "tripack/voronoi.hpp"

namespace delone::tripack {
namespace {

using support::PlaneFamily;
using support::PlanePoints;

// The example of J. Burkardt, Some Notes on Delaunay Triangulations (2005); rows from 0.
const PlanePoints diamond{{0, 0},     {0, 1},     {0.2, 0.5}, {0.3, 0.6}, {0.4, 0.5},
                          {0.6, 0.3}, {0.6, 0.5}, {1, 0},     {1, 1}};

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

Voronoi diagram(const PlanePoints& points) {
  return Voronoi(std::make_shared<const Triangulation>(points));
}

Site site(const Voronoi& v, Node row) { return v.triangulation().sites()[at(row)]; }

bool is_near(Point2 a, Point2 b, double tolerance) {
  return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

double sum_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double v : numbers) sum += v;
  return sum;
}

TEST(DiamondVoronoi, HasItsTwelveVertices) {
  const std::vector<Point2> expected{
      {-21. / 40, 1. / 2},    {23. / 80, 7. / 40}, {1. / 2, -1. / 4},
      {9. / 140, 103. / 140}, {1. / 2, 17. / 16},  {3. / 10, 1. / 2},
      {3. / 10, 1. / 5},      {1. / 2, 7. / 10},   {219. / 380, 353. / 380},
      {1. / 2, 2. / 5},       {79. / 80, 2. / 5},  {89. / 80, 1. / 2}};
  const Voronoi v = diagram(diamond);
  ASSERT_EQ(v.vertices().size(), 12U);
  for (const Point2 p : expected) {
    EXPECT_TRUE(std::any_of(v.vertices().begin(), v.vertices().end(),
                            [&](Point2 q) { return is_near(p, q, 4e-16); }))
        << p.x << " " << p.y;
  }
}

// The file of the example gives (0.3, 0.3) and (0.3, 0.6) for two of these; its text is
// right.
TEST(DiamondVoronoi, CellOfTheFifthPointIsAParallelogram) {
  const Voronoi v = diagram(diamond);
  Polygon cell = v.polygon(site(v, 4));
  ASSERT_EQ(cell.size(), 4U);
  const Polygon expected{{0.3, 0.2}, {0.5, 0.4}, {0.5, 0.7}, {0.3, 0.5}};
  const auto first = std::min_element(cell.begin(), cell.end(),
                                      [](Point2 a, Point2 b) { return a.y < b.y; });
  std::rotate(cell.begin(), first, cell.end());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(is_near(cell[i], expected[i], 4e-16));
}

TEST(DiamondVoronoi, HasItsAreasAndCentroids) {
  struct Known {
    Node row;
    double area;
    Point2 centroid;
  };
  const std::vector<Known> expected{
      {2, 5223. / 22400, {-23347. / 2924880, 137119. / 292488}},
      {3, 29781. / 212800, {4610113. / 13202910, 737619077. / 950609520}},
      {4, 3. / 50, {2. / 5, 9. / 20}},
      {5, 183. / 800, {25931. / 43920, 4717. / 29280}},
      {6, 2359. / 12160, {13173413. / 17928400, 1136077. / 1920900}}};
  const Triangulation t(diamond);
  const std::vector<CellMeasure> measures = voronoi_measures(t);
  for (const Known& known : expected) {
    const CellMeasure& cell = measures[at(t.sites()[at(known.row)])];
    EXPECT_NEAR(cell.area, known.area, 1e-15) << known.row;
    EXPECT_TRUE(is_near(cell.centroid, known.centroid, 2e-15)) << known.row;
  }
}

TEST(DiamondVoronoi, HasFourUnboundedCellsAndTheirRays) {
  const Voronoi v = diagram(diamond);
  const std::vector<std::pair<Node, std::array<Point2, 2>>> expected{
      {0, {{{0, -1}, {-1, 0}}}},
      {1, {{{-1, 0}, {0, 1}}}},
      {7, {{{1, 0}, {0, -1}}}},
      {8, {{{0, 1}, {1, 0}}}}};
  for (const auto& [row, rays] : expected) {
    EXPECT_FALSE(v.is_bounded(site(v, row)));
    EXPECT_EQ(v.rays(site(v, row)), rays) << row;
    EXPECT_TRUE(v.polygon(site(v, row)).empty());
  }
  for (const Node row : {2, 3, 4, 5, 6}) EXPECT_TRUE(v.is_bounded(site(v, row)));
  const std::vector<double> areas = voronoi_areas(v.triangulation());
  EXPECT_EQ(
      std::count(areas.begin(), areas.end(), std::numeric_limits<double>::infinity()), 4);
}

TEST(DiamondVoronoi, FillsTheUnitSquare) {
  const Triangulation t(diamond);
  EXPECT_NEAR(sum_of(voronoi_areas(t, Region::box({0, 0}, {1, 1}))), 1, 4e-16);
}

TEST(OkabesFormula, NeedsNothingButTheNeighbors) {
  const PlanePoints neighbors{diamond[2], diamond[5], diamond[6], diamond[3]};
  const CellMeasure cell = voronoi_measure(diamond[4], neighbors);
  EXPECT_NEAR(cell.area, 3. / 50, 1e-16);
  EXPECT_TRUE(is_near(cell.centroid, {2. / 5, 9. / 20}, 2e-16));
  EXPECT_EQ(voronoi_polygon(diamond[4], neighbors).size(), 4U);
}

TEST(OkabesFormula, RefusesNeighborsThatDoNotGoRound) {
  const PlanePoints clockwise{diamond[3], diamond[6], diamond[5], diamond[2]};
  EXPECT_THROW((void)voronoi_polygon(diamond[4], clockwise), Error);
  const PlanePoints two{diamond[3], diamond[6]};
  EXPECT_THROW((void)voronoi_polygon(diamond[4], two), Error);
  try {
    (void)voronoi_polygon({0, 0}, PlanePoints{{1, 0}, {0, 1}, {-1, 0}, {-1, 1}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows()[0], 2);
  }
}

TEST(Voronoi, LatticeCellsHaveFourCorners) {
  const Voronoi v = diagram(support::lattice_points(100));
  EXPECT_EQ(v.vertices().size(), 81U);  // one for each square, not for each triangle
  for (Site s = 0; s < v.triangulation().num_sites(); ++s) {
    if (!v.is_bounded(s)) continue;
    EXPECT_EQ(v.cell(s).size(), 4U);
    EXPECT_EQ(signed_area(v.polygon(s)), 1);
  }
}

TEST(Voronoi, PointsOnOneCircleShareOneVertex) {
  const Voronoi v = diagram(support::integer_circle_points(108));
  ASSERT_EQ(v.vertices().size(), 1U);
  EXPECT_EQ(v.vertices()[0], (Point2{0, 0}));
  EXPECT_EQ(v.edges().size(), 108U);
}

TEST(Voronoi, NoPointsHaveNoCells) {
  const Voronoi v = diagram({});
  EXPECT_TRUE(v.vertices().empty());
  EXPECT_TRUE(v.edges().empty());
  EXPECT_TRUE(voronoi_areas(v.triangulation(), Region::box({0, 0}, {1, 1})).empty());
}

TEST(Voronoi, OnePointHasTheWholeRegion) {
  const Voronoi v = diagram({{5, 5}, {5, 5}});
  EXPECT_FALSE(v.is_bounded(0));
  EXPECT_TRUE(v.cell(0).empty());
  const Region region = Region::box({0, 0}, {2, 3});
  EXPECT_EQ(voronoi_areas(v.triangulation(), region), std::vector<double>{6});
  ASSERT_EQ(v.clipped(0, region).size(), 1U);
  EXPECT_EQ(v.clipped(0, region)[0], region.corners());
  EXPECT_EQ(voronoi_measures(v.triangulation(), region)[0].centroid, (Point2{1, 1.5}));
}

TEST(Voronoi, CollinearPointsHaveStrips) {
  const Voronoi v = diagram({{0, 0}, {3, 3}, {1, 1}, {2, 2}});
  const std::vector<double> areas =
      voronoi_areas(v.triangulation(), Region::box({0, 0}, {3, 3}));
  const auto area_of = [&](Node row) { return areas[at(site(v, row))]; };
  EXPECT_NEAR(area_of(0), 0.5, 1e-15);
  EXPECT_NEAR(area_of(1), 0.5, 1e-15);
  EXPECT_NEAR(area_of(2), 4, 1e-15);
  EXPECT_NEAR(area_of(3), 4, 1e-15);
  const std::vector<VoronoiEdge> edges = v.edges();
  ASSERT_EQ(edges.size(), 3U);
  for (const VoronoiEdge& edge : edges) {
    EXPECT_EQ(edge.vertices, (std::array{delaunay::none, delaunay::none}));
    EXPECT_EQ(edge.direction, (Point2{-1, 1}));
  }
}

TEST(Voronoi, SiteInsideAHullEdgeHasParallelRays) {
  const Voronoi v = diagram({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  const auto rays = v.rays(site(v, 1));
  EXPECT_EQ(rays[0], (Point2{0, -1}));
  EXPECT_EQ(rays[1], (Point2{0, -1}));
  const std::vector<Polygon> cell = v.clipped(site(v, 1), Region::box({-5, -7}, {5, 7}));
  ASSERT_EQ(cell.size(), 1U);
  EXPECT_NEAR(signed_area(cell[0]), 7.5, 1e-14);
}

TEST(Voronoi, EdgesHaveTheirCellsOnTheirSides) {
  const Voronoi v = diagram(support::uniform_points(200, 3));
  const auto points = v.triangulation().points();
  for (const VoronoiEdge& edge : v.edges()) {
    const Point2 a = points[at(edge.sites[0])], b = points[at(edge.sites[1])];
    EXPECT_GT(edge.direction.x * (a.y - b.y) - edge.direction.y * (a.x - b.x), 0);
    if (edge.vertices[0] == delaunay::none || edge.vertices[1] == delaunay::none)
      continue;
    const Point2 from = v.vertices()[at(edge.vertices[0])],
                 to = v.vertices()[at(edge.vertices[1])];
    EXPECT_GT(edge.direction.x * (to.x - from.x) + edge.direction.y * (to.y - from.y), 0);
  }
}

TEST(Voronoi, DoesNotDependOnThreads) {
  const PlanePoints points = support::clustered_points(20000, 5);
  const Triangulation t(points);
  const Region region = Region::box({0.1, 0.2}, {0.9, 0.7});
  const RunOptions one{.num_threads = 1, .progress = {}},
      four{.num_threads = 4, .progress = {}};
  EXPECT_EQ(voronoi_areas(t, region, one), voronoi_areas(t, region, four));
}

TEST(Voronoi, CanBeCancelled) {
  const Triangulation t(support::uniform_points(20000, 5));
  const RunOptions stop{.num_threads = 2, .progress = [](double) { return false; }};
  EXPECT_THROW((void)voronoi_areas(t, {}, stop), Cancelled);
}

TEST(VoronoiAreas, OfAlmostCollinearPointsAreThoseOfStrips) {
  // Three almost collinear points: a circumcentre 1e17 away, cells that are strips.
  const PlanePoints points{{0, 0}, {1, 1e-17}, {2, 0}};
  const Triangulation t(points);
  ASSERT_EQ(t.dimension(), 2);
  const std::vector<double> areas = voronoi_areas(t, Region::box({-1, -1}, {3, 1}));
  EXPECT_NEAR(areas[at(t.sites()[0])], 3, 1e-15);
  EXPECT_NEAR(areas[at(t.sites()[1])], 2, 1e-15);
  EXPECT_NEAR(areas[at(t.sites()[2])], 3, 1e-15);
}

// Oracle: the region cut by the bisectors with all other sites.
double brute_force_area(std::span<const Point2> sites, std::size_t s, Polygon region) {
  for (std::size_t w = 0; w < sites.size() && !region.empty(); ++w) {
    if (w == s) continue;
    const Point2 a = sites[s], b = sites[w];
    const auto excess = [&](Point2 p) {
      return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y) -
             ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) / 2;
    };
    Polygon kept;  // as Sutherland and Hodgman do it
    for (std::size_t i = 0; i < region.size(); ++i) {
      const Point2 p = region[i], q = region[(i + 1) % region.size()];
      const double u = excess(p), v = excess(q);
      if (u <= 0) kept.push_back(p);
      if ((u <= 0) != (v <= 0))
        kept.push_back(
            {p.x + (q.x - p.x) * u / (u - v), p.y + (q.y - p.y) * u / (u - v)});
    }
    region = kept;
  }
  return signed_area(region);
}

struct Bounds {
  Point2 low, high;
  double width = 0;
};

Bounds bounds_of(const PlanePoints& points) {
  Bounds b{points[0], points[0], 0};
  for (const Point2 p : points) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y)};
  }
  b.width = std::max(b.high.x - b.low.x, b.high.y - b.low.y);
  return b;
}

// Where squares neither overflow nor underflow, and the box is not lost in the rounding
// of coordinates.
bool is_measurable(const Bounds& b) {
  const double largest = std::max(
      {std::abs(b.low.x), std::abs(b.low.y), std::abs(b.high.x), std::abs(b.high.y)});
  return b.width > 1e-100 && b.width < 1e100 && b.width > 1e-3 * largest;
}

class PlaneVoronoi : public testing::TestWithParam<PlaneFamily> {};

template <class F>
void for_each_measurable_set(const PlaneFamily& family, F check) {
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 7U, 12U, 40U, 300U}) {
    for (std::uint64_t seed = 1; seed <= (n < 20 ? 4 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const PlanePoints points = family.make(n, seed);
      if (points.empty()) continue;  // some families round their size down
      const Bounds b = bounds_of(points);
      if (is_measurable(b)) check(points, b);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST_P(PlaneVoronoi, AreasSumToTheClipBox) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds& b) {
    const Triangulation t(points);
    for (const double margin : {-0.25, 0.0, 0.1, 30.0}) {
      const double m = margin * b.width;
      const Point2 low{b.low.x - m, b.low.y - m}, high{b.high.x + m, b.high.y + m};
      if (!(low.x < high.x) || !(low.y < high.y)) continue;
      const Region region = Region::box(low, high);
      EXPECT_NEAR(sum_of(voronoi_areas(t, region)) / region.area(), 1, 1e-12) << margin;
    }
  });
}

TEST_P(PlaneVoronoi, AreasSumToAPolygonThatIsNotConvex) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds& b) {
    const Triangulation t(points);
    const Point2 c{(b.low.x + b.high.x) / 2, (b.low.y + b.high.y) / 2};
    Polygon star;
    for (int i = 0; i < 14; ++i) {
      const double r = (i % 2 == 0 ? 0.6 : 0.2) * b.width, a = i * std::numbers::pi / 7;
      star.push_back({c.x + r * std::cos(a), c.y + r * std::sin(a)});
    }
    const Region region = Region::polygon(star);
    EXPECT_NEAR(sum_of(voronoi_areas(t, region)) / region.area(), 1, 1e-12);
  });
}

TEST_P(PlaneVoronoi, CellsAreWhatAllBisectorsLeave) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds& b) {
    if (points.size() > 40) return;
    const Triangulation t(points);
    const double m = 0.2 * b.width;
    const Region region =
        Region::box({b.low.x - m, b.low.y - m}, {b.high.x + m, b.high.y + m});
    const std::vector<double> areas = voronoi_areas(t, region);
    for (std::size_t s = 0; s < areas.size(); ++s) {
      EXPECT_NEAR(areas[s], brute_force_area(t.points(), s, region.corners()),
                  1e-12 * region.area());
    }
  });
}

TEST_P(PlaneVoronoi, ClippedCellsAreTheOnesMeasured) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds& b) {
    const Voronoi v = diagram(points);
    const double w = b.width;
    const Point2 c{(b.low.x + b.high.x) / 2, (b.low.y + b.high.y) / 2};
    // An L, the site in its notch's cell may fall into two parts.
    const Region region = Region::polygon(PlanePoints{{c.x - w, c.y - w},
                                                      {c.x + w, c.y - w},
                                                      {c.x + w, c.y - w / 3},
                                                      {c.x - w / 3, c.y - w / 4},
                                                      {c.x - w / 4, c.y + w},
                                                      {c.x - w, c.y + w}});
    const std::vector<CellMeasure> measures = voronoi_measures(v.triangulation(), region);
    for (Site s = 0; s < v.triangulation().num_sites(); ++s) {
      double area = 0;
      Point2 moment;
      for (const Polygon& part : v.clipped(s, region)) {
        const double a = signed_area(part);
        EXPECT_GE(a, -1e-14 * w * w);
        area += a;
        if (a == 0) continue;
        moment.x += a * centroid(part).x;
        moment.y += a * centroid(part).y;
      }
      const CellMeasure& m = measures[at(s)];
      EXPECT_NEAR(area, m.area, 1e-12 * w * w);
      if (m.area <= 1e-6 * w * w) continue;
      EXPECT_TRUE(is_near({moment.x / area, moment.y / area}, m.centroid, 1e-8 * w));
    }
  });
}

// Cells, edges and vertices of the closed diagram, whose rays meet at infinity.
TEST_P(PlaneVoronoi, SatisfiesEulersFormula) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds&) {
    const Voronoi v = diagram(points);
    if (v.triangulation().dimension() < 2) return;
    EXPECT_EQ(v.triangulation().num_sites() + static_cast<long>(v.vertices().size()) -
                  static_cast<long>(v.edges().size()),
              1);
  });
}

TEST_P(PlaneVoronoi, VerticesDoNotDependOnTheOrderOfPoints) {
  for_each_measurable_set(GetParam(), [](const PlanePoints& points, const Bounds&) {
    const Voronoi v = diagram(points), w = diagram(support::shuffled(points, 5));
    EXPECT_TRUE(std::equal(v.vertices().begin(), v.vertices().end(), w.vertices().begin(),
                           w.vertices().end()));
  });
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneVoronoi,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(Region, RefusesWhatEnclosesNothing) {
  EXPECT_THROW((void)Region::box({0, 0}, {0, 1}), Error);
  EXPECT_THROW((void)Region::box({0, 0}, {std::nan(""), 1}), Error);
  EXPECT_THROW((void)Region::polygon(Polygon{{0, 0}, {1, 1}}), Error);
  EXPECT_THROW((void)Region::polygon(Polygon{{0, 0}, {1, 1}, {2, 2}}), Error);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)Region::polygon(Polygon{{0, 0}, {1, 1}, {0, infinity}}), Error);
}

TEST(Region, NamesTheSidesThatCross) {
  try {
    (void)Region::polygon(Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 2U);
    EXPECT_EQ(error.rows()[0], 0);
    EXPECT_EQ(error.rows()[1], 2);
  }
}

TEST(Region, TakesEitherOrientation) {
  const Region region = Region::polygon(Polygon{{0, 0}, {0, 2}, {3, 0}});
  EXPECT_EQ(region.area(), 3);
}

TEST(Region, RelationIsNeverWrong) {
  support::SplitMix64 random(4);
  Polygon comb{{0, 0}, {10, 0}};
  for (int i = 10; i-- > 0;) {
    comb.push_back({i + 0.7, 5});
    comb.push_back({i + 0.3, 0.5});
  }
  comb.push_back({0, 6});
  const Region region = Region::polygon(comb);
  int certain = 0;
  for (int k = 0; k < 20000; ++k) {
    const Point2 low{random.between(-1, 11), random.between(-1, 7)};
    const double size = random.uniform() * random.uniform();
    const Point2 high{low.x + size, low.y + size};
    const Region::Relation relation = region.relation(low, high);
    if (relation == Region::Relation::crossing) continue;
    ++certain;
    const Point2 p{random.between(low.x, high.x), random.between(low.y, high.y)};
    EXPECT_EQ(relation == Region::Relation::inside, contains(comb, p));
  }
  EXPECT_GT(certain, 5000);
}

}  // namespace
}  // namespace delone::tripack
