#include "bench/measure.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <type_traits>
#include <utility>

namespace delone::bench {

namespace {

std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == key + ":" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

Measurement measure_here(const std::function<Job()>& make, int repeats) {
  const Job job = make();
  Measurement result;
  result.num_points = job.num_points;
  const std::size_t before = resident_bytes();
  reset_peak_bytes();
  Built built = job.build();
  result.peak_bytes = static_cast<double>(peak_bytes()) - static_cast<double>(before);
  result.kept_bytes = static_cast<double>(resident_bytes()) - static_cast<double>(before);
  result.num_triangles = built.num_triangles;
  std::vector<double> walls, cpus;
  for (int i = 0; i < repeats; ++i) {
    built = {};
    const Seconds time = seconds([&] { built = job.build(); });
    walls.push_back(time.wall);
    cpus.push_back(time.cpu);
  }
  result.seconds = spread(std::move(walls));
  result.cpu_seconds = spread(std::move(cpus)).median;
  result.is_valid = true;
  return result;
}

}  // namespace

Seconds seconds(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  run();
  const std::clock_t cpu = std::clock() - cpu_start;
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(cpu) / CLOCKS_PER_SEC};
}

Spread spread(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t n = numbers.size();
  return {numbers.front(), (numbers[(n - 1) / 2] + numbers[n / 2]) / 2, numbers.back()};
}

std::size_t resident_bytes() { return status_bytes("VmRSS"); }
std::size_t peak_bytes() { return status_bytes("VmHWM"); }
void reset_peak_bytes() { std::ofstream("/proc/self/clear_refs") << "5"; }

Measurement measure(const std::function<Job()>& make, int repeats) {
  static_assert(std::is_trivially_copyable_v<Measurement>);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const Measurement result = measure_here(make, repeats);
    const bool is_sent = write(ends[1], &result, sizeof result) == sizeof result;
    _exit(is_sent ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  Measurement result;
  if (child < 0 || read(ends[0], &result, sizeof result) != sizeof result) result = {};
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return result;
}

}  // namespace delone::bench
