#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
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

/// Bytes to edits, of which each is compared with building afresh. Three bits of a byte
/// choose what happens, the others which of the points (`pool`) or rows.
template <class Triangulation, class Editor, class Point>
void run_edits(const std::vector<Point>& pool, std::span<const std::uint8_t> bytes) {
  if (pool.empty()) return;
  Editor editor;
  std::size_t next = 0;
  for (const std::uint8_t b : bytes.first(std::min(bytes.size(), max_edits))) {
    const std::vector<delaunay::Node> rows = editor.rows();
    const auto row = [&] { return rows[(b / 8) % rows.size()]; };
    const Point& p = pool[next++ % pool.size()];
    const int action = rows.empty() ? 0 : b % 8;
    if (action < 3) {
      editor.insert(p);
    } else if (action == 3) {
      editor.insert(pool[(b / 8) % pool.size()], row());
    } else if (action < 6) {
      editor.remove(row());
    } else if (action == 6) {
      editor.move(row(), p);
    } else {
      editor = Editor(editor.triangulation());
    }
    check_canonical<Triangulation>(editor);
  }
}

}  // namespace delone::fuzz
