#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/error.hpp"
#include "fuzz/fuzz_points.hpp"

namespace delone::fuzz {

inline constexpr std::size_t max_edits = 96;

/// Is what an editor gives the triangulation of its points?
template <class Triangulation, class Editor>
void check_canonical(const Editor& editor) {
  const auto equal = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  const Triangulation t = editor.triangulation(), u(editor.points());
  if (!(t.adjacency() == u.adjacency()) || t.dimension() != u.dimension())
    fail("not the triangulation of the points");
  if (!equal(t.points(), u.points()) || !equal(t.rows(), u.rows()) ||
      !equal(t.sites(), u.sites()))
    fail("other sites than those of the points");
}

/// Is it the constrained triangulation of its points and arcs? `afresh(points, arcs)`
/// gives that one.
template <class Editor, class Afresh>
void check_arcs(const Editor& editor, Afresh afresh) {
  const std::vector<delaunay::Node> rows = editor.rows();
  auto arcs = editor.arcs();
  for (auto& ends : arcs) {
    for (delaunay::Node& row : ends)
      row = static_cast<delaunay::Node>(std::lower_bound(rows.begin(), rows.end(), row) -
                                        rows.begin());
  }
  const auto t = editor.constrained_triangulation(), u = afresh(editor.points(), arcs);
  if (t.triangles() != u.triangles() || t.constraint_edges() != u.constraint_edges())
    fail("not the constrained triangulation of the points and arcs");
}

/// Forces an arc between two rows, or releases it; what is refused changes nothing.
template <class Editor>
void toggle_arc(Editor& editor, delaunay::Node a, delaunay::Node b) {
  try {
    if (editor.is_forced(a, b)) {
      editor.release_arc(a, b);
    } else {
      editor.force_arc(a, b);
    }
  } catch (const Error&) {
  }
}

/// Removes the row, or moves it to `p`, unless forced arcs hold it.
template <class Editor, class Point>
void take_out(Editor& editor, delaunay::Node row, const Point* p) {
  try {
    if (p == nullptr) {
      editor.remove(row);
    } else {
      editor.move(row, *p);
    }
  } catch (const Error&) {
    if (editor.arcs().empty()) throw;
  }
}

/// Bytes to edits, of which each is compared with building afresh. Three bits of a byte
/// choose what happens, the others which of the points (`pool`) or rows.
template <class Triangulation, class Editor, class Point, class Afresh>
void run_edits(const std::vector<Point>& pool, std::span<const std::uint8_t> bytes,
               Afresh afresh) {
  if (pool.empty()) return;
  Editor editor;
  std::size_t next = 0;
  for (const std::uint8_t b : bytes.first(std::min(bytes.size(), max_edits))) {
    const std::vector<delaunay::Node> rows = editor.rows();
    const auto row = [&] { return rows[(b / 8) % rows.size()]; };
    const Point& p = pool[next++ % pool.size()];
    const int action = rows.empty() ? 0 : b % 8;
    if (action < 2) {
      editor.insert(p);
    } else if (action == 2) {
      editor.insert(pool[(b / 8) % pool.size()], row());
    } else if (action == 3) {
      take_out<Editor, Point>(editor, row(), nullptr);
    } else if (action == 4) {
      take_out(editor, row(), &p);
    } else if (action < 7) {
      toggle_arc(editor, row(), rows[next % rows.size()]);
    } else {
      editor = b == 255 ? Editor(editor.triangulation()) : Editor(editor);
    }
    check_canonical<Triangulation>(editor);
    check_arcs(editor, afresh);
  }
}

}  // namespace delone::fuzz
