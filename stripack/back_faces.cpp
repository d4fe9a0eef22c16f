#include "stripack/back_faces.hpp"

#include <cstddef>
#include <numeric>
#include <utility>

#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Triangles in a polygon whose corners are places 0 .. n - 1 around the back. A
/// half-edge 3 * face + k runs from corner k to the next, the face on its left.
class PolygonMesh {
 public:
  struct Face {
    std::array<std::int32_t, 3> corner{};
    std::array<std::int32_t, 3> link{none, none, none};  // none: a side of the polygon
  };

  PolygonMesh(std::span<const Direction> points, std::span<const Site> loop)
      : points_(points), loop_(loop), side_(loop.size(), none) {}

  void start(std::int32_t a, std::int32_t b, std::int32_t c) {
    faces_.push_back({{a, b, c}, {}});
    for (std::int32_t k = 0; k < 3; ++k) {
      faces_[0].link[at(k)] = none;
      side_[at(faces_[0].corner[at(k)])] = k;
    }
  }

  /// A corner between two that are joined by a side.
  void insert(std::int32_t q, std::int32_t left, std::int32_t right) {
    dig(q, left, right);
    fill(q);
  }

  [[nodiscard]] const std::vector<Face>& faces() const noexcept { return faces_; }
  /// The half-edge that leaves the corner along the polygon.
  [[nodiscard]] std::int32_t side(std::int32_t corner) const noexcept {
    return side_[at(corner)];
  }

 private:
  /// An edge with what lies on its left: a half-edge, or none beyond the polygon.
  struct Edge {
    std::int32_t from, to, inner;
  };

  [[nodiscard]] const Direction& point(std::int32_t corner) const {
    return points_[at(loop_[at(corner)])];
  }
  [[nodiscard]] bool sees(std::int32_t q, const Face& face) const {
    return in_circle_perturbed(point(face.corner[0]), point(face.corner[1]),
                               point(face.corner[2]), point(q)) > 0;
  }

  // The faces that q sees hang together from the side it is put into; their rim comes out
  // in order from left to right.
  void dig(std::int32_t q, std::int32_t left, std::int32_t right) {
    rim_.clear();
    stack_.assign(1, {left, right, side_[at(left)]});
    while (!stack_.empty()) {
      const Edge edge = stack_.back();
      stack_.pop_back();
      if (edge.inner == none || !sees(q, faces_[at(edge.inner / 3)])) {
        rim_.push_back(edge);
        continue;
      }
      const std::int32_t f = edge.inner / 3;
      const std::size_t k = at(edge.inner % 3), next = (k + 1) % 3, last = (k + 2) % 3;
      const Face& face = faces_[at(f)];
      free_.push_back(f);
      stack_.push_back({face.corner[last], edge.to, face.link[next]});
      stack_.push_back({edge.from, face.corner[last], face.link[last]});
    }
  }

  void fill(std::int32_t q) {
    std::int32_t before = none;  // half-edge q -> from
    for (const Edge& edge : rim_) {
      const std::int32_t f = new_face({edge.to, edge.from, q});
      join(3 * f, edge.inner, edge.to);
      join(3 * f + 1, before, edge.from);
      before = 3 * f + 2;
    }
    side_[at(q)] = before;
  }

  void join(std::int32_t a, std::int32_t b, std::int32_t from) {
    faces_[at(a / 3)].link[at(a % 3)] = b;
    if (b == none) {
      side_[at(from)] = a;
    } else {
      faces_[at(b / 3)].link[at(b % 3)] = a;
    }
  }

  std::int32_t new_face(const std::array<std::int32_t, 3>& corner) {
    if (free_.empty()) {
      faces_.push_back({corner, {none, none, none}});
      return static_cast<std::int32_t>(faces_.size()) - 1;
    }
    const std::int32_t f = free_.back();
    free_.pop_back();
    faces_[at(f)] = {corner, {none, none, none}};
    return f;
  }

