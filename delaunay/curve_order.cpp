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

namespace {

constexpr int digit_bits = 11, num_passes = 3;
constexpr std::size_t num_buckets = 1u << digit_bits;

std::size_t digit(KeyedRow item, int pass) {
  return static_cast<std::size_t>(item >> (32 + digit_bits * pass)) & (num_buckets - 1);
}

/// One pass of a stable radix sort by a digit, in parts that are counted and written side
/// by side.
class RadixPass {
 public:
  RadixPass(std::span<const KeyedRow> from, std::span<KeyedRow> to, int pass,
            std::size_t num_parts)
      : from_(from), to_(to), pass_(pass), counts_(num_parts) {}

  void run(const RunOptions& options) {
    const auto num_parts = static_cast<std::int64_t>(counts_.size());
    parallel_chunks(num_parts, 1, options, [this](std::int64_t k, std::int64_t) {
      count(static_cast<std::size_t>(k));
    });
    add_up();
    parallel_chunks(num_parts, 1, options, [this](std::int64_t k, std::int64_t) {
      move(static_cast<std::size_t>(k));
    });
  }

 private:
  using Counts = std::array<std::uint32_t, num_buckets>;

  [[nodiscard]] std::span<const KeyedRow> part(std::size_t k) const {
    const std::size_t begin = from_.size() * k / counts_.size(),
                      end = from_.size() * (k + 1) / counts_.size();
    return from_.subspan(begin, end - begin);
  }
  void count(std::size_t k) {
    counts_[k].fill(0);
    for (const KeyedRow item : part(k)) ++counts_[k][digit(item, pass_)];
  }
  // Counts become the places where parts begin to write.
  void add_up() {
    std::uint32_t start = 0;
    for (std::size_t d = 0; d < num_buckets; ++d) {
      for (Counts& counts : counts_) counts[d] = std::exchange(start, start + counts[d]);
    }
  }
  void move(std::size_t k) {
    Counts& place = counts_[k];
    for (const KeyedRow item : part(k)) to_[place[digit(item, pass_)]++] = item;
  }

  std::span<const KeyedRow> from_;
  std::span<KeyedRow> to_;
  int pass_;
  std::vector<Counts> counts_;
};

/// Few items: four digits of eight bits, all counted at once. A sort by comparisons would
/// mispredict half of them.
void sort_few(Buffer<KeyedRow>& items) {
  constexpr std::size_t num_small_buckets = 256;
  const auto small_digit = [](KeyedRow item, std::size_t pass) {
    return static_cast<std::size_t>(item >> (32 + 8 * pass)) & (num_small_buckets - 1);
  };
  std::array<std::array<std::uint32_t, num_small_buckets>, 4> places{};
  for (const KeyedRow item : items) {
    for (std::size_t pass = 0; pass < 4; ++pass) ++places[pass][small_digit(item, pass)];
  }
  Buffer<KeyedRow> sorted(items.size());
  for (std::size_t pass = 0; pass < 4; ++pass) {
    std::uint32_t start = 0;
    for (std::uint32_t& place : places[pass]) place = std::exchange(start, start + place);
    for (const KeyedRow item : items)
      sorted[places[pass][small_digit(item, pass)]++] = item;
    items.swap(sorted);
  }
}

}  // namespace

void sort_by_key(Buffer<KeyedRow>& items, const RunOptions& run) {
  constexpr std::size_t very_few = 48;
  if (items.size() < very_few) {
    std::stable_sort(items.begin(), items.end(),
                     [](KeyedRow a, KeyedRow b) { return a >> 32 < b >> 32; });
    return;
  }
  if (items.size() < num_buckets) return sort_few(items);
  constexpr std::size_t grain = 1u << 16;
  const std::size_t num_parts =
      std::min(items.size() / grain + 1, static_cast<std::size_t>(num_threads(run)));
  Buffer<KeyedRow> sorted(items.size());
  for (int pass = 0; pass < num_passes; ++pass) {
    RadixPass(items, sorted, pass, num_parts).run(run);
    items.swap(sorted);
  }
}

}  // namespace delone::delaunay
