// Any points and any edits: an editor holds the triangulation of its points, and the
// constrained one of its points and arcs.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fuzz/fuzz_edits.hpp"
#include "tripack/editor.hpp"

using delone::tripack::ConstrainedTriangulation;
using delone::tripack::Domain;
using delone::tripack::Editor;
using delone::tripack::Point2;
using delone::tripack::Triangulation;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto points = delone::fuzz::plane_points({data, size});
  std::erase_if(points,
                [](Point2 p) { return !std::isfinite(p.x) || !std::isfinite(p.y); });
  delone::fuzz::run_edits<Triangulation, Editor>(
      points, {data, size}, [](const auto& at, const auto& arcs) {
        return ConstrainedTriangulation({.points = at, .segments = arcs},
                                        {.domain = Domain::hull});
      });
  return 0;
}
