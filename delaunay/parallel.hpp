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

/// Numbers 0 .. count - 1, shared out among threads: each takes from a range of its own,
/// in order, and then what others have left of theirs. So threads keep away from one
/// another's memory: two that touch one page for the first time clear it twice.
class SharedNumbers {
 public:
  SharedNumbers(std::int64_t count, std::int64_t num_threads)
      : ranges_(static_cast<std::size_t>(num_threads)) {
    for (std::int64_t t = 0; t < num_threads; ++t) {
      Range& range = ranges_[static_cast<std::size_t>(t)];
      range.next = count * t / num_threads;
      range.end = count * (t + 1) / num_threads;
    }
  }

  /// The next number for a thread, or -1 if all are taken.
  std::int64_t take(std::size_t thread) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      Range& range = ranges_[(thread + i) % ranges_.size()];
      if (range.next.load(std::memory_order_relaxed) >= range.end) continue;
      const std::int64_t k = range.next.fetch_add(1);
      if (k < range.end) return k;
    }
    return -1;
  }

 private:
  struct alignas(64) Range {
    std::atomic<std::int64_t> next{0};
    std::int64_t end = 0;
  };
  std::vector<Range> ranges_;
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
  if (num_chunks <= 0) return;
  const auto num_workers = std::min<std::int64_t>(num_threads(run), num_chunks);
  SharedNumbers chunks(num_chunks, num_workers);
  std::atomic<std::int64_t> num_done{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&](std::int64_t worker, auto after_chunk) {
    try {
      while (!stop) {
        const std::int64_t k = chunks.take(static_cast<std::size_t>(worker));
        if (k < 0) return;
        body(k * chunk, std::min(count, (k + 1) * chunk));
        after_chunk(num_done.fetch_add(1) + 1);
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
    std::vector<std::jthread> threads;
    for (std::int64_t t = 1; t < num_workers; ++t) {
      threads.emplace_back([&work, t] { work(t, [](std::int64_t) {}); });
    }
    work(0, report);
  }
  if (failure) std::rethrow_exception(failure);
  if (last_reported < num_chunks)
    report(num_chunks);  // the last pieces were another thread's
}

}  // namespace delone::delaunay
