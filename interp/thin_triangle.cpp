#include "interp/thin_triangle.hpp"

#include "interp/sphere_facet.hpp"

namespace delone::interp {

namespace {

using delaunay::two_difference;

double power_near_inverse(double largest) {
  return largest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), 0, 1000)) : 1;
}

double largest_of(double a, double b, double c) {
  return std::max({std::abs(a), std::abs(b), std::abs(c)});
}

}  // namespace

ThinTriangle::AccurateVector ThinTriangle::exact(Vector3 a) noexcept {
  return {{a.x, 0}, {a.y, 0}, {a.z, 0}};
}

ThinTriangle::AccurateVector ThinTriangle::difference(Vector3 a, Vector3 b) noexcept {
  return {two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z)};
}

ThinTriangle::AccurateVector ThinTriangle::cross(const AccurateVector& a,
                                                 const AccurateVector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

DoubleDouble ThinTriangle::dot(const AccurateVector& a,
                               const AccurateVector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector3 ThinTriangle::stretched(Vector3 v) const noexcept {
  return {v.x * stretch_.x, v.y * stretch_.y, v.z * stretch_.z};
}

ThinTriangle::ThinTriangle(Vector3 a, Vector3 b, Vector3 c) noexcept
    : stretch_{power_near_inverse(largest_of(a.x, b.x, c.x)),
               power_near_inverse(largest_of(a.y, b.y, c.y)),
               power_near_inverse(largest_of(a.z, b.z, c.z))},
      corners_{stretched(a), stretched(b), stretched(c)} {
  const AccurateVector origin = exact(corners_[0]);
  const AccurateVector u = difference(corners_[1], corners_[0]),
                       w = difference(corners_[2], corners_[0]);
  b_slope_ = cross(w, origin);
  c_slope_ = cross(origin, u);
  normal_ = cross(u, w);
}

std::array<double, 3> ThinTriangle::weights(Vector3 p) const noexcept {
  p = stretched(p);
  const DoubleDouble height = dot(normal_, exact(p));
  if (!(height.high > 0)) return weights_along_longest_side(p);
  const AccurateVector q = difference(p, corners_[0]);
  const double wb = std::max(0.0, (dot(b_slope_, q) / height).rounded());
  const double wc = std::max(0.0, (dot(c_slope_, q) / height).rounded());
  const double wa = std::max(0.0, 1 - wb - wc), sum = wa + wb + wc;
  return {wa / sum, wb / sum, wc / sum};
}

std::array<double, 3> ThinTriangle::weights_along_longest_side(Vector3 p) const noexcept {
  const auto side = [&](std::size_t i, std::size_t j) {
    return length(corners_[j] - corners_[i]);
  };
  const double ab = side(0, 1), ac = side(0, 2), bc = side(1, 2);
  const std::size_t from = bc > ab && bc > ac ? 1 : 0, to = ab >= ac && ab >= bc ? 1 : 2;
  std::array<double, 3> weights{};
  weights[to] = edge_weight(corners_[from], corners_[to], p);
  weights[from] = 1 - weights[to];
  return weights;
}

ThinTriangle::Slopes ThinTriangle::slopes() const noexcept {
  const auto rounded = [&](const AccurateVector& v) {
    return stretched({v.x.rounded(), v.y.rounded(), v.z.rounded()});
  };
  return {rounded(b_slope_), rounded(c_slope_), rounded(normal_)};
}

}  // namespace delone::interp
