#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangle_quality.hpp"

/// Volumes in space. Faces are lists of corners, counter-clockwise as seen from outside;
/// a face with more than three corners should be plane and is cut into a fan.
namespace delone::delaunay {

using PolyhedronFace = std::vector<std::int32_t>;

/// Volume enclosed by a closed surface, negative if its faces are clockwise. Summed in
/// twice the precision: correct to the last places unless volumes beyond 2^40 of it
/// cancel. O(corners). Throws Error naming the face whose corner does not exist.
[[nodiscard]] double polyhedron_volume(std::span<const Position> corners,
                                       std::span<const PolyhedronFace> faces);

/// Centre of mass of the volume; NaN if there is none. Errors as above.
[[nodiscard]] Position polyhedron_centroid(std::span<const Position> corners,
                                           std::span<const PolyhedronFace> faces);

struct Ball {
  Position center{};
  double radius = 0;
};

/// The sphere through the corners of a tetrahedron, to a few units in the last place of
/// the corners and the radius; flat ones have a centre of NaN and an infinite radius.
[[nodiscard]] Ball tetrahedron_circumsphere(const Position& a, const Position& b,
                                            const Position& c,
                                            const Position& d) noexcept;

}  // namespace delone::delaunay
