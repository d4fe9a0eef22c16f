#pragma once

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cli/settings.hpp"
#include "delaunay/options.hpp"

namespace delone::cli {

/// The phases that --timings tells apart.
enum class Phase : std::uint8_t { read, build, fit, evaluate, write };

/// What a run says on standard error, and how long its phases take.
class Reporter {
 public:
  using Clock = std::chrono::steady_clock;

  Reporter(const RunSettings& settings, Clock::time_point start)
      : settings_(settings), start_(start) {}

  /// One line, `delone: ...`; nothing with --quiet.
  template <class... Args>
  void say(fmt::format_string<Args...> format, Args&&... args) const {
    if (!settings_.is_quiet) print_line(fmt::format(format, std::forward<Args>(args)...));
  }

  /// Does `work` and adds its time to `phase`.
  template <class Work>
  decltype(auto) timed(Phase phase, Work&& work) {
    const Stopwatch stopwatch(seconds_[static_cast<std::size_t>(phase)]);
    return std::forward<Work>(work)();
  }

  /// Threads as asked for, and a progress bar called `label` that shows itself after a
  /// second if standard error is a terminal. The bar is wiped when the last copy of the
  /// options goes.
  [[nodiscard]] RunOptions run_options(std::string_view label) const;

  /// The number of points that --timings states.
  void count_points(std::int64_t num_points) noexcept { num_points_ = num_points; }

  /// The last line of a run with --timings; nothing without. It was asked for by name, so
  /// --quiet does not silence it.
  void print_timings() const;

 private:
  using Seconds = std::optional<double>;

  /// Adds the time between its construction and its end.
  class Stopwatch {
   public:
    explicit Stopwatch(Seconds& total) : total_(total) {}
    ~Stopwatch() { total_ = total_.value_or(0) + seconds_since(begin_); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

   private:
    Seconds& total_;
    Clock::time_point begin_ = Clock::now();
  };

  static double seconds_since(Clock::time_point begin);
  static void print_line(std::string_view text);

  RunSettings settings_;
  Clock::time_point start_;
  std::array<Seconds, 5> seconds_{};
  std::int64_t num_points_ = 0;
};

/// `text` on one line: control characters, which binary garbage brings into messages,
/// become '?'.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace delone::cli
