#pragma once

#include <string>

#include "io/triangle_file.hpp"
#include "tripack/voronoi.hpp"

namespace delone::io {

/// Triangle's .v.node: the vertices of a Voronoi diagram as a .node file. Triangles on
/// one circle share a vertex here, so there may be fewer than triangles. Throws
/// WriteError.
void write_v_node(const std::string& path, const tripack::Voronoi& diagram, int base);

/// Triangle's .v.edge: the edges of the diagram over the vertices of the .v.node file,
/// rays with -1 and their direction. The lines between collinear sites, which have no
/// vertex, have no place in the format and are left out. Throws WriteError.
void write_v_edge(const std::string& path, const tripack::Voronoi& diagram, int base);

/// The edges that write_v_edge writes.
[[nodiscard]] EdgeFile voronoi_edges(const tripack::Voronoi& diagram, int base);

}  // namespace delone::io
