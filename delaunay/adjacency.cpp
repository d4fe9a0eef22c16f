#include "delaunay/adjacency.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

// Where does v stand in w's list? Long lists are searched through a sorted copy, so that
// a hub with n neighbours costs n log n and not n^2.
class PositionFinder {
 public:
  explicit PositionFinder(const Adjacency& adjacency) : adjacency_(adjacency) {
    for (Site w = 0; w < adjacency.num_sites(); ++w) {
      if (adjacency.degree(w) > long_list) long_lists_.emplace(w, sorted_slots(w));
    }
  }

  [[nodiscard]] bool has_no_long_lists() const { return long_lists_.empty(); }

  [[nodiscard]] std::int32_t position(Site w, Site v) const {
    if (adjacency_.degree(w) > long_list) {
      const std::vector<Slot>& slots = long_lists_.find(w)->second;
      const auto slot = std::lower_bound(slots.begin(), slots.end(), Slot{v, 0});
      return slot != slots.end() && slot->first == v ? slot->second : none;
    }
    const std::span<const Site> list = adjacency_.neighbors(w);
    const auto slot = std::find(list.begin(), list.end(), v);
    return slot != list.end() ? static_cast<std::int32_t>(slot - list.begin()) : none;
  }

 private:
  static constexpr std::int32_t long_list = 48;
  using Slot = std::pair<Site, std::int32_t>;  // neighbour, its position in the list

  std::vector<Slot> sorted_slots(Site w) const {
    std::vector<Slot> slots;
    for (const Site v : adjacency_.neighbors(w)) {
      slots.emplace_back(v, static_cast<std::int32_t>(slots.size()));
    }
    std::sort(slots.begin(), slots.end());
    return slots;
  }

  const Adjacency& adjacency_;
  std::unordered_map<Site, std::vector<Slot>> long_lists_;
};

}  // namespace

Adjacency::Adjacency(const std::vector<std::int32_t>& offsets,
                     const std::vector<Site>& neighbors, std::vector<bool> is_boundary)
    : offsets_(offsets.begin(), offsets.end()),
      neighbors_(neighbors.begin(), neighbors.end()),
      is_boundary_(std::move(is_boundary)),
      reverse_(neighbors_.size()) {
  const PositionFinder finder(*this);
  for (Site v = 0; v < num_sites(); ++v) {
    for (std::int32_t i = offsets_[index(v)]; i < offsets_[index(v) + 1]; ++i) {
      const std::int32_t position = finder.position(neighbors_[index(i)], v);
      if (position == none) {
        throw Error(
            "the lists are not symmetric: " + std::to_string(neighbors_[index(i)]) +
            " is in the list of " + std::to_string(v) + " but not the other way round");
      }
      reverse_[index(i)] = static_cast<std::uint8_t>(std::min(position, far_reverse));
    }
  }
  note_far_reverses();
}

Adjacency::Adjacency(Lists lists)
    : offsets_(std::move(lists.offsets)),
      neighbors_(std::move(lists.neighbors)),
      is_boundary_(std::move(lists.is_boundary)),
      reverse_(std::move(lists.reverse)) {
  note_far_reverses();
}

void Adjacency::note_far_reverses() {
  const PositionFinder finder(*this);
  if (finder.has_no_long_lists()) return;
  for (Site v = 0; v < num_sites(); ++v) {
    for (std::int32_t i = offsets_[index(v)]; i < offsets_[index(v) + 1]; ++i) {
      if (reverse_[index(i)] != far_reverse) continue;
      const Site w = neighbors_[index(i)];
      far_.emplace_back(i, offsets_[index(w)] + finder.position(w, v));
    }
  }
}

