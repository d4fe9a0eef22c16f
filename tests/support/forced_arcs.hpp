#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/closed_mesh.hpp"
#include "delaunay/error.hpp"
#include "support/random.hpp"

namespace delone::support {

using delaunay::Node;
using NodePair = std::array<Node, 2>;

/// The arcs between rows, as pairs of places in `rows`.
inline std::vector<NodePair> places_of(const std::vector<NodePair>& arcs,
                                       const std::vector<Node>& rows) {
  const auto place = [&](Node row) {
    return static_cast<Node>(std::lower_bound(rows.begin(), rows.end(), row) -
                             rows.begin());
  };
  std::vector<NodePair> result;
  for (const auto& [a, b] : arcs) result.push_back({place(a), place(b)});
  return result;
}

/// The lists of all faces but those to the ghost.
template <class Constrained>
delaunay::Adjacency lists_of(const Constrained& t) {
  return delaunay::Adjacency(
      t.mesh().to_lists(t.num_sites(), [](std::int32_t) { return false; }));
}

/// Same lists, marks, points, numbers, paths and reports?
template <class Constrained>
void expect_same(const Constrained& t, const Constrained& u) {
  const auto equal = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  ASSERT_TRUE(equal(t.points(), u.points()));
  ASSERT_TRUE(equal(t.rows(), u.rows()));
  ASSERT_TRUE(equal(t.sites(), u.sites()));
  ASSERT_EQ(t.triangles(), u.triangles());
  ASSERT_EQ(t.triangle_regions(), u.triangle_regions());
  ASSERT_EQ(t.constraint_edges(), u.constraint_edges());
  ASSERT_TRUE(lists_of(t) == lists_of(u));
  ASSERT_EQ(t.num_segments(), u.num_segments());
  for (std::int64_t i = 0; i < t.num_segments(); ++i) ASSERT_EQ(t.path(i), u.path(i));
  ASSERT_EQ(t.report().on_segment, u.report().on_segment);
  ASSERT_EQ(t.report().overlapping, u.report().overlapping);
  ASSERT_EQ(t.report().repeated, u.report().repeated);
}

/// Has the set's own surface the lists and the marks of `expected`, the constrained
/// triangulation of its points and arcs?
template <class Set, class Constrained>
void expect_surface(const Set& set, const Constrained& expected) {
  const std::vector<Node> rows = set.rows();
  if (set.surface().is_flat()) {
    ASSERT_EQ(expected.mesh().num_faces(), 0);
    return;
  }
  ASSERT_TRUE(set.forced_adjacency(rows, expected.rows()) == lists_of(expected));
  std::vector<Node> first(rows.size() + 1, delaunay::none);  // of every node
  for (std::size_t i = rows.size(); i-- > 0;) {
    const auto node = static_cast<std::size_t>(set.node(rows[i]));
    first.resize(std::max(first.size(), node + 1), delaunay::none);
    first[node] = static_cast<Node>(i);
  }
  std::set<NodePair> marked;
  const delaunay::ClosedMesh& mesh = set.surface().mesh();
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto e = delaunay::ClosedMesh::half_edge(f, k);
      ASSERT_EQ(mesh.is_constraint(e), mesh.is_constraint(mesh.reverse(e)));
      if (!mesh.is_constraint(e)) continue;
      const auto [low, high] =
          std::minmax(first[static_cast<std::size_t>(mesh.origin(e))],
                      first[static_cast<std::size_t>(mesh.target(e))]);
      marked.insert({low, high});
    }
  }
  const auto edges = expected.constraint_edges();
  ASSERT_EQ(std::vector<NodePair>(marked.begin(), marked.end()), edges);
}

/// How often what was asked for was refused.
struct Refusals {
  int num_forces = 0, num_removals = 0;
};

/// Edits an editor (or a set of the same interface) at random, forcing and releasing arcs
/// too. `pool` is where points come from; of ten steps `grow` insert. `refuses(points,
/// arcs)`: does the last of the arcs, pairs of places, not go with the others? It must
/// not where the editor refuses it. `check()` after every step.
template <class Editor, class Point, class Refuses, class Check>
Refusals edit_arcs_at_random(Editor& editor, const std::vector<Point>& pool,
                             std::size_t num_steps, std::size_t grow, SplitMix64& random,
                             Refuses refuses, Check check) {
  Refusals refusals;
  const auto force = [&](const std::vector<Node>& rows) {
    const Node a = rows[random.below(rows.size())], b = rows[random.below(rows.size())];
    try {
      editor.force_arc(a, b);
    } catch (const Error&) {
      ++refusals.num_forces;
      auto arcs = editor.arcs();
      arcs.push_back({a, b});
      EXPECT_TRUE(refuses(editor.points(), places_of(arcs, rows)));
    }
  };
  const auto leave = [&](Node row, const Point& p) {
    try {
      if (random.below(4) == 0) {
        editor.move(row, p);
      } else {
        editor.remove(row);
      }
    } catch (const Error&) {
      ++refusals.num_removals;
    }
  };
  for (std::size_t step = 0; step < num_steps; ++step) {
    const Point& p = pool[random.below(pool.size())];
    const auto rows = editor.rows();
    const auto arcs = editor.arcs();
    if (rows.empty() || random.below(10) < grow) {
      const auto hint =
          rows.empty() || random.below(2) == 0 ? -1 : rows[random.below(rows.size())];
      editor.insert(p, hint);
    } else if (random.below(3) == 0) {
      leave(rows[random.below(rows.size())], p);
    } else if (!arcs.empty() && random.below(3) == 0) {
      const auto& [a, b] = arcs[random.below(arcs.size())];
      editor.release_arc(b, a);
    } else {
      force(rows);
    }
    check();
    if (testing::Test::HasFatalFailure()) break;
  }
  return refusals;
}

/// An EditableSet with the names of an editor.
template <class Set>
struct SetEditor {
  Set set{};

  auto insert(const typename Set::Point& p, Node hint) { return set.insert(p, hint); }
  void remove(Node row) { set.remove(row); }
  void move(Node row, const typename Set::Point& p) { set.move(row, p); }
  void force_arc(Node a, Node b) { set.force(a, b); }
  void release_arc(Node a, Node b) { set.release(a, b); }
  [[nodiscard]] auto rows() const { return set.rows(); }
  [[nodiscard]] auto points() const { return set.points(); }
  [[nodiscard]] auto arcs() const { return set.arcs(); }
};

}  // namespace delone::support
