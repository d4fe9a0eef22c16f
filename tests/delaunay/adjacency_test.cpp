#include "delaunay/adjacency.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/error.hpp"

namespace delone::delaunay {
namespace {

using Sites = std::vector<Site>;
using Offsets = std::vector<std::int32_t>;

// A square 0, 1, 2, 3 around its centre 4.
Adjacency square() {
  return {Offsets{0, 3, 6, 9, 12, 16},
          Sites{1, 4, 3, 2, 4, 0, 3, 4, 1, 0, 4, 2, 0, 1, 2, 3},
          {true, true, true, true, false}};
}
const std::vector<Node> rows{10, 11, 12, 13, 14};

// A fan of `n` triangles around site 0, closed: its hub has a list too long for a byte.
Adjacency wheel(Site n) {
  Offsets offsets{0, n};
  Sites neighbors;
  for (Site i = 1; i <= n; ++i) neighbors.push_back(i);
  for (Site i = 1; i <= n; ++i) {
    const Site after = i == n ? 1 : i + 1, before = i == 1 ? n : i - 1;
    neighbors.insert(neighbors.end(), {after, 0, before});
    offsets.push_back(static_cast<std::int32_t>(neighbors.size()));
  }
  std::vector<bool> is_boundary(static_cast<std::size_t>(n) + 1, true);
  is_boundary[0] = false;
  return {offsets, neighbors, is_boundary};
}

TEST(Adjacency, OfNothingHasNoSites) {
  EXPECT_EQ(Adjacency().num_sites(), 0);
  EXPECT_EQ(Adjacency().num_triangles(), 0);
}

TEST(Adjacency, CountsTriangles) {
  EXPECT_EQ(square().num_triangles(), 4);
  EXPECT_EQ(wheel(1000).num_triangles(), 1000);
}

TEST(Adjacency, VisitsEveryTriangleOnceSmallestSiteFirst) {
  const Adjacency a = square();
  std::vector<std::array<Site, 3>> triangles;
  a.for_each_triangle([&](Arc arc) { triangles.push_back(a.left(arc)); });
  EXPECT_EQ(triangles, (std::vector<std::array<Site, 3>>{
                           {0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}}));
}

TEST(Adjacency, LeadsFromEveryArcToItsReverse) {
  for (const Adjacency& a :
       {square(), wheel(254), wheel(255), wheel(256), wheel(257), wheel(2000)}) {
    for (Site v = 0; v < a.num_sites(); ++v) {
      Arc arc = a.first_arc(v);
      for (std::int32_t i = 0; i < a.degree(v); ++i, arc = a.next(arc)) {
        const Arc back = a.reverse(arc);
        ASSERT_EQ(back.origin, a.target(arc));
        ASSERT_EQ(a.target(back), v);
        ASSERT_EQ(a.reverse(back), arc);
        ASSERT_EQ(a.previous(a.next(arc)), arc);
      }
    }
  }
}

TEST(Adjacency, HasNothingOnTheLeftOfTheLastArcOfABoundarySite) {
  const Adjacency a = square();
  EXPECT_TRUE(a.has_left(a.first_arc(0)));
  EXPECT_FALSE(a.has_left(a.previous(a.first_arc(0))));
  EXPECT_TRUE(a.has_left(a.previous(a.first_arc(4))));
}

TEST(Adjacency, RefusesListsThatAreNotSymmetric) {
  EXPECT_THROW(Adjacency(Offsets{0, 1, 1}, Sites{1}, {true, true}), Error);
}

TEST(Adjacency, JoinsAChainWithoutTriangles) {
  const Adjacency open = Adjacency::chain(4, Adjacency::Chain::open);
  EXPECT_EQ(open.num_arcs(), 6);
  EXPECT_EQ(open.num_triangles(), 0);
  EXPECT_EQ(open.degree(0), 1);
  EXPECT_EQ(open.degree(3), 1);
  const Adjacency closed = Adjacency::chain(4, Adjacency::Chain::closed);
  EXPECT_EQ(closed.num_arcs(), 8);
  EXPECT_EQ(closed.num_triangles(), 0);
  for (const Adjacency& a : {open, closed}) {
    int num_triangles = 0;
    a.for_each_triangle([&](Arc) { ++num_triangles; });
    EXPECT_EQ(num_triangles, 0);
  }
  EXPECT_EQ(Adjacency::chain(0, Adjacency::Chain::open).num_sites(), 0);
  EXPECT_EQ(Adjacency::chain(1, Adjacency::Chain::open).num_arcs(), 0);
}

TEST(Renka, ListsAreCountedFromOneAndMarkTheBoundary) {
  const RenkaLists lists = to_renka(square());
  EXPECT_EQ(lists.list, (Sites{2, 5, -4, 3, 5, -1, 4, 5, -2, 1, 5, -3, 1, 2, 3, 4}));
  EXPECT_EQ(lists.lptr, (Sites{2, 3, 1, 5, 6, 4, 8, 9, 7, 11, 12, 10, 14, 15, 16, 13}));
  EXPECT_EQ(lists.lend, (Sites{3, 6, 9, 12, 16}));
  EXPECT_EQ(lists.lnew, 17);
}

TEST(Renka, ListsComeBackAsTheyWent) {
  for (const Adjacency& a : {square(), wheel(300)})
    EXPECT_TRUE(from_renka(to_renka(a)) == a);
}

// TRIPACK leaves the first neighbour of an interior node arbitrary.
TEST(Renka, AnyRotationOfAnInteriorListIsTheSame) {
  RenkaLists lists = to_renka(square());
  lists.lend[4] = 14;
  EXPECT_TRUE(from_renka(lists) == square());
}

TEST(Renka, PointersThatFormNoListsAreRefused) {
  const auto with = [](auto change) {
    RenkaLists lists = to_renka(square());
    change(lists);
    return lists;
  };
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.lptr[0] = 99; })), Error);
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.lptr[2] = 2; })), Error);
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.lend[0] = 0; })), Error);
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.lend[0] = 17; })), Error);
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.list[0] = 0; })), Error);
  EXPECT_THROW((void)from_renka(with([](RenkaLists& l) { l.list[0] = 6; })), Error);
}

