#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace delone::delaunay {

/// What stands for the observations of a block.
enum class BlockStatistic : std::uint8_t {
  mean,    ///< weighted
  median,  ///< half of the weight on either side; between two values, the middle of them
  mode,    ///< the middle of the shortest interval that holds half of the weight (least
         ///< median of squares); of several equally short ones the mean of their middles
};

/// Where a block's result lies.
enum class BlockPosition : std::uint8_t {
  reduced,  ///< x and y reduced as the values are, each by itself
  center,   ///< in the middle of the block
};

/// West, east, south, north.
struct BlockRegion {
  double west = 0, east = 0, south = 0, north = 0;
};

struct BlockOptions {
  double dx = 0, dy = 0;  ///< size of a block
  /// Empty: blocks begin at multiples of their size, and everything is used. Else they
  /// begin at its south-western corner, and what lies outside of it is left out; its
  /// eastern and northern edges belong to the last blocks.
  std::optional<BlockRegion> region;
  BlockStatistic statistic = BlockStatistic::mean;
  BlockPosition position = BlockPosition::reduced;
};

/// Blocks that hold something, row by row from south to north, each from west to east.
struct Blocks {
  std::vector<double> x, y;
  std::vector<double> value;   ///< empty if there were no values
  std::vector<double> weight;  ///< sums
  std::vector<std::int64_t> count;
};

/// Reduces scattered observations to one a block, as GMT's blockmean, blockmedian and
/// blockmode do.
///
/// A block holds west + i dx <= x < west + (i + 1) dx, and so for y. `values` may be
/// empty, and so may `weights` (all 1); an observation of weight 0 is left out. Results
/// do not depend on the order of the input, and no mean, median or mode leaves the range
/// of what it is taken of. Throws Error for sizes that differ, for what is not finite,
/// weights below 0 (naming the row), a size of blocks that is not positive, an empty
/// region, and blocks so small that their numbers are not exact (2^53). O(n log n).
///
/// Source: P. Wessel, W. H. F. Smith, Eos 72 (1991) 441-446; of the mode: P. J.
/// Rousseeuw, J. Am. Stat. Assoc. 79 (1984) 871-880.
[[nodiscard]] Blocks block_reduce(std::span<const double> x, std::span<const double> y,
                                  std::span<const double> values,
                                  std::span<const double> weights,
                                  const BlockOptions& options);

/// A number and its weight.
struct Weighted {
  double value = 0, weight = 1;
};
/// The statistic of at least one number, all weights positive. Changes the order of
/// `numbers`, nothing else.
[[nodiscard]] double reduce(std::span<Weighted> numbers, BlockStatistic statistic);

}  // namespace delone::delaunay
