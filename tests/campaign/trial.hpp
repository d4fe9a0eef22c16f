#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "campaign/families.hpp"

namespace delone::campaign {

/// Which set: everything else follows.
struct TrialKey {
  std::uint64_t seed = 0;
  std::size_t size = 0;
};

struct Outcome {
  std::optional<std::string> defect;
  std::string variant;
  std::int64_t num_points = 0;
  std::int64_t num_triangles = 0;
  std::int64_t num_ties = 0;
};

/// Makes the set, triangulates it and judges the answer. Of every eight seeds one is
/// built again from shuffled rows, of every 64 one with several threads (family P17:
/// every one); both must give the same lists. Never throws: an exception is a defect.
[[nodiscard]] Outcome run_trial(const Family& family, TrialKey key);

/// The set's rows as a case of tests/corpus, numbers in hexadecimal.
[[nodiscard]] std::string corpus_text(const Family& family, TrialKey key);

}  // namespace delone::campaign
