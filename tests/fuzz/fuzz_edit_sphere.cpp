// Any directions and any edits: an editor holds the triangulation of its points.

#include <cstddef>
#include <cstdint>

#include "fuzz/fuzz_edits.hpp"
#include "stripack/editor.hpp"

using delone::stripack::ConstrainedTriangulation;
using delone::stripack::Domain;
using delone::stripack::Editor;
using delone::stripack::Triangulation;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto points = delone::fuzz::sphere_points({data, size});
  delone::fuzz::run_edits<Triangulation, Editor>(
      points, {data, size}, [](const auto& at, const auto& arcs) {
        return ConstrainedTriangulation({.points = at, .arcs = arcs},
                                        {.domain = Domain::hull});
      });
  return 0;
}
