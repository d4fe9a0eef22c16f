#include "stripack/merge_near.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "delaunay/defect.hpp"
#include "stripack/distance_order.hpp"
#include "stripack/great_circle.hpp"

namespace delone::stripack {

namespace {

using delaunay::Node;

/// Cells of space, in which chords are measured.
class SphereCells {
 public:
  // A little larger than the chord, so that rounding of quotients never separates two
  // that are that far apart by more than one; triples of one direction differ by 2^-51.
  SphereCells(std::span<const Direction> points, double angle_rad)
      : points_(points),
        size_(2 * std::sin(std::min(angle_rad, std::numbers::pi) / 2) * (1 + 0x1p-20) +
              0x1p-49) {}

  [[nodiscard]] std::array<double, 3> cell(Node row) const {
    const Direction& d = at(row);
    return {std::floor(d.x() / size_), std::floor(d.y() / size_),
            std::floor(d.z() / size_)};
  }
  [[nodiscard]] int reach(Node row) const { return delaunay::cell_reach(cell(row)); }
  [[nodiscard]] const Direction& at(Node row) const {
    return points_[static_cast<std::size_t>(row)];
  }

 private:
  std::span<const Direction> points_;
  double size_;
};

class GreatCircleCells : public SphereCells {
 public:
  GreatCircleCells(std::span<const Direction> points, double angle_rad)
      : SphereCells(points, angle_rad), angle_(angle_rad) {}
  [[nodiscard]] bool is_within(Node p, Node q) const {
    return angle(at(p), at(q)) <= angle_ || is_same_direction(at(p), at(q));
  }
  [[nodiscard]] bool is_nearer(Node p, Node a, Node b) const {
    const int order = compare_distances(at(p), at(a), at(b));
    return order != 0 ? order < 0 : lexicographically_less(at(a), at(b));
  }

 private:
  double angle_;
};

class GeodesicCells : public SphereCells {
 public:
  // 6335.439 km is the least radius of curvature: no geodesic makes a larger angle.
  GeodesicCells(std::span<const Direction> points, double distance_km)
      : SphereCells(points, distance_km / 6335.439), distance_km_(distance_km) {}
  [[nodiscard]] bool is_within(Node p, Node q) const {
    return kilometers(p, q) <= distance_km_ || is_same_direction(at(p), at(q));
  }
  [[nodiscard]] bool is_nearer(Node p, Node a, Node b) const {
    const double to_a = kilometers(p, a), to_b = kilometers(p, b);
    return to_a != to_b ? to_a < to_b : lexicographically_less(at(a), at(b));
  }

 private:
  [[nodiscard]] double kilometers(Node p, Node q) const {
    return geodesic_km(lonlat(at(p)), lonlat(at(q)));
  }
  double distance_km_;
};

template <class Cells>
MergedRows merge(std::span<const Direction> points, const Cells& cells) {
  const auto positions = delaunay::merge_positions(points, lexicographically_less);
  delaunay::NearMerger merger(cells);
  return delaunay::spread_to_rows(merger.merge(positions.rows), positions.sites);
}

}  // namespace

MergedRows merge_near(std::span<const Direction> points, double angle_rad) {
  delaunay::check_merge_distance(angle_rad);
  return merge(points, GreatCircleCells(points, angle_rad));
}

MergedRows merge_near_wgs84(std::span<const Direction> points, double distance_km) {
  delaunay::check_merge_distance(distance_km);
  return merge(points, GeodesicCells(points, distance_km));
}

}  // namespace delone::stripack
