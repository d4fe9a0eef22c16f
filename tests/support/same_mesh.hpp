#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "delaunay/closed_mesh.hpp"

namespace delone::support {

/// Are two meshes the same number for number: faces, links and marks, and the half-edge
/// that each node names?
[[nodiscard]] inline testing::AssertionResult is_same_mesh(
    const delaunay::ClosedMesh& a, const delaunay::ClosedMesh& b) {
  if (a.num_nodes() != b.num_nodes() || a.num_faces() != b.num_faces() ||
      a.num_face_slots() != b.num_face_slots())
    return testing::AssertionFailure() << "other numbers of nodes or faces";
  for (std::int32_t f = 0; f < a.num_face_slots(); ++f) {
    const auto &one = a.face(f), &other = b.face(f);
    if (one.node != other.node || one.link != other.link ||
        one.constraints != other.constraints)
      return testing::AssertionFailure() << "face " << f << " is another one";
  }
  for (delaunay::Site v = 0; v < a.num_nodes(); ++v) {
    if (a.edge_at(v) != b.edge_at(v))
      return testing::AssertionFailure() << "node " << v << " names another half-edge";
  }
  return testing::AssertionSuccess();
}

}  // namespace delone::support
