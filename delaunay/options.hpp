#pragma once

#include <cstdint>
#include <functional>

namespace delone {

/// Called now and then with the fraction done, 0..1; returning false cancels the call,
/// which then throws `Cancelled`. Called from the calling thread only.
using Progress = std::function<bool(double fraction)>;

/// What every long call takes. Results never depend on these.
struct RunOptions {
  int num_threads = 0;  ///< 0: all cores
  Progress progress;    ///< empty: none
};

/// Reports how far a loop of `total` steps has come, about every thousandth part.
class ProgressMeter {
 public:
  ProgressMeter(const Progress& progress, std::int64_t total)
      : progress_(progress),
        total_(total),
        stride_(total / 1000 + 1),
        next_(progress ? stride_ : total + 1) {}
  /// One step is done. Throws Cancelled if the callback says stop.
  void step() {
    if (++done_ >= next_) report();
  }

 private:
  void report();

  const Progress& progress_;
  std::int64_t total_, stride_, next_, done_ = 0;
};

}  // namespace delone
