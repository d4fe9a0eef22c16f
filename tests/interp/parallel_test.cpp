#include "delaunay/parallel.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

namespace delone::delaunay {
namespace {

TEST(ParallelChunks, CallsEveryPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    for (const std::int64_t count : {0, 1, 9, 10, 11, 1000}) {
      std::vector<int> calls(static_cast<std::size_t>(count));
      parallel_chunks(count, 10, {.num_threads = threads, .progress = {}},
                      [&](std::int64_t first, std::int64_t last) {
                        EXPECT_EQ(first % 10, 0);
                        EXPECT_LE(last - first, 10);
                        for (std::int64_t i = first; i < last; ++i)
                          ++calls[static_cast<std::size_t>(i)];
                      });
      EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), count);
      EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](int c) { return c == 1; }));
    }
  }
}

TEST(ParallelChunks, RethrowsTheExceptionOfABody) {
  const auto fail = [](std::int64_t first, std::int64_t) {
    if (first == 30) throw Error("piece 3");
  };
  for (const int threads : {1, 4}) {
    EXPECT_THROW(parallel_chunks(100, 10, {.num_threads = threads, .progress = {}}, fail),
                 Error);
  }
}

TEST(ParallelChunks, ReportsFromTheCallingThreadWithinItsSpan) {
  const auto caller = std::this_thread::get_id();
  double last = 0.25;
  const RunOptions run{.num_threads = 3, .progress = [&](double part) {
                         EXPECT_EQ(std::this_thread::get_id(), caller);
                         EXPECT_GE(part, 0.25);
                         EXPECT_LE(part, 0.75);
                         last = part;
                         return true;
                       }};
  parallel_chunks(1000, 1, run, [](std::int64_t, std::int64_t) {}, {0.25, 0.75});
  EXPECT_EQ(last, 0.75);
}

TEST(ParallelChunks, StopsWhenProgressSaysSo) {
  std::atomic<int> pieces{0};
  const RunOptions run{.num_threads = 1,
                       .progress = [](double part) { return part < 0.5; }};
  EXPECT_THROW(
      parallel_chunks(100, 1, run, [&](std::int64_t, std::int64_t) { ++pieces; }),
      Cancelled);
  EXPECT_EQ(pieces, 50);
}

TEST(ParallelChunks, UsesACoreEachUnlessTold) {
  EXPECT_EQ(num_threads({.num_threads = 3, .progress = {}}), 3);
  EXPECT_GE(num_threads({}), 1);
}

}  // namespace
}  // namespace delone::delaunay
