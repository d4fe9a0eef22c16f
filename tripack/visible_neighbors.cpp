#include "tripack/visible_neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "tripack/distance_order.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double beyond(double v, double a, double b) {
  return std::max({0.0, std::min(a, b) - v, v - std::max(a, b)});
}

// At most the distance of p from any point of the edge a-b, whatever rounding does.
double least_distance(Point2 p, Point2 a, Point2 b) {
  return std::hypot(beyond(p.x, a.x, b.x), beyond(p.y, a.y, b.y)) * (1 - 0x1p-50);
}

// A node as seen from `source`, come to in the sector of `arrival`, a half-edge that
// leaves it.
struct Arrival {
  double distance;
  Point2 at, source_at;
  Site node, source;
  HalfEdge arrival;
};

bool is_later(const Arrival& a, const Arrival& b) {
  const auto key = [](const Arrival& v) {
    return std::tuple(v.distance, v.at.x, v.at.y, v.source_at.x, v.source_at.y);
  };
  return key(a) > key(b);
}

// What a source sees through `edge`, which has the source's side on its left: between the
// rays through `right` and `left`.
struct Sight {
  double least;  // no node beyond is nearer along this path
  double at_source;
  Site source, right, left;
  HalfEdge edge;
};

bool is_farther(const Sight& a, const Sight& b) { return a.least > b.least; }

}  // namespace

struct VisibleNodes::State {
  explicit State(const ConstrainedTriangulation& triangulation) : t(triangulation) {}

  const ConstrainedTriangulation& t;

  template <class T>
  using Queue = std::priority_queue<T, std::vector<T>, bool (*)(const T&, const T&)>;
  Queue<Arrival> arrivals{is_later};
  Queue<Sight> sights{is_farther};
  std::unordered_set<HalfEdge> seen_from{};  // sectors
  std::unordered_set<Site> reached{};

  [[nodiscard]] const ClosedMesh& mesh() const { return t.mesh(); }
  [[nodiscard]] Point2 point(Site v) const { return t.points()[at(v)]; }
  [[nodiscard]] int side(Site a, Site b, Site c) const {
    return orientation(point(a), point(b), point(c));
  }

  [[nodiscard]] bool is_turning_point(Site v) const;
  [[nodiscard]] HalfEdge sector_of(HalfEdge e) const;
  void begin(Site v);
  void arrive_at(Site v, Site source, double at_source, HalfEdge arrival);
  void arrive(Site source, double at_source, HalfEdge e);
  void look(Site source, double at_source, HalfEdge sector);
  void look_through(Sight sight);
  void look_on(const Sight& sight);
  void reach_all_in_line(Site v);
  [[nodiscard]] std::optional<PathNeighbor> next();
};

bool VisibleNodes::State::is_turning_point(Site v) const {
  const HalfEdge first = mesh().edge_at(v);
  HalfEdge e = first;
  do {
    if (mesh().is_constraint(e)) return true;
    e = mesh().next_around(e);
  } while (e != first);
  return false;
}

// The same for all faces of a sector: the wall that bounds it on the right, seen from the
// node.
HalfEdge VisibleNodes::State::sector_of(HalfEdge e) const {
  const HalfEdge first = e;
  while (!mesh().is_constraint(e)) {
    e = mesh().previous_around(e);
    if (e == first) return mesh().edge_at(mesh().origin(e));
  }
  return e;
}

void VisibleNodes::State::begin(Site v) {
  arrivals = Queue<Arrival>{is_later};
  sights = Queue<Sight>{is_farther};
  seen_from.clear();
  reached = {v};
  if (mesh().num_faces() == 0) return reach_all_in_line(v);
  const HalfEdge first = mesh().edge_at(v);
  HalfEdge e = first;
  do {
    look(v, 0, sector_of(e));
    e = mesh().next_around(e);
  } while (e != first);
}

// Walls along the line are in nobody's way.
void VisibleNodes::State::reach_all_in_line(Site v) {
  for (Site w = 0; w < t.num_sites(); ++w) arrive_at(w, v, 0, none);
}

void VisibleNodes::State::arrive_at(Site v, Site source, double at_source,
                                    HalfEdge arrival) {
  const Point2 p = point(v), q = point(source);
  arrivals.push({at_source + distance(q, p), p, q, v, source, arrival});
}

// At the origin of `e`, through the face on its left.
void VisibleNodes::State::arrive(Site source, double at_source, HalfEdge e) {
  const Site v = mesh().origin(e);
  if (v != t.infinity()) arrive_at(v, source, at_source, e);
}

