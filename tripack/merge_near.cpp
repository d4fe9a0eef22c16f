#include "tripack/merge_near.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "delaunay/defect.hpp"
#include "delaunay/error.hpp"
#include "tripack/distance_order.hpp"

namespace delone::tripack {

namespace {

using delaunay::Node;

bool is_before(Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

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
    return order != 0 ? order < 0 : is_before(at(a), at(b));
  }

 private:
  [[nodiscard]] Point2 at(Node row) const {
    return points_[static_cast<std::size_t>(row)];
  }

  std::span<const Point2> points_;
  double distance_, size_;
};

void check(std::span<const Point2> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) +
                    ": a coordinate is not a finite number; remove the row",
                {row});
  }
}

}  // namespace

MergedRows merge_near(std::span<const Point2> points, double distance) {
  delaunay::check_merge_distance(distance);
  check(points);
  const auto positions = delaunay::merge_positions(points, is_before);
  const PlaneCells cells(points, distance);
  delaunay::NearMerger merger(cells);
  return delaunay::spread_to_rows(merger.merge(positions.rows), positions.sites);
}

}  // namespace delone::tripack
