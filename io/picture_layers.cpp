#include "io/picture_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "delaunay/triangle_list.hpp"
#include "io/mesh_points.hpp"

namespace delone::io {
namespace {

constexpr Color edge_color{70, 100, 140}, voronoi_color{190, 80, 40},
    spoke_color{205, 170, 150}, circle_color{170, 170, 170}, polyline_color{40, 120, 70};

using Vector = SpacePoint;

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector plus(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector times(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}
bool is_finite(const PicturePoint& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]);
}

double line_width(std::size_t num_lines) {
  return std::clamp(45 / std::sqrt(static_cast<double>(num_lines) + 1), 0.35, 1.4);
}

PicturePoint lonlat_of(const Vector& v) {
  const auto p = lonlat(stripack::Direction::from(v[0], v[1], v[2]));
  return {p.lon_deg, p.lat_deg};
}

/// Positive if counter-clockwise.
double turn(const std::vector<SpacePoint>& points, const Triangle& t, Mesh::Space space) {
  const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
  const Vector n = cross(minus(at(1), at(0)), minus(at(2), at(0)));
  return space == Mesh::Space::plane ? n[2] : dot(n, at(0));
}

/// The triangles of files of any orientation: rays must know where the outside is.
std::vector<Triangle> counter_clockwise(const Mesh& mesh) {
  const std::vector<SpacePoint> points = space_points(mesh);
  std::vector<Triangle> triangles = triangles_of(mesh);
  for (Triangle& t : triangles)
    if (turn(points, t, mesh.space) < 0) std::swap(t[1], t[2]);
  return triangles;
}

/// Builds the lines that are made of triangles.
class Dual {
 public:
  explicit Dual(const Mesh& mesh)
      : mesh_(mesh),
        triangles_(counter_clockwise(mesh)),
        neighbors_(
            delaunay::triangle_neighbors(triangles_, delaunay::SideOrder::after_corner)) {
    if (mesh.space == Mesh::Space::globe) directions_ = space_points(mesh);
    for (const Triangle& t : triangles_) centers_.push_back(center(t));
  }

  /// An edge of the diagram crosses each side of a triangle.
  [[nodiscard]] std::vector<PictureLine> voronoi() const {
    std::vector<PictureLine> lines;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t other = neighbors_[t][k];
        const bool is_drawn_there = other >= 0 && std::cmp_less(other, t);
        if (!is_finite(centers_[t]) || is_drawn_there) continue;
        if (other < 0) {
          lines.push_back({centers_[t], far_away(t, k)});
        } else if (is_finite(centers_[static_cast<std::size_t>(other)])) {
          lines.push_back({centers_[t], centers_[static_cast<std::size_t>(other)]});
        }
      }
    }
    return lines;
  }

  [[nodiscard]] std::vector<PictureLine> spokes() const {
    std::vector<PictureLine> lines;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!is_finite(centers_[t])) continue;
      for (const std::int32_t corner : triangles_[t])
        lines.push_back({node(corner), centers_[t]});
    }
    return lines;
  }

  [[nodiscard]] std::vector<PictureLine> circles() const {
    std::vector<PictureLine> lines;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_finite(centers_[t])) lines.push_back(circle(t));
    return lines;
  }

 private:
  [[nodiscard]] bool is_globe() const { return mesh_.space == Mesh::Space::globe; }
  [[nodiscard]] PicturePoint node(std::int32_t i) const {
    const auto at = static_cast<std::size_t>(i);
    return {mesh_.x[at], mesh_.y[at]};
  }
  [[nodiscard]] const Vector& direction(std::int32_t i) const {
    return directions_[static_cast<std::size_t>(i)];
  }

  [[nodiscard]] Vector globe_center(const Triangle& t) const {
    const Vector a = direction(t[0]);
    const Vector n = cross(minus(direction(t[1]), a), minus(direction(t[2]), a));
    return times(1 / std::sqrt(dot(n, n)), n);
  }

  /// NaN for a triangle without area.
  [[nodiscard]] PicturePoint center(const Triangle& t) const {
    if (is_globe()) {
      const Vector c = globe_center(t);
      if (!std::isfinite(c[0] + c[1] + c[2])) return {c[0], c[0]};
      return lonlat_of(c);
    }
    const auto [ax, ay] = node(t[0]);
    const auto [bx, by] = node(t[1]);
    const auto [cx, cy] = node(t[2]);
    const double ux = bx - ax, uy = by - ay, vx = cx - ax, vy = cy - ay;
    const double scale = 0.5 / (ux * vy - uy * vx);
    const double uu = ux * ux + uy * uy, vv = vx * vx + vy * vy;
    return {ax + (vy * uu - uy * vv) * scale, ay + (ux * vv - vx * uu) * scale};
  }

  /// The end of a ray that is longer than any window, at a right angle to side k.
  [[nodiscard]] PicturePoint far_away(std::size_t t, std::size_t k) const {
    const std::int32_t from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
    if (is_globe()) {
      // To the far side of the globe's edge: a quarter turn on, away from the triangle.
      const Vector out = cross(direction(to), direction(from));
      return lonlat_of(out);
    }
    const auto [ax, ay] = node(from);
    const auto [bx, by] = node(to);
    const auto [low, high] = std::ranges::minmax(mesh_.x);
    const auto [bottom, top] = std::ranges::minmax(mesh_.y);
    const PicturePoint& c = centers_[t];
    const double reach =
        10 * (high - low + top - bottom + std::abs(c[0] - ax) + std::abs(c[1] - ay));
    const double length = std::hypot(bx - ax, by - ay);
    return {c[0] + (by - ay) / length * reach, c[1] - (bx - ax) / length * reach};
  }

  [[nodiscard]] PictureLine circle(std::size_t t) const {
    constexpr int num_steps = 120;
    PictureLine line;
    for (int i = 0; i <= num_steps; ++i) {
      const double turn = 2 * std::numbers::pi * i / num_steps;
      line.push_back(is_globe() ? on_globe_circle(t, turn) : on_plane_circle(t, turn));
    }
    return line;
  }

  [[nodiscard]] PicturePoint on_plane_circle(std::size_t t, double turn) const {
    const auto [x, y] = centers_[t];
    const auto [ax, ay] = node(triangles_[t][0]);
    const double radius = std::hypot(ax - x, ay - y);
    return {x + radius * std::cos(turn), y + radius * std::sin(turn)};
  }

  /// The corner turned about the centre.
  [[nodiscard]] PicturePoint on_globe_circle(std::size_t t, double turn) const {
    const Vector c = globe_center(triangles_[t]);
    const Vector a = direction(triangles_[t][0]);
    const Vector along = times(dot(a, c), c), across = minus(a, along);
    return lonlat_of(plus(along, plus(times(std::cos(turn), across),
                                      times(std::sin(turn), cross(c, across)))));
  }

  const Mesh& mesh_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<std::int32_t, 3>> neighbors_;
  std::vector<Vector> directions_;
  std::vector<PicturePoint> centers_;
};

