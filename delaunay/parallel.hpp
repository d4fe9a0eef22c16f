#pragma once

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "delaunay/error.hpp"
#include "delaunay/options.hpp"

namespace delone::delaunay {

/// Threads that a call with these options uses: the number asked for, or one a core.
[[nodiscard]] inline int num_threads(const RunOptions& run) noexcept {
  if (run.num_threads > 0) return run.num_threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// A part of a fork-join loop's progress: the loop covers [begin, end] of the call's
/// 0..1.
struct ProgressSpan {
  double begin = 0, end = 1;
};

/// Calls `body(first, last)` for the pieces [0, chunk), [chunk, 2 chunk), ... of [0,
/// count), each once, on several threads, and returns when all are done.
///
/// The pieces do not depend on the number of threads; a body that writes only what
/// belongs to its piece therefore gives the same result for every number. Progress is
/// reported from the calling thread; when it asks to stop, no new piece is begun and
/// Cancelled is thrown. The first exception of a body is rethrown.
template <std::invocable<std::int64_t, std::int64_t> Body>
void parallel_chunks(std::int64_t count, std::int64_t chunk, const RunOptions& run,
                     Body body, ProgressSpan progress = {}) {
  const std::int64_t num_chunks = (count + chunk - 1) / chunk;
  std::atomic<std::int64_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&](auto after_chunk) {
    try {
      while (!stop) {
        const std::int64_t k = next.fetch_add(1);
        if (k >= num_chunks) return;
        body(k * chunk, std::min(count, (k + 1) * chunk));
        after_chunk(k + 1);
      }
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  };
  std::int64_t last_reported = 0;
  const auto report = [&](std::int64_t done) {
    if (!run.progress) return;
    last_reported = done;
    const double part = static_cast<double>(done) / static_cast<double>(num_chunks);
    if (!run.progress(progress.begin + (progress.end - progress.begin) * part))
      throw Cancelled();
  };
  {
    const auto helpers = std::min<std::int64_t>(num_threads(run), num_chunks) - 1;
    std::vector<std::jthread> threads;
    for (std::int64_t t = 0; t < helpers; ++t) {
      threads.emplace_back([&work] { work([](std::int64_t) {}); });
    }
    work(report);
  }
  if (failure) std::rethrow_exception(failure);
  if (last_reported < num_chunks)
    report(num_chunks);  // the last pieces were another thread's
}

}  // namespace delone::delaunay
