#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace delone::support {

/// Random numbers that are the same everywhere: splitmix64 (Steele, Lea, Flood, OOPSLA
/// 2014).
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  /// 0 .. count - 1.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(next() % count);
  }

 private:
  std::uint64_t state_;
};

/// A copy in random order (Fisher and Yates, from the last element down).
template <class T>
std::vector<T> shuffled(std::vector<T> items, std::uint64_t seed) {
  SplitMix64 random(seed ^ 0x5DEECE66Du);
  for (std::size_t i = items.size(); i-- > 1;)
    std::swap(items[i], items[random.below(i + 1)]);
  return items;
}

}  // namespace delone::support
