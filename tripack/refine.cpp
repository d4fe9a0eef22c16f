#include "tripack/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "tripack/constrained_builder.hpp"

namespace delone::tripack {

namespace {

using delaunay::MeshPlace;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double squared_length(Point2 a, Point2 b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return dx * dx + dy * dy;
}

double twice_area(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Is p inside the circle with diameter a-b?
bool encroaches(Point2 p, Point2 a, Point2 b) {
  return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0;
}

Point2 circumcenter(Point2 a, Point2 b, Point2 c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double d = 2 * (bx * cy - by * cx);
  return {a.x + (cy * bb - by * cc) / d, a.y + (bx * cc - cx * bb) / d};
}

/// A triangle as the queue knows it: a face may have been replaced since.
struct Candidate {
  std::int32_t face;
  std::array<Site, 3> node;
};

class Refiner {
 public:
  Refiner(const PlanarGraph& graph, const RefineOptions& options, const RunOptions& run)
      : graph_(graph),
        options_(options),
        builder_(graph, options.constraints, run),
        squared_sine_(
            std::pow(std::sin(options.min_angle_deg * std::numbers::pi / 180), 2)) {}

  Refinement run() {
    if (builder_.mesh().mesh().num_faces() > 0) {
      label();
      queue_all();
      work();
    }
    return measured();
  }

 private:
  using Edge = ConstraintBuilder::Mesh::Edge;

  [[nodiscard]] const ClosedMesh& mesh() { return builder_.mesh().mesh(); }
  [[nodiscard]] Point2 at_site(Site v) const { return builder_.position(v); }
  [[nodiscard]] bool is_inside(HalfEdge e) {
    return builder_.mesh().label(ClosedMesh::face_of(e)) != none;
  }

  void label() {
    delaunay::DomainFaces domain = builder_.classify();
    for (const DomainRegion& region : domain.regions) {
      const double own =
          region.seed == none ? 0 : graph_.regions[at(region.seed)].max_area;
      const bool has_both = own > 0 && options_.max_area > 0;
      max_areas_.push_back(has_both ? std::min(own, options_.max_area)
                                    : std::max(own, options_.max_area));
    }
    builder_.mesh().set_labels(std::move(domain.region_of_face));
  }

  void queue_all() {
    for (std::int32_t f = 0; f < mesh().num_face_slots(); ++f) {
      if (mesh().is_free(f) || !is_inside(ClosedMesh::half_edge(f, 0))) continue;
      triangles_.push_back({f, mesh().face(f).node});
      for (std::size_t k = 0; k < 3; ++k) {
        const HalfEdge e = ClosedMesh::half_edge(f, k);
        if (!mesh().is_constraint(e)) continue;
        const Edge ends = ends_of(e);
        segments_.push_back(ends);
        note_acute(e);
      }
    }
  }

  [[nodiscard]] Edge ends_of(HalfEdge e) {
    const Site a = mesh().origin(e), b = mesh().target(e);
    return {std::min(a, b), std::max(a, b)};
  }

  // Does the segment from v meet the next one that leaves v at less than 60 degrees?
  // Then its pieces are to end on shells about v.
  void note_acute(HalfEdge e) {
    const Site v = mesh().origin(e);
    const Point2 p = at_site(v), a = at_site(mesh().target(e));
    HalfEdge next = mesh().next_around(e);
    while (next != e && !mesh().is_constraint(next) && is_inside(next))
      next = mesh().next_around(next);
    if (next == e || !mesh().is_constraint(next)) return;
    const Point2 b = at_site(mesh().target(next));
    const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
    const double turn = twice_area(p, a, b);
    if (dot > 0 && turn > 0 && turn < std::numbers::sqrt3 * dot) is_acute_.insert(v);
  }

  void work() {
    while (!is_full() && (!segments_.empty() || !triangles_.empty())) {
      if (!segments_.empty()) {
        const Edge ends = segments_.back();
        segments_.pop_back();
        const HalfEdge e = mesh().find(ends[0], ends[1]);
        if (e != none && mesh().is_constraint(e) && is_encroached(e)) divide(e);
      } else {
        const Candidate candidate = triangles_.front();
        triangles_.pop_front();
        const bool is_there = !mesh().is_free(candidate.face) &&
                              mesh().face(candidate.face).node == candidate.node;
        if (is_there && is_bad(candidate.face)) improve(candidate);
      }
    }
  }

  [[nodiscard]] bool is_full() const { return num_added_ >= options_.max_added; }

  [[nodiscard]] bool is_encroached(HalfEdge e) {
    const Point2 a = at_site(mesh().origin(e)), b = at_site(mesh().target(e));
    for (const HalfEdge side : {e, mesh().reverse(e)}) {
      if (is_inside(side) && encroaches(at_site(mesh().apex(side)), a, b)) return true;
    }
    return false;
  }

  // Where a segment is divided: in the middle, or on a shell about its acute end.
  [[nodiscard]] Point2 division(Site a, Site b) {
    const bool a_is_acute = is_acute_.contains(a), b_is_acute = is_acute_.contains(b);
    double t = 0.5;
    if (a_is_acute != b_is_acute) {
      const double length = std::sqrt(squared_length(at_site(a), at_site(b)));
      // The power of two between 1/3 and 2/3 of the length, or near to it.
      const double shell = std::exp2(std::round(std::log2(length / 2)));
      t = a_is_acute ? shell / length : 1 - shell / length;
    }
    const Point2 p = at_site(a), q = at_site(b);
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

  // Divides a constraint; false if doubles do not hold the new vertex.
  bool divide(HalfEdge e) {
    const HalfEdge back = mesh().reverse(e);
    const Site a = mesh().origin(e), b = mesh().target(e);
    const Point2 middle = division(a, b);
    // Lengths beyond the range of doubles, or below it.
    if (!std::isfinite(middle.x) || !std::isfinite(middle.y)) return false;
    const Site v = builder_.add_site(middle);
    if (!fits(e, v) || !fits(back, v)) {
      builder_.drop_site();
      return false;
    }
    const auto [root_a, root_b] = roots_of(a, b);
    builder_.mesh().insert_at({MeshPlace::Kind::edge, e, none}, v);
    roots_[v] = {root_a, root_b};
    added(v);
    return true;
  }

  // Are the two faces that v makes of the one at `e` counter-clockwise?
  [[nodiscard]] bool fits(HalfEdge e, Site v) {
    const Site a = mesh().origin(e), b = mesh().target(e), c = mesh().apex(e);
    if (c == builder_.mesh().ghost())
      return !(at_site(v) == at_site(a)) && !(at_site(v) == at_site(b));
    return orientation(at_site(a), at_site(v), at_site(c)) > 0 &&
           orientation(at_site(v), at_site(b), at_site(c)) > 0;
  }

  // The ends of the undivided segment that the piece a-b belongs to.
  [[nodiscard]] Edge roots_of(Site a, Site b) const {
    const auto root_a = roots_.find(a), root_b = roots_.find(b);
    if (root_a != roots_.end()) return root_a->second;
    if (root_b != roots_.end()) return root_b->second;
    return {a, b};
  }

  [[nodiscard]] std::array<Point2, 3> corners(std::int32_t f) {
    const auto& node = mesh().face(f).node;
    return {at_site(node[0]), at_site(node[1]), at_site(node[2])};
  }

  // The corner opposite to the shortest edge has the smallest angle.
  [[nodiscard]] std::size_t sharpest(const std::array<Point2, 3>& p) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (squared_length(p[(k + 1) % 3], p[(k + 2) % 3]) <
          squared_length(p[(best + 1) % 3], p[(best + 2) % 3]))
        best = k;
    }
    return best;
  }

  [[nodiscard]] static double squared_sine(const std::array<Point2, 3>& p,
                                           std::size_t k) {
    const Point2 a = p[k], b = p[(k + 1) % 3], c = p[(k + 2) % 3];
    const double area = twice_area(a, b, c);
    return area * area / (squared_length(a, b) * squared_length(a, c));
  }

  [[nodiscard]] bool is_too_large(std::int32_t f, const std::array<Point2, 3>& p) {
    const double most = max_areas_[at(builder_.mesh().label(f))];
    return most > 0 && twice_area(p[0], p[1], p[2]) > 2 * most;
  }

  [[nodiscard]] bool is_bad(std::int32_t f) {
    if (builder_.mesh().label(f) == none) return false;
    const auto p = corners(f);
    if (is_too_large(f, p)) return true;
    const std::size_t k = sharpest(p);
    if (squared_sine(p, k) >= squared_sine_) return false;
    const auto& node = mesh().face(f).node;
    return !are_on_one_shell(node[(k + 1) % 3], node[(k + 2) % 3]);
  }

  // Are both on segments with a common end, equally far from it? The edge between them is
  // as short as the angle there makes it.
  [[nodiscard]] bool are_on_one_shell(Site p, Site q) const {
    const auto root_p = roots_.find(p), root_q = roots_.find(q);
    if (root_p == roots_.end() || root_q == roots_.end()) return false;
    for (const Site end : root_p->second) {
      if (end != root_q->second[0] && end != root_q->second[1]) continue;
      const double far_p = squared_length(at_site(p), at_site(end));
      const double far_q = squared_length(at_site(q), at_site(end));
      if (std::abs(far_p - far_q) <= 1e-3 * far_p) return true;
    }
    return false;
  }

  // Puts a vertex at the circle's centre, or divides the segments that it would be too
  // close to.
  void improve(const Candidate& candidate) {
    const auto p = corners(candidate.face);
    const Point2 center = circumcenter(p[0], p[1], p[2]);
    if (!std::isfinite(center.x) || !std::isfinite(center.y)) return;
    const Site v = builder_.add_site(center);
    HalfEdge wall = find_wall(candidate, v);
    MeshPlace place;
    if (wall == none) {
      place = builder_.mesh().locate(v, candidate.node[0]);
      const bool is_edge = place.kind == MeshPlace::Kind::edge;
      if (is_edge && mesh().is_constraint(place.at)) wall = place.at;
    }
    if (wall != none) {
      builder_.drop_site();
      if (divide(wall)) triangles_.push_back(candidate);
      return;
    }
    if (place.kind == MeshPlace::Kind::site || !is_inside(place.at)) {
      builder_.drop_site();
      return;
    }
    const std::vector<Edge> walls = encroached_by(v, place);
    if (walls.empty()) {
      builder_.mesh().insert_at(place, v);
      added(v);
      return;
    }
    builder_.drop_site();
    bool has_divided = false;
    for (const Edge& ends : walls) {
      const HalfEdge e = mesh().find(ends[0], ends[1]);
      if (e != none && mesh().is_constraint(e)) has_divided = divide(e) || has_divided;
    }
    if (has_divided) triangles_.push_back(candidate);
  }

  // The first constraint between the triangle and v, or none: a walk straight from its
  // middle.
  [[nodiscard]] HalfEdge find_wall(const Candidate& candidate, Site v) {
    HalfEdge e = ClosedMesh::half_edge(candidate.face, 0);
    for (std::int32_t steps = 0; steps < mesh().num_face_slots(); ++steps) {
      HalfEdge out = none;
      for (int k = 0; k < 3 && out == none; ++k, e = ClosedMesh::next(e)) {
        if (orientation(at_site(mesh().origin(e)), at_site(mesh().target(e)),
                        at_site(v)) < 0)
          out = e;
      }
      if (out == none) return none;
      if (mesh().is_constraint(out)) return out;
      e = mesh().reverse(out);
      // The edge that was crossed last is asked last.
      e = ClosedMesh::next(e);
    }
    return none;
  }

  // Constraints around the faces whose circles hold v that v would be too close to.
  [[nodiscard]] std::vector<Edge> encroached_by(Site v, const MeshPlace& place) {
    std::vector<Edge> walls;
    std::vector<std::int32_t> open{ClosedMesh::face_of(place.at)}, seen = open;
    while (!open.empty()) {
      const std::int32_t f = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const HalfEdge e = ClosedMesh::half_edge(f, k);
        if (mesh().is_constraint(e)) {
          if (encroaches(at_site(v), at_site(mesh().origin(e)),
                         at_site(mesh().target(e))))
            walls.push_back(ends_of(e));
          continue;
        }
        const std::int32_t other = ClosedMesh::face_of(mesh().reverse(e));
        const auto& node = mesh().face(other).node;
        if (std::find(seen.begin(), seen.end(), other) != seen.end() ||
            in_circle(at_site(node[0]), at_site(node[1]), at_site(node[2]), at_site(v)) <=
                0)
          continue;
        open.push_back(other);
        seen.push_back(other);
      }
    }
    return walls;
  }

