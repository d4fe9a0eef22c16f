#pragma once

#include <array>
#include <memory>
#include <vector>

#include "tripack/constrained_triangulation.hpp"
#include "tripack/point.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

/// A Delaunay triangulation that changes: points come, go and move.
///
/// After every change the triangulation is the canonical one of the points that are
/// there: `triangulation()` equals `Triangulation(points())`. Exact, no tolerance.
///
/// Points are known by *rows*, as everywhere; here a row keeps its number as long as it
/// is in the set. `insert` gives the number removed last, if there is one, and num_rows()
/// otherwise, so after equally many removals and insertions numbers are without gaps
/// again.
///
/// Repeated positions are allowed: each row counts, and the position stays until its last
/// row is removed. No state is special: no point, all points on a line, a hull that
/// shrinks and grows. A copy is an independent value (keep one to undo).
///
/// Cost, in addition to finding the place: O(degree) expected, whatever the degree;
/// finding it takes a few steps for spread points, O(1) with a hint. The first point off
/// a line of n, and the last one to leave it, cost O(n log n): they have n neighbours.
/// At random places of a million uniform points an edit takes 2 to 3 microseconds.
/// Memory: 100 bytes a point.
///
///     tripack::Editor editor(triangulation);
///     const Node row = editor.insert({0.25, 0.5});
///     editor.move(row, {0.3, 0.5});
///     editor.remove(0);
///     const tripack::Triangulation changed = editor.triangulation();
///
/// Arcs between rows can be forced, to stay whatever the points say until released. After
/// every change the constrained triangulation is the canonical one, too:
/// `constrained_triangulation()` equals ConstrainedTriangulation of points() and arcs().
/// A point on a forced arc divides it; where it goes again, the pieces unite. Arcs may
/// share points and pieces, and be forced in any order, but not cross: give them a point
/// in common where they do. An end of a forced arc cannot be removed or moved: release
/// its arcs first. Forcing costs what the edges crossed do, nearly linear in their
/// number; releasing the flips that it allows; insertions and removals O(degree) as
/// before.
///
/// Not for use by two threads at a time; different editors are independent.
/// Sources: A. Bowyer, Comput. J. 24 (1981) 162-166; L. P. Chew, Dartmouth TR
/// PCS-TR90-147 (1990).
class Editor {
 public:
  /// No points.
  Editor();
  /// The points of `t`, with its rows. A row that repeats another takes that one's point.
  /// O(n).
  explicit Editor(const Triangulation& t);
  Editor(const Editor& other);
  Editor(Editor&& other) noexcept;
  Editor& operator=(const Editor& other);
  Editor& operator=(Editor&& other) noexcept;
  ~Editor();

  /// Adds a point and returns its row. `hint`: a row near it, or none. Throws Error if a
  /// coordinate is NaN or infinite, or if there are too many points (2^28).
  Node insert(Point2 p, Node hint = delaunay::none);
  /// Throws Error if the row is not in the set, if it is an end of a forced arc, or if
  /// forced arcs cross there that share no other point; then nothing has changed.
  void remove(Node row);
  /// remove(row) and insertion of `p` under the same number. Throws Error as `remove`
  /// does, or if a coordinate is NaN or infinite; then nothing has changed.
  void move(Node row, Point2 p);

  /// Forces the arc between two rows, over the points that are exactly on it: EDGE. One
  /// that is forced already stays. Throws Error if a row is not in the set, if both have
  /// one position, or if the arc would cross a forced one between the ends of both
  /// (naming these); then nothing has changed.
  void force_arc(Node a, Node b);
  /// Lets a forced arc go. Throws Error if there is none between the rows.
  void release_arc(Node a, Node b);
  [[nodiscard]] bool is_forced(Node a, Node b) const noexcept;
  /// Forced arcs: smaller row first, sorted. O(their number).
  [[nodiscard]] std::vector<std::array<Node, 2>> arcs() const;

  /// One more than the largest row number that was ever in the set.
  [[nodiscard]] Node num_rows() const noexcept;
  /// Rows in the set.
  [[nodiscard]] Node num_points() const noexcept;
  /// Different positions.
  [[nodiscard]] Site num_sites() const noexcept;
  [[nodiscard]] bool has(Node row) const noexcept;
  /// Throws Error if the row is not in the set.
  [[nodiscard]] Point2 point(Node row) const;
  /// Rows in the set, ascending: row i of `triangulation()` is rows()[i]. O(n).
  [[nodiscard]] std::vector<Node> rows() const;
  /// Points of rows(). O(n).
  [[nodiscard]] std::vector<Point2> points() const;

  /// The triangulation of points(), its rows numbered as they are there: the Delaunay
  /// triangulation, without what arcs force. O(n): sites are sorted, nothing is
  /// triangulated again; forced arcs are released in a copy.
  [[nodiscard]] Triangulation triangulation() const;
  /// The constrained triangulation of points() and of arcs() as segments, in the order of
  /// both, with rows numbered as in triangulation(). Options as there: all of the hull is
  /// the domain unless they say otherwise. O(n + pieces of arcs).
  [[nodiscard]] ConstrainedTriangulation constrained_triangulation(
      const ConstraintOptions& options = {.domain = Domain::hull}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::tripack
