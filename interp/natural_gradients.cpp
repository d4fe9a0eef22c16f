#include "interp/natural_gradients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "delaunay/parallel.hpp"

namespace delone::interp {

namespace {

constexpr std::size_t largest_hole = 64;

/// The triangulation of the hole that a removed site leaves: the Delaunay triangulation
/// of its neighbours as far as it lies in there.
///
/// The sides of the hole are Delaunay edges, so its triangles are found one by one: of
/// the corners that a side sees on its left the one whose circle holds no other.
template <class Triangulation>
class Hole {
 public:
  Hole(const Triangulation& t, std::span<const Site> ring)
      : points_(t.points()), ring_(ring) {
    const auto size = static_cast<std::int32_t>(ring.size());
    shape_.ring =
        SmallVector<CavityShape::Side, CavityShape::usual>(ring.size(), {0, -1});
    for (std::int32_t k = 0; k < size; ++k) shape_.ring[at(k)].corner = k;
    fill({0, size - 1, -1});
  }
  /// Without triangles if neighbours on one line left none to be found.
  [[nodiscard]] const CavityShape& shape() const noexcept { return shape_; }

 private:
  // The corners from first to last are on the left of the side from last to first, and
  // `parent` on its right. Of the whole hole that side is one of its own.
  struct Chain {
    std::int32_t first, last, parent;
  };

  void fill(Chain whole) {
    SmallVector<Chain, CavityShape::usual> open;
    open.push_back(whole);
    while (!open.empty()) {
      const Chain chain = open.back();
      open.pop_back();
      if (chain.last == chain.first + 1) {
        shape_.ring[at(chain.first)].triangle = chain.parent;
        continue;
      }
      const std::int32_t apex = best_apex(chain);
      if (apex < 0) {
        shape_.triangles = {};
        return;
      }
      const auto number = static_cast<std::int32_t>(shape_.triangles.size());
      shape_.triangles.push_back({{chain.last, chain.first, apex}, chain.parent});
      if (chain.parent < 0) shape_.ring[at(chain.last)].triangle = number;
      open.push_back({chain.first, apex, number});
      open.push_back({apex, chain.last, number});
    }
  }

  [[nodiscard]] std::int32_t best_apex(const Chain& chain) const {
    const auto& from = point(chain.last);
    const auto& to = point(chain.first);
    std::int32_t best = -1;
    for (std::int32_t k = chain.first + 1; k < chain.last; ++k) {
      if (orientation(from, to, point(k)) <= 0) continue;
      if (best < 0 || in_circle(from, to, point(best), point(k)) > 0) best = k;
    }
    return best;
  }
  [[nodiscard]] const auto& point(std::int32_t k) const {
    return points_[at(ring_[at(k)])];
  }

