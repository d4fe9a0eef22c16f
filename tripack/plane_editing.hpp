#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/editable_surface.hpp"
#include "tripack/constrained_geometry.hpp"
#include "tripack/point.hpp"
#include "tripack/predicates.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

/// The plane for delaunay::EditableSet: node 0 is at infinity, and a face with it lies
/// outside a hull edge.
struct PlaneEditing {
  using Point = Point2;
  using Key = std::array<double, 2>;
  using Triangulation = tripack::Triangulation;
  using Segments = SitePlane;
  static constexpr bool has_infinity = true;
  static constexpr Site infinity = 0;

  static bool sees(std::span<const Point2> points, const std::array<Site, 3>& corner,
                   Point2 q) noexcept;
  static bool is_front(std::span<const Point2>,
                       const std::array<Site, 3>& corner) noexcept {
    return corner[0] != infinity && corner[1] != infinity && corner[2] != infinity;
  }
  static int side(Point2 a, Point2 b, Point2 q) noexcept { return orientation(a, b, q); }
  static bool is_same(Point2 p, Point2 q) noexcept { return p == q; }
  static bool is_flat(std::span<const Point2> points,
                      std::span<const Site> nodes) noexcept;
  /// In lexicographic order: that along the line.
  static Key key(Point2 p) noexcept { return {p.x, p.y}; }
  static bool is_preferred(Point2, Point2) noexcept { return false; }

  /// Is there one segment between two points?
  static bool has_arc(Point2, Point2) noexcept { return true; }

  /// The square of 2^32 x 2^32 cells that the index of places lives on.
  class Chart {
   public:
    /// Covers twice the extent of the points and `p`, so that growing sets are seldom
    /// indexed anew.
    Chart(std::span<const Point2> points, Point2 p) noexcept;
    [[nodiscard]] bool covers(Point2 p) const noexcept {
      return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y;
    }
    [[nodiscard]] delaunay::Place place(Point2 p) const noexcept {
      return {cell(p.x, low_.x, scale_.x), cell(p.y, low_.y, scale_.y)};
    }

   private:
    static std::uint32_t cell(double v, double low, double scale) noexcept;
    Point2 low_, high_, scale_;
  };

  /// The neighbours of a node that goes: which of them sees which face over three others?
  ///
  /// Infinity is a neighbour like the others, and the three may be clockwise or on one
  /// line, though not in the end. So every four need an answer, and the answers must be
  /// those of one convex polyhedron. It is that of in_circle_perturbed, with points on a
  /// line bent apart: by infinitesimals in such a way that the middle one of three moves
  /// towards the node that goes (from there its neighbours are seen one beside the other:
  /// no three are on a line with it), and by much smaller ones that grow with the third
  /// power of the coordinate along the line, which decide between four.
  class Star {
   public:
    Star(std::span<const Point2> points, Site removed, std::span<const Site> rim);
    [[nodiscard]] bool sees(const std::array<Site, 3>& corner, Site q) const noexcept;

   private:
    [[nodiscard]] Point2 point(Site i) const noexcept {
      return rim_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] int bent_side(Point2 a, Point2 b, Point2 q) const noexcept;

    Point2 removed_;
    std::vector<Point2> rim_;
    Site infinity_;  // its place on the rim, or none
  };
};

}  // namespace delone::tripack
