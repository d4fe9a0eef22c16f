#include "tripack/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/defect.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {
namespace {

using delaunay::none;
using support::PlanePoints;
using Rows = std::vector<Node>;
using Triangles = std::vector<std::array<Node, 3>>;
using Kind = Location::Kind;

// The example of J. Burkardt, Some Notes on Delaunay Triangulations (2005); rows from 0.
const PlanePoints diamond{{0, 0},     {0, 1},     {0.2, 0.5}, {0.3, 0.6}, {0.4, 0.5},
                          {0.6, 0.3}, {0.6, 0.5}, {1, 0},     {1, 1}};

template <class F>
PlanePoints mapped(PlanePoints points, F map) {
  for (Point2& p : points) p = map(p);
  return points;
}

double area(const PlanePoints& p, const std::array<Node, 3>& t) {
  const Point2 a = p[static_cast<std::size_t>(t[0])],
               b = p[static_cast<std::size_t>(t[1])],
               c = p[static_cast<std::size_t>(t[2])];
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

TEST(Diamond, HasItsTwelveTriangles) {
  const Triangles expected{{0, 2, 1}, {0, 5, 2}, {0, 7, 5}, {1, 2, 3},
                           {1, 3, 8}, {2, 4, 3}, {2, 5, 4}, {3, 4, 6},
                           {3, 6, 8}, {4, 5, 6}, {5, 7, 6}, {6, 7, 8}};
  EXPECT_EQ(Triangulation(diamond).triangles(), expected);
}

TEST(Diamond, HasItsCounts) {
  const Triangulation t(diamond);
  EXPECT_EQ(t.num_triangles(), 2 * 9 - 2 - 4);
  EXPECT_EQ(t.adjacency().num_arcs(), 2 * (3 * 9 - 3 - 4));
  EXPECT_EQ(t.boundary(), (Rows{0, 7, 8, 1}));
  EXPECT_EQ(t.dimension(), 2);
  EXPECT_EQ(t.num_rows(), 9);
  EXPECT_EQ(t.num_sites(), 9);
}

TEST(Diamond, HasItsAreas) {
  const std::array<double, 12> expected{1. / 10,   3. / 25,  3. / 20, 7. / 200,
                                        1. / 5,    1. / 100, 1. / 50, 1. / 100,
                                        19. / 200, 1. / 50,  1. / 25, 1. / 5};
  const Triangles triangles = Triangulation(diamond).triangles();
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(area(diamond, triangles[i]), expected[i], 1e-16);
}

// Boundary lists run from one boundary neighbour to the other; interior ones are compared
// as rings.
TEST(Diamond, HasItsAdjacencyLists) {
  const Triangulation t(diamond);
  const std::vector<Rows> expected{{7, 5, 2, 1},    {0, 2, 3, 8}, {0, 5, 4, 3, 1},
                                   {1, 2, 4, 6, 8}, {2, 5, 6, 3}, {0, 7, 6, 4, 2},
                                   {3, 4, 5, 7, 8}, {8, 6, 5, 0}, {1, 3, 6, 7}};
  for (Node row = 0; row < 9; ++row) {
    Rows ring = t.neighbors(row);
    const Rows& want = expected[static_cast<std::size_t>(row)];
    const bool is_interior = row > 1 && row < 7;
    if (is_interior) {
      const auto start = std::find(ring.begin(), ring.end(), want[0]);
      std::rotate(ring.begin(), start, ring.end());
    }
    EXPECT_EQ(ring, want) << "row " << row;
  }
}

TEST(Triangulation, OfNothingIsEmpty) {
  const Triangulation t{PlanePoints{}};
  EXPECT_EQ(t.dimension(), -1);
  EXPECT_EQ(t.num_sites(), 0);
  EXPECT_TRUE(t.triangles().empty());
  EXPECT_TRUE(t.boundary().empty());
  EXPECT_EQ(t.nearest({1, 2}), none);
  EXPECT_EQ(t.locate({1, 2}).kind, Kind::outside);
  EXPECT_EQ(t.find({1, 2}), Arc{});
}

TEST(Triangulation, OfOnePositionIsOneSite) {
  const Triangulation t(PlanePoints(5, {3, 4}));
  EXPECT_EQ(t.dimension(), 0);
  EXPECT_EQ(t.num_sites(), 1);
  EXPECT_EQ(t.num_rows(), 5);
  EXPECT_EQ(t.nearest({100, 0}), 0);
  EXPECT_EQ(t.locate({3, 4}).kind, Kind::node);
  EXPECT_EQ(t.locate({3, 4}).nodes[0], 0);
  EXPECT_EQ(t.locate({3, 5}).kind, Kind::outside);
  EXPECT_EQ(t.boundary(), Rows{0});
  EXPECT_TRUE(t.neighbors(3).empty());
}

TEST(Triangulation, OfCollinearPointsIsAChain) {
  const Triangulation t(PlanePoints{{4, 8}, {0, 0}, {3, 6}, {1, 2}, {3, 6}});
  EXPECT_EQ(t.dimension(), 1);
  EXPECT_EQ(t.num_triangles(), 0);
  EXPECT_TRUE(t.triangles().empty());
  Rows chain = t.boundary();
  if (chain.front() != 1) std::reverse(chain.begin(), chain.end());
  EXPECT_EQ(chain, (Rows{1, 3, 2, 0}));
  EXPECT_EQ(t.neighbors(1), Rows{3});
  EXPECT_EQ(t.neighbors(4).size(), 2u);
  EXPECT_EQ(t.nearest({3.1, 6}), 2);
  EXPECT_EQ(t.locate({3, 6}).kind, Kind::node);
  EXPECT_EQ(t.locate({2, 4}).kind, Kind::edge);
  EXPECT_EQ(t.locate({2, 4.5}).kind, Kind::outside);
  EXPECT_EQ(t.locate({5, 10}).kind, Kind::outside);
}

TEST(Triangulation, MergesRepeatedPositions) {
  PlanePoints points = diamond;
  points.insert(points.end(), diamond.begin(), diamond.end());
  const Triangulation once(diamond), twice(points);
  EXPECT_EQ(twice.num_sites(), 9);
  EXPECT_EQ(twice.num_rows(), 18);
  EXPECT_EQ(twice.triangles(), once.triangles());
  for (Node row = 0; row < 9; ++row) {
    const auto i = static_cast<std::size_t>(row);
    EXPECT_EQ(twice.sites()[i], twice.sites()[i + 9]);
    EXPECT_EQ(twice.rows()[static_cast<std::size_t>(twice.sites()[i])], row);
    EXPECT_EQ(twice.neighbors(row + 9), twice.neighbors(row));
  }
}

TEST(Triangulation, TakesBothZerosForOnePosition) {
  const Triangulation t(
      PlanePoints{{0.0, 0.0}, {-0.0, 0.0}, {1, -0.0}, {1, 0.0}, {0.5, 1}});
  EXPECT_EQ(t.num_sites(), 3);
  EXPECT_EQ(t.triangles(), (Triangles{{0, 2, 4}}));
}

TEST(Triangulation, NamesTheRowOfACoordinateThatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    for (const Point2 p : {Point2{bad, 1}, Point2{1, bad}}) {
      PlanePoints points = diamond;
      points.insert(points.begin() + 6, p);
      try {
        const Triangulation t(points);
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        ASSERT_FALSE(error.rows().empty());
        EXPECT_EQ(error.rows()[0], 6);
        EXPECT_NE(std::string(error.what()).find("6"), std::string::npos);
      }
    }
  }
}

TEST(Triangulation, IsTheOneOfTheDefinitionWithPerturbedTies) {
  support::SplitMix64 random(21);
  for (int trial = 0; trial < 300; ++trial) {
    PlanePoints points;
    while (points.size() < 9) {
      const Point2 p{static_cast<double>(random.below(5)),
                     static_cast<double>(random.below(5))};
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    Triangles expected;
    for (const auto& t :
         support::empty_circle_triangles(std::span<const Point2>(points))) {
      const auto at = [&](Node i) { return points[static_cast<std::size_t>(i)]; };
      const auto is_empty_of = [&](const Point2& p) {
        return p == at(t[0]) || p == at(t[1]) || p == at(t[2]) ||
               in_circle_perturbed(at(t[0]), at(t[1]), at(t[2]), p) < 0;
      };
      if (std::all_of(points.begin(), points.end(), is_empty_of)) expected.push_back(t);
    }
    ASSERT_EQ(Triangulation(points).triangles(), expected) << "trial " << trial;
  }
}

// Every set of k points of a small lattice: all the ties and collinearities there are.
TEST(Triangulation, IsRightForEverySubsetOfASmallLattice) {
  int num_sets = 0;
  for (unsigned subset = 0; subset < (1u << 12); ++subset) {
    PlanePoints points;
    for (unsigned i = 0; i < 12; ++i) {
      if (subset >> i & 1u)
        points.push_back({static_cast<double>(i % 4), static_cast<double>(i / 4)});
    }
    if (points.size() > 8) continue;
    ++num_sets;
    const Triangulation t(points);
    ASSERT_EQ(find_defect(t).value_or("none"), "none") << "subset " << subset;
    ASSERT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  }
  EXPECT_EQ(num_sets, 4096 - 220 - 66 - 12 - 1);
}

TEST(Triangulation, ListsTrianglesInCanonicalForm) {
  const Triangles triangles = Triangulation(support::uniform_points(500, 3)).triangles();
  EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end()));
  for (const auto& t : triangles) EXPECT_LT(t[0], std::min(t[1], t[2]));
}

