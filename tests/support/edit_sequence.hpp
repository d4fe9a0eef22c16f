#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace delone::support {

/// Edits an editor of either room at random: `pool` is where points come from.
///
/// While `grow` of ten steps insert, others remove or move a row that is there; nothing
/// is removed from an empty editor. `check()` after every step.
template <class Editor, class Point, class Check>
void edit_at_random(Editor& editor, const std::vector<Point>& pool, std::size_t num_steps,
                    std::size_t grow, SplitMix64& random, Check check) {
  for (std::size_t step = 0; step < num_steps; ++step) {
    const Point& p = pool[random.below(pool.size())];
    const auto rows = editor.rows();
    if (rows.empty() || random.below(10) < grow) {
      const auto hint =
          rows.empty() || random.below(2) == 0 ? -1 : rows[random.below(rows.size())];
      editor.insert(p, hint);
    } else if (random.below(4) == 0) {
      editor.move(rows[random.below(rows.size())], p);
    } else {
      editor.remove(rows[random.below(rows.size())]);
    }
    check();
  }
}

}  // namespace delone::support
