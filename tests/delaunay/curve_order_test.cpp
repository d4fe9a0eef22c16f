#include "delaunay/curve_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "support/random.hpp"

namespace delone::delaunay {
namespace {

// Keys of so many bits; few bits make many equal keys.
Buffer<KeyedRow> random_items(std::size_t size, int num_bits) {
  support::SplitMix64 random(size);
  Buffer<KeyedRow> items(size);
  for (std::size_t i = 0; i < size; ++i)
    items[i] = random.next() >> (64 - num_bits) << 32 | i;
  return items;
}

TEST(SortByKey, OrdersKeysAndKeepsRowsOfEqualKeysInOrder) {
  for (const std::size_t size : {0u, 1u, 2u, 47u, 48u, 100u, 2047u, 2048u, 70000u}) {
    for (const int num_bits : {1, 8, 17, 32}) {
      for (const int num_threads : {1, 3}) {
        Buffer<KeyedRow> items = random_items(size, num_bits), expected = items;
        std::stable_sort(expected.begin(), expected.end(),
                         [](KeyedRow a, KeyedRow b) { return a >> 32 < b >> 32; });
        sort_by_key(items, {.num_threads = num_threads, .progress = {}});
        EXPECT_EQ(items, expected) << size << " items, " << num_bits << " bits";
      }
    }
  }
}

}  // namespace
}  // namespace delone::delaunay
