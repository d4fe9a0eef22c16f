#include "stripack/sphere_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "stripack/triangulation.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using Portable = SphereLanes<delaunay::Portable>;

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

delaunay::EdgeRings block_of(const std::vector<Direction>& sites,
                             const delaunay::BlockWork<SpherePoints>& work) {
  // One block without keys: sites in exact order along the chart, cut in the middle.
  delaunay::EdgeRings rings;
  rings.edges.resize(6 * sites.size());
  rings.first.resize(sites.size());
  delaunay::SiteOrder order;
  order.keys.assign(sites.size(), 0);
  delaunay::EdgeSupply supply{0, static_cast<std::int32_t>(rings.edges.size())};
  work.build({sites.data()}, {rings.edges.data(), rings.first.data()}, supply,
             delaunay::BlockKeys(order), 0, static_cast<Site>(sites.size()));
  return rings;
}

TEST(SphereBuilder, AreTheSameForEveryInstructionSet) {
  if (sphere_block_work().build == delaunay::BlockWorker<Portable>::work.build)
    GTEST_SKIP() << "this processor runs the portable version only";
  for (const std::size_t n : {4u, 5u, 50u, 3000u}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      std::vector<Direction> sites;
      for (const Direction& d : support::uniform_directions(8 * n, seed)) {
        const Octant o = octant_of(d);
        if (o.half == 0 && o.lune == 0) sites.push_back(d);
      }
      std::sort(sites.begin(), sites.end(),
                [](const Direction& a, const Direction& b) { return is_less_u(a, b); });
      const auto best = block_of(sites, sphere_block_work());
      const auto portable = block_of(sites, delaunay::BlockWorker<Portable>::work);
      EXPECT_EQ(lists_of(best), lists_of(portable)) << "n = " << n << ", seed = " << seed;
    }
  }
}

TEST(SphereBuilder, AreTheSameForEveryInstructionSetOnDegenerateSets) {
  if (sphere_block_work().build == delaunay::BlockWorker<Portable>::work.build)
    GTEST_SKIP() << "this processor runs the portable version only";
  for (const support::SphereFamily& family : support::sphere_families()) {
    std::vector<Direction> sites;
    for (const Direction& d : family.make(800, 1)) {
      const Octant o = octant_of(d);
      if (o.half == 0 && o.lune == 0) sites.push_back(d);
    }
    const auto is_before = [](const Direction& a, const Direction& b) {
      return is_less_u(a, b) || (!is_less_u(b, a) && is_less_v(a, b));
    };
    std::sort(sites.begin(), sites.end(), is_before);
    sites.erase(std::unique(sites.begin(), sites.end(),
                            [&](const Direction& a, const Direction& b) {
                              return !is_before(a, b) && !is_before(b, a);
                            }),
                sites.end());
    if (sites.size() < 2) continue;
    const auto best = block_of(sites, sphere_block_work());
    const auto portable = block_of(sites, delaunay::BlockWorker<Portable>::work);
    EXPECT_EQ(lists_of(best), lists_of(portable)) << family.name;
  }
}

TEST(SphereBuilder, DoNotDependOnTheNumberOfThreads) {
  const auto points = support::uniform_directions(30000, 7);
  const Triangulation one(points, {.num_threads = 1, .progress = {}});
  for (const int threads : {2, 3, 8}) {
    const Triangulation many(points, {.num_threads = threads, .progress = {}});
    EXPECT_TRUE(one.adjacency() == many.adjacency()) << threads << " threads";
    EXPECT_TRUE(std::equal(one.rows().begin(), one.rows().end(), many.rows().begin()));
  }
}

}  // namespace
}  // namespace delone::stripack