TEST(Triangulation, DoesNotChangeUnderScalingByPowersOfTwo) {
  for (const auto& family :
       {support::lattice_points(100), support::uniform_points(200, 4),
        support::integer_circle_points(60)}) {
    const Triangles triangles = Triangulation(family).triangles();
    for (const int exponent : {-900, -100, -1, 1, 60, 900}) {
      const auto scaled = mapped(family, [&](Point2 p) {
        return Point2{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      });
      EXPECT_EQ(Triangulation(scaled).triangles(), triangles) << "2^" << exponent;
    }
  }
}

TEST(Triangulation, DoesNotChangeUnderExactTranslation) {
  const PlanePoints points = support::shuffled(support::lattice_points(150), 2);
  const auto moved = mapped(points, [](Point2 p) {
    return Point2{p.x + 0x1p40, p.y - 0x1p50};
  });
  EXPECT_EQ(Triangulation(moved).triangles(), Triangulation(points).triangles());
}

// Where there are no ties the triangulation is unique, so it turns and mirrors with the
// points.
TEST(Triangulation, TurnsAndMirrorsWithPointsInGeneralPosition) {
  const auto canonical = [](Triangles triangles, bool is_mirrored) {
    for (auto& t : triangles) {
      if (is_mirrored) std::swap(t[1], t[2]);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  for (const PlanePoints& points :
       {support::uniform_points(400, 6), support::clustered_points(400, 7)}) {
    const Triangles triangles = Triangulation(points).triangles();
    const auto negated = mapped(points, [](Point2 p) { return Point2{-p.x, -p.y}; });
    const auto turned = mapped(points, [](Point2 p) { return Point2{-p.y, p.x}; });
    const auto swapped = mapped(points, [](Point2 p) { return Point2{p.y, p.x}; });
    const auto mirrored = mapped(points, [](Point2 p) { return Point2{-p.x, p.y}; });
    EXPECT_EQ(Triangulation(negated).triangles(), triangles);
    EXPECT_EQ(Triangulation(turned).triangles(), triangles);
    EXPECT_EQ(canonical(Triangulation(swapped).triangles(), true), triangles);
    EXPECT_EQ(canonical(Triangulation(mirrored).triangles(), true), triangles);
  }
}

TEST(Triangulation, DoesNotDependOnTheNumberOfThreads) {
  const PlanePoints points = support::clustered_points(20000, 8);
  const Triangulation one(points, {.num_threads = 1, .progress = {}});
  for (const int num_threads : {2, 3, 8}) {
    const Triangulation many(points, {.num_threads = num_threads, .progress = {}});
    EXPECT_TRUE(many.adjacency() == one.adjacency()) << num_threads;
    EXPECT_TRUE(std::equal(many.rows().begin(), many.rows().end(), one.rows().begin()));
  }
}

// A hub has more neighbours than a byte can count.
TEST(Triangulation, FindsReverseArcsOfHubs) {
  const Triangulation t(support::wheel_points(1001));
  const Site hub = t.sites()[1000];
  const auto& adjacency = t.adjacency();
  ASSERT_EQ(adjacency.degree(hub), 1000);
  Arc a = adjacency.first_arc(hub);
  for (int i = 0; i < 1000; ++i, a = adjacency.next(a)) {
    const Arc back = adjacency.reverse(a);
    EXPECT_EQ(adjacency.target(back), hub);
    EXPECT_EQ(adjacency.reverse(back), a);
  }
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
}

TEST(Triangulation, BoundaryIsTheHullWithThePointsOnItsEdges) {
  const Triangulation t(support::lattice_points(16));
  EXPECT_EQ(t.boundary(), (Rows{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}));
}

TEST(Triangulation, NeighborsAreThoseOfTheTriangles) {
  const PlanePoints points = support::clustered_points(300, 2);
  const Triangulation t(points);
  std::vector<Rows> expected(points.size());
  for (const auto& triangle : t.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
        expected[static_cast<std::size_t>(triangle[k])].push_back(triangle[other]);
      }
    }
  }
  for (Node row = 0; row < t.num_rows(); ++row) {
    Rows& want = expected[static_cast<std::size_t>(row)];
    std::sort(want.begin(), want.end());
    want.erase(std::unique(want.begin(), want.end()), want.end());
    Rows have = t.neighbors(row);
    std::sort(have.begin(), have.end());
    EXPECT_EQ(have, want) << "row " << row;
  }
}

TEST(Triangulation, GoesToRenkaListsAndBack) {
  for (const PlanePoints& points :
       {diamond, support::lattice_points(100), support::wheel_points(600)}) {
    const Triangulation t(points);
    const auto lists = to_renka(t.adjacency());
    EXPECT_EQ(lists.lnew - 1, t.adjacency().num_arcs());
    EXPECT_TRUE(from_renka(lists) == t.adjacency());
  }
}

}  // namespace
}  // namespace delone::tripack
