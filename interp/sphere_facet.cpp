#include "interp/sphere_facet.hpp"

#include <cmath>

#include "interp/globe_table.hpp"
#include "interp/plane_facet.hpp"

namespace delone::interp {

namespace {

std::array<double, 3> normalized(double wa, double wb, double wc) {
  wa = std::max(wa, 0.0), wb = std::max(wb, 0.0), wc = std::max(wc, 0.0);
  const double sum = wa + wb + wc;
  return {wa / sum, wb / sum, wc / sum};
}

double squared_length(Vector3 a) { return dot(a, a); }

}  // namespace

bool is_thin(Vector3 a, Vector3 b, Vector3 c) noexcept {
  const Vector3 u = b - a, w = c - a, normal = cross(u, w);
  const double longest =
      std::max({squared_length(u), squared_length(w), squared_length(w - u)});
  const double least = thin_ratio * longest, height = dot(normal, a);
  return !(squared_length(normal) > least * least) ||
         !(height > 0 &&
           height * height > thin_ratio * thin_ratio * squared_length(normal));
}

SphereFacet::SphereFacet(const SphereCorner& a, const SphereCorner& b,
                         const SphereCorner& c) noexcept
    : is_thin_(interp::is_thin(a.p, b.p, c.p)),
      rise_b_(b.value - a.value),
      rise_c_(c.value - a.value) {
  plain_.origin = a.p;
  plain_.value = a.value;
  plain_.low = std::min({a.value, b.value, c.value});
  plain_.high = std::max({a.value, b.value, c.value});
  if (is_thin_) {
    thin_ = ThinTriangle(a.p, b.p, c.p);
    const ThinTriangle::Slopes slopes = thin_.slopes();
    plain_.slope = rise_b_ * slopes.b + rise_c_ * slopes.c;
    plain_.normal = slopes.normal;
  } else {
    const Vector3 u = b.p - a.p, w = c.p - a.p;
    plain_.slope = rise_b_ * cross(w, a.p) + rise_c_ * cross(a.p, u);
    plain_.normal = cross(u, w);
  }
}

void SphereFacet::fill_row(double* row, const GlobeTable& table, IndexRange columns,
                           std::int64_t j) const noexcept {
  if (is_thin_) {
    for (std::int64_t i = columns.begin; i < columns.end; ++i)
      row[i] = thin_value(table.vector(i, j));
    return;
  }
  const PlainSphereFacet facet =
      plain_;  // a copy that the stores cannot change: kept in registers
  const double *const cosines = table.cos_lon(), *const sines = table.sin_lon();
  const double across = table.cos_lat(j), z = table.sin_lat(j);
  for (std::int64_t i = columns.begin; i < columns.end; ++i)
    row[i] = facet({across * cosines[i], across * sines[i], z});
}

double SphereFacet::thin_value(Vector3 p) const noexcept {
  const std::array<double, 3> w = thin_.weights(p);
  return std::max(plain_.low, std::min(plain_.high,
                                       plain_.value + (w[1] * rise_b_ + w[2] * rise_c_)));
}

Vector3 SphereFacet::gradient(Vector3 p) const noexcept {
  const double height = dot(plain_.normal, p), rise = (*this)(p)-plain_.value;
  return (1 / height) * (plain_.slope - rise * plain_.normal);
}

std::array<double, 3> corner_weights(Vector3 a, Vector3 b, Vector3 c,
                                     Vector3 p) noexcept {
  const Vector3 u = b - a, w = c - a, normal = cross(u, w);
  if (is_thin(a, b, c)) return ThinTriangle(a, b, c).weights(p);
  const Vector3 q = p - a;
  const double height = dot(normal, p);
  const double wb = dot(cross(w, a), q) / height, wc = dot(cross(a, u), q) / height;
  return normalized(1 - wb - wc, wb, wc);
}

// p = s a + t b, so |a x p| : |p x b| = t : s.
double edge_weight(Vector3 a, Vector3 b, Vector3 p) noexcept {
  const double from_a = length(cross(a, p - a)), to_b = length(cross(p, b - p));
  return from_a == 0 ? 0 : from_a / (from_a + to_b);
}

double edge_value(const SphereCorner& a, const SphereCorner& b, Vector3 p) noexcept {
  const double value = a.value + edge_weight(a.p, b.p, p) * (b.value - a.value);
  return std::clamp(value, std::min(a.value, b.value), std::max(a.value, b.value));
}

// With angles s to a and t to b the weight of b is sin s / (sin s + sin t), whose
// derivative by s is sin(s + t) / (sin s + sin t)^2.
Vector3 edge_gradient(const SphereCorner& a, const SphereCorner& b, Vector3 p) noexcept {
  const Vector3 axis = cross(a.p, b.p - a.p);
  const double sine = length(axis),
               sum = length(cross(a.p, p - a.p)) + length(cross(p, b.p - p));
  return ((b.value - a.value) / (sum * sum)) * cross((1 / sine) * axis, sine * p);
}

}  // namespace delone::interp
