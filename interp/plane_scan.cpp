#include "interp/plane_scan.hpp"

#include "interp/plane_cells.hpp"

namespace delone::interp {

std::vector<double> scan(const PlaneCells& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_plane(cells, grid, run);
}

}  // namespace delone::interp
