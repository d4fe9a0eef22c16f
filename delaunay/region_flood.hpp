#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/buffer.hpp"
#include "delaunay/closed_mesh.hpp"

namespace delone::delaunay {

/// What constraints cut a closed mesh into: faces that can be reached from one another
/// without crossing a constraint. Regions are numbered in the order of their first faces.
struct FaceRegions {
  Buffer<std::int32_t> of_face;  ///< one a face slot; none for free ones
  std::int32_t count = 0;
};

/// O(faces), nearly, without recursion.
[[nodiscard]] FaceRegions flood_regions(const ClosedMesh& mesh);

/// For every region the parity of the number of marked edges on the way to it from region
/// `outside`: 0 or 1, or none where there is no way. `is_boundary`: one flag a half-edge
/// (both sides the same). A mesh whose marked edges do not form closed curves has no such
/// parity: then the result is empty.
[[nodiscard]] std::vector<std::int8_t> find_parities(const ClosedMesh& mesh,
                                                     const FaceRegions& regions,
                                                     const std::vector<bool>& is_boundary,
                                                     std::int32_t outside);

}  // namespace delone::delaunay
