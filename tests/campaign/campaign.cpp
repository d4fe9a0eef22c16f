// Many generated sets of every family, each triangulated and judged in exact arithmetic.
//
//   campaign [--sets N] [--seconds S] [--first SEED] [--family ID] [--threads T]
//            [--largest N]
//   campaign --family ID --seed SEED [--size N] [--print]     one set again
//
// Set number k is seed first + k / 29 of family k % 29, so a run is the same everywhere.
// Prints a table of counts, and for every failure the command that repeats it. Exit code
// 1 if there is one.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "campaign/families.hpp"
#include "campaign/trial.hpp"

namespace {

using namespace delone::campaign;

struct Options {
  std::uint64_t num_sets = 2900, first = 1;
  double seconds = 0;  // 0: no limit
  std::string family;  // empty: all
  unsigned num_threads = 1;
  std::size_t largest = 2000, size = 0;  // size 0: by the seed
  std::uint64_t seed = 0;
  bool is_single = false, prints = false, has_sets = false;
};

struct Row {
  std::int64_t sets = 0, points = 0, triangles = 0, ties = 0, failures = 0;
  void add(const Outcome& outcome) {
    ++sets;
    points += outcome.num_points;
    triangles += outcome.num_triangles;
    ties += outcome.num_ties;
    failures += outcome.defect ? 1 : 0;
  }
  void add(const Row& other) {
    sets += other.sets;
    points += other.points;
    triangles += other.triangles;
    ties += other.ties;
    failures += other.failures;
  }
};

std::uint64_t whole(const std::string& text) {
  std::size_t end = 0;
  const std::uint64_t value = std::stoull(text, &end);
  if (end != text.size()) throw std::invalid_argument("not a whole number: " + text);
  return value;
}

Options parse(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto next = [&]() -> const std::string& {
      if (i + 1 == words.size()) throw std::invalid_argument(word + " lacks its value");
      return words[++i];
    };
    if (word == "--sets") {
      options.num_sets = whole(next());
      options.has_sets = true;
    } else if (word == "--seconds") {
      options.seconds = std::stod(next());
    } else if (word == "--first") {
      options.first = whole(next());
    } else if (word == "--family") {
      options.family = next();
    } else if (word == "--threads") {
      options.num_threads =
          static_cast<unsigned>(std::max<std::uint64_t>(1, whole(next())));
    } else if (word == "--largest") {
      options.largest = std::max<std::size_t>(3, whole(next()));
    } else if (word == "--seed") {
      options.seed = whole(next());
      options.is_single = true;
    } else if (word == "--size") {
      options.size = whole(next());
    } else if (word == "--print") {
      options.prints = true;
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  if (options.seconds > 0 && !options.has_sets) options.num_sets = ~std::uint64_t{0} >> 1;
  return options;
}

std::vector<Family> chosen(const std::string& id) {
  std::vector<Family> families = all_families();
  if (id.empty()) return families;
  std::erase_if(families, [&](const Family& f) { return id != f.id; });
  if (families.empty()) throw std::invalid_argument("no family " + id);
  return families;
}

TrialKey key_of(const Options& options, std::uint64_t seed) {
  return {seed, options.size != 0 ? options.size : size_of(seed, options.largest)};
}

void report(const Family& family, TrialKey key, const Outcome& outcome) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::printf(
      "FAILED %s (%s): %s\n  campaign --family %s --seed %llu --size %zu --print\n",
      family.id, outcome.variant.c_str(), outcome.defect->c_str(), family.id,
      static_cast<unsigned long long>(key.seed), key.size);
  std::fflush(stdout);
}

// Takes the next number until none or no time is left.
class Run {
 public:
  Run(const Options& options, const std::vector<Family>& families)
      : options_(options), families_(families), table_(families.size()) {}

  std::vector<Row> all() {
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < options_.num_threads; ++i)
      threads.emplace_back([this] { work(); });
    work();
    for (std::thread& t : threads) t.join();
    return table_;
  }
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void work() {
    std::vector<Row> rows(families_.size());
    while (options_.seconds <= 0 || seconds() < options_.seconds) {
      const std::uint64_t k = next_.fetch_add(1, std::memory_order_relaxed);
      if (k >= options_.num_sets) break;
      const std::size_t f = k % families_.size();
      const TrialKey key = key_of(options_, options_.first + k / families_.size());
      const Outcome outcome = run_trial(families_[f], key);
      if (outcome.defect) report(families_[f], key, outcome);
      rows[f].add(outcome);
    }
    const std::lock_guard lock(mutex_);
    for (std::size_t f = 0; f < rows.size(); ++f) table_[f].add(rows[f]);
  }

  const Options& options_;
  const std::vector<Family>& families_;
  std::vector<Row> table_;
  std::mutex mutex_;
  std::atomic<std::uint64_t> next_ = 0;
  Clock::time_point begin_ = Clock::now();
};

void print(const char* id, const char* title, const Row& row) {
  std::printf("%-5s %-52s %10lld %12lld %12lld %12lld %9lld\n", id, title,
              static_cast<long long>(row.sets), static_cast<long long>(row.points),
              static_cast<long long>(row.triangles), static_cast<long long>(row.ties),
              static_cast<long long>(row.failures));
}

int run_many(const Options& options, const std::vector<Family>& families) {
  Run run(options, families);
  const std::vector<Row> table = run.all();
  std::printf("%-5s %-52s %10s %12s %12s %12s %9s\n", "id", "family", "sets", "points",
              "triangles", "ties", "failures");
  Row sum;
  for (std::size_t f = 0; f < families.size(); ++f) {
    print(families[f].id, families[f].title, table[f]);
    sum.add(table[f]);
  }
  print("all", "", sum);
  const double seconds = run.seconds();
  std::printf("%.1f s, %.0f sets a second, seeds from %llu on\n", seconds,
              static_cast<double>(sum.sets) / seconds,
              static_cast<unsigned long long>(options.first));
  return sum.failures == 0 && sum.sets > 0 ? 0 : 1;
}

int run_one(const Options& options, const Family& family) {
  const TrialKey key = key_of(options, options.seed);
  if (options.prints) std::fputs(corpus_text(family, key).c_str(), stdout);
  const Outcome outcome = run_trial(family, key);
  std::printf("# %s %s: %lld points, %lld triangles, %lld ties: %s\n", family.id,
              outcome.variant.c_str(), static_cast<long long>(outcome.num_points),
              static_cast<long long>(outcome.num_triangles),
              static_cast<long long>(outcome.num_ties),
              outcome.defect.value_or("no defect").c_str());
  return outcome.defect ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse({argv + 1, argv + argc});
    const std::vector<Family> families = chosen(options.family);
    if (!options.is_single) return run_many(options, families);
    if (families.size() != 1) throw std::invalid_argument("--seed needs --family");
    return run_one(options, families[0]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "campaign: error: %s\n", error.what());
    return 2;
  }
}
