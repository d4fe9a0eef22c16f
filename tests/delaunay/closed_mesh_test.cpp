#include "delaunay/closed_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace delone::delaunay {
namespace {

using Sites = std::vector<Site>;
using Offsets = std::vector<std::int32_t>;
using Triangles = std::vector<std::array<Site, 3>>;

// A square 0, 1, 2, 3 around its centre 4.
Adjacency square() {
  return {Offsets{0, 3, 6, 9, 12, 16},
          Sites{1, 4, 3, 2, 4, 0, 3, 4, 1, 0, 4, 2, 0, 1, 2, 3},
          {true, true, true, true, false}};
}

Adjacency octahedron() {
  return {Offsets{0, 4, 8, 12, 16, 20, 24},
          Sites{1, 2, 3, 4, 0, 4, 5, 2, 0, 1, 5, 3, 0, 2, 5, 4, 0, 3, 5, 1, 1, 4, 3, 2},
          {false, false, false, false, false, false}};
}

// A fan of `n` triangles around site 0, closed: lists too long for a byte.
Adjacency wheel(Site n) {
  Offsets offsets{0, n};
  Sites neighbors;
  for (Site i = 1; i <= n; ++i) neighbors.push_back(i);
  for (Site i = 1; i <= n; ++i) {
    const Site after = i == n ? 1 : i + 1, before = i == 1 ? n : i - 1;
    neighbors.insert(neighbors.end(), {after, 0, before});
    offsets.push_back(static_cast<std::int32_t>(neighbors.size()));
  }
  std::vector<bool> is_boundary(static_cast<std::size_t>(n) + 1, true);
  is_boundary[0] = false;
  return {offsets, neighbors, is_boundary};
}

bool has_ghost_of(const ClosedMesh& mesh, std::int32_t f, Site ghost) {
  const auto& node = mesh.face(f).node;
  return std::find(node.begin(), node.end(), ghost) != node.end();
}

// Every edge is seen from both sides, and every node's edge leaves it.
void expect_closed(const ClosedMesh& mesh) {
  std::int32_t num_faces = 0;
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    ++num_faces;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), r = mesh.reverse(e);
      ASSERT_EQ(mesh.reverse(r), e);
      EXPECT_EQ(mesh.origin(r), mesh.target(e));
      EXPECT_EQ(mesh.target(r), mesh.origin(e));
      EXPECT_EQ(mesh.is_constraint(r), mesh.is_constraint(e));
      EXPECT_NE(mesh.edge_at(mesh.origin(e)), none);
    }
  }
  EXPECT_EQ(mesh.num_faces(), num_faces);
  for (Site v = 0; v < mesh.num_nodes(); ++v) {
    const HalfEdge e = mesh.edge_at(v);
    EXPECT_TRUE(e == none || mesh.origin(e) == v);
  }
}

Adjacency back(const ClosedMesh& mesh, Site num_sites) {
  return Adjacency(mesh.to_lists(num_sites, [](std::int32_t) { return false; }));
}

TEST(ClosedMesh, OfNothingHasOnlyTheGhost) {
  const ClosedMesh mesh = ClosedMesh::from(Adjacency());
  EXPECT_EQ(mesh.num_nodes(), 1);
  EXPECT_EQ(mesh.num_faces(), 0);
  EXPECT_EQ(mesh.edge_at(0), none);
  EXPECT_EQ(mesh.find(0, 0), none);
}

TEST(ClosedMesh, OfAChainHasNoFaces) {
  const ClosedMesh mesh = ClosedMesh::from(Adjacency::chain(4, Adjacency::Chain::open));
  EXPECT_EQ(mesh.num_nodes(), 5);
  EXPECT_EQ(mesh.num_faces(), 0);
}

TEST(ClosedMesh, ClosesABoundaryWithAGhost) {
  const ClosedMesh mesh = ClosedMesh::from(square());
  expect_closed(mesh);
  EXPECT_EQ(mesh.num_nodes(), 6);
  EXPECT_EQ(mesh.num_faces(), 8);
  int ghosts = 0;
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f)
    ghosts += has_ghost_of(mesh, f, 5) ? 1 : 0;
  EXPECT_EQ(ghosts, 4);
}

