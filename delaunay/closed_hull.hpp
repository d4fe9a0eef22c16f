#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"

namespace delone::delaunay {

/// A point of the polyhedron.
struct Vector3 {
  double x, y, z;
};

/// A triangular face, counter-clockwise from outside; one cache line.
///
/// `link[k]` is 4 * face + edge of the face on the other side of the edge node[k] ->
/// node[k + 1]. A site q sees the face if normal . q - offset > error; it does not if
/// that is < -error; in between an exact predicate decides.
///
/// `position[k]` is where node[k + 1] stands in the list of node[k]; written by
/// HullLists.
struct alignas(64) Face {
  std::array<Site, 3> node;
  std::array<std::int32_t, 3> link;
  Vector3 normal;
  double offset;
  float error;
  std::array<std::uint8_t, 3> position;
};
static_assert(sizeof(Face) == 64);

/// What the builder has to be told.
///
/// `point(s)`         coordinates for the floating-point tests;
/// `plane_error`      times (|B|_1 + |C|_1), the sides from a face's first corner: error
///                    of a face;
/// `sees(n, q)`       exact: does q see the face with corners n? Ties broken canonically,
///                    never zero;
/// `is_front(f)`      is the face part of the triangulation (not of the outside)?
/// `side(a, b, q)`    floating: > 0 if q is left of a -> b, as seen from outside a front
///                    face;
/// `exact_side`       the same, exact sign.
template <class G>
concept HullGeometry = requires(const G& g, const Face& f, Site s) {
  { g.point(s) } -> std::convertible_to<Vector3>;
  { G::plane_error } -> std::convertible_to<double>;
  { g.sees(f.node, s) } -> std::same_as<bool>;
  { g.is_front(f) } -> std::same_as<bool>;
  { g.side(s, s, s) } -> std::same_as<double>;
  { g.exact_side(s, s, s) } -> std::same_as<int>;
};

/// The boundary of the convex hull of points in convex position, by insertion along a
/// curve.
///
/// On the sphere the Delaunay triangulation is such a boundary. The surface is closed
/// from the first face on, so there is no special case for the outside. An inserted site
/// sees a disc of faces (its cavity); as no site lies inside that disc its dual is a
/// tree, walked depth first without marks, and its rim comes out in counter-clockwise
/// order. The cavity is replaced by the fan of the site over the rim.
///
/// Sources: A. Bowyer, Comput. J. 24 (1981) 162-166; D. F. Watson, ibid. 167-172; K. Q.
/// Brown, Inf. Process. Lett. 9 (1979) 223-228 (lifting); N. Amenta, S. Choi, G. Rote,
/// SoCG 2003 (order).
template <HullGeometry Geometry>
class ClosedHull {
 public:
  /// `num_nodes` counts every node the hull will get: a surface of n nodes has 2n - 4
  /// faces.
  ClosedHull(const Geometry& geometry, Site num_nodes)
      : geometry_(geometry),
        faces_(2 * static_cast<std::size_t>(num_nodes)),
        corners_(static_cast<std::size_t>(num_nodes) + 1),
        stack_(256),
        cavity_(256),
        rim_(256) {}

  /// The first closed surface; links are found from the corners.
  void start(std::span<const std::array<Site, 3>> faces) {
    for (const auto& corners : faces) add_face(corners);
    for (std::int32_t f = 0; f < num_faces_; ++f) {
      for (std::size_t k = 0; k < 3; ++k) link_by_search(f, k);
    }
    for (std::int32_t f = 0; f < num_faces_; ++f) {
      if (geometry_.is_front(face(f))) last_ = f;
    }
  }

  void insert(Site q) {
    dig_cavity(find_seen(q), q);
    fill_cavity(q);
  }

  /// For every node one of its corners, 4 * face + k. Takes them away: no insertion
  /// afterwards.
  [[nodiscard]] Buffer<std::int32_t> take_corners() noexcept {
    return std::move(corners_);
  }

