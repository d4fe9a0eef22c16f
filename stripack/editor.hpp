#pragma once

#include <array>
#include <memory>
#include <vector>

#include "stripack/constrained_triangulation.hpp"
#include "stripack/direction.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

/// A Delaunay triangulation on the sphere that changes: directions come, go and move.
///
/// After every change the triangulation is the canonical one of the directions that are
/// there: `triangulation()` equals `Triangulation(points())`. Exact, no tolerance.
///
/// Points are known by *rows*, as everywhere; here a row keeps its number as long as it
/// is in the set. `insert` gives the number removed last, if there is one, and num_rows()
/// otherwise, so after equally many removals and insertions numbers are without gaps
/// again.
///
/// Repeated directions are allowed: each row counts, and the position stays until its
/// last row is removed. No state is special: no point, all points on a great circle, a
/// hemisphere that grows to the whole sphere and shrinks back. A copy is an independent
/// value (keep one to undo).
///
/// Cost, in addition to finding the place: O(degree) expected, whatever the degree;
/// finding it takes a few steps for spread points, O(1) with a hint. The first point off
/// a great circle of n, and the last one to leave it, cost O(n log n): they have n
/// neighbours. Memory: 110 bytes a point.
///
///     stripack::Editor editor;
///     const Node paris = editor.insert(Direction::from(LonLat{2.35, 48.86}));
///     editor.insert(Direction::from(LonLat{-0.13, 51.51}), paris);
///     editor.remove(paris);
///     const stripack::Triangulation changed = editor.triangulation();
///
/// Arcs between rows can be forced, to stay whatever the points say until released. After
/// every change the constrained triangulation is the canonical one, too:
/// `constrained_triangulation()` equals ConstrainedTriangulation of points() and arcs().
/// A point on a forced arc divides it; where it goes again, the pieces unite. Arcs may
/// share points and pieces, and be forced in any order, but not cross: give them a point
/// in common where they do. An end of a forced arc cannot be removed or moved: release
/// its arcs first. Forcing costs what the edges crossed do, nearly linear in their
/// number; releasing the flips that it allows; insertions and removals O(degree) as
/// before. The first arc that is forced costs O(n).
///
/// Not for use by two threads at a time; different editors are independent.
/// Sources: A. Bowyer, Comput. J. 24 (1981) 162-166; L. P. Chew, Dartmouth TR
/// PCS-TR90-147 (1990).
class Editor {
 public:
  /// No points.
  Editor();
  /// The points of `t`, with its rows. A row that repeats another takes that one's
  /// direction. O(n).
  explicit Editor(const Triangulation& t);
  Editor(const Editor& other);
  Editor(Editor&& other) noexcept;
  Editor& operator=(const Editor& other);
  Editor& operator=(Editor&& other) noexcept;
  ~Editor();

  /// Adds a point and returns its row. `hint`: a row near it, or none. Throws Error if
  /// there are too many points (2^28).
  Node insert(const Direction& p, Node hint = delaunay::none);
  /// Throws Error if the row is not in the set, if it is an end of a forced arc, or if
  /// forced arcs cross there that share no other point; then nothing has changed.
  void remove(Node row);
  /// remove(row) and insertion of `p` under the same number. Throws Error as `remove`
  /// does; then nothing has changed.
  void move(Node row, const Direction& p);

  /// Forces the arc between two rows, over the points that are exactly on it: EDGE. One
  /// that is forced already stays. Throws Error if a row is not in the set, if both have
  /// one position or are antipodes, or if the arc would cross a forced one between the
  /// ends of both (naming these); then nothing has changed.
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
  /// Different directions.
  [[nodiscard]] Site num_sites() const noexcept;
  [[nodiscard]] bool has(Node row) const noexcept;
  /// Throws Error if the row is not in the set.
  [[nodiscard]] Direction point(Node row) const;
  /// Rows in the set, ascending: row i of `triangulation()` is rows()[i]. O(n).
  [[nodiscard]] std::vector<Node> rows() const;
  /// Points of rows(). O(n).
  [[nodiscard]] std::vector<Direction> points() const;

  /// The triangulation of points(), its rows numbered as they are there: the Delaunay
  /// triangulation, without what arcs force. O(n): sites are sorted, nothing is
  /// triangulated again; forced arcs are released in a copy.
  [[nodiscard]] Triangulation triangulation() const;
  /// The constrained triangulation of points() and of arcs() as segments, in the order of
  /// both, with rows numbered as in triangulation(). Options as there: all of the hull is
  /// the domain unless they say otherwise. O(n + pieces of arcs).
  [[nodiscard]] ConstrainedTriangulation constrained_triangulation(
      const SphereConstraintOptions& options = {.domain = Domain::hull}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::stripack
