#include "tripack/plane_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "support/plane_sets.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

using Portable = PlaneLanes<delaunay::Portable>;

// Everything that blocks can differ in: the arcs of every site, in order.
std::vector<std::vector<Site>> lists_of(const delaunay::EdgeRings& rings) {
  std::vector<std::vector<Site>> lists(rings.first.size());
  for (std::size_t v = 0; v < lists.size(); ++v) {
    std::int32_t e = rings.first[v];
    do {
      lists[v].push_back(rings.edges[static_cast<std::size_t>(e)].target);
      e = rings.edges[static_cast<std::size_t>(e)].next;
    } while (e != rings.first[v]);
  }
  return lists;
}

delaunay::EdgeRings block_of(const std::vector<Point2>& sites,
                             const delaunay::BlockWork<PlanePoints>& work) {
  // One block without keys: sites in exact order along the chart, cut in the middle.
  delaunay::EdgeRings rings;
  rings.edges.resize(6 * sites.size());
  rings.first.resize(sites.size());
  delaunay::SiteOrder order;
  order.keys.assign(sites.size(), 0);
  delaunay::EdgeSupply supply{0, static_cast<std::int32_t>(rings.edges.size())};
  work.build({sites.data(), 0}, {rings.edges.data(), rings.first.data()}, supply,
             delaunay::BlockKeys(order), 0, static_cast<Site>(sites.size()));
  return rings;
}

TEST(PlaneBuilder, AreTheSameForEveryInstructionSet) {
  if (plane_block_work().build == delaunay::BlockWorker<Portable>::work.build)
    GTEST_SKIP() << "this processor runs the portable version only";
  for (const std::size_t n : {4u, 5u, 50u, 3000u}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      std::vector<Point2> sites = support::uniform_points(n, seed);
      std::sort(sites.begin(), sites.end(), lexicographically_less);
      const auto best = block_of(sites, plane_block_work());
      const auto portable = block_of(sites, delaunay::BlockWorker<Portable>::work);
      EXPECT_EQ(lists_of(best), lists_of(portable)) << "n = " << n << ", seed = " << seed;
    }
  }
}

TEST(PlaneBuilder, AreTheSameForEveryInstructionSetOnDegenerateSets) {
  if (plane_block_work().build == delaunay::BlockWorker<Portable>::work.build)
    GTEST_SKIP() << "this processor runs the portable version only";
  for (const support::PlaneFamily& family : support::plane_families()) {
    std::vector<Point2> sites = family.make(400, 1);
    std::sort(sites.begin(), sites.end(), lexicographically_less);
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    if (sites.size() < 2) continue;
    const auto best = block_of(sites, plane_block_work());
    const auto portable = block_of(sites, delaunay::BlockWorker<Portable>::work);
    EXPECT_EQ(lists_of(best), lists_of(portable)) << family.name;
  }
}

TEST(PlaneBuilder, DoNotDependOnTheNumberOfThreads) {
  const auto points = support::uniform_points(30000, 7);
  const Triangulation one(points, {.num_threads = 1, .progress = {}});
  for (const int threads : {2, 3, 8}) {
    const Triangulation many(points, {.num_threads = threads, .progress = {}});
    EXPECT_TRUE(one.adjacency() == many.adjacency()) << threads << " threads";
    EXPECT_TRUE(std::equal(one.rows().begin(), one.rows().end(), many.rows().begin()));
  }
}

}  // namespace
}  // namespace delone::tripack
