#pragma once

#include <memory>
#include <vector>

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
/// Arcs that must stay whatever the points say are the business of
/// ConstrainedTriangulation, which takes points() as they are.
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
  /// Throws Error if the row is not in the set.
  void remove(Node row);
  /// remove(row) and insertion of `p` under the same number. Throws Error if the row is
  /// not in the set or a coordinate is NaN or infinite; then nothing has changed.
  void move(Node row, Point2 p);

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

  /// The triangulation of points(), its rows numbered as they are there. O(n): sites are
  /// sorted, nothing is triangulated again.
  [[nodiscard]] Triangulation triangulation() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::tripack
