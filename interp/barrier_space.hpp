#pragma once

#include "interp/barrier_mesh.hpp"
#include "interp/blend_space.hpp"

namespace delone::interp {

/// The constrained triangulation of a space.
template <BlendSpace Space>
struct ConstrainedOf;
template <>
struct ConstrainedOf<PlaneSpace> {
  using Type = tripack::ConstrainedTriangulation;
};
template <>
struct ConstrainedOf<SphereSpace> {
  using Type = stripack::ConstrainedTriangulation;
};
template <BlendSpace Space>
using ConstrainedIn = typename ConstrainedOf<Space>::Type;
template <BlendSpace Space>
using BarrierMeshIn = BarrierMesh<ConstrainedIn<Space>>;

}  // namespace delone::interp
