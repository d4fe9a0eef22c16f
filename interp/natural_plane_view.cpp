#include <algorithm>
#include <cmath>
#include <limits>

#include "interp/natural_view.hpp"
#include "interp/plane_facet.hpp"

namespace delone::interp {

namespace {

// Coordinates as seen from the query, exact, and the same with derivatives.
Pair<DoubleDouble> exact_offset(tripack::Point2 v, tripack::Point2 p, DoubleDouble) {
  return {delaunay::two_difference(v.x, p.x), delaunay::two_difference(v.y, p.y)};
}
Pair<Dual<DoubleDouble>> exact_offset(tripack::Point2 v, tripack::Point2 p,
                                      Dual<DoubleDouble>) {
  const Pair<DoubleDouble> d = exact_offset(v, p, DoubleDouble{});
  return {{d.x, {-1}, {}}, {d.y, {}, {-1}}};
}
DoubleDouble times(const DoubleDouble& a, double power_of_two) {
  return {a.high * power_of_two, a.low * power_of_two};
}
Dual<DoubleDouble> times(const Dual<DoubleDouble>& a, double power_of_two) {
  return {times(a.value, power_of_two), a.x, a.y};
}

// Power of two that brings the largest coordinate near one.
double unit_scale(std::span<const Pair<double>> corners) {
  double largest = 0;
  for (const Pair<double>& c : corners)
    largest = std::max({largest, std::abs(c.x), std::abs(c.y)});
  if (!(largest > 0 && largest <= std::numeric_limits<double>::max())) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022));
}

template <class T>
PerCorner<T> parts(NaturalKind kind, const CavityShape& shape,
                   std::span<const Pair<T>> corners) {
  return kind == NaturalKind::laplace ? laplace_ratios<T>(shape, corners)
                                      : sibson_areas<T>(shape, corners);
}

std::span<const Pair<double>> corners_of(const Cavity<Pair<double>>& cavity) {
  return {cavity.vertices.data(), cavity.vertices.size()};
}

}  // namespace

template <class T>
PerCorner<T> PlaneView::accurate_weights(NaturalKind kind,
                                         const Cavity<Vertex>& cavity) const {
  const double unit = unit_scale(corners_of(cavity));
  PerCorner<Pair<T>> corners;
  for (const Site s : cavity.sites) {
    const tripack::Point2 v = points_[at(s)];
    const Pair<T> offset =
        exact_offset({v.x * scale_, v.y * scale_}, {scaled_p_.x, scaled_p_.y}, T{});
    corners.push_back({times(offset.x, unit), times(offset.y, unit)});
  }
  return normalized(parts<T>(kind, cavity.shape, {corners.data(), corners.size()}));
}

PerCorner<double> PlaneView::linear_weights(const Cavity<Vertex>& cavity) const {
  const auto point = [&](std::size_t k) {
    const tripack::Point2 v = points_[at(cavity.sites[k])];
    return tripack::Point2{v.x * scale_, v.y * scale_};
  };
  PerCorner<double> weights(cavity.sites.size(), 0.0);
  const std::array<double, 3> w =
      corner_weights(point(0), point(1), point(2), {scaled_p_.x, scaled_p_.y});
  std::copy(w.begin(), w.end(), weights.begin());
  return weights;
}

PerCorner<double> PlaneView::weights(NaturalKind kind,
                                     const Cavity<Vertex>& cavity) const {
  const std::span<const Pair<double>> corners = corners_of(cavity);
  PerCorner<double> weights = normalized(parts<double>(kind, cavity.shape, corners));
  if (!weights.empty()) return weights;
  for (const DoubleDouble& w : accurate_weights<DoubleDouble>(kind, cavity))
    weights.push_back(w.rounded());
  return weights.empty() ? linear_weights(cavity) : weights;
}

PerCorner<Dual<double>> PlaneView::sloped_weights(NaturalKind kind,
                                                  const Cavity<Vertex>& cavity) const {
  const std::span<const Pair<double>> corners = corners_of(cavity);
  PerCorner<Pair<Dual<double>>> sloped;
  for (const Pair<double>& c : corners) sloped.push_back({{c.x, -1, 0}, {c.y, 0, -1}});
  PerCorner<Dual<double>> weights =
      normalized(parts<Dual<double>>(kind, cavity.shape, {sloped.data(), sloped.size()}));
  if (!weights.empty()) return weights;
  const double unit = unit_scale(corners);
  for (const Dual<DoubleDouble>& w : accurate_weights<Dual<DoubleDouble>>(kind, cavity)) {
    const Dual<double> r = rounded(w);
    weights.push_back({r.value, r.x * unit, r.y * unit});
  }
  return weights;
}

}  // namespace delone::interp
