#include "cli/reporter.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

namespace delone::cli {
namespace {

class ProgressBar {
 public:
  explicit ProgressBar(std::string_view label) : label_(label) {}
  ~ProgressBar() {
    if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction) {
    const auto now = Reporter::Clock::now();
    if (now - begin_ < std::chrono::seconds(1)) return;
    // Ten pictures a second are enough for an eye and cost nothing.
    if (is_shown_ && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    is_shown_ = true;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %", label_, "", filled, "",
               width - filled, 100 * fraction);
    std::fflush(stderr);
  }

 private:
  static constexpr int width = 40;
  std::string label_;
  Reporter::Clock::time_point begin_ = Reporter::Clock::now(), last_ = begin_;
  bool is_shown_ = false;
};

std::int64_t peak_bytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

unsigned num_threads_used(const RunSettings& settings) {
  if (settings.num_threads > 0) return static_cast<unsigned>(settings.num_threads);
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

RunOptions Reporter::run_options(std::string_view label) const {
  RunOptions options;
  options.num_threads = settings_.num_threads;
  if (settings_.is_quiet || isatty(STDERR_FILENO) == 0) return options;
  options.progress = [bar = std::make_shared<ProgressBar>(label)](double fraction) {
    bar->show(fraction);
    return true;
  };
  return options;
}

void Reporter::print_timings() const {
  if (!settings_.prints_timings) return;
  static constexpr std::array names{"read", "build", "fit", "evaluate", "write"};
  std::string phases;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (seconds_[i]) phases += fmt::format("\"{}\":{:.6f},", names[i], *seconds_[i]);
  }
  fmt::print(stderr,
             "{{{}\"total\":{:.6f},\"threads\":{},\"points\":{},\"peak_bytes\":{}}}\n",
             phases, seconds_since(start_), num_threads_used(settings_), num_points_,
             peak_bytes());
}

double Reporter::seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void Reporter::print_line(std::string_view text) {
  fmt::print(stderr, "delone: {}\n", one_line(text));
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\t') c = ' ';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

}  // namespace delone::cli
