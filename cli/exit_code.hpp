#pragma once

#include <stdexcept>

namespace delone::cli {

/// What the program's exit status says.
enum class ExitCode : int {
  done = 0,
  check_failed = 1,  ///< a check that was asked for does not hold
  wrong_usage = 2,
  bad_input = 3,  ///< unreadable, malformed, too few points, out of memory
  cannot_write = 4
};

/// Arguments that make no sense; one line that names the option and the mend.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace delone::cli