  // Queues what the new vertex changed: the faces round it and the segments across.
  void added(Site v) {
    ++num_added_;
    const HalfEdge first = mesh().edge_at(v);
    HalfEdge e = first;
    do {
      if (is_inside(e)) {
        const std::int32_t f = ClosedMesh::face_of(e);
        triangles_.push_back({f, mesh().face(f).node});
        const HalfEdge across = ClosedMesh::next(e);
        if (mesh().is_constraint(across)) segments_.push_back(ends_of(across));
      }
      if (mesh().is_constraint(e)) segments_.push_back(ends_of(e));
      e = mesh().next_around(e);
    } while (e != first);
  }

  Refinement measured() {
    Refinement result;
    double smallest = 2;
    for (std::int32_t f = 0; f < mesh().num_face_slots(); ++f) {
      if (mesh().is_free(f) || max_areas_.empty() || builder_.mesh().label(f) == none)
        continue;
      const auto p = corners(f);
      const double sine = squared_sine(p, sharpest(p));
      smallest = std::min(smallest, sine);
      result.num_below_angle += sine < squared_sine_ ? 1 : 0;
      result.num_above_area += is_too_large(f, p) ? 1 : 0;
    }
    if (smallest <= 1)
      result.smallest_angle_deg = std::asin(std::sqrt(smallest)) * 180 / std::numbers::pi;
    result.num_added = num_added_;
    result.triangulation = std::move(builder_).finish();
    return result;
  }

  const PlanarGraph& graph_;
  const RefineOptions& options_;
  ConstraintBuilder builder_;
  double squared_sine_;
  std::vector<double> max_areas_;  // one a region; 0: no limit
  std::unordered_set<Site> is_acute_;
  std::unordered_map<Site, Edge> roots_;  // of added vertices on segments
  std::vector<Edge> segments_;            // to be looked at
  std::deque<Candidate> triangles_;
  std::int64_t num_added_ = 0;
};

}  // namespace

Refinement refine(const PlanarGraph& graph, const RefineOptions& options,
                  const RunOptions& run) {
  if (!(options.min_angle_deg >= 0 && options.min_angle_deg < 60))
    throw Error("the smallest angle must be from 0 up to, but not, 60 degrees");
  if (!(options.max_area >= 0)) throw Error("the largest area must not be negative");
  return Refiner(graph, options, run).run();
}

}  // namespace delone::tripack