PicturePoint node_at(const Mesh& mesh, std::int32_t i) {
  const auto at = static_cast<std::size_t>(i);
  return {mesh.x[at], mesh.y[at]};
}

PictureLayer edge_layer(const Mesh& mesh) {
  PictureLayer layer{edge_color, 1, {}};
  for (const auto& [a, b] : edges_of(mesh))
    layer.lines.push_back({node_at(mesh, a), node_at(mesh, b)});
  layer.width = line_width(layer.lines.size());
  return layer;
}

void add_layer(Picture& picture, Color color, std::vector<PictureLine> lines) {
  const double width = line_width(lines.size());
  picture.layers.push_back({color, width, std::move(lines)});
}

void add_dual(Picture& picture, const Mesh& mesh, const ShownParts& parts) {
  const Dual dual(mesh);
  if (parts.circles) add_layer(picture, circle_color, dual.circles());
  if (parts.spokes) add_layer(picture, spoke_color, dual.spokes());
  if (parts.triangles) picture.layers.push_back(edge_layer(mesh));
  if (parts.voronoi || parts.spokes) add_layer(picture, voronoi_color, dual.voronoi());
}

/// The mean of the corners; on the globe the direction of their sum.
PicturePoint middle_of(const Mesh& mesh, std::int64_t cell,
                       const std::vector<SpacePoint>& points) {
  Vector sum{};
  for (const std::int32_t corner : mesh.cell(cell))
    sum = plus(sum, points[static_cast<std::size_t>(corner)]);
  if (mesh.space == Mesh::Space::globe)
    return dot(sum, sum) > 0 ? lonlat_of(sum) : PicturePoint{};
  const double share = 1 / static_cast<double>(mesh.cell(cell).size());
  return {share * sum[0], share * sum[1]};
}

void add_labels(Picture& picture, const Mesh& mesh, const ShownParts& parts) {
  using Kind = PictureLabel::Kind;
  for (std::int64_t i = 0; parts.node_labels && i < mesh.num_nodes(); ++i)
    picture.labels.push_back({node_at(mesh, static_cast<std::int32_t>(i)),
                              std::to_string(i + parts.base), Kind::node});
  if (!parts.cell_labels) return;
  const std::vector<SpacePoint> points = space_points(mesh);
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i)
    if (!mesh.cell(i).empty())
      picture.labels.push_back(
          {middle_of(mesh, i, points), std::to_string(i + parts.base), Kind::cell});
}

}  // namespace

Picture make_picture(const Mesh& mesh, const ShownParts& parts) {
  check_mesh(mesh);
  Picture picture{.space = mesh.space, .layers = {}, .dots = {}, .labels = {}};
  if (parts.voronoi || parts.spokes || parts.circles)
    add_dual(picture, mesh, parts);
  else if (parts.triangles)
    picture.layers.push_back(edge_layer(mesh));
  if (parts.polyline) {
    PictureLine line;
    for (std::int32_t i = 0; i < mesh.num_nodes(); ++i) line.push_back(node_at(mesh, i));
    picture.layers.push_back({polyline_color, 1.2, {std::move(line)}});
  }
  for (std::int32_t i = 0; parts.points && i < mesh.num_nodes(); ++i)
    picture.dots.push_back(node_at(mesh, i));
  add_labels(picture, mesh, parts);
  return picture;
}

}  // namespace delone::io