  decltype(std::declval<const Triangulation&>().points()) points_;
  std::span<const Site> ring_;
  CavityShape shape_;
};

struct Neighbor {
  Pair<double> offset;
  double rise, weight;
};

// Of the determinant of a fit, beside its squared trace: neighbours on one line.
constexpr double singular = 1e-12;

// The gradient that fits the rises best.
Pair<double> fitted(std::span<const Neighbor> neighbors) {
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const auto& [d, rise, weight] : neighbors) {
    xx += weight * d.x * d.x, xy += weight * d.x * d.y, yy += weight * d.y * d.y;
    xz += weight * d.x * rise, yz += weight * d.y * rise;
  }
  const double det = xx * yy - xy * xy, trace = xx + yy;
  if (det > singular * trace * trace)
    return {(xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det};
  const Pair<double> along = xx >= yy ? Pair<double>{xx, xy} : Pair<double>{xy, yy};
  const double square = dot(along, along) * trace;
  return square > 0 ? ((along.x * xz + along.y * yz) / square) * along : Pair<double>{};
}

// Gradients are no steeper than this times the steepest way to a neighbour, and do not
// rise, over the distance of the farthest one, by more than this times the largest rise.
constexpr double steeper = 4, higher = 16;
// So much more where the bounds are for the worst of all values, which hardly occur.
constexpr double for_all = 4;

Pair<double> limited(Pair<double> gradient, std::span<const Neighbor> neighbors) {
  double steepest = 0, farthest = 0, highest = 0;
  for (const auto& [d, rise, weight] : neighbors) {
    const double distance = std::hypot(d.x, d.y);
    steepest = std::max(steepest, std::abs(rise) / distance);
    farthest = std::max(farthest, distance);
    highest = std::max(highest, std::abs(rise));
  }
  const double size = std::hypot(gradient.x, gradient.y);
  if (!std::isfinite(size)) return {};
  const double most = std::min(steeper * steepest, higher * highest / farthest);
  return size > most ? (most / size) * gradient : gradient;
}

using SlopeWeights = SmallVector<Pair<double>, CavityShape::usual>;

// What `fitted` takes from each of the rises.
SlopeWeights fitting_weights(std::span<const Neighbor> neighbors) {
  double xx = 0, xy = 0, yy = 0;
  for (const auto& [d, rise, weight] : neighbors)
    xx += weight * d.x * d.x, xy += weight * d.x * d.y, yy += weight * d.y * d.y;
  const double det = xx * yy - xy * xy, trace = xx + yy;
  const Pair<double> along = xx >= yy ? Pair<double>{xx, xy} : Pair<double>{xy, yy};
  const double square = dot(along, along) * trace;
  SlopeWeights result;
  for (const auto& [d, rise, weight] : neighbors) {
    if (det > singular * trace * trace) {
      result.push_back(
          {weight * (d.x * yy - d.y * xy) / det, weight * (d.y * xx - d.x * xy) / det});
    } else {
      result.push_back(square > 0 ? (weight * dot(along, d) / square) * along
                                  : Pair<double>{});
    }
  }
  return result;
}

// The weights shortened so that no rises break the limits.
SlopeWeights limited(SlopeWeights weights, std::span<const Neighbor> neighbors) {
  double steepest = 0, highest = 0, farthest = 0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const double distance = std::hypot(neighbors[k].offset.x, neighbors[k].offset.y),
                 size = std::hypot(weights[k].x, weights[k].y);
    steepest += size * distance;
    highest += size;
    farthest = std::max(farthest, distance);
  }
  const double excess =
      std::max(steepest / (steeper * for_all), highest * farthest / (higher * for_all));
  if (!std::isfinite(excess)) return SlopeWeights(weights.size(), Pair<double>{});
  const double part = excess > 1 ? 1 / excess : 1;
  for (Pair<double>& weight : weights) weight = part * weight;
  return weights;
}

template <class View, class Triangulation>
class Fit {
 public:
  Fit(const Triangulation& t, double scale, std::span<const double> values)
      : t_(t), scale_(scale), values_(values) {}

  [[nodiscard]] typename View::Slope operator()(const SiteStar& star,
                                                SlopeLimit limit) const {
    const View view(t_, scale_, t_.points()[at(star.site)]);
    const Neighbors neighbors = around(view, star);
    const std::span<const Neighbor> all{neighbors.data(), neighbors.size()};
    if (limit == SlopeLimit::values) return view.slope(limited(fitted(all), all));
    const SlopeWeights weights = limited(fitting_weights(all), all);
    Pair<double> slope;
    for (std::size_t k = 0; k < all.size(); ++k) slope = slope + all[k].rise * weights[k];
    return view.slope(slope);
  }

  /// See natural_slope_weights.
  [[nodiscard]] std::vector<typename View::Slope> weights(const SiteStar& star) const {
    const View view(t_, scale_, t_.points()[at(star.site)]);
    const Neighbors neighbors = around(view, star);
    const std::span<const Neighbor> all{neighbors.data(), neighbors.size()};
    std::vector<typename View::Slope> result;
    for (const Pair<double>& weight : limited(fitting_weights(all), all))
      result.push_back(view.slope(weight));
    return result;
  }

 private:
  using Neighbors = SmallVector<Neighbor, CavityShape::usual>;

  // Without values all rises are zero.
  [[nodiscard]] Neighbors around(const View& view, const SiteStar& star) const {
    Cavity<typename View::Vertex> around;
    for (const Site w : star.neighbors) around.add(w, view.vertex(w));
    const PerCorner<double> areas = shares(view, star, around);
    Neighbors neighbors;
    for (std::size_t k = 0; k < star.neighbors.size(); ++k) {
      const Pair<double> d = View::flat(around.vertices[k]);
      const double rise =
          values_.empty() ? 0 : values_[at(star.neighbors[k])] - values_[at(star.site)];
      neighbors.push_back({d, rise, areas[k] / dot(d, d)});
    }
    return neighbors;
  }

