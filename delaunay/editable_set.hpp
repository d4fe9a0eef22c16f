#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "delaunay/buffer.hpp"
#include "delaunay/curve_order.hpp"
#include "delaunay/editable_surface.hpp"
#include "delaunay/error.hpp"

namespace delone::delaunay {

/// What the set needs besides: `Key key(p)`, equal for equal positions; `is_preferred(p,
/// q)`: of two forms of one position, does p stand for both? `has_arc(p, q)`: is there
/// one arc between two positions? `Triangulation`, the room's.
template <class G>
concept EditableSetGeometry = EditableGeometry<G> &&
    requires(const typename G::Point& p, std::span<const typename G::Point> points) {
  typename G::Triangulation;
  { G::key(p) } -> std::same_as<typename G::Key>;
  { G::is_preferred(p, p) } -> std::same_as<bool>;
  { G::has_arc(p, p) } -> std::same_as<bool>;
};

/// The rows of an editor: numbered points that come and go, several of which may share a
/// position. Positions are the nodes of a surface, numbered from 1; while they are flat,
/// they are kept in a map. Forced arcs join rows; the surface has them as walls between
/// nodes, but while it is flat.
template <EditableSetGeometry G>
class EditableSet {
 public:
  using Point = typename G::Point;
  using Triangulation = typename G::Triangulation;
  using Arc = std::array<Node, 2>;

  EditableSet() = default;
  explicit EditableSet(const Triangulation& t);

  /// Row numbers in use are below this.
  [[nodiscard]] Node num_rows() const noexcept {
    return static_cast<Node>(node_of_row_.size());
  }
  [[nodiscard]] Node num_points() const noexcept {
    return num_rows() - static_cast<Node>(free_rows_.size());
  }
  [[nodiscard]] Site num_sites() const noexcept {
    return static_cast<Site>(row_of_node_.size() - 1 - free_nodes_.size());
  }
  [[nodiscard]] bool has(Node row) const noexcept {
    return row >= 0 && row < num_rows() && node_of_row_[at(row)] != none;
  }
  [[nodiscard]] std::vector<Node> rows() const;
  [[nodiscard]] Point point(Node row) const;
  [[nodiscard]] Node representative(Node row) const {
    return row_of_node_[at(node_of(row))];
  }

  Node insert(const Point& p, Node hint);
  void remove(Node row);
  void move(Node row, const Point& p);

  void force(Node a, Node b);
  void release(Node a, Node b);
  [[nodiscard]] bool is_forced(Node a, Node b) const { return arcs_.contains({a, b}); }
  /// Smaller row first, sorted.
  [[nodiscard]] std::vector<Arc> arcs() const;

  /// Points of rows(), in their order.
  [[nodiscard]] std::vector<Point> points() const;
  /// Lists of the sites whose first rows, as places in rows(), are `first`: of the
  /// Delaunay triangulation without the forced arcs, and of that with them.
  [[nodiscard]] Adjacency adjacency(std::span<const Node> live,
                                    std::span<const Node> first) const;
  [[nodiscard]] Adjacency forced_adjacency(std::span<const Node> live,
                                           std::span<const Node> first) const {
    return lists(surface_, live, first);
  }
  /// For checking: the nodes' surface, unless flat, and the node of a row.
  [[nodiscard]] const EditableSurface<G>& surface() const noexcept { return surface_; }
  [[nodiscard]] Site node(Node row) const { return node_of(row); }

 private:
  /// One of several rows at a position.
  struct Repeat {
    Node row;
    Point point;
  };

  static std::size_t at(std::int32_t i) noexcept { return static_cast<std::size_t>(i); }
  void check_has(Node row) const;
  [[nodiscard]] Site node_of(Node row) const {
    check_has(row);
    return node_of_row_[at(row)];
  }
  /// Throws if the row cannot go: forced arcs end at it, or cross there.
  void check_leaves(Node row) const;
  [[nodiscard]] bool is_on_arc(const Arc& arc, Site v) const;
  [[noreturn]] void refuse_node(Node row) const;
  [[noreturn]] void refuse_crossing(const Arc& arc, Site u, Site v) const;
  static std::string name_of(const Arc& arc) {
    return std::to_string(arc[0]) + "-" + std::to_string(arc[1]);
  }
  [[nodiscard]] Adjacency lists(const EditableSurface<G>& surface,
                                std::span<const Node> live,
                                std::span<const Node> first) const;
  [[nodiscard]] Node new_row();
  [[nodiscard]] Site new_node(Node row, const Point& p);
  void put(Node row, const Point& p, Site hint);
  /// Takes the row out of its position; returns a node near it, or none.
  Site take(Node row);
  void add_repeat(Node row, const Point& p, Site node);
  void take_repeat(Node row, Site node);
  void replace_point(Site node, const Point& p);

