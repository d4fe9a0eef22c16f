#pragma once

#include <memory>
#include <span>

#include "interp/idw_surface.hpp"
#include "interp/rbf_surface.hpp"
#include "interp/shepard_surface.hpp"

/// The meshless methods under one name on plane and sphere, for tests of what they share.
namespace delone::support {

using PlaneSet = std::shared_ptr<const tripack::Triangulation>;
using SphereSet = std::shared_ptr<const stripack::Triangulation>;
using Values = std::span<const double>;

struct InverseDistances {
  static constexpr double turning_tolerance = 1e-11;
  static interp::PlaneInverseDistance make(const PlaneSet& t, Values v,
                                           const interp::SurfaceOptions& o = {}) {
    return {t, v, {}, o};
  }
  static interp::SphereInverseDistance make(const SphereSet& t, Values v,
                                            const interp::SurfaceOptions& o = {}) {
    return {t, v, {}, o};
  }
};

template <interp::ShepardDegree degree>
struct Shepards {
  static constexpr double turning_tolerance = 1e-9;
  static interp::PlaneShepard make(const PlaneSet& t, Values v,
                                   const interp::SurfaceOptions& o = {}) {
    return {t, v, {.degree = degree}, o};
  }
  static interp::SphereShepard make(const SphereSet& t, Values v,
                                    const interp::SurfaceOptions& o = {}) {
    return {t, v, {.degree = degree}, o};
  }
};
using QuadraticShepards = Shepards<interp::ShepardDegree::quadratic>;
using CubicShepards = Shepards<interp::ShepardDegree::cubic>;

/// Sets of more than `most_at_once` nodes are local splines.
template <interp::RadialKernel kernel, int most_at_once>
struct Radials {
  // Which nodes are centres of local splines depends on the curve.
  static constexpr double turning_tolerance = most_at_once < 100 ? 0.1 : 1e-9;
  static interp::PlaneRadial make(const PlaneSet& t, Values v,
                                  const interp::SurfaceOptions& o = {}) {
    return {t, v, {.kernel = kernel, .most_at_once = most_at_once}, o};
  }
  static interp::SphereRadial make(const SphereSet& t, Values v,
                                   const interp::SurfaceOptions& o = {}) {
    return {t, v, {.kernel = kernel, .most_at_once = most_at_once}, o};
  }
};
using ThinPlates = Radials<interp::RadialKernel::thin_plate, 512>;
using LocalThinPlates = Radials<interp::RadialKernel::thin_plate, 40>;
using LocalCubics = Radials<interp::RadialKernel::cubic, 40>;
using LocalQuintics = Radials<interp::RadialKernel::quintic, 40>;

}  // namespace delone::support
