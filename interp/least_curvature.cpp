#include "interp/least_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "delaunay/parallel.hpp"
#include "interp/curvature_network.hpp"
#include "interp/index.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

namespace {

using tripack::Point2;
using Tangent = CurvatureNetwork::Tangent;
using End = CurvatureNetwork::End;

/// Area of the triangle on the left of an arc; 0 where there is none.
template <BlendSpace Space>
double area_on_left(const Space& space, const typename Space::Triangulation& t, Arc arc) {
  if (!t.adjacency().has_left(arc)) return 0;
  const std::array<Site, 3> corners = t.adjacency().left(arc);
  const auto p = [&](std::size_t k) { return space.vector(t.points()[at(corners[k])]); };
  const auto a = Space::difference(p(1), p(0)), b = Space::difference(p(2), p(0));
  const double ab = Space::dot(a, b);
  return 0.5 * std::sqrt(std::max(0.0, Space::dot(a, a) * Space::dot(b, b) - ab * ab));
}

double length_of(const PlaneSpace&, double chord) { return chord; }
double length_of(const SphereSpace&, double chord) {
  return 2 * std::asin(std::min(1.0, chord / 2));
}

/// An edge as its origin sees it; `area` that of the triangles beside it. The number of
/// the other end is left open.
template <BlendSpace Space>
End end_of(const Space& space, const typename Space::Triangulation& t, double rise,
           Site from, Site to, double area) {
  const auto origin = space.vector(t.points()[at(from)]);
  const auto difference = Space::difference(space.vector(t.points()[at(to)]), origin);
  const LocalPosition<double> d =
      Space::local(Space::axes(origin), Space::position(difference), 1);
  // What underflows, or lies on the far side of the sphere, says nothing of slopes.
  constexpr double shortest = 1e-60;
  const double across = std::hypot(d.u, d.v);
  if (!(across > shortest)) return {};
  const double length = length_of(space, std::sqrt(Space::dot(difference, difference)));
  constexpr double least_area = 1e-3;  // of the square of the length
  const double share = std::max(area / (length * length), least_area);
  return {.direction = {d.u / across, d.v / across},
          .weight = share / (length * std::sqrt(length)),
          .slope = rise / length};
}

template <BlendSpace Space>
typename Space::Vector tangent_vector(const typename Space::Axes& axes, const Tangent& g);
template <>
Point2 tangent_vector<PlaneSpace>(const PlaneSpace::Axes&, const Tangent& g) {
  return {g[0], g[1]};
}
template <>
Vector3 tangent_vector<SphereSpace>(const SphereSpace::Axes& axes, const Tangent& g) {
  return g[0] * axes.u + g[1] * axes.v;
}

/// The network of all edges; `rise(from, to)`.
template <BlendSpace Space, class Rise>
CurvatureNetwork network_of(const Space& space,
                            const typename Space::Triangulation& triangulation,
                            const RunOptions& run, Rise rise) {
  constexpr std::int64_t chunk = 2048;
  const Adjacency& t = triangulation.adjacency();
  const Site num_sites = triangulation.num_sites();
  std::vector<std::int32_t> offsets(at(num_sites) + 1);
  for (Site v = 0; v < num_sites; ++v) offsets[at(v) + 1] = offsets[at(v)] + t.degree(v);
  std::vector<End> ends(at(offsets.back()));
  RunOptions quiet = run;
  quiet.progress = {};
  delaunay::parallel_chunks(
      num_sites, chunk, quiet, [&](std::int64_t first, std::int64_t last) {
        for (auto v = static_cast<Site>(first); v < last; ++v) {
          Arc a = t.first_arc(v);
          for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a)) {
            const Arc back = t.reverse(a);
            End& end = ends[at(a.index)];
            end = end_of(space, triangulation, rise(v, t.target(a)), v, t.target(a),
                         area_on_left(space, triangulation, a) +
                             area_on_left(space, triangulation, back));
            end.reverse = back.index;
          }
        }
      });
  return {std::move(offsets), std::move(ends)};
}

}  // namespace

template <BlendSpace Space>
CurvatureNetworkOfSites curvature_network_of(
    const Space& space, const typename Space::Triangulation& triangulation,
    const RunOptions& run) {
  CurvatureNetwork network =
      network_of(space, triangulation, run, [](Site, Site) { return 1.0; });
  std::vector<double> inverse_lengths;
  inverse_lengths.reserve(network.ends().size());
  for (const End& e : network.ends()) inverse_lengths.push_back(e.slope);
  return {std::move(network).in_unit_coordinates(run), std::move(inverse_lengths)};
}

template <BlendSpace Space>
std::vector<typename Space::Vector> least_curvature_gradients(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, const RunOptions& run) {
  const Site num_sites = triangulation.num_sites();
  const std::vector<Tangent> solution =
      network_of(space, triangulation, run, [&](Site from, Site to) {
        return site_values[at(to)] - site_values[at(from)];
      }).solve(num_curvature_steps, run);
  std::vector<typename Space::Vector> gradients(at(num_sites));
  for (Site v = 0; v < num_sites; ++v) {
    gradients[at(v)] = tangent_vector<Space>(
        Space::axes(space.vector(triangulation.points()[at(v)])), solution[at(v)]);
  }
  return gradients;
}

namespace {

/// The nodes around a hole and the edges between them.
template <BlendSpace Space>
class Surroundings {
 public:
  using Triangulation = typename Space::Triangulation;

