#include "interp/blend_scan.hpp"

#include "interp/plane_scan.hpp"
#include "interp/sphere_scan.hpp"

namespace delone::interp {

template <int Degree>
std::vector<double> scan(const BlendCells<PlaneSpace, Degree>& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_plane(cells, grid, run);
}

template <int Degree>
std::vector<double> scan(const BlendCells<SphereSpace, Degree>& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_sphere(cells, grid, run);
}

template std::vector<double> scan(const BlendCells<PlaneSpace, 3>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BlendCells<PlaneSpace, 4>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BlendCells<SphereSpace, 3>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BlendCells<SphereSpace, 4>&, const Grid&,
                                  const RunOptions&);

}  // namespace delone::interp
