#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "delaunay/divide_conquer.hpp"
#include "delaunay/edge_rings.hpp"
#include "delaunay/parallel.hpp"
#include "delaunay/site_order.hpp"

namespace delone::delaunay {

/// The work of a block, compiled once for every instruction set; which is chosen changes
/// no result. `build` makes one block of the sites begin .. end - 1; `merge` makes one of
/// two, and gives how many of the supplies it has used up.
template <class Points>
struct BlockWork {
  Extremes (*build)(const Points&, RingArrays, EdgeSupply&, BlockKeys, Site begin,
                    Site end);
  struct Merged {
    Extremes extremes;
    std::ptrdiff_t num_used_up;
  };
  Merged (*merge)(const Points&, RingArrays, EdgeSupply*, const Extremes&,
                  const Extremes&);
};

/// The two functions for a geometry.
template <class Geometry>
struct BlockWorker {
  using Points = typename Geometry::Points;
  static Extremes build(const Points& points, RingArrays arrays, EdgeSupply& supply,
                        BlockKeys keys, Site begin, Site end) {
    const Geometry geometry(points, begin, end);
    EdgeSupply own = supply;  // two supplies of two threads may share a cache line
    const Extremes extremes =
        DivideConquer(geometry, arrays, &own).build(keys, begin, end);
    supply = own;
    return extremes;
  }
  static typename BlockWork<Points>::Merged merge(const Points& points, RingArrays arrays,
                                                  EdgeSupply* supplies, const Extremes& p,
                                                  const Extremes& q) {
    const Geometry geometry(points);
    DivideConquer worker(geometry, arrays, supplies);
    const Extremes extremes = worker.merge(p, q);
    return {extremes, worker.supply() - supplies};
  }
  static constexpr BlockWork<Points> work{build, merge};
};

/// Builds all sites: small blocks side by side, then merges of two, level by level.
template <class Geometry>
class RingBuilder {
 public:
  using Points = typename Geometry::Points;

  RingBuilder(const Points& points, const SiteOrder& order, const BlockWork<Points>& work)
      : points_(points), order_(order), work_(work) {
    rings_.edges.resize(6 * order.keys.size());
    rings_.first.resize(order.keys.size());
  }

  EdgeRings build(const RunOptions& run) {
    const Block all = build_block(cut(BlockKeys(order_), 0, num_sites(), 0), run);
    rings_.hull = rings_.first[static_cast<std::size_t>(all.extremes.low_u)];
    note_use(all.supplies);
    return std::move(rings_);
  }

  /// The sites below `second` and those from it on are two halves of the sphere. Nothing
  /// if rounded numbers could not tell where to begin closing them.
  std::optional<EdgeRings> build_halves(Site second, const RunOptions& run) {
    if (second == 0 || second == num_sites()) return build(run);
    const std::size_t root = blocks_.size();
    blocks_.push_back({0, num_sites(), BlockKeys(order_), 0, 0, {}, {}});
    const std::size_t left = cut(BlockKeys(order_), 0, second, 1);
    const std::size_t right = cut(BlockKeys(order_), second, num_sites(), 1);
    build_blocks(run);
    blocks_[root].supplies =
        concatenated(blocks_[left].supplies, blocks_[right].supplies);
    const Geometry geometry(points_);
    DivideConquer<Geometry> worker(geometry, arrays(), blocks_[root].supplies.data());
    const auto closed =
        worker.close(blocks_[left].extremes.low_u, blocks_[right].extremes.high_u);
    if (!closed.is_certain) return std::nullopt;
    rings_.hull = closed.hull;
    note_use(blocks_[root].supplies);
    return std::move(rings_);
  }

 private:
  // The half-edges of a block this large fit into a core's cache twice, which matters
  // when their lists are written.
  static constexpr Site block_size = ring_block_size;

  struct Block {
    Site begin, end;
    BlockKeys keys;
    std::size_t left, right;  // parts; 0 for a block that is built in one go
    std::vector<EdgeSupply> supplies;
    Extremes extremes;
  };

  [[nodiscard]] Site num_sites() const { return static_cast<Site>(rings_.first.size()); }
  RingArrays arrays() { return {rings_.edges.data(), rings_.first.data()}; }

  // A range of n sites has at most 3 n edges at any time, so block ranges never meet.
  std::size_t cut(BlockKeys keys, Site begin, Site end, std::size_t level) {
    const std::size_t id = blocks_.size();
    blocks_.push_back({begin, end, keys, 0, 0, {}, {}});
    if (end - begin <= block_size) {
      blocks_[id].supplies = {{6 * begin, 6 * end}};
      leaves_.push_back(id);
      return id;
    }
    if (levels_.size() <= level) levels_.resize(level + 1);
    levels_[level].push_back(id);
    if (keys[begin] == keys[end - 1]) keys = keys.inside(begin, end);
    const Site middle = middle_of(keys, begin, end);
    const std::size_t left = cut(keys, begin, middle, level + 1);
    const std::size_t right = cut(keys, middle, end, level + 1);
    blocks_[id].left = left, blocks_[id].right = right;
    return id;
  }

  const Block& build_block(std::size_t root, const RunOptions& run) {
    build_blocks(run);
    return blocks_[root];
  }

  void build_blocks(const RunOptions& run) {
    for_each(leaves_, run, [this](Block& b) {
      b.extremes = work_.build(points_, arrays(), b.supplies[0], b.keys, b.begin, b.end);
    });
    const RunOptions quietly{.num_threads = run.num_threads, .progress = {}};
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
      for_each(*level, quietly, [this](Block& b) { merge(b); });
  }
  template <class F>
  void for_each(const std::vector<std::size_t>& ids, const RunOptions& run, F f) {
    parallel_chunks(static_cast<std::int64_t>(ids.size()), 1, run,
                    [&](std::int64_t k, std::int64_t) {
                      f(blocks_[ids[static_cast<std::size_t>(k)]]);
                    });
  }

  void merge(Block& b) {
    const Block &left = blocks_[b.left], &right = blocks_[b.right];
    b.supplies = concatenated(left.supplies, right.supplies);
    const auto merged =
        work_.merge(points_, arrays(), b.supplies.data(), left.extremes, right.extremes);
    b.extremes = merged.extremes;
    b.supplies.erase(b.supplies.begin(), b.supplies.begin() + merged.num_used_up);
  }
  static std::vector<EdgeSupply> concatenated(std::vector<EdgeSupply> a,
                                              const std::vector<EdgeSupply>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  // Leaves whose supply is not among those left have used all of it.
  void note_use(const std::vector<EdgeSupply>& left) {
    auto supply = left.begin();
    for (const std::size_t id : leaves_) {
      const std::int32_t begin = 6 * blocks_[id].begin, end = 6 * blocks_[id].end;
      while (supply != left.end() && supply->end < end) ++supply;
      const bool is_left = supply != left.end() && supply->end == end;
      rings_.used.emplace_back(begin, is_left ? supply->unused : end);
    }
  }

  Points points_;
  const SiteOrder& order_;
  BlockWork<Points> work_;
  EdgeRings rings_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> leaves_;
  std::vector<std::vector<std::size_t>> levels_;  // blocks that are merged, by depth
};

}  // namespace delone::delaunay