  /// Where node[k + 1] stands in the list of node[k], noted while lists are written.
  void set_position(std::int32_t f, int k, std::uint8_t position) noexcept {
    face(f).position[static_cast<std::size_t>(k)] = position;
  }

  [[nodiscard]] std::int32_t num_faces() const noexcept { return num_faces_; }
  [[nodiscard]] const Face& face(std::int32_t f) const noexcept {
    return faces_[static_cast<std::size_t>(f)];
  }

 private:
  struct RimEdge {
    Site from;
    std::int32_t outside;  // link to the face that stays
  };

  static constexpr std::size_t turn(std::size_t k) { return k == 2 ? 0 : k + 1; }
  // Links and corners are 4 * face + edge.
  static constexpr std::int32_t face_of(std::int32_t link) { return link >> 2; }
  static constexpr std::size_t edge_of(std::int32_t link) {
    return static_cast<std::size_t>(link & 3);
  }
  static constexpr std::int32_t link_to(std::int32_t f, std::size_t k) {
    return 4 * f + static_cast<std::int32_t>(k);
  }

  std::int32_t& corner_of(Site s) noexcept {
    return corners_[static_cast<std::size_t>(s)];
  }
  Face& face(std::int32_t f) noexcept { return faces_[static_cast<std::size_t>(f)]; }

  void add_face(const std::array<Site, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) corner_of(corners[k]) = link_to(num_faces_, k);
    Face& f = face(num_faces_++);
    f.node = corners;
    const Vector3 p = geometry_.point(corners[0]);
    set_plane(f, p, side_from(p, corners[1]), side_from(p, corners[2]));
  }

  /// A side of a face from its first corner, and its 1-norm.
  struct Side {
    Vector3 vector;
    double norm;
  };

  [[nodiscard]] Side side_from(const Vector3& p, Site s) const noexcept {
    const Vector3 to = geometry_.point(s);
    const Vector3 v{to.x - p.x, to.y - p.y, to.z - p.z};
    return {v, std::abs(v.x) + std::abs(v.y) + std::abs(v.z)};
  }

  // The error is kept as a float: the factor covers its rounding, the least normal float
  // the range below it.
  static void set_error(Face& f, double error) noexcept {
    f.error =
        static_cast<float>((1 + 0x1p-22) * error) + std::numeric_limits<float>::min();
  }

  void set_plane(Face& f, const Vector3& p, const Side& b, const Side& c) const noexcept {
    const Vector3 &u = b.vector, &v = c.vector;
    f.normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    f.offset = f.normal.x * p.x + f.normal.y * p.y + f.normal.z * p.z;
    set_error(f, Geometry::plane_error * (b.norm + c.norm));
  }

