// From a table to a NetCDF grid and back, through installed headers only.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "interp/linear_surface.hpp"
#include "io/grid_file.hpp"
#include "io/table.hpp"

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  const delone::io::PointTable table = delone::io::read_table(folder + "/points.csv");
  std::vector<delone::tripack::Point2> points;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    points.push_back({table.x[i], table.y[i]});
  const delone::interp::PlaneLinear surface(
      std::make_shared<delone::tripack::Triangulation>(points), table.value);

  const delone::interp::Grid grid{.x = {.spacing = 0.5, .size = 3},
                                  .y = {.spacing = 0.5, .size = 3}};
  delone::io::write_grid("grid.nc", {surface.grid(grid), {.name = "height"}});
  const delone::io::GridFile back = delone::io::read_grid("grid.nc");
  std::printf("%s %g\n", back.info.name.c_str(), back.field.values.back());
  return 0;
}
