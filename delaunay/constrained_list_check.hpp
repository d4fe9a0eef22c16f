#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/defect.hpp"

/// Checking foreign lists of triangles against a constrained triangulation: what both
/// rooms share. `T` is either room's ConstrainedTriangulation `t`.
///
/// The check is local and yet complete. If
///   1. every triangle is counter-clockwise,
///   2. no directed side belongs to two of them, and the sides without a partner are
///      those of the boundary of t's domain,
/// then the triangles cover the domain once (in the plane), since as chains they have the
/// boundary that the domain has; on the sphere once and the whole sphere k times more,
///   3. where the sum of their areas tells that k is 0.
/// The sum of their angles then counts the sites used: two triangles for each inside. So
///   4. as many triangles as the domain has
/// means that all are used. And if
///   5. every piece of a segment is a side,
///   6. on every other side neither triangle has the other's far corner in its circle,
/// the list is constrained Delaunay.
namespace delone::delaunay {

namespace internal {

/// A directed side of a listed triangle, and the corner across it.
struct ListedSide {
  Site from, to, apex;
  [[nodiscard]] std::pair<Site, Site> ends() const noexcept { return {from, to}; }
};

inline const ListedSide* find_side(std::span<const ListedSide> sides, Site from,
                                   Site to) {
  const std::pair ends(from, to);
  const auto found = std::ranges::lower_bound(sides, ends, {}, &ListedSide::ends);
  return found != sides.end() && found->ends() == ends ? &*found : nullptr;
}

template <class T, CheckedGeometry G>
class ListCheck {
 public:
  ListCheck(const T& t, const G& g) : t_(t), g_(g) {}

  [[nodiscard]] Defect find(std::span<const Triple> triangles) {
    if (auto defect = take_triangles(triangles)) return defect;
    if (auto defect = find_double_side()) return defect;
    if (auto defect = find_domain_defect()) return defect;
    if (auto defect = find_second_cover(triangles)) return defect;
    if (std::ssize(triangles) != t_.num_triangles()) return miscounted(triangles.size());
    return find_circle_defect();
  }

 private:
  [[nodiscard]] Defect take_triangles(std::span<const Triple> triangles) {
    sides_.reserve(3 * triangles.size());
    for (const Triple& rows : triangles) {
      std::array<Site, 3> v{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (rows[k] < 0 || rows[k] >= t_.num_rows())
          return name_of_triangle(rows) + " has a corner that is no row";
        v[k] = site(rows[k]);
      }
      const int turn = g_.orientation(v[0], v[1], v[2]);
      if (turn == 0) return name_of_triangle(rows) + " has no area";
      if (turn < 0) std::swap(v[1], v[2]);
      for (std::size_t k = 0; k < 3; ++k)
        sides_.push_back({v[k], v[(k + 1) % 3], v[(k + 2) % 3]});
    }
    std::ranges::sort(sides_, {}, &ListedSide::ends);
    return std::nullopt;
  }

  [[nodiscard]] Defect find_double_side() const {
    const auto twice = std::ranges::adjacent_find(sides_, {}, &ListedSide::ends);
    if (twice == sides_.end()) return std::nullopt;
    return name(*twice) + " has two triangles on one side: " + triangle(*twice) +
           " and " + triangle(*(twice + 1));
  }

  /// Every boundary side and every piece of a segment listed, and no other side alone.
  [[nodiscard]] Defect find_domain_defect() {
    const ClosedMesh& mesh = t_.mesh();
    for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
      if (mesh.is_free(f) || t_.region_of(f) < 0) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (auto defect = find_missing(mesh, ClosedMesh::half_edge(f, k))) return defect;
    }
    std::ranges::sort(boundary_);
    std::ranges::sort(constraints_);
    return find_lone_side();
  }