  // What each neighbour gets of the site's cell.
  [[nodiscard]] PerCorner<double> shares(const View& view, const SiteStar& star,
                                         Cavity<typename View::Vertex>& around) const {
    if (star.is_boundary) return PerCorner<double>(around.sites.size(), 1.0);
    if (star.neighbors.size() > largest_hole) return beside(around);
    around.shape = Hole<Triangulation>(t_, star.neighbors).shape();
    if (around.shape.triangles.empty())
      return PerCorner<double>(around.sites.size(), 1.0);
    return view.weights(NaturalKind::sibson_c1, around);
  }

  [[nodiscard]] static PerCorner<double> beside(
      const Cavity<typename View::Vertex>& around) {
    CavityShape shape;
    PerCorner<Pair<double>> corners;
    for (const auto& v : around.vertices) {
      shape.ring.push_back({static_cast<std::int32_t>(corners.size()), 0});
      corners.push_back(View::flat(v));
    }
    PerCorner<double> areas =
        laplace_ratios<double>(shape, {corners.data(), corners.size()});
    for (std::size_t k = 0; k < areas.size(); ++k) {
      areas[k] = std::max(areas[k], 0.0) * dot(corners[k], corners[k]);
      if (!std::isfinite(areas[k])) areas[k] = 0;
    }
    return areas;
  }

  const Triangulation& t_;
  double scale_;
  std::span<const double> values_;
};

template <class Triangulation>
SiteStar star_of(const Triangulation& t, Site s) {
  return {s, t.adjacency().neighbors(s), t.adjacency().is_boundary(s)};
}

template <class View, class Triangulation>
std::vector<typename View::Slope> gradients(const Triangulation& t, double scale,
                                            std::span<const double> values,
                                            SlopeLimit limit) {
  constexpr std::int64_t chunk = 1024;
  std::vector<typename View::Slope> result(at(t.num_sites()));
  const Fit<View, Triangulation> fit(t, scale, values);
  delaunay::parallel_chunks(t.num_sites(), chunk, {},
                            [&](std::int64_t first, std::int64_t last) {
                              for (auto s = static_cast<Site>(first); s < last; ++s)
                                result[at(s)] = fit(star_of(t, s), limit);
                            });
  return result;
}

}  // namespace

std::vector<PlaneView::Slope> natural_gradients(const tripack::Triangulation& t,
                                                double scale,
                                                std::span<const double> site_values,
                                                SlopeLimit limit) {
  return gradients<PlaneView>(t, scale, site_values, limit);
}

std::vector<SphereView::Slope> natural_gradients(const stripack::Triangulation& t,
                                                 double scale,
                                                 std::span<const double> site_values,
                                                 SlopeLimit limit) {
  return gradients<SphereView>(t, scale, site_values, limit);
}

PlaneView::Slope natural_gradient(const tripack::Triangulation& t, double scale,
                                  std::span<const double> site_values,
                                  const SiteStar& star) {
  return Fit<PlaneView, tripack::Triangulation>(t, scale, site_values)(
      star, SlopeLimit::values);
}

SphereView::Slope natural_gradient(const stripack::Triangulation& t, double scale,
                                   std::span<const double> site_values,
                                   const SiteStar& star) {
  return Fit<SphereView, stripack::Triangulation>(t, scale, site_values)(
      star, SlopeLimit::values);
}

std::vector<PlaneView::Slope> natural_slope_weights(const tripack::Triangulation& t,
                                                    double scale, Site site) {
  return Fit<PlaneView, tripack::Triangulation>(t, scale, {}).weights(star_of(t, site));
}

std::vector<SphereView::Slope> natural_slope_weights(const stripack::Triangulation& t,
                                                     double scale, Site site) {
  return Fit<SphereView, stripack::Triangulation>(t, scale, {}).weights(star_of(t, site));
}

}  // namespace delone::interp