  // Nodes in and out of the surface, or of the map of flat sets.
  [[nodiscard]] Site find_in_chain(const Point& p) const;
  [[nodiscard]] bool is_on_chain(Site v) const;
  void add_to_chain(Site v);
  void attach(Site v, Site hint);
  void detach(Site v);
  void raise_surface();

  EditableSurface<G> surface_;
  std::multimap<typename G::Key, Site> chain_;  // all nodes, if the surface is flat
  Buffer<Site> node_of_row_;                    // none: no such row
  std::vector<Node> free_rows_;
  Buffer<Node> row_of_node_{none};
  std::vector<Site> free_nodes_;
  // Nodes with several rows: all their rows.
  std::unordered_map<Site, std::vector<Repeat>> repeats_;
  std::set<Arc> arcs_;  // each from both its ends
};

template <EditableSetGeometry G>
EditableSet<G>::EditableSet(const Triangulation& t) {
  node_of_row_.reserve(t.sites().size());
  for (const Site s : t.sites()) node_of_row_.push_back(s + 1);
  row_of_node_.insert(row_of_node_.end(), t.rows().begin(), t.rows().end());
  std::vector<Site> number;
  for (Site s = 0; s < t.num_sites(); ++s) {
    number.push_back(s + 1);
    surface_.set_point(s + 1, t.points()[at(s)]);
  }
  for (Node row = 0; row < num_rows() && t.num_sites() < num_rows(); ++row) {
    const Site node = node_of_row_[at(row)];
    const Node first = row_of_node_[at(node)];
    if (first == row) continue;
    auto& rows = repeats_[node];
    if (rows.empty()) rows.push_back({first, surface_.point(node)});
    rows.push_back({row, surface_.point(node)});
  }
  if (t.dimension() == 2) {
    surface_.build(t.adjacency(), std::move(number));
  } else {
    for (const Site v : number) add_to_chain(v);
  }
}

template <EditableSetGeometry G>
std::vector<Node> EditableSet<G>::rows() const {
  std::vector<Node> live;
  live.reserve(at(num_points()));
  for (Node row = 0; row < num_rows(); ++row) {
    if (has(row)) live.push_back(row);
  }
  return live;
}

template <EditableSetGeometry G>
auto EditableSet<G>::points() const -> std::vector<Point> {
  std::vector<Point> points;
  points.reserve(at(num_points()));
  for (Node row = 0; row < num_rows(); ++row) {
    if (has(row)) points.push_back(point(row));
  }
  return points;
}

template <EditableSetGeometry G>
void EditableSet<G>::check_has(Node row) const {
  if (has(row)) return;
  throw Error("row " + std::to_string(row) +
                  " is not in the set: it was removed, or never inserted",
              {row});
}

template <EditableSetGeometry G>
auto EditableSet<G>::point(Node row) const -> Point {
  const Site node = node_of(row);
  if (const auto repeat = repeats_.find(node); repeat != repeats_.end()) {
    for (const Repeat& r : repeat->second) {
      if (r.row == row) return r.point;
    }
  }
  return surface_.point(node);
}

template <EditableSetGeometry G>
Node EditableSet<G>::insert(const Point& p, Node hint) {
  const Site near = has(hint) ? node_of(hint) : none;
  if (free_rows_.empty()) check_num_points(node_of_row_.size() + 1);
  const Node row = new_row();
  put(row, p, near);
  return row;
}

template <EditableSetGeometry G>
void EditableSet<G>::remove(Node row) {
  check_has(row);
  check_leaves(row);
  take(row);
  node_of_row_[at(row)] = none;
  free_rows_.push_back(row);
}

template <EditableSetGeometry G>
void EditableSet<G>::move(Node row, const Point& p) {
  check_has(row);
  check_leaves(row);
  put(row, p, take(row));
}

template <EditableSetGeometry G>
void EditableSet<G>::force(Node a, Node b) {
  const Site u = node_of(a), v = node_of(b);
  const std::string name = "rows " + std::to_string(a) + " and " + std::to_string(b);
  if (u == v) throw Error(name + " have one position: there is no arc to force", {a, b});
  if (!G::has_arc(surface_.point(u), surface_.point(v)))
    throw Error(name +
                    " are antipodes, which many arcs join; force arcs over a point "
                    "between",
                {a, b});
  if (is_forced(a, b)) return;
  surface_.open();
  if (!surface_.is_flat()) {
    surface_.force(u, v, [&](Site from, Site to) { refuse_crossing({a, b}, from, to); });
  }
  arcs_.insert({a, b});
  arcs_.insert({b, a});
}

template <EditableSetGeometry G>
void EditableSet<G>::release(Node a, Node b) {
  if (!is_forced(a, b)) {
    throw Error("there is no forced arc between rows " + std::to_string(a) + " and " +
                    std::to_string(b),
                {a, b});
  }
  if (!surface_.is_flat()) surface_.release(node_of(a), node_of(b));
  arcs_.erase({a, b});
  arcs_.erase({b, a});
}

template <EditableSetGeometry G>
auto EditableSet<G>::arcs() const -> std::vector<Arc> {
  std::vector<Arc> result;
  for (const Arc& arc : arcs_) {
    if (arc[0] < arc[1]) result.push_back(arc);
  }
  return result;
}

template <EditableSetGeometry G>
void EditableSet<G>::check_leaves(Node row) const {
  if (arcs_.empty()) return;
  const auto arc = arcs_.lower_bound({row, 0});
  if (arc != arcs_.end() && (*arc)[0] == row) {
    throw Error("row " + std::to_string(row) + " is an end of the arc forced to row " +
                    std::to_string((*arc)[1]) + "; release the arc first",
                {row, (*arc)[1]});
  }
  const Site node = node_of_row_[at(row)];
  if (surface_.is_flat() || repeats_.contains(node)) return;
  if (surface_.num_walls_at(node) > 2) refuse_node(row);
}

template <EditableSetGeometry G>
bool EditableSet<G>::is_on_arc(const Arc& arc, Site v) const {
  const Site a = node_of_row_[at(arc[0])], b = node_of_row_[at(arc[1])];
  if (v == a || v == b) return true;
  const typename G::Segments segments = surface_.segments();
  return segments.orientation(a, b, v) == 0 && segments.is_ahead(a, b, v) &&
         segments.is_ahead(b, a, v);
}

// Two arcs of different lines: the second has no end on the first one's.
template <EditableSetGeometry G>
void EditableSet<G>::refuse_node(Node row) const {
  const Site node = node_of_row_[at(row)];
  const typename G::Segments segments = surface_.segments();
  std::vector<Arc> crossing;
  for (const Arc& arc : arcs()) {
    if (!is_on_arc(arc, node)) continue;
    if (crossing.empty() ||
        segments.orientation(node_of(crossing[0][0]), node, node_of(arc[0])) != 0)
      crossing.push_back(arc);
    if (crossing.size() == 2) break;
  }
  throw Error("row " + std::to_string(row) + " is where the forced arcs " +
                  name_of(crossing[0]) + " and " + name_of(crossing[1]) +
                  " cross; release one of them first",
              {row, crossing[0][0], crossing[0][1], crossing[1][0], crossing[1][1]});
}

template <EditableSetGeometry G>
void EditableSet<G>::refuse_crossing(const Arc& arc, Site u, Site v) const {
  const Arc other = *std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& forced) {
    return is_on_arc(forced, u) && is_on_arc(forced, v);
  });
  throw Error("the arc " + name_of(arc) + " would cross the forced arc " +
                  name_of(other) +
                  "; release that, or force both over a point that they share",
              {arc[0], arc[1], other[0], other[1]});
}

