#include "interp/sphere_scan.hpp"

#include "interp/sphere_cells.hpp"

namespace delone::interp {

std::vector<double> scan(const SphereCells& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_sphere(cells, grid, run);
}

}  // namespace delone::interp
