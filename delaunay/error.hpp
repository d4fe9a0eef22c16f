#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace delone {

/// Input that breaks a contract. Thrown before any work is done.
///
/// `what()` is one line that names the mend; `rows()` holds the 0-based numbers of the
/// offending rows of the caller's arrays (at most a few; empty where no row is to blame).
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, std::vector<std::int64_t> rows = {});
  [[nodiscard]] std::span<const std::int64_t> rows() const noexcept { return rows_; }

 private:
  std::vector<std::int64_t> rows_;
};

/// A progress callback answered "stop". Nothing is left half done.
class Cancelled : public Error {
 public:
  Cancelled();
};

}  // namespace delone
