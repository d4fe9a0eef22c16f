#include "tripack/finite.hpp"

#include <cmath>
#include <cstdint>

#include "delaunay/error.hpp"

namespace delone::tripack {

void check_finite(std::span<const Point2> points, const std::string& what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
    const auto number = static_cast<std::int64_t>(i);
    throw Error(what + " " + std::to_string(number) +
                    ": a coordinate is not a finite number; remove the " + what,
                {number});
  }
}

}  // namespace delone::tripack