  std::span<const Direction> points_;
  std::span<const Site> loop_;
  std::vector<Face> faces_;
  std::vector<std::int32_t> side_, free_;
  std::vector<Edge> rim_, stack_;
};

// Around the back, which lies on the left.
std::vector<Site> back_loop(const Triangulation& t) {
  const Adjacency& adjacency = t.adjacency();
  std::vector<Site> loop;
  Site first = 0;
  while (first < t.num_sites() && !adjacency.is_boundary(first)) ++first;
  if (first == t.num_sites()) return loop;
  Site s = first;
  do {
    loop.push_back(s);
    s = adjacency.neighbors(s).back();
  } while (s != first);
  return loop;
}

std::vector<std::int32_t> random_order(std::size_t n) {
  std::vector<std::int32_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::uint64_t state = 0x9E3779B97F4A7C15u;
  for (std::size_t i = n; i-- > 1;) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[i], order[(state >> 33) % (i + 1)]);
  }
  return order;
}

PolygonMesh triangulate(std::span<const Direction> points, std::span<const Site> loop) {
  const auto n = static_cast<std::int32_t>(loop.size());
  std::vector<std::int32_t> next(loop.size()), previous(loop.size());
  for (std::int32_t i = 0; i < n; ++i) {
    next[at(i)] = (i + 1) % n;
    previous[at(i)] = (i + n - 1) % n;
  }
  const std::vector<std::int32_t> order = random_order(loop.size());
  for (std::int32_t k = n; k-- > 3;) {
    const std::int32_t q = order[at(k)];
    next[at(previous[at(q)])] = next[at(q)];
    previous[at(next[at(q)])] = previous[at(q)];
  }
  PolygonMesh mesh(points, loop);
  const std::int32_t a = order[0], b = next[at(a)];
  mesh.start(a, b, next[at(b)]);
  for (std::int32_t k = 3; k < n; ++k) {
    const std::int32_t q = order[at(k)];
    mesh.insert(q, previous[at(q)], next[at(q)]);
  }
  return mesh;
}

}  // namespace

BackFaces::BackFaces(const Triangulation& t) {
  if (t.dimension() < 2) return;
  const std::vector<Site> loop = back_loop(t);
  if (loop.empty()) return;
  const PolygonMesh mesh = triangulate(t.points(), loop);
  for (const PolygonMesh::Face& face : mesh.faces()) {
    faces_.push_back(
        {loop[at(face.corner[0])], loop[at(face.corner[1])], loop[at(face.corner[2])]});
  }
  place_.assign(at(t.num_sites()), none);
  offsets_.push_back(0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    place_[at(loop[i])] = static_cast<std::int32_t>(i);
    std::int32_t h = mesh.side(static_cast<std::int32_t>(i));
    while (h != none) {
      const PolygonMesh::Face& face = mesh.faces()[at(h / 3)];
      const std::size_t last = at((h % 3 + 2) % 3);
      face_lists_.push_back(h / 3);
      neighbor_lists_.push_back(loop[at(face.corner[last])]);
      h = face.link[last];
    }
    offsets_.push_back(static_cast<std::int32_t>(face_lists_.size()));
  }
}

std::span<const Site> BackFaces::neighbors(Site s) const noexcept {
  const std::int32_t place = place_.empty() ? none : place_[at(s)];
  if (place == none) return {};
  const std::int32_t begin = offsets_[at(place)], end = offsets_[at(place) + 1];
  return {neighbor_lists_.data() + begin, at(end - begin - 1)};
}

std::span<const std::int32_t> BackFaces::faces_at(Site s) const noexcept {
  const std::int32_t place = place_.empty() ? none : place_[at(s)];
  if (place == none) return {};
  const std::int32_t begin = offsets_[at(place)], end = offsets_[at(place) + 1];
  return {face_lists_.data() + begin, at(end - begin)};
}

}  // namespace delone::stripack
