#include "tripack/blocks.hpp"

#include <vector>

namespace delone::tripack {

Blocks block_reduce(std::span<const Point2> points, std::span<const double> values,
                    std::span<const double> weights, const BlockOptions& options) {
  std::vector<double> x, y;
  for (const Point2 p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  return delaunay::block_reduce(x, y, values, weights, options);
}

}  // namespace delone::tripack