  Surroundings(Site removed, std::span<const Site> corners, const Space& space,
               const Triangulation& triangulation, std::span<const double> site_values)
      : removed_(removed),
        space_(space),
        triangulation_(&triangulation),
        site_values_(site_values) {
    gather(corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) join(corners[i], corners[j]);
    }
    add_edges();
  }

  [[nodiscard]] CurvatureNetwork network() const {
    std::vector<std::int32_t> offsets(nodes_.size() + 1);
    for (const Edge& e : edges_) {
      ++offsets[e.first + 1];
      ++offsets[e.second + 1];
    }
    for (std::size_t v = 0; v < nodes_.size(); ++v) offsets[v + 1] += offsets[v];
    std::vector<std::int32_t> next(offsets.begin(), offsets.end() - 1);
    std::vector<End> ends(2 * edges_.size());
    for (const Edge& e : edges_) {
      const std::int32_t a = next[e.first]++, b = next[e.second]++;
      ends[at(a)] = end(e.first, e.second, e.area);
      ends[at(b)] = end(e.second, e.first, e.area);
      ends[at(a)].reverse = b;
      ends[at(b)].reverse = a;
    }
    return {std::move(offsets), std::move(ends)};
  }

  [[nodiscard]] std::size_t number_of(Site s) const {
    return static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), s) -
                                    nodes_.begin());
  }

 private:
  static constexpr std::int32_t whole_list = 32;
  struct Edge {
    std::size_t first, second;
    double area;
  };

  void gather(std::span<const Site> corners) {
    StencilGatherer<Space> gatherer(space_, *triangulation_);
    for (const Site c : corners) {
      nodes_.push_back(c);
      for (const StencilNode& n : gatherer.around_without(removed_, corners, c, 0))
        nodes_.push_back(n.site);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  }
  [[nodiscard]] bool is_here(Site s) const {
    return std::binary_search(nodes_.begin(), nodes_.end(), s);
  }
  // An edge that there may be already; as one between equilateral triangles.
  void join(Site a, Site b) {
    const Adjacency& t = triangulation_->adjacency();
    const Site fewer = t.degree(a) < t.degree(b) ? a : b, more = fewer == a ? b : a;
    const auto list = t.neighbors(fewer);
    if (std::find(list.begin(), list.end(), more) != list.end()) return;
    const auto d = Space::difference(vector_of(a), vector_of(b));
    edges_.push_back({number_of(a), number_of(b), 0.5 * Space::dot(d, d)});
  }
  // Hubs are seen from their neighbours only.
  void add_edges() {
    const Adjacency& t = triangulation_->adjacency();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Site v = nodes_[i];
      if (t.degree(v) > whole_list) continue;
      Arc a = t.first_arc(v);
      for (std::int32_t k = 0; k < t.degree(v); ++k, a = t.next(a)) {
        const Site w = t.target(a);
        if (!is_here(w) || (w < v && t.degree(w) <= whole_list)) continue;
        edges_.push_back({i, number_of(w),
                          area_on_left(space_, *triangulation_, a) +
                              area_on_left(space_, *triangulation_, t.reverse(a))});
      }
    }
  }
  [[nodiscard]] End end(std::size_t from, std::size_t to, double area) const {
    const double rise = site_values_[at(nodes_[to])] - site_values_[at(nodes_[from])];
    return end_of(space_, *triangulation_, rise, nodes_[from], nodes_[to], area);
  }
  [[nodiscard]] typename Space::Vector vector_of(Site s) const {
    return space_.vector(triangulation_->points()[at(s)]);
  }

  Site removed_;
  Space space_;
  const Triangulation* triangulation_;
  std::span<const double> site_values_;
  std::vector<Site> nodes_;
  std::vector<Edge> edges_;
};

}  // namespace

template <BlendSpace Space>
std::vector<typename Space::Vector> least_curvature_gradients_without(
    Site removed, std::span<const Site> corners, const Space& space,
    const typename Space::Triangulation& triangulation,
    std::span<const double> site_values) {
  constexpr int num_steps = 8;
  const Surroundings<Space> surroundings(removed, corners, space, triangulation,
                                         site_values);
  const std::vector<Tangent> solution =
      surroundings.network().solve(num_steps, {.num_threads = 1, .progress = {}});
  std::vector<typename Space::Vector> gradients;
  for (const Site c : corners) {
    gradients.push_back(
        tangent_vector<Space>(Space::axes(space.vector(triangulation.points()[at(c)])),
                              solution[surroundings.number_of(c)]));
  }
  return gradients;
}

template CurvatureNetworkOfSites curvature_network_of<PlaneSpace>(
    const PlaneSpace&, const tripack::Triangulation&, const RunOptions&);
template CurvatureNetworkOfSites curvature_network_of<SphereSpace>(
    const SphereSpace&, const stripack::Triangulation&, const RunOptions&);
template std::vector<Point2> least_curvature_gradients<PlaneSpace>(
    const PlaneSpace&, const tripack::Triangulation&, std::span<const double>,
    const RunOptions&);
template std::vector<Vector3> least_curvature_gradients<SphereSpace>(
    const SphereSpace&, const stripack::Triangulation&, std::span<const double>,
    const RunOptions&);
template std::vector<Point2> least_curvature_gradients_without<PlaneSpace>(
    Site, std::span<const Site>, const PlaneSpace&, const tripack::Triangulation&,
    std::span<const double>);
template std::vector<Vector3> least_curvature_gradients_without<SphereSpace>(
    Site, std::span<const Site>, const SphereSpace&, const stripack::Triangulation&,
    std::span<const double>);

}  // namespace delone::interp
