#include "stripack/sphere_editing.hpp"

#include <algorithm>
#include <cmath>

#include "stripack/great_circle.hpp"

namespace delone::stripack {

bool SphereEditing::is_same(const Direction& p, const Direction& q) noexcept {
  return is_same_direction(p, q);
}

bool SphereEditing::is_preferred(const Direction& p, const Direction& q) noexcept {
  return lexicographically_less(p, q);
}

bool SphereEditing::has_arc(const Direction& p, const Direction& q) noexcept {
  return !is_same_direction(p, Direction::from(-q.x(), -q.y(), -q.z()));
}

bool SphereEditing::is_beyond(std::span<const Direction> points,
                              const std::array<Site, 3>& corner,
                              const Direction& q) noexcept {
  std::size_t k = 0;
  while (corner[k] != 0) ++k;
  const Direction& from = point(points, corner[(k + 1) % 3]);
  const Direction& to = point(points, corner[(k + 2) % 3]);
  const int s = orientation(from, to, q);
  return s != 0 ? s > 0 : is_inside_arc(from, to, q);
}

// Of three directions on a great circle at most two are opposite to each other, so if all
// lie on the circles of the pairs of the first three, all lie on one.
bool SphereEditing::is_flat(std::span<const Direction> points,
                            std::span<const Site> nodes) noexcept {
  if (nodes.size() < 3) return true;
  const Direction &a = point(points, nodes[0]), &b = point(points, nodes[1]),
                  &c = point(points, nodes[2]);
  return std::all_of(nodes.begin() + 2, nodes.end(), [&](Site v) {
    const Direction& d = point(points, v);
    return orientation(a, b, d) == 0 && orientation(b, c, d) == 0 &&
           orientation(c, a, d) == 0;
  });
}

SphereEditing::Key SphereEditing::key(const Direction& d) noexcept {
  const double largest = std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
  return {d.x() / largest, d.y() / largest, d.z() / largest};
}

delaunay::Place SphereEditing::Chart::place(const Direction& d) noexcept {
  const double norm = std::abs(d.x()) + std::abs(d.y()) + std::abs(d.z());
  double u = d.x() / norm, v = d.y() / norm;
  if (d.z() < 0) {
    const double folded = std::copysign(1 - std::abs(v), u);
    v = std::copysign(1 - std::abs(u), v);
    u = folded;
  }
  const auto cell = [](double w) {
    return static_cast<std::uint32_t>((w + 1) * 2147483647.0);
  };
  return {cell(u), cell(v)};
}

SphereEditing::Star::Star(std::span<const Direction> points, Site,
                          std::span<const Site> rim) {
  rim_.reserve(rim.size());
  for (const Site v : rim) rim_.push_back(point(points, v));
}

}  // namespace delone::stripack