// From the source over the faces of a sector, those beyond the hull included: along the
// outer side of a wall there is a way, too.
void VisibleNodes::State::look(Site source, double at_source, HalfEdge sector) {
  if (!seen_from.insert(sector).second) return;
  HalfEdge e = sector;
  do {
    const HalfEdge opposite = ClosedMesh::next(e);
    arrive(source, at_source, opposite);
    arrive(source, at_source, ClosedMesh::next(opposite));
    const Site right = mesh().origin(opposite), left = mesh().target(opposite);
    if (right != t.infinity() && left != t.infinity())
      look_through({at_source, at_source, source, right, left, opposite});
    e = mesh().next_around(e);
  } while (e != sector && !mesh().is_constraint(e));
}

void VisibleNodes::State::look_through(Sight sight) {
  const Site a = mesh().origin(sight.edge), b = mesh().target(sight.edge);
  if (mesh().is_constraint(sight.edge)) return;
  if (mesh().apex(mesh().reverse(sight.edge)) == t.infinity()) return;
  const double least =
      sight.at_source + least_distance(point(sight.source), point(a), point(b));
  sight.least = std::max(sight.least, least);
  sights.push(sight);
}

// Into the face beyond the edge. A node exactly on the ray of a node without walls is
// seen past that; one on the ray of a turning point is not: the path turns there, if only
// by nothing.
void VisibleNodes::State::look_on(const Sight& sight) {
  const HalfEdge back = mesh().reverse(sight.edge);
  const HalfEdge from_right = ClosedMesh::next(back),
                 to_left = ClosedMesh::previous(back);
  const Site x = mesh().origin(to_left);
  const int of_right = side(sight.source, sight.right, x);
  const int of_left = side(sight.source, sight.left, x);
  const bool is_seen = of_right >= 0 && of_left <= 0 &&
                       (of_right != 0 || !is_turning_point(sight.right)) &&
                       (of_left != 0 || !is_turning_point(sight.left));
  if (is_seen) arrive(sight.source, sight.at_source, to_left);
  Sight right = sight, left = sight;
  right.edge = from_right;
  left.edge = to_left;
  if (of_left < 0 || is_seen) right.left = x;
  if (of_right > 0 || is_seen) left.right = x;
  if (of_right > 0) look_through(right);
  if (of_left < 0) look_through(left);
}

std::optional<PathNeighbor> VisibleNodes::State::next() {
  for (;;) {
    if (!sights.empty() &&
        (arrivals.empty() || sights.top().least <= arrivals.top().distance)) {
      const Sight sight = sights.top();
      sights.pop();
      look_on(sight);
      continue;
    }
    if (arrivals.empty()) return std::nullopt;
    const Arrival found = arrivals.top();
    arrivals.pop();
    if (found.arrival != none && is_turning_point(found.node))
      look(found.node, found.distance, sector_of(found.arrival));
    if (!reached.insert(found.node).second) continue;
    return PathNeighbor{t.rows()[at(found.node)], found.distance,
                        t.rows()[at(found.source)]};
  }
}

VisibleNodes::VisibleNodes(const ConstrainedTriangulation& t)
    : state_(std::make_unique<State>(t)) {}
VisibleNodes::~VisibleNodes() = default;
VisibleNodes::VisibleNodes(VisibleNodes&&) noexcept = default;
VisibleNodes& VisibleNodes::operator=(VisibleNodes&&) noexcept = default;

void VisibleNodes::start(Node row) {
  if (row < 0 || row >= state_->t.num_rows()) {
    throw Error("there is no row " + std::to_string(row) + "; the triangulation has " +
                    std::to_string(state_->t.num_rows()),
                {row});
  }
  state_->begin(state_->t.sites()[at(row)]);
}

std::optional<PathNeighbor> VisibleNodes::next() { return state_->next(); }

std::vector<PathNeighbor> nearest_k_visible(const ConstrainedTriangulation& t, Node row,
                                            std::int32_t k) {
  if (k < 1) throw Error("k is " + std::to_string(k) + "; it must be at least 1");
  VisibleNodes nodes(t);
  nodes.start(row);
  std::vector<PathNeighbor> result;
  while (std::cmp_less(result.size(), k)) {
    const auto found = nodes.next();
    if (!found) break;
    result.push_back(*found);
  }
  return result;
}

}  // namespace delone::tripack
