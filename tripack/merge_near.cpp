#include "tripack/merge_near.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "delaunay/defect.hpp"
#include "delaunay/error.hpp"
#include "tripack/distance_order.hpp"
#include "tripack/finite.hpp"

namespace delone::tripack {

namespace {

using delaunay::Node;

double largest_coordinate(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2 p : points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

class PlaneCells {
 public:
  // Cells a little larger than the distance: rounding of quotients then never separates
  // two that are that far apart by more than one. Not so small that quotients overflow.
  PlaneCells(std::span<const Point2> points, double distance)
      : points_(points),
        distance_(distance),
        size_(std::max({distance * (1 + 0x1p-20), 0x1p-51 * largest_coordinate(points),
                        std::numeric_limits<double>::denorm_min()})) {}

  [[nodiscard]] std::array<double, 2> cell(Node row) const {
    return {std::floor(at(row).x / size_), std::floor(at(row).y / size_)};
  }
  [[nodiscard]] int reach(Node row) const { return delaunay::cell_reach(cell(row)); }
  [[nodiscard]] bool is_within(Node p, Node q) const {
    return tripack::is_within(at(p), at(q), distance_);
  }
  [[nodiscard]] bool is_nearer(Node p, Node a, Node b) const {
    const int order = compare_distances(at(p), at(a), at(b));
    return order != 0 ? order < 0 : lexicographically_less(at(a), at(b));
  }

 private:
  [[nodiscard]] Point2 at(Node row) const {
    return points_[static_cast<std::size_t>(row)];
  }

  std::span<const Point2> points_;
  double distance_, size_;
};

}  // namespace

MergedRows merge_near(std::span<const Point2> points, double distance) {
  delaunay::check_merge_distance(distance);
  check_finite(points, "row");
  const auto positions = delaunay::merge_positions(points, lexicographically_less);
  const PlaneCells cells(points, distance);
  delaunay::NearMerger merger(cells);
  return delaunay::spread_to_rows(merger.merge(positions.rows), positions.sites);
}

}  // namespace delone::tripack