Adjacency Adjacency::chain(Site num_sites, Chain kind) {
  std::vector<std::int32_t> offsets{0};
  std::vector<Site> neighbors;
  // Two sites are joined once, whatever the kind.
  const bool is_ring = kind == Chain::closed && num_sites > 2;
  for (Site v = 0; v < num_sites; ++v) {
    if (v + 1 < num_sites || is_ring) neighbors.push_back((v + 1) % num_sites);
    if (v > 0 || is_ring) neighbors.push_back((v + num_sites - 1) % num_sites);
    offsets.push_back(static_cast<std::int32_t>(neighbors.size()));
  }
  const std::vector<bool> is_boundary(static_cast<std::size_t>(num_sites), true);
  Adjacency adjacency(offsets, neighbors, is_boundary);
  adjacency.is_chain_ = true;
  return adjacency;
}

Arc Adjacency::find_far_reverse(Arc a) const noexcept {
  const auto found =
      std::lower_bound(far_.begin(), far_.end(), std::pair(a.index, std::int32_t{0}));
  return {target(a), found->second};
}

std::int64_t Adjacency::num_triangles() const noexcept {
  if (is_chain_) return 0;
  std::int64_t corners = num_arcs();
  for (Site v = 0; v < num_sites(); ++v) {
    if (is_boundary(v) && degree(v) > 0) --corners;
  }
  return corners / 3;
}

RenkaLists to_renka(const Adjacency& adjacency) {
  RenkaLists lists;
  const auto num_arcs = static_cast<std::size_t>(adjacency.num_arcs());
  lists.list.reserve(num_arcs);
  lists.lptr.reserve(num_arcs);
  for (Site v = 0; v < adjacency.num_sites(); ++v) {
    const auto first = static_cast<std::int32_t>(lists.list.size()) + 1;
    for (const Site w : adjacency.neighbors(v)) {
      lists.list.push_back(w + 1);
      lists.lptr.push_back(static_cast<std::int32_t>(lists.list.size()) + 1);
    }
    lists.lend.push_back(static_cast<std::int32_t>(lists.list.size()));
    if (adjacency.degree(v) == 0) continue;
    lists.lptr.back() = first;
    if (adjacency.is_boundary(v)) lists.list.back() = -lists.list.back();
  }
  lists.lnew = static_cast<std::int32_t>(lists.list.size()) + 1;
  return lists;
}

namespace {

// The list of one node, first to last, checked step by step.
std::vector<Site> renka_list(const RenkaLists& lists, std::int32_t last) {
  const auto size =
      static_cast<std::int32_t>(std::min(lists.list.size(), lists.lptr.size()));
  std::vector<Site> neighbors;
  std::int32_t pointer = last;
  do {
    if (pointer < 1 || pointer > size || std::ssize(neighbors) >= size) {
      throw Error("LPTR does not close a list; entry " + std::to_string(pointer));
    }
    pointer = lists.lptr[static_cast<std::size_t>(pointer - 1)];
    if (pointer < 1 || pointer > size) throw Error("LPTR points outside LIST");
    const std::int32_t node = std::abs(lists.list[static_cast<std::size_t>(pointer - 1)]);
    if (node < 1 || node > std::ssize(lists.lend))
      throw Error("LIST names a node that is not there");
    neighbors.push_back(node - 1);
  } while (pointer != last);
  return neighbors;
}

}  // namespace

Adjacency from_renka(const RenkaLists& lists) {
  std::vector<std::int32_t> offsets{0};
  std::vector<Site> neighbors;
  std::vector<bool> is_boundary;
  for (const std::int32_t last : lists.lend) {
    std::vector<Site> list = renka_list(lists, last);
    is_boundary.push_back(lists.list[static_cast<std::size_t>(last - 1)] < 0);
    // An interior list is a ring; ours begins with the smallest neighbour.
    if (!is_boundary.back())
      std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
    neighbors.insert(neighbors.end(), list.begin(), list.end());
    // Or lists that share their entries would grow as the square of the input.
    if (neighbors.size() > lists.list.size()) throw Error("two nodes share a list");
    offsets.push_back(static_cast<std::int32_t>(neighbors.size()));
  }
  return {offsets, neighbors, std::move(is_boundary)};
}

}  // namespace delone::delaunay
