#pragma once

#include <functional>

namespace delone {

/// Called now and then with the fraction done, 0..1; returning false cancels the call, which then
/// throws `Cancelled`. Called from the calling thread only.
using Progress = std::function<bool(double fraction)>;

/// What every long call takes. Results never depend on these.
struct RunOptions {
  int num_threads = 0;  ///< 0: all cores
  Progress progress;    ///< empty: none
};

}  // namespace delone
