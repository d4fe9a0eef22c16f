#pragma once

#include "io/picture.hpp"

namespace delone::io {

/// What of a triangulation is drawn.
struct ShownParts {
  bool points = true;
  bool polyline = false;  ///< the nodes joined in their order
  bool triangles = true;  ///< the sides of the cells
  bool voronoi = false;   ///< the edges of the Voronoi diagram, rays included
  bool spokes = false;  ///< with them the triangulated Voronoi diagram: from each node to
                        ///< the corners of its cell
  bool circles = false;  ///< the largest empty circles: around the triangles
  bool node_labels = false, cell_labels = false;
  int base = 0;  ///< the number of the first node and cell in labels
};

/// The picture of a mesh, whose cells must be triangles if Voronoi edges, spokes or
/// circles are shown; they are the dual of these triangles. Triangles without area have
/// none. Throws Error if a cell is no triangle then.
///
/// Positions are good to a pixel of any picture, not to the last digit: diagrams to
/// compute with are tripack's and stripack's.
[[nodiscard]] Picture make_picture(const Mesh& mesh, const ShownParts& parts = {});

}  // namespace delone::io
