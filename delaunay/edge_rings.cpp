#include "delaunay/edge_rings.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "delaunay/parallel.hpp"

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Sites whose lists are written one after the other; chunks are written side by side.
constexpr int chunk_bits = 15;
constexpr Site chunk_size = 1 << chunk_bits;

// An arc to another chunk, and its half-edge: its reverse is known when both are written.
struct FarArc {
  std::int32_t arc, edge;
};

// Writes the lists of a chunk. The arrays are looked at through plain pointers: those of
// a vector would be read anew after every store.
class ChunkWriter {
 public:
  ChunkWriter(RingEdge* edges, const std::int32_t* first, Adjacency::Lists& lists,
              Site begin, std::int32_t first_arc)
      : edges_(edges),
        first_(first),
        offsets_(lists.offsets.data()),
        neighbors_(lists.neighbors.data()),
        reverse_(lists.reverse.data()),
        begin_(begin),
        arc_(first_arc) {}

  void write(Site v, bool is_boundary) {
    const std::size_t degree = walk_around(v);
    std::size_t k = is_boundary ? 0 : smallest_;
    const std::int32_t begin = arc_;
    offsets_[v] = begin;
    for (std::size_t i = 0; i < degree; ++i) {
      write_arc(v, ring_[k], arc_ - begin);
      ++arc_;
      k = k + 1 == degree ? 0 : k + 1;
    }
  }

  [[nodiscard]] std::vector<FarArc> take_far_arcs() { return std::move(far_arcs_); }

 private:
  struct Spoke {
    std::int32_t edge;
    Site target;
  };

  static std::uint8_t byte(std::int32_t place) {
    return static_cast<std::uint8_t>(std::min(place, Adjacency::far_reverse));
  }

  std::size_t walk_around(Site v) {
    const std::int32_t start = first_[v];
    Spoke* ring = ring_.data();
    std::size_t degree = 0, room = ring_.size();
    Site lowest = std::numeric_limits<Site>::max();
    std::int32_t e = start;
    do {
      if (degree == room) {
        ring_.resize(2 * room);
        ring = ring_.data(), room = ring_.size();
      }
      const Site w = edges_[e ^ 1].origin;
      ring[degree] = {e, w};
      if (w < lowest) lowest = w, smallest_ = degree;
      ++degree;
      e = edges_[e].next;
    } while (e != start);
    return degree;
  }

  // `previous` is not needed any more and takes the place of the arc in its list. The
  // later end of an edge writes both places; of an edge between chunks both ends wait.
  void write_arc(Site v, Spoke spoke, std::int32_t place) {
    const auto [e, w] = spoke;
    neighbors_[arc_] = w;
    edges_[e].previous = place;
    if (w >= begin_ && w < v) {
      const std::int32_t place_back = edges_[e ^ 1].previous;
      reverse_[arc_] = byte(place_back);
      reverse_[offsets_[w] + place_back] = byte(place);
    } else if (w < begin_ || w >= begin_ + chunk_size) {
      far_arcs_.push_back({arc_, e});
    }
  }

  RingEdge* edges_;
  const std::int32_t* first_;
  std::int32_t* offsets_;
  Site* neighbors_;
  std::uint8_t* reverse_;
  Site begin_;
  std::int32_t arc_;
  std::size_t smallest_ = 0;
  std::vector<Spoke> ring_ = std::vector<Spoke>(64);
  std::vector<FarArc> far_arcs_;
};

class RingLists {
 public:
  RingLists(EdgeRings rings, const RunOptions& run)
      : rings_(std::move(rings)),
        num_sites_(static_cast<Site>(rings_.first.size())),
        num_chunks_((num_sites_ + chunk_size - 1) / chunk_size),
        run_{.num_threads = run.num_threads, .progress = {}},
        begins_(at(num_chunks_) + 1),
        far_arcs_(at(num_chunks_)) {}