TEST(ClosedMesh, GivesBackTheListsItWasMadeFrom) {
  EXPECT_EQ(back(ClosedMesh::from(square()), 5), square());
  EXPECT_EQ(back(ClosedMesh::from(octahedron()), 6), octahedron());
  EXPECT_EQ(back(ClosedMesh::from(wheel(300)), 301), wheel(300));
}

TEST(ClosedMesh, LeavesOutFacesThatAreOutside) {
  const ClosedMesh mesh = ClosedMesh::from(octahedron());
  const Adjacency open(
      mesh.to_lists(6, [&](std::int32_t f) { return has_ghost_of(mesh, f, 0); }));
  EXPECT_EQ(open, Adjacency(Offsets{0, 0, 3, 6, 9, 12, 16},
                            Sites{4, 5, 2, 1, 5, 3, 2, 5, 4, 3, 5, 1, 1, 4, 3, 2},
                            {false, true, true, true, true, false}));
}

TEST(ClosedMesh, WalksAroundANodeCounterclockwise) {
  const ClosedMesh mesh = ClosedMesh::from(square());
  HalfEdge e = mesh.find(4, 0);
  Sites targets, apexes;
  for (int i = 0; i < 4; ++i, e = mesh.next_around(e)) {
    EXPECT_EQ(mesh.origin(e), 4);
    EXPECT_EQ(mesh.previous_around(mesh.next_around(e)), e);
    targets.push_back(mesh.target(e));
    apexes.push_back(mesh.apex(e));
  }
  EXPECT_EQ(e, mesh.find(4, 0));
  EXPECT_EQ(targets, (Sites{0, 1, 2, 3}));
  EXPECT_EQ(apexes, (Sites{1, 2, 3, 0}));
}

TEST(ClosedMesh, FindsOnlyEdgesThatAreThere) {
  const ClosedMesh mesh = ClosedMesh::from(square());
  EXPECT_EQ(mesh.find(0, 2), none);
  const HalfEdge e = mesh.find(2, 3);
  ASSERT_NE(e, none);
  EXPECT_EQ(mesh.origin(e), 2);
  EXPECT_EQ(mesh.target(e), 3);
  EXPECT_EQ(mesh.apex(e), 4);
}

TEST(ClosedMesh, FlipsAnEdgeToTheOtherDiagonal) {
  ClosedMesh mesh = ClosedMesh::from(square());
  const HalfEdge flipped = mesh.flip(mesh.find(0, 4));
  expect_closed(mesh);
  EXPECT_EQ(mesh.find(0, 4), none);
  EXPECT_EQ(mesh.origin(flipped), 1);
  EXPECT_EQ(mesh.target(flipped), 3);
  EXPECT_EQ(mesh.apex(flipped), 0);
  EXPECT_EQ(mesh.apex(mesh.reverse(flipped)), 4);
}

TEST(ClosedMesh, FlippedTwiceIsTheSameSurface) {
  ClosedMesh mesh = ClosedMesh::from(square());
  mesh.flip(mesh.flip(mesh.find(4, 2)));
  expect_closed(mesh);
  EXPECT_EQ(back(mesh, 5), square());
}

TEST(ClosedMesh, KeepsTheMarksOfTheFourOuterEdgesThroughAFlip) {
  const Triangles edges{{0, 1, 0}, {1, 4, 0}, {4, 3, 0}, {3, 0, 0}};
  for (unsigned marks = 0; marks < 16; ++marks) {
    ClosedMesh mesh = ClosedMesh::from(square());
    const auto is_marked = [&](std::size_t i) { return ((marks >> i) & 1U) != 0; };
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_marked(i))
        mesh.set_constraint(mesh.find(edges[i][0], edges[i][1]), Constraint::on);
    }
    mesh.set_constraint(mesh.find(0, 4), Constraint::on);
    mesh.flip(mesh.find(0, 4));
    expect_closed(mesh);
    EXPECT_FALSE(mesh.is_constraint(mesh.find(1, 3)));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(mesh.is_constraint(mesh.find(edges[i][0], edges[i][1])), is_marked(i));
  }
}

