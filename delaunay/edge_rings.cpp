#include "delaunay/edge_rings.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "delaunay/few_walks.hpp"
#include "delaunay/parallel.hpp"

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Sites whose lists are written one after the other; chunks are written side by side.
constexpr int chunk_bits = 13;
constexpr Site chunk_size = 1 << chunk_bits;

// An arc to another chunk, and its half-edge: its reverse is known when both are written.
struct FarArc {
  std::int32_t arc, edge;
};

// Writes the lists of a chunk. Nearly all sites are written by the same instructions,
// whatever their degree: a loop around every site would end with a branch that nothing
// foretells. The arrays are looked at through plain pointers, in local variables: members
// would be read anew after every store.
class ChunkWriter {
 public:
  ChunkWriter(EdgeRings& rings, Adjacency::Lists& lists, Site begin,
              std::int32_t first_arc, std::int32_t last_arc)
      : edges_(rings.edges.data()),
        num_edges_(rings.edges.size()),
        first_(rings.first.data()),
        lists_(lists),
        begin_(begin),
        first_arc_(first_arc),
        arc_(first_arc),
        edge_of_(at(last_arc - first_arc)) {}

  void write_lists(Site end) {
    Site v = begin_;
    for (; v + FewWalks::num_walks <= end; v += FewWalks::num_walks) {
      FewWalks::fetch_ahead(edges_, num_edges_, v);
      write_few(v);
    }
    for (; v < end; ++v) write_any(v);
  }

  // When all lists are written: the places of reverse arcs.
  std::vector<FarArc> write_reverses() const {
    std::vector<FarArc> far;
    const RingEdge* const edges = edges_;
    const std::int32_t* const edge_of = edge_of_.data() - first_arc_;
    const Site* const neighbors = lists_.neighbors.data();
    std::uint8_t* const reverse = lists_.reverse.data();
    const Site begin = begin_;
    for (std::int32_t arc = first_arc_, last = arc_; arc < last; ++arc) {
      const std::int32_t e = edge_of[arc];
      if (static_cast<std::uint32_t>(neighbors[arc] - begin) >= chunk_size) [[unlikely]] {
        far.push_back({arc, e});
      } else {
        reverse[arc] = byte(edges[e ^ 1].previous);
      }
    }
    return far;
  }

  static std::uint8_t byte(std::int32_t place) {
    return static_cast<std::uint8_t>(std::min(place, Adjacency::far_reverse));
  }

 private:
  void write_few(Site begin) {
    const FewWalks walks(edges_, first_, begin);
    for (Site j = 0; j < FewWalks::num_walks; ++j) {
      if (!walks.is_whole(j) || lists_.is_boundary[at(begin + j)]) [[unlikely]] {
        write_any(begin + j);
        continue;
      }
      lists_.offsets[at(begin + j)] = arc_;
      RingEdge* const edges = edges_;
      Site* const neighbors = lists_.neighbors.data() + arc_;
      std::int32_t* const edge_of = edge_of_.data() + (arc_ - first_arc_);
#pragma GCC unroll 8
      for (std::int32_t i = 0; i < FewWalks::num_steps; ++i) {
        const std::int32_t place = walks.place(i, j), e = walks.edge(i, j);
        edges[e].previous = place;
        neighbors[place] = walks.target(i, j);
        edge_of[place] = e;
      }
      arc_ += walks.degree(j);
    }
  }

  // `previous` is not needed any more and takes the place of the arc in its list.
  void write_any(Site v) {
    lists_.offsets[at(v)] = arc_;
    const std::int32_t start =
        lists_.is_boundary[at(v)] ? first_[v] : to_smallest(edges_, first_[v]);
    std::int32_t e = start, place = 0;
    do {
      lists_.neighbors[at(arc_)] = edges_[e].target;
      edge_of_[at(arc_ - first_arc_)] = e;
      edges_[e].previous = place++;
      ++arc_;
      e = edges_[e].next;
    } while (e != start);
  }
  RingEdge* edges_;
  std::size_t num_edges_;
  const std::int32_t* first_;
  Adjacency::Lists& lists_;
  Site begin_;
  std::int32_t first_arc_, arc_;
  Buffer<std::int32_t> edge_of_;  // arc of the chunk -> its half-edge
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
  [[nodiscard]] Site target(std::int32_t e) const { return edge(e).target; }

  // A boundary site's list begins with its hull edge.
  void mark_boundary() {
    lists_.is_boundary.assign(at(num_sites_), false);
    std::int32_t e = rings_.hull;
    if (e == none) return;
    do {
      const Site v = target(e ^ 1);
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
      // Freed half-edges have target -1 and count before the first chunk.
      for (std::int32_t e = begin; e < end; ++e)
        ++count[at((edge(e).target >> chunk_bits) + 1)];
    });
    for (std::int32_t k = 0; k < num_chunks_; ++k) {
      begins_[at(k) + 1] = begins_[at(k)];
      for (const auto& count : counts) begins_[at(k) + 1] += count[at(k) + 1];
    }
  }

  void write_chunk(std::int32_t k) {
    const Site begin = k * chunk_size, end = std::min(num_sites_, begin + chunk_size);
    ChunkWriter writer(rings_, lists_, begin, begins_[at(k)], begins_[at(k) + 1]);
    writer.write_lists(end);
    far_arcs_[at(k)] = writer.write_reverses();
  }

  void write_far_reverses(std::int32_t k) {
    for (const FarArc far : far_arcs_[at(k)]) {
      lists_.reverse[at(far.arc)] = ChunkWriter::byte(edge(far.edge ^ 1).previous);
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