TEST(RingDefect, IsNotFoundInGoodLists) {
  EXPECT_EQ(find_ring_defect(square(), rows), std::nullopt);
  EXPECT_EQ(find_euler_defect(square()), std::nullopt);
}

TEST(RingDefect, IsAnInteriorListThatDoesNotBeginWithItsSmallestNeighbor) {
  const Adjacency a(Offsets{0, 3, 6, 9, 12, 16},
                    Sites{1, 4, 3, 2, 4, 0, 3, 4, 1, 0, 4, 2, 1, 2, 3, 0},
                    {true, true, true, true, false});
  EXPECT_EQ(find_ring_defect(a, rows).value_or(""),
            "the list of row 14 does not begin with its smallest neighbour");
}

TEST(RingDefect, IsATriangleThatIsNotTheSameFromAllCorners) {
  const Adjacency a(Offsets{0, 3, 6, 9, 12, 16},
                    Sites{1, 4, 3, 2, 4, 0, 3, 4, 1, 0, 4, 2, 0, 2, 1, 3},
                    {true, true, true, true, false});
  EXPECT_NE(find_ring_defect(a, rows), std::nullopt);
}

TEST(RingDefect, IsABoundaryListThatBeginsInside) {
  const Adjacency a(Offsets{0, 3, 6, 9, 12, 16},
                    Sites{4, 3, 1, 2, 4, 0, 3, 4, 1, 0, 4, 2, 0, 1, 2, 3},
                    {true, true, true, true, false});
  EXPECT_NE(find_ring_defect(a, rows), std::nullopt);
}

TEST(RingDefect, IsABoundaryFlagTooFew) {
  const Adjacency a(Offsets{0, 3, 6, 9, 12, 16},
                    Sites{1, 4, 3, 2, 4, 0, 3, 4, 1, 0, 4, 2, 0, 1, 2, 3},
                    {false, true, true, true, false});
  EXPECT_NE(find_ring_defect(a, rows), std::nullopt);
}

TEST(RingDefect, IsALoneSite) {
  const Adjacency a(Offsets{0, 2, 4, 6, 6}, Sites{1, 2, 2, 0, 0, 1},
                    {true, true, true, false});
  EXPECT_EQ(find_ring_defect(a, rows).value_or(""), "row 13 is in no triangle");
}

TEST(MapDefect, IsARowWithoutASiteOrASiteWithoutARow) {
  using Map = std::vector<std::int32_t>;
  const auto defect = [](const Map& row_of_site, const Map& site_of_row) {
    return find_map_defect(row_of_site, site_of_row).value_or("");
  };
  EXPECT_EQ(defect({2, 0}, {1, 1, 0}), "");
  EXPECT_EQ(defect({2, 0}, {1, 2, 0}), "row 1 belongs to no site");
  EXPECT_EQ(defect({2, 0}, {1, -1, 0}), "row 1 belongs to no site");
  EXPECT_EQ(defect({2, 1}, {1, 1, 0}),
            "row 0 is the first of its position, but row 1 stands for it");
  EXPECT_EQ(defect({0, 1, 2}, {0, 1}), "site 2 stands for no row");
}

TEST(ChainDefect, IsANeighborThatIsNotNextInLine) {
  const Adjacency a = Adjacency::chain(4, Adjacency::Chain::open);
  EXPECT_EQ(find_chain_defect(a, Sites{0, 1, 2, 3}, Chain::open, rows), std::nullopt);
  EXPECT_EQ(find_chain_defect(a, Sites{3, 2, 1, 0}, Chain::open, rows), std::nullopt);
  EXPECT_NE(find_chain_defect(a, Sites{0, 1, 2, 3}, Chain::closed, rows), std::nullopt);
  EXPECT_EQ(find_chain_defect(a, Sites{0, 2, 1, 3}, Chain::open, rows).value_or(""),
            "row 10 is not joined to its neighbours along the chain");
}

}  // namespace
}  // namespace delone::delaunay