TEST(ClosedMesh, UnmarksBothSides) {
  ClosedMesh mesh = ClosedMesh::from(square());
  const HalfEdge e = mesh.find(0, 1);
  mesh.set_constraint(e, Constraint::on);
  EXPECT_TRUE(mesh.is_constraint(mesh.reverse(e)));
  mesh.set_constraint(mesh.reverse(e), Constraint::off);
  EXPECT_FALSE(mesh.is_constraint(e));
  expect_closed(mesh);
}

// The centre of the square goes, one diagonal comes, and the numbers of two faces are
// used again.
TEST(ClosedMesh, UsesTheNumbersOfRemovedFacesAgain) {
  ClosedMesh mesh = ClosedMesh::from(square());
  const std::int32_t slots = mesh.num_face_slots();
  std::array<HalfEdge, 4> rim{};
  for (Site v = 0; v < 4; ++v)
    rim[static_cast<std::size_t>(v)] = mesh.reverse(mesh.find(v, (v + 1) % 4));
  for (Site v = 0; v < 4; ++v)
    mesh.remove_face(ClosedMesh::face_of(mesh.find(v, (v + 1) % 4)));
  EXPECT_EQ(mesh.edge_at(4), none);
  const std::int32_t f = mesh.add_face({0, 1, 2}), g = mesh.add_face({2, 3, 0});
  mesh.join(ClosedMesh::half_edge(f, 0), rim[0]);
  mesh.join(ClosedMesh::half_edge(f, 1), rim[1]);
  mesh.join(ClosedMesh::half_edge(g, 0), rim[2]);
  mesh.join(ClosedMesh::half_edge(g, 1), rim[3]);
  mesh.join(ClosedMesh::half_edge(f, 2), ClosedMesh::half_edge(g, 2));
  expect_closed(mesh);
  EXPECT_EQ(mesh.num_face_slots(), slots);
  EXPECT_EQ(mesh.num_faces(), 6);
  const Adjacency lists = back(mesh, 5);
  EXPECT_EQ(lists.degree(4), 0);
  EXPECT_EQ(lists.num_triangles(), 2);
}

TEST(ClosedMesh, RenumbersNodes) {
  const ClosedMesh mesh = ClosedMesh::from(square());
  const Sites number{9, 8, 7, 6, 5, 2};
  const ClosedMesh other = mesh.renumbered(number, 10);
  expect_closed(other);
  EXPECT_EQ(other.num_nodes(), 10);
  EXPECT_EQ(other.num_faces(), mesh.num_faces());
  EXPECT_EQ(other.edge_at(0), none);
  const HalfEdge e = other.find(9, 8);
  ASSERT_NE(e, none);
  EXPECT_EQ(other.apex(e), 5);
  EXPECT_EQ(other.apex(other.reverse(e)), 2);
  EXPECT_EQ(back(other.renumbered(Sites{0, 0, 5, 0, 0, 4, 3, 2, 1, 0}, 6), 5), square());
}

TEST(ClosedMesh, ReplacesAFaceWithoutItsMarks) {
  ClosedMesh mesh = ClosedMesh::from(square());
  const HalfEdge e = mesh.find(0, 1);
  mesh.set_constraint(e, Constraint::on);
  mesh.replace_face(ClosedMesh::face_of(e), {3, 2, 1});
  EXPECT_FALSE(mesh.is_constraint(e));
  EXPECT_EQ(mesh.edge_at(2), ClosedMesh::half_edge(ClosedMesh::face_of(e), 1));
}

TEST(ClosedMesh, ForgetsAndClears) {
  ClosedMesh mesh = ClosedMesh::from(square());
  mesh.forget(4);
  EXPECT_EQ(mesh.edge_at(4), none);
  mesh.clear(3);
  EXPECT_EQ(mesh.num_nodes(), 3);
  EXPECT_EQ(mesh.num_faces(), 0);
  EXPECT_EQ(mesh.num_face_slots(), 0);
  EXPECT_EQ(mesh.add_face({0, 1, 2}), 0);
}

TEST(ClosedMesh, GrowsByNodes) {
  ClosedMesh mesh;
  EXPECT_EQ(mesh.add_node(), 0);
  EXPECT_EQ(mesh.add_node(), 1);
  EXPECT_EQ(mesh.num_nodes(), 2);
  EXPECT_EQ(mesh.edge_at(1), none);
}

}  // namespace
}  // namespace delone::delaunay
