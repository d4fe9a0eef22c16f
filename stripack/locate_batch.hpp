#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

/// The triangle that holds each of many points: its number in Triangulation::triangles(),
/// or -1 outside (MATLAB's tsearchn). Exact.
///
/// A point on an edge or at a node is held by the one of the triangles there whose sites
/// are smallest, whatever the order of queries, rows and threads. Where there are no
/// triangles all answers are -1. Queries are sorted along a curve and each walk begins
/// where the last ended; they are answered in the caller's order. Memory:
/// 24 bytes a node.
[[nodiscard]] std::vector<std::int32_t> locate_triangles(
    const Triangulation& t, std::span<const Direction> queries,
    const RunOptions& run = {});

/// What holds each of many points, as Triangulation::locate says, in names that depend on
/// nothing else: of an edge or a triangle the smallest row comes first.
[[nodiscard]] std::vector<Location> locate_all(const Triangulation& t,
                                               std::span<const Direction> queries,
                                               const RunOptions& run = {});

}  // namespace delone::stripack
