#pragma once

#include <cstdint>

#include "delaunay/twofold_lanes.hpp"

namespace delone::support {

/// Signs in numbers of twice the precision, 0 where they are not certain.
struct TwofoldSigns {
  int turn;    ///< of points 0, 1 and 2
  int circle;  ///< of point 3 in the circle of 0, 1 and 2
};

/// Of the first four points of a geometry for blocks.
template <class Lanes>
[[nodiscard]] TwofoldSigns twofold_signs(const Lanes& g) {
  using Arithmetic = typename Lanes::Arithmetic;
  const auto sign_beyond = [](double value, double error) {
    return static_cast<int>(value > error) - static_cast<int>(value < -error);
  };
  const auto lane = [](const delaunay::Twofold4& v, int i) {
    return delaunay::Twofold4{delaunay::four(v.high[i]), delaunay::four(v.low[i])};
  };
  const std::int32_t s[4] = {2, 3, 2, 3};
  const auto a = g.corner(0), b = g.corner(1), x = g.corners(s);
  const auto lanes = Lanes::twofold_lanes(a, b, x);
  const delaunay::Double4 size = g.sizes(0, 1, Lanes::lanes(a, b, x));
  const auto det = Arithmetic::difference(
      Arithmetic::product(lane(lanes.dot, 0), lane(lanes.cross, 1)),
      Arithmetic::product(lane(lanes.dot, 1), lane(lanes.cross, 0)));
  const delaunay::Double4 error =
      g.twofold_circle_error(delaunay::four(size[0]), delaunay::four(size[1]));
  return {sign_beyond(lanes.cross.rounded()[0], g.twofold_cross_error(size)[0]),
          sign_beyond(det.rounded()[0], error[0])};
}

}  // namespace delone::support
