#include "delaunay/curve_order.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

// Hilbert's curve in a square is four copies of itself; two are transposed, one of those
// also turned. State bit 0: x and y change places; bit 1: both run backwards.
struct Digit {
  std::uint8_t key;
  std::uint8_t state;
};

constexpr Digit hilbert_digit(unsigned state, unsigned x, unsigned y) {
  if (state & 1u) std::swap(x, y);
  if (state & 2u) x ^= 1u, y ^= 1u;
  const unsigned next = y != 0 ? state : state ^ 1u ^ (x << 1);
  return {static_cast<std::uint8_t>((3 * x) ^ y), static_cast<std::uint8_t>(next)};
}

// Four levels at once: index state * 256 + x * 16 + y.
constexpr std::array<Digit, 1024> hilbert_table() {
  std::array<Digit, 1024> table{};
  for (unsigned i = 0; i < 1024; ++i) {
    unsigned state = i >> 8, key = 0;
    for (int bit = 3; bit >= 0; --bit) {
      const Digit d = hilbert_digit(state, (i >> (4 + bit)) & 1u, (i >> bit) & 1u);
      key = key << 2 | d.key;
      state = d.state;
    }
    table[i] = {static_cast<std::uint8_t>(key), static_cast<std::uint8_t>(state)};
  }
  return table;
}

constexpr auto table = hilbert_table();

}  // namespace

std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) noexcept {
  std::uint32_t key = 0, state = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const Digit d = table[state << 8 | ((x >> shift) & 15u) << 4 | ((y >> shift) & 15u)];
    key = key << 8 | d.key;
    state = d.state;
  }
  return key;
}

void check_num_points(std::size_t num_points) {
  constexpr std::size_t limit = std::size_t{1} << 28;
  if (num_points <= limit) return;
  throw Error(std::to_string(num_points) + " points are more than the limit of " +
              std::to_string(limit) + " a triangulation; divide the set");
}

void sort_by_key(Buffer<KeyedRow>& items) {
  constexpr int bits = 11, passes = 3;
  constexpr std::size_t buckets = 1u << bits;
  if (items.size() < buckets) {
    std::stable_sort(items.begin(), items.end(),
                     [](KeyedRow a, KeyedRow b) { return a >> 32 < b >> 32; });
    return;
  }
  const auto digit = [](KeyedRow item, int pass) {
    return static_cast<std::size_t>(item >> (32 + bits * pass)) & (buckets - 1);
  };
  std::array<std::array<std::uint32_t, buckets>, passes> counts{};
  for (const KeyedRow item : items) {
    for (int pass = 0; pass < passes; ++pass)
      ++counts[static_cast<std::size_t>(pass)][digit(item, pass)];
  }
  Buffer<KeyedRow> sorted(items.size());
  for (int pass = 0; pass < passes; ++pass) {
    auto& count = counts[static_cast<std::size_t>(pass)];
    std::uint32_t start = 0;
    for (std::uint32_t& c : count) c = std::exchange(start, start + c);
    for (const KeyedRow item : items) sorted[count[digit(item, pass)]++] = item;
    items.swap(sorted);
  }
}

}  // namespace delone::delaunay