  void link_by_search(std::int32_t f, std::size_t k) {
    const Site from = face(f).node[k], to = face(f).node[turn(k)];
    for (std::int32_t g = 0; g < num_faces_; ++g) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (face(g).node[j] == to && face(g).node[turn(j)] == from)
          face(f).link[k] = link_to(g, j);
      }
    }
  }

  [[nodiscard]] bool sees(const Face& f, const Vector3& p, Site q) const {
    const double height =
        f.normal.x * p.x + f.normal.y * p.y + f.normal.z * p.z - f.offset;
    if (height > f.error) return true;
    if (height < -f.error) return false;
    return geometry_.sees(f.node, q);
  }

  /// A face that q sees, walking from the last front face: across an edge that has q on
  /// its outer side, by plain doubles; if rounding leads these astray, exactly.
  [[nodiscard]] std::int32_t find_seen(Site q) {
    constexpr int patience = 4096;
    const Vector3 p = geometry_.point(q);
    std::int32_t f = last_;
    std::size_t entered = 3;  // the edge we came in by
    for (int step = 0; step < patience; ++step) {
      const Face& current = face(f);
      if (sees(current, p, q)) return f;
      std::size_t out = 3;
      for (std::size_t k = 0; k < 3 && out == 3; ++k) {
        if (k != entered && geometry_.side(current.node[k], current.node[turn(k)], q) < 0)
          out = k;
      }
      if (out == 3 || !geometry_.is_front(current)) break;
      entered = edge_of(current.link[out]);
      f = face_of(current.link[out]);
    }
    return find_seen_exactly(q);
  }

  /// Every step brings q nearer to the circle it is in (Edelsbrunner: no cycles), so this
  /// ends; an edge of the boundary that has q strictly outside leads to a face q sees.
  [[nodiscard]] std::int32_t find_seen_exactly(Site q) const {
    std::int32_t f = last_;
    for (;;) {
      const Face& current = face(f);
      if (geometry_.sees(current.node, q)) return f;
      std::size_t out = 0;
      while (out < 2 &&
             geometry_.exact_side(current.node[out], current.node[turn(out)], q) >= 0)
        ++out;
      f = face_of(current.link[out]);
    }
  }

  void dig_cavity(std::int32_t seed, Site q) {
    const Vector3 p = geometry_.point(q);
    num_cavity_ = num_rim_ = 0;
    cavity_[num_cavity_++] = seed;
    // The stack holds half-edges of the faces beyond, next one in counter-clockwise order
    // on top.
    std::size_t top = 0;
    stack_[top++] = face(seed).link[2];
    stack_[top++] = face(seed).link[1];
    stack_[top++] = face(seed).link[0];
    while (top > 0) {
      std::int32_t link = stack_[--top];
      for (;;) {
        const std::size_t k = edge_of(link);
        const Face& beyond = face(face_of(link));
        if (!sees(beyond, p, q)) {
          rim_[num_rim_++] = {beyond.node[turn(k)], link};
          break;
        }
        if (num_cavity_ + 4 > cavity_.size()) make_room();
        cavity_[num_cavity_++] = face_of(link);
        stack_[top++] = beyond.link[turn(turn(k))];
        link = beyond.link[turn(k)];
      }
    }
  }

  // A cavity of k faces has k + 2 rim edges, and never more than k + 2 half-edges wait on
  // the stack.
  void make_room() {
    const std::size_t size = 2 * cavity_.size();
    cavity_.resize(size);
    rim_.resize(size);
    stack_.resize(size);
  }

  void fill_cavity(Site q) {
    cavity_[num_cavity_++] = num_faces_++;
    cavity_[num_cavity_++] = num_faces_++;
    const Vector3 p = geometry_.point(q);
    Side side = side_from(p, rim_[0].from);
    rim_[num_rim_] = rim_[0];
    std::int32_t before = cavity_[num_rim_ - 1];
    cavity_[num_rim_] = cavity_[0];
    for (std::size_t i = 0; i < num_rim_; ++i) {
      const auto [from, outside] = rim_[i];
      const Site to = rim_[i + 1].from;
      const std::int32_t id = cavity_[i];
      Face& f = face(id);
      f.node = {q, from, to};
      f.link = {link_to(before, 2), outside, link_to(cavity_[i + 1], 0)};
      face(face_of(outside)).link[edge_of(outside)] = link_to(id, 1);
      // A rim node may have lost the face its corner was in.
      corner_of(from) = link_to(id, 1);
      const Side last = side;
      side = side_from(p, to);
      set_plane(f, p, last, side);
      before = id;
    }
    corner_of(q) = link_to(before, 0);
    last_ = first_front();
  }

  // Every new site is a corner of at least one front face.
  [[nodiscard]] std::int32_t first_front() const {
    std::size_t i = 0;
    while (i + 1 < num_rim_ && !geometry_.is_front(face(cavity_[i]))) ++i;
    return cavity_[i];
  }

  const Geometry& geometry_;
  Buffer<Face> faces_;
  Buffer<std::int32_t> corners_;
  std::int32_t num_faces_ = 0;
  std::int32_t last_ = 0;  // a front face near the last inserted site
  std::vector<std::int32_t> stack_, cavity_;
  std::vector<RimEdge> rim_;
  std::size_t num_cavity_ = 0, num_rim_ = 0;
};

}  // namespace delone::delaunay