template <EditableSetGeometry G>
Node EditableSet<G>::new_row() {
  if (free_rows_.empty()) {
    node_of_row_.push_back(none);
    return num_rows() - 1;
  }
  const Node row = free_rows_.back();
  free_rows_.pop_back();
  return row;
}

template <EditableSetGeometry G>
Site EditableSet<G>::new_node(Node row, const Point& p) {
  Site node = static_cast<Site>(row_of_node_.size());
  if (free_nodes_.empty()) {
    row_of_node_.push_back(row);
  } else {
    node = free_nodes_.back();
    free_nodes_.pop_back();
    row_of_node_[at(node)] = row;
  }
  surface_.set_point(node, p);
  node_of_row_[at(row)] = node;
  return node;
}

template <EditableSetGeometry G>
void EditableSet<G>::put(Node row, const Point& p, Site hint) {
  if (surface_.is_flat()) {
    const Site same = find_in_chain(p);
    if (same != none) return add_repeat(row, p, same);
    return attach(new_node(row, p), hint);
  }
  const auto found = surface_.locate(p, hint);
  if (found.node != none) return add_repeat(row, p, found.node);
  surface_.insert(new_node(row, p), found);
}

template <EditableSetGeometry G>
Site EditableSet<G>::take(Node row) {
  const Site node = node_of_row_[at(row)];
  if (!repeats_.empty() && repeats_.contains(node)) {
    take_repeat(row, node);
    return node;
  }
  detach(node);
  free_nodes_.push_back(node);
  return surface_.is_flat() ? none : surface_.last();
}

