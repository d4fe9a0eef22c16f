// Block means, medians and modes against their definitions.

#include "delaunay/block_reduce.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "support/random.hpp"

namespace delone::delaunay {
namespace {

using Numbers = std::vector<double>;

double reduced(std::vector<Weighted> numbers, BlockStatistic statistic) {
  return reduce(numbers, statistic);
}

TEST(Reduce, MeanIsWeightedAndOfEqualValuesExact) {
  EXPECT_EQ(reduced({{1, 3}, {5, 1}}, BlockStatistic::mean), 2);
  EXPECT_EQ(reduced({{0.1, 1}, {0.1, 0.3}, {0.1, 7}}, BlockStatistic::mean), 0.1);
  EXPECT_EQ(reduced({{1e308, 1}, {1e308, 1}}, BlockStatistic::mean), 1e308);
}

TEST(Reduce, MedianHasHalfOfTheWeightOnEitherSide) {
  EXPECT_EQ(reduced({{9, 1}, {1, 1}, {2, 1}}, BlockStatistic::median), 2);
  EXPECT_EQ(reduced({{9, 1}, {1, 1}, {2, 1}, {4, 1}}, BlockStatistic::median), 3);
  EXPECT_EQ(reduced({{9, 5}, {1, 1}, {2, 1}}, BlockStatistic::median), 9);
  // A whole weight is so many repeats.
  support::SplitMix64 random(3);
  for (int i = 0; i < 300; ++i) {
    std::vector<Weighted> weighted, repeated;
    for (std::size_t k = 0; k < 1 + random.below(6); ++k) {
      const double value = static_cast<double>(random.below(9));
      const std::size_t count = 1 + random.below(4);
      weighted.push_back({value, static_cast<double>(count)});
      for (std::size_t c = 0; c < count; ++c) repeated.push_back({value, 1});
    }
    EXPECT_EQ(reduced(weighted, BlockStatistic::median),
              reduced(repeated, BlockStatistic::median));
  }
}

TEST(Reduce, ModeIsTheMiddleOfTheShortestHalf) {
  const auto mode = [](const Numbers& values) {
    std::vector<Weighted> numbers;
    for (const double v : values) numbers.push_back({v, 1});
    return reduced(numbers, BlockStatistic::mode);
  };
  EXPECT_EQ(mode({0, 10, 10.5, 11, 20, 35}), 10.5);
  EXPECT_EQ(mode({7}), 7);
  EXPECT_EQ(mode({1, 2}), 1.5);  // either alone is half: their mean
  EXPECT_EQ(reduced({{0, 1}, {4, 1}, {5, 6}}, BlockStatistic::mode), 5);
  // Every window of half the numbers, looked at.
  support::SplitMix64 random(5);
  for (int i = 0; i < 300; ++i) {
    Numbers values(1 + random.below(9));
    for (double& v : values) v = static_cast<double>(random.below(40));
    std::ranges::sort(values);
    const std::size_t half = (values.size() + 1) / 2;
    double shortest = HUGE_VAL, sum = 0, count = 0;
    for (std::size_t k = 0; k + half <= values.size(); ++k)
      shortest = std::min(shortest, values[k + half - 1] - values[k]);
    for (std::size_t k = 0; k + half <= values.size(); ++k) {
      if (values[k + half - 1] - values[k] != shortest) continue;
      sum += (values[k + half - 1] + values[k]) / 2;
      ++count;
    }
    EXPECT_NEAR(mode(values), sum / count, 1e-12);
  }
}

struct Cloud {
  Numbers x, y, values, weights;
};

Cloud cloud(std::size_t n) {
  support::SplitMix64 random(7);
  Cloud c;
  for (std::size_t i = 0; i < n; ++i) {
    c.x.push_back(random.between(-3, 5));
    c.y.push_back(random.between(-3, 5));
    c.values.push_back(random.between(0, 1));
    c.weights.push_back(static_cast<double>(random.below(4)));
  }
  return c;
}

TEST(BlockReduce, GathersTheRowsOfEachBlock) {
  const Cloud c = cloud(400);
  std::map<std::pair<int, int>, std::vector<std::size_t>> expected;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    if (c.weights[i] > 0)
      expected[{std::floor(c.y[i]), std::floor(c.x[i] / 0.5)}].push_back(i);
  }
  const BlockOptions options{.dx = 0.5, .dy = 1};
  const Blocks blocks = block_reduce(c.x, c.y, c.values, c.weights, options);
  ASSERT_EQ(blocks.x.size(), expected.size());
  std::size_t b = 0;
  for (const auto& [block, rows] : expected) {
    double x = 0, value = 0, weight = 0;
    for (const std::size_t i : rows) {
      x += c.weights[i] * c.x[i];
      value += c.weights[i] * c.values[i];
      weight += c.weights[i];
    }
    EXPECT_NEAR(blocks.x[b], x / weight, 1e-13);
    EXPECT_NEAR(blocks.value[b], value / weight, 1e-13);
    EXPECT_EQ(blocks.weight[b], weight);
    EXPECT_EQ(blocks.count[b], std::ssize(rows));
    EXPECT_EQ(std::floor(blocks.y[b]), block.first);
    ++b;
  }
}

TEST(BlockReduce, DoesNotDependOnTheOrderOfRows) {
  const Cloud c = cloud(300);
  std::vector<std::size_t> order(c.x.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Cloud mixed;
  for (const std::size_t i : support::shuffled(order, 2)) {
    mixed.x.push_back(c.x[i]);
    mixed.y.push_back(c.y[i]);
    mixed.values.push_back(c.values[i]);
    mixed.weights.push_back(c.weights[i] / 3);
  }
  Cloud same = c;
  for (double& w : same.weights) w /= 3;
  for (const auto statistic :
       {BlockStatistic::mean, BlockStatistic::median, BlockStatistic::mode}) {
    const BlockOptions options{.dx = 1, .dy = 1, .statistic = statistic};
    const Blocks a = block_reduce(same.x, same.y, same.values, same.weights, options);
    const Blocks b = block_reduce(mixed.x, mixed.y, mixed.values, mixed.weights, options);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.weight, b.weight);
  }
}

TEST(BlockReduce, RegionLeavesOutWhatIsOutsideAndClosesItsLastBlocks) {
  const Numbers x{0, 1, 2, 2.5, -0.1, 1}, y{0, 1, 2, 1, 1, 2}, values{1, 2, 3, 4, 5, 6};
  BlockOptions options{.dx = 1, .dy = 1, .region = BlockRegion{0, 2, 0, 2}};
  options.position = BlockPosition::center;
  const Blocks blocks = block_reduce(x, y, values, {}, options);
  EXPECT_EQ(blocks.x, (Numbers{0.5, 1.5}));
  EXPECT_EQ(blocks.y, (Numbers{0.5, 1.5}));
  EXPECT_EQ(blocks.value[0], 1);
  EXPECT_DOUBLE_EQ(blocks.value[1], 11.0 / 3);
  EXPECT_EQ(blocks.count, (std::vector<std::int64_t>{1, 3}));
}

TEST(BlockReduce, TakesPointsWithoutValues) {
  const Numbers x{0.25, 0.75}, y{0, 0};
  const Blocks blocks = block_reduce(x, y, {}, {}, {.dx = 1, .dy = 1});
  EXPECT_EQ(blocks.x, (Numbers{0.5}));
  EXPECT_TRUE(blocks.value.empty());
  EXPECT_TRUE(block_reduce({}, {}, {}, {}, {.dx = 1, .dy = 1}).x.empty());
}

TEST(BlockReduce, RefusesWhatCannotBe) {
  const Numbers one{1}, two{1, 2}, bad{std::nan("")}, negative{-1};
  const BlockOptions good{.dx = 1, .dy = 1};
  const auto fails = [](auto... arguments) {
    EXPECT_THROW(static_cast<void>(block_reduce(arguments...)), Error);
  };
  const std::span<const double> none;
  fails(one, one, none, none, BlockOptions{.dx = 0, .dy = 1});
  fails(one, one, none, none, BlockOptions{.dx = 1, .dy = HUGE_VAL});
  fails(one, two, none, none, good);
  fails(one, one, two, none, good);
  fails(one, one, one, negative, good);
  fails(bad, one, none, none, good);
  fails(one, one, bad, none, good);
  fails(one, one, none, none, BlockOptions{.dx = 1e-300, .dy = 1});
  fails(one, one, none, none,
        BlockOptions{.dx = 1, .dy = 1, .region = BlockRegion{1, 1, 0, 2}});
}

}  // namespace
}  // namespace delone::delaunay