  /// Notes what an edge of the domain is, and looks for it in the list if it must be
  /// there.
  [[nodiscard]] Defect find_missing(const ClosedMesh& mesh, HalfEdge e) {
    const std::pair ends(mesh.origin(e), mesh.target(e));
    const bool is_piece = mesh.is_constraint(e);
    const bool is_boundary = t_.region_of(ClosedMesh::face_of(mesh.reverse(e))) < 0;
    if (is_boundary) boundary_.push_back(ends);
    if (is_piece) constraints_.push_back(ends);
    if (!is_boundary && !is_piece) return std::nullopt;
    if (find_side(sides_, ends.first, ends.second)) return std::nullopt;
    return name({ends.first, ends.second, none}) +
           (is_piece ? ", a piece of a segment, has no triangle on its left"
                     : ", at the boundary of the domain, has no triangle on its left");
  }

  [[nodiscard]] Defect find_lone_side() const {
    for (const ListedSide& side : sides_) {
      const bool is_alone = !find_side(sides_, side.to, side.from);
      if (is_alone == std::ranges::binary_search(boundary_, side.ends())) continue;
      if (!is_alone)
        return name(side) + " is at the boundary of the domain, but has two triangles";
      return name(side) + " has one triangle, " + triangle(side) +
             ", but is not at the boundary of the domain";
    }
    return std::nullopt;
  }

  /// On the sphere, areas of the list and the domain are equal or differ by whole spheres
  /// (4 pi), so rounding does not matter.
  [[nodiscard]] Defect find_second_cover(std::span<const Triple> triangles) const {
    if constexpr (requires { g_.area(Site(), Site(), Site()); }) {
      const auto total = [&](std::span<const Triple> list) {
        double sum = 0;
        for (const auto& [a, b, c] : list) sum += g_.area(site(a), site(b), site(c));
        return sum;
      };
      if (total(triangles) > total(t_.triangles()) + 6)
        return "the triangles cover the sphere more than once";
    }
    return std::nullopt;
  }

  [[nodiscard]] Site site(Node row) const {
    return t_.sites()[static_cast<std::size_t>(row)];
  }

  [[nodiscard]] std::string miscounted(std::size_t num_listed) const {
    std::vector<bool> is_used(static_cast<std::size_t>(t_.num_sites()));
    for (const ListedSide& side : sides_)
      is_used[static_cast<std::size_t>(side.from)] = true;
    for (const Triple& rows : t_.triangles()) {
      for (const Node row : rows)
        if (!is_used[static_cast<std::size_t>(site(row))])
          return "row " + std::to_string(row) +
                 " lies in the domain, but no triangle "
                 "has it as a corner";
    }
    return std::to_string(num_listed) + " triangles where the domain has " +
           std::to_string(t_.num_triangles());
  }

  [[nodiscard]] Defect find_circle_defect() const {
    for (const ListedSide& side : sides_) {
      if (std::ranges::binary_search(constraints_, side.ends())) continue;
      const ListedSide* const back = find_side(sides_, side.to, side.from);
      if (!back || !g_.is_violated(side.from, side.to, side.apex, back->apex)) continue;
      return name(side) + " is not Delaunay: row " + std::to_string(g_.row(back->apex)) +
             " is inside the circle of " + triangle(side);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string name(const ListedSide& side) const {
    return name_of_edge(g_.row(side.from), g_.row(side.to));
  }
  [[nodiscard]] std::string triangle(const ListedSide& side) const {
    return name_of_triangle({g_.row(side.from), g_.row(side.to), g_.row(side.apex)});
  }

  const T& t_;
  const G& g_;
  std::vector<ListedSide> sides_;
  std::vector<std::pair<Site, Site>> boundary_, constraints_;
};

}  // namespace internal

/// Nothing, or one sentence: see above. `g.is_violated` must leave ties open. O(n log n).
template <class T, CheckedGeometry G>
[[nodiscard]] Defect find_constrained_list_defect(const T& t,
                                                  std::span<const Triple> triangles,
                                                  const G& g) {
  return internal::ListCheck<T, G>(t, g).find(triangles);
}

}  // namespace delone::delaunay