template <EditableSetGeometry G>
void EditableSet<G>::add_repeat(Node row, const Point& p, Site node) {
  auto& rows = repeats_[node];
  if (rows.empty()) rows.push_back({row_of_node_[at(node)], surface_.point(node)});
  rows.push_back({row, p});
  node_of_row_[at(row)] = node;
  if (G::is_preferred(p, surface_.point(node))) replace_point(node, p);
}

template <EditableSetGeometry G>
void EditableSet<G>::take_repeat(Node row, Site node) {
  auto& rows = repeats_.find(node)->second;
  std::erase_if(rows, [&](const Repeat& r) { return r.row == row; });
  row_of_node_[at(node)] = rows.front().row;
  Point best = rows.front().point;
  for (const Repeat& r : rows) {
    if (G::is_preferred(r.point, best)) best = r.point;
  }
  if (rows.size() == 1) repeats_.erase(node);
  if (best != surface_.point(node)) replace_point(node, best);
}

// The same position, but another form of it stands for all and breaks ties its own way.
template <EditableSetGeometry G>
void EditableSet<G>::replace_point(Site node, const Point& p) {
  if (!arcs_.empty() && !surface_.is_flat()) return surface_.restate(node, p);
  detach(node);
  surface_.set_point(node, p);
  attach(node, none);
}

template <EditableSetGeometry G>
Site EditableSet<G>::find_in_chain(const Point& p) const {
  const auto [begin, end] = chain_.equal_range(G::key(p));
  for (auto i = begin; i != end; ++i) {
    if (G::is_same(surface_.point(i->second), p)) return i->second;
  }
  return none;
}

// Three of the nodes tell: on the sphere two of them may be opposite to each other.
template <EditableSetGeometry G>
bool EditableSet<G>::is_on_chain(Site v) const {
  std::vector<Site> nodes;
  for (auto i = chain_.begin(); i != chain_.end() && nodes.size() < 3; ++i)
    nodes.push_back(i->second);
  nodes.push_back(v);
  return G::is_flat(surface_.points(), nodes);
}

template <EditableSetGeometry G>
void EditableSet<G>::add_to_chain(Site v) {
  chain_.emplace(G::key(surface_.point(v)), v);
}

template <EditableSetGeometry G>
void EditableSet<G>::attach(Site v, Site hint) {
  if (!surface_.is_flat())
    return surface_.insert(v, surface_.locate(surface_.point(v), hint));
  const bool stays_flat = is_on_chain(v);
  add_to_chain(v);
  if (!stays_flat) raise_surface();
}

template <EditableSetGeometry G>
void EditableSet<G>::detach(Site v) {
  if (!surface_.is_flat()) {
    for (const Site w : surface_.remove(v)) add_to_chain(w);
    return;
  }
  auto i = chain_.lower_bound(G::key(surface_.point(v)));
  while (i->second != v) ++i;
  chain_.erase(i);
}

// The node that ends flatness is a neighbour of all others: building anew costs O(degree)
// but for sorting.
template <EditableSetGeometry G>
void EditableSet<G>::raise_surface() {
  std::vector<Site> nodes;
  std::vector<Point> points;
  for (const auto& [key, node] : chain_) {
    nodes.push_back(node);
    points.push_back(surface_.point(node));
  }
  chain_.clear();
  const Triangulation t(points, RunOptions{.num_threads = 1, .progress = {}});
  std::vector<Site> number;
  for (const Node row : t.rows()) number.push_back(nodes[at(row)]);
  surface_.build(t.adjacency(), std::move(number));
  for (const Arc& arc : arcs()) {
    surface_.force(node_of(arc[0]), node_of(arc[1]),
                   [&](Site u, Site v) { refuse_crossing(arc, u, v); });
  }
}

template <EditableSetGeometry G>
Adjacency EditableSet<G>::adjacency(std::span<const Node> live,
                                    std::span<const Node> first) const {
  if (arcs_.empty()) return lists(surface_, live, first);
  EditableSurface<G> released = surface_;
  for (const auto& [a, b] : arcs()) released.release(node_of(a), node_of(b));
  return lists(released, live, first);
}

template <EditableSetGeometry G>
Adjacency EditableSet<G>::lists(const EditableSurface<G>& surface,
                                std::span<const Node> live,
                                std::span<const Node> first) const {
  const auto num_sites = static_cast<Site>(first.size());
  std::vector<Site> number(row_of_node_.size(), none);
  number[0] = num_sites;
  for (Site s = 0; s < num_sites; ++s)
    number[at(node_of_row_[at(live[at(first[at(s)])])])] = s;
  const ClosedMesh& mesh = surface.mesh();
  return Adjacency(
      mesh.renumbered(number, num_sites + 1).to_lists(num_sites, [&](std::int32_t f) {
        return !surface.is_front(f);
      }));
}

}  // namespace delone::delaunay
