// Both triangulations and a surface on each, through installed headers only.
#include <cstdio>
#include <memory>
#include <vector>

#include "interp/linear_surface.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

int main() {
  using delone::stripack::Direction;
  const std::vector<delone::tripack::Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<double> height{0, 1, 2, 1};
  const delone::interp::PlaneLinear plane(
      std::make_shared<delone::tripack::Triangulation>(square), height);

  const std::vector<Direction> axes{Direction::from(1, 0, 0),  Direction::from(0, 1, 0),
                                    Direction::from(0, 0, 1),  Direction::from(-1, 0, 0),
                                    Direction::from(0, -1, 0), Direction::from(0, 0, -1)};
  const std::vector<double> z{0, 0, 1, 0, 0, -1};
  const delone::interp::SphereLinear sphere(
      std::make_shared<delone::stripack::Triangulation>(axes), z);

  std::printf("%g %g\n", plane.value({0.5, 0.25}),
              sphere.value(Direction::from({10, 90})));
  return 0;
}
