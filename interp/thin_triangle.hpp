#pragma once

#include <array>

#include "delaunay/double_double.hpp"
#include "interp/sphere_vector.hpp"

namespace delone::interp {

using delaunay::DoubleDouble;

/// Weights within a flat triangle that is thin, tiny, or nearly seen edge-on from the
/// centre, in double-double arithmetic.
///
/// Weights do not change when an axis is stretched: each is scaled by a power of two
/// until the largest component is near one, so that components down to the smallest
/// double do not underflow.
class ThinTriangle {
 public:
  ThinTriangle() = default;
  ThinTriangle(Vector3 a, Vector3 b, Vector3 c) noexcept;

  /// At the point where the ray through p meets the triangle: not negative, sum one up to
  /// rounding. Corners on one great circle to 100 bits: linear along the longest side.
  [[nodiscard]] std::array<double, 3> weights(Vector3 p) const noexcept;

  /// Vectors m, n, k with weight_b = m . (p - a) / k . p and weight_c = n . (p - a) / k .
  /// p, for gradients.
  struct Slopes {
    Vector3 b, c, normal;
  };
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  struct AccurateVector {
    DoubleDouble x, y, z;
  };
  static AccurateVector exact(Vector3 a) noexcept;
  static AccurateVector difference(Vector3 a, Vector3 b) noexcept;
  static AccurateVector cross(const AccurateVector& a, const AccurateVector& b) noexcept;
  static DoubleDouble dot(const AccurateVector& a, const AccurateVector& b) noexcept;
  [[nodiscard]] Vector3 stretched(Vector3 v) const noexcept;
  [[nodiscard]] std::array<double, 3> weights_along_longest_side(
      Vector3 p) const noexcept;

  Vector3 stretch_;
  std::array<Vector3, 3> corners_;  // stretched
  AccurateVector b_slope_, c_slope_, normal_;
};

}  // namespace delone::interp