  Adjacency::Lists build() {
    mark_boundary();
    count_arcs();
    lists_.offsets.resize(at(num_sites_) + 1);
    lists_.offsets.back() = begins_.back();
    lists_.neighbors.resize(at(begins_.back()));
    lists_.reverse.resize(at(begins_.back()));
    for_each_chunk([this](std::int32_t k) { write_chunk(k); });
    for_each_chunk([this](std::int32_t k) { write_far_reverses(k); });
    return std::move(lists_);
  }

 private:
  template <class F>
  void for_each_chunk(F f) const {
    parallel_chunks(num_chunks_, 1, run_, [&](std::int64_t k, std::int64_t) {
      f(static_cast<std::int32_t>(k));
    });
  }
  [[nodiscard]] const RingEdge& edge(std::int32_t e) const { return rings_.edges[at(e)]; }
  [[nodiscard]] Site target(std::int32_t e) const { return edge(e ^ 1).origin; }

  // A boundary site's list begins with its hull edge.
  void mark_boundary() {
    lists_.is_boundary.assign(at(num_sites_), false);
    std::int32_t e = rings_.hull;
    if (e == none) return;
    do {
      const Site v = edge(e).origin;
      lists_.is_boundary[at(v)] = true;
      rings_.first[at(v)] = e;
      e = edge(e ^ 1).next;
    } while (e != rings_.hull);
  }

  // Where the lists of a chunk begin. Half-edges are looked at in the order of memory,
  // which is much faster than a walk around every site.
  void count_arcs() {
    const auto num_ranges = static_cast<std::int64_t>(rings_.used.size());
    std::vector<std::vector<std::int32_t>> counts(rings_.used.size());
    parallel_chunks(num_ranges, 1, run_, [&](std::int64_t k, std::int64_t) {
      auto& count = counts[static_cast<std::size_t>(k)];
      count.assign(at(num_chunks_) + 1, 0);
      const auto [begin, end] = rings_.used[static_cast<std::size_t>(k)];
      // Freed half-edges have origin -1 and count before the first chunk.
      for (std::int32_t e = begin; e < end; ++e)
        ++count[at((edge(e).origin >> chunk_bits) + 1)];
    });
    for (std::int32_t k = 0; k < num_chunks_; ++k) {
      begins_[at(k) + 1] = begins_[at(k)];
      for (const auto& count : counts) begins_[at(k) + 1] += count[at(k) + 1];
    }
  }

  void write_chunk(std::int32_t k) {
    const Site begin = k * chunk_size, end = std::min(num_sites_, begin + chunk_size);
    ChunkWriter writer(rings_.edges.data(), rings_.first.data(), lists_, begin,
                       begins_[at(k)]);
    for (Site v = begin; v < end; ++v) {
      fetch_ahead(v);
      writer.write(v, lists_.is_boundary[at(v)]);
    }
    far_arcs_[at(k)] = writer.take_far_arcs();
  }

  // The half-edges of a site lie anywhere in its block, which is fetched as a whole, a
  // piece with every site of the block before.
  void fetch_ahead(Site v) const {
    const std::size_t first = 6 * (at(v) + at(ring_block_size));
    if (first + 6 > rings_.edges.size()) return;
    __builtin_prefetch(&rings_.edges[first]);
    __builtin_prefetch(&rings_.edges[first + 5]);
  }

  void write_far_reverses(std::int32_t k) {
    for (const FarArc far : far_arcs_[at(k)]) {
      lists_.reverse[at(far.arc)] = static_cast<std::uint8_t>(
          std::min(edge(far.edge ^ 1).previous, Adjacency::far_reverse));
    }
  }

  EdgeRings rings_;
  Site num_sites_;
  std::int32_t num_chunks_;
  RunOptions run_;
  std::vector<std::int32_t> begins_;  // chunk -> its first arc
  std::vector<std::vector<FarArc>> far_arcs_;
  Adjacency::Lists lists_;
};

}  // namespace

Adjacency::Lists take_lists(EdgeRings rings, const RunOptions& run) {
  return RingLists(std::move(rings), run).build();
}

}  // namespace delone::delaunay
