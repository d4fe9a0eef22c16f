#include "interp/natural_gradients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "delaunay/parallel.hpp"

namespace delone::interp {

namespace {

constexpr std::int32_t largest_hole = 64;

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

// The gradient that fits the rises best.
Pair<double> fitted(std::span<const Neighbor> neighbors) {
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const auto& [d, rise, weight] : neighbors) {
    xx += weight * d.x * d.x, xy += weight * d.x * d.y, yy += weight * d.y * d.y;
    xz += weight * d.x * rise, yz += weight * d.y * rise;
  }
  const double det = xx * yy - xy * xy, trace = xx + yy;
  constexpr double singular = 1e-12;
  if (det > singular * trace * trace)
    return {(xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det};
  const Pair<double> along = xx >= yy ? Pair<double>{xx, xy} : Pair<double>{xy, yy};
  const double square = dot(along, along) * trace;
  return square > 0 ? ((along.x * xz + along.y * yz) / square) * along : Pair<double>{};
}

Pair<double> limited(Pair<double> gradient, std::span<const Neighbor> neighbors) {
  constexpr double steeper = 4, higher = 16;
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

template <class View, class Triangulation>
class Fit {
 public:
  Fit(const Triangulation& t, double scale, std::span<const double> values)
      : t_(t), scale_(scale), values_(values) {}

  [[nodiscard]] typename View::Slope operator()(Site s) const {
    const View view(t_, scale_, t_.points()[at(s)]);
    const std::span<const Site> ring = t_.adjacency().neighbors(s);
    Cavity<typename View::Vertex> around;
    for (const Site w : ring) around.add(w, view.vertex(w));
    const PerCorner<double> areas = shares(view, s, around);
    SmallVector<Neighbor, CavityShape::usual> neighbors;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Pair<double> d = View::flat(around.vertices[k]);
      neighbors.push_back(
          {d, values_[at(ring[k])] - values_[at(s)], areas[k] / dot(d, d)});
    }
    const std::span<const Neighbor> all{neighbors.data(), neighbors.size()};
    return view.slope(limited(fitted(all), all));
  }

 private:
  // What each neighbour gets of the site's cell.
  [[nodiscard]] PerCorner<double> shares(const View& view, Site s,
                                         Cavity<typename View::Vertex>& around) const {
    const Adjacency& adjacency = t_.adjacency();
    if (adjacency.is_boundary(s)) return PerCorner<double>(around.sites.size(), 1.0);
    if (adjacency.degree(s) > largest_hole) return beside(around);
    around.shape = Hole<Triangulation>(t_, adjacency.neighbors(s)).shape();
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

template <class View, class Triangulation>
std::vector<typename View::Slope> gradients(const Triangulation& t, double scale,
                                            std::span<const double> values) {
  constexpr std::int64_t chunk = 1024;
  std::vector<typename View::Slope> result(at(t.num_sites()));
  const Fit<View, Triangulation> fit(t, scale, values);
  delaunay::parallel_chunks(t.num_sites(), chunk, {},
                            [&](std::int64_t first, std::int64_t last) {
                              for (std::int64_t s = first; s < last; ++s)
                                result[at(s)] = fit(static_cast<Site>(s));
                            });
  return result;
}

}  // namespace

std::vector<PlaneView::Slope> natural_gradients(const tripack::Triangulation& t,
                                                double scale,
                                                std::span<const double> site_values) {
  return gradients<PlaneView>(t, scale, site_values);
}

std::vector<SphereView::Slope> natural_gradients(const stripack::Triangulation& t,
                                                 double scale,
                                                 std::span<const double> site_values) {
  return gradients<SphereView>(t, scale, site_values);
}

}  // namespace delone::interp
