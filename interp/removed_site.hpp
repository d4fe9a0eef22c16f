#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "interp/spot.hpp"

namespace delone::interp {

/// A site of a Delaunay triangulation (dimension 2) and what lies in its place once it is
/// removed, in O(degree) and without changing the triangulation.
///
/// The hole that a site leaves is filled by triangles over its neighbours (the rim), and
/// these are the ones of the canonical triangulation of the other sites. The one in which
/// the site itself lies is found by descent, as in linear programming: seen from above,
/// it is the face of the lower hull of the lifted rim over the site. From a triangle of
/// the rim that holds the site, any neighbour inside its circle gives a lower one that
/// holds it, until no circle holds a neighbour. On the sphere the same with the faces of
/// the polyhedron and the ray to the site; if it leaves the polyhedron of the rim on the
/// far side, what remains is a hemisphere, and the site is outside of it.
///
/// A site on the boundary is outside of what remains, unless the boundary runs straight
/// through it. All decisions are exact.
template <class Triangulation>
class RemovedSite {
 public:
  using Point =
      std::remove_cvref_t<decltype(std::declval<const Triangulation&>().points()[0])>;

  RemovedSite(const Triangulation& t, Site site) : t_(&t), site_(site) {}

  [[nodiscard]] const Triangulation& triangulation() const noexcept { return *t_; }
  [[nodiscard]] Site site() const noexcept { return site_; }
  [[nodiscard]] const Point& position() const noexcept { return point(site_); }
  /// The neighbours, counter-clockwise; those of a boundary site from one boundary
  /// neighbour to the other.
  [[nodiscard]] std::span<const Site> rim() const noexcept {
    return t_->adjacency().neighbors(site_);
  }
  [[nodiscard]] bool is_boundary() const noexcept {
    return t_->adjacency().is_boundary(site_);
  }
  /// Does the boundary run straight through the site?
  [[nodiscard]] bool is_on_straight_boundary() const {
    return is_boundary() && side(rim().front(), rim().back()) == 0;
  }

  /// What holds the position among the sites that remain. For a boundary site: outside;
  /// if the boundary runs straight through it, the edge between its boundary neighbours
  /// (right in the plane; on the sphere if they are less than half a turn apart).
  [[nodiscard]] Spot spot() const {
    if (!is_boundary()) return spot_in_hole();
    return is_on_straight_boundary() ? edge_spot(rim().front(), rim().back()) : Spot{};
  }

  /// The nearest of the sites that remain; of several the smallest. `none` if there are
  /// none.
  [[nodiscard]] Site nearest() const {
    Site best = nearest_of(rim());
    // Beyond a right angle the nearest site may be a neighbour across the outside.
    if (best != none && squared_distance(point(best), position()) < far) return best;
    for (Site s = 0; s < t_->num_sites(); ++s) {
      if (s != site_ && (best == none || is_nearer(s, best))) best = s;
    }
    return best;
  }

  /// The sites within `rings` steps along edges, without the site itself, ascending.
  [[nodiscard]] std::vector<Site> surroundings(int rings) const {
    std::vector<Site> sites{site_};
    for (int ring = 0; ring < rings; ++ring) {
      const std::size_t size = sites.size();
      for (std::size_t i = 0; i < size; ++i) {
        for (const Site n : t_->adjacency().neighbors(sites[i])) sites.push_back(n);
      }
      std::sort(sites.begin(), sites.end());
      sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    }
    sites.erase(std::find(sites.begin(), sites.end(), site_));
    return sites;
  }

 private:
  static constexpr bool is_plane = std::is_same_v<Point, tripack::Point2>;
  static constexpr double far = is_plane ? std::numeric_limits<double>::infinity() : 1.99;
  using Corners = std::array<Site, 3>;

  [[nodiscard]] const Point& point(Site s) const noexcept { return t_->points()[at(s)]; }
  /// Do a, b follow each other counter-clockwise round the site? 0: in line with it.
  [[nodiscard]] int side(Site a, Site b) const noexcept {
    return orientation(position(), point(a), point(b));
  }
  [[nodiscard]] bool is_nearer(Site a, Site b) const noexcept {
    const double to_a = squared_distance(point(a), position()),
                 to_b = squared_distance(point(b), position());
    return to_a < to_b || (to_a == to_b && a < b);
  }
  [[nodiscard]] Site nearest_of(std::span<const Site> sites) const noexcept {
    Site best = none;
    for (const Site s : sites) {
      if (best == none || is_nearer(s, best)) best = s;
    }
    return best;
  }

  [[nodiscard]] Spot spot_in_hole() const {
    const Corners c = lowest_triangle();
    if constexpr (!is_plane) {
      if (orientation(point(c[0]), point(c[1]), point(c[2])) <= 0) return {};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (side(c[k], c[(k + 1) % 3]) == 0) return edge_spot(c[k], c[(k + 1) % 3]);
    }
    return {Spot::Kind::triangle, smallest_first(c)};
  }

  /// Neighbours in an order in which those that lower the triangle come early or late
  /// by chance: large rims may be sorted in any way.
  [[nodiscard]] std::vector<Site> shuffled_rim() const {
    std::vector<Site> sites(rim().begin(), rim().end());
    std::uint64_t state = 0x9E3779B97F4A7C15u;
    for (std::size_t i = sites.size(); i > 1; --i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::swap(sites[i - 1], sites[static_cast<std::size_t>((state >> 33) % i)]);
    }
    return sites;
  }

  [[nodiscard]] Corners lowest_triangle() const {
    constexpr std::size_t many = 32;
    if (rim().size() <= many) return descend(first_triangle(), rim());
    return descend(first_triangle(), shuffled_rim());
  }

  /// Of the triangles from the first neighbour over the rim's edges one that holds the
  /// site.
  [[nodiscard]] Corners first_triangle() const {
    const std::span<const Site> sites = rim();
    std::size_t i = 1;
    while (i + 2 < sites.size() && side(sites[0], sites[i + 1]) > 0) ++i;
    return {sites[0], sites[i], sites[i + 1]};
  }

  [[nodiscard]] Corners descend(Corners c, std::span<const Site> sites) const {
    std::size_t num_clear = 0;
    for (std::size_t i = 0; num_clear < sites.size(); i = (i + 1) % sites.size()) {
      ++num_clear;
      const Site p = sites[i];
      if (p == c[0] || p == c[1] || p == c[2] || !is_within(c, p)) continue;
      c = lowered(c, p);
      num_clear = 1;
    }
    return c;
  }
  [[nodiscard]] bool is_within(const Corners& c, Site p) const noexcept {
    return in_circle_perturbed(point(c[0]), point(c[1]), point(c[2]), point(p)) > 0;
  }

  /// Of the triangles from p over the sides of `c` the one that holds the site. It may be
  /// on a side, but all three corners are never in line with it.
  [[nodiscard]] Corners lowered(const Corners& c, Site p) const noexcept {
    const std::array<int, 3> to_p{side(c[0], p), side(c[1], p), side(c[2], p)};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t next = k + 1;
      if (to_p[k] > 0 || to_p[next] < 0) continue;
      const int num_in_line =
          (to_p[k] == 0) + (to_p[next] == 0) + (side(c[k], c[next]) == 0);
      if (num_in_line <= 1) return {c[k], c[next], p};
    }
    return {c[2], c[0], p};
  }

  const Triangulation* t_;
  Site site_;
};

}  // namespace delone::interp
