#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// What every benchmark here needs: a clock, medians, memory.
namespace delone::bench {

/// Seconds that `run` takes by the clock on the wall, and of processor time over all
/// threads. On a busy machine the second is the one to compare.
struct Seconds {
  double wall = 0, cpu = 0;
};
[[nodiscard]] Seconds seconds(const std::function<void()>& run);

struct Spread {
  double min = 0, median = 0, max = 0;
};
/// Of at least one number.
[[nodiscard]] Spread spread(std::vector<double> numbers);

/// Resident memory of this process now, in bytes, and its peak since the last reset
/// (Linux).
[[nodiscard]] std::size_t resident_bytes();
[[nodiscard]] std::size_t peak_bytes();
void reset_peak_bytes();

/// What a build leaves behind.
struct Built {
  std::shared_ptr<void> kept;
  std::int64_t num_triangles = 0;
};
using Builder = std::function<Built()>;

struct Measurement {
  Spread seconds;          ///< of the repeated builds; the first one is left out
  double cpu_seconds = 0;  ///< median
  double peak_bytes = 0;   ///< of the first build, above what was there before it
  double kept_bytes = 0;   ///< what stays after it
  std::int64_t num_points = 0;
  std::int64_t num_triangles = 0;
  bool is_valid = false;
};

/// Builds once for memory, then `repeats` times for time, in a child process of its own,
/// so that one measurement finds no memory that another one left. `make` prepares the
/// input there.
struct Job {
  std::int64_t num_points = 0;
  Builder build;
};
[[nodiscard]] Measurement measure(const std::function<Job()>& make, int repeats);

}  // namespace delone::bench
