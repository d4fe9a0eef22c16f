// triangulate, check, hull, locate, nearest, info.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <regex>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// The nine points and twelve triangles of TRIPACK's diamond example (Burkardt, 2003).
const std::string diamond =
    "x,y\n0.0,0.0\n0.0,1.0\n0.2,0.5\n0.3,0.6\n0.4,0.5\n0.6,0.3\n0.6,0.5\n1.0,0.0\n1.0,1."
    "0\n";
const std::string diamond_triangles =
    "1 3 2\n1 6 3\n1 8 6\n2 3 4\n2 4 9\n3 5 4\n3 6 5\n4 5 7\n4 7 9\n5 6 7\n6 8 7\n7 8 "
    "9\n";

/// A file of numbers without its layout.
std::vector<std::vector<int>> numbers(const std::string& text) {
  std::vector<std::vector<int>> rows;
  for (const std::string& line : lines(text)) {
    std::istringstream stream(line);
    auto& row = rows.emplace_back();
    for (int n = 0; stream >> n;) row.push_back(n);
  }
  return rows;
}

TEST(Triangulate, DiamondHasItsTwelveTriangles) {
  const Folder folder;
  const std::string points = folder.write("diamond.csv", diamond);
  expect_success(
      run({"triangulate", points, "-o", folder / "d.tri", "--base", "1", "--canonical"}));
  EXPECT_EQ(numbers(folder.read("d.tri")), numbers(diamond_triangles));
}

TEST(Triangulate, CountsFromZeroUnlessToldOtherwise) {
  const Folder folder;
  const std::string points = folder.write("t.csv", "x,y\n0,0\n1,0\n0,1\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.tri"}));
  EXPECT_EQ(numbers(folder.read("t.tri")), (std::vector<std::vector<int>>{{0, 1, 2}}));
}

TEST(Triangulate, WritesElementsAndTheirNeighbors) {
  const Folder folder;
  const std::string points =
      folder.write("square.csv", "x,y\n0,0\n2,0\n2,1\n0,1\n1,0.5\n");
  expect_success(run({"triangulate", points, "-o", folder / "s.ele", "--neighbors"}));
  const auto elements = numbers(folder.read("s.ele")),
             neighbors = numbers(folder.read("s.neigh"));
  ASSERT_EQ(elements.size(), 5U);
  EXPECT_EQ(elements[0], (std::vector<int>{4, 3, 0}));
  EXPECT_EQ(elements[1], (std::vector<int>{0, 0, 1, 4}));
  ASSERT_EQ(neighbors.size(), 5U);
  EXPECT_EQ(neighbors[0], (std::vector<int>{4, 3}));
  // Opposite corner 0 lies triangle 1 4 2, opposite 1 triangle 0 4 3, opposite 4 the
  // outside.
  const auto number_of = [&](const std::vector<int>& corners) {
    for (std::size_t i = 1; i < elements.size(); ++i) {
      if (std::is_permutation(elements[i].begin() + 1, elements[i].end(),
                              corners.begin())) {
        return elements[i][0];
      }
    }
    return -2;
  };
  EXPECT_EQ(neighbors[1],
            (std::vector<int>{0, number_of({1, 2, 4}), number_of({0, 3, 4}), -1}));
}

TEST(Triangulate, AdjacencyListsRunCounterClockwise) {
  const Folder folder;
  const std::string points =
      folder.write("square.csv", "x,y\n0,0\n2,0\n2,1\n0,1\n1,0.5\n");
  expect_success(run({"triangulate", points, "-o", folder / "s.adj"}));
  const auto lists = numbers(folder.read("s.adj"));
  ASSERT_EQ(lists.size(), 5U);
  EXPECT_EQ(lists[0], (std::vector<int>{0, 1, 4, 3}));
  EXPECT_EQ(lists[2], (std::vector<int>{2, 3, 4, 1}));
  // The inner node's list is a cycle.
  auto inner = lists[4];
  ASSERT_EQ(inner.size(), 5U);
  EXPECT_EQ(inner[0], 4);
  std::rotate(inner.begin() + 1, std::ranges::min_element(inner.begin() + 1, inner.end()),
              inner.end());
  EXPECT_EQ(inner, (std::vector<int>{4, 0, 1, 2, 3}));
}

TEST(Triangulate, NodesAreDataRowsWithDroppedOnesCounted) {
  const Folder folder;
  const std::string points =
      folder.write("t.csv", "# note\nx,y\n0,0\nbad,9\n\n# note\n1,0\n0,1\n1,0\n");
  expect_success(run({"triangulate", points, "-o", folder / "t.tri", "--skip-bad-rows"}));
  EXPECT_EQ(numbers(folder.read("t.tri")), (std::vector<std::vector<int>>{{0, 2, 3}}));
  expect_success(run({"check", points, folder / "t.tri", "--skip-bad-rows"}));
  expect_failure(
      run({"check", points, folder.write("u.tri", "0 1 3\n"), "--skip-bad-rows"}), 1,
      {"row 1", "u.tri"});
}

TEST(Triangulate, CollinearPointsHaveNoTriangles) {
  const Folder folder;
  const std::string points = folder.write("line.csv", "x,y\n0,0\n2,2\n1,1\n3,3\n");
  const Outcome outcome = run({"triangulate", points, "-o", folder / "l.tri"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("all lie on one line"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.read("l.tri"), "");
  expect_success(run({"check", points, folder / "l.tri"}));
  EXPECT_EQ(run({"hull", points, "--quiet"}).out, "0\n2\n1\n3\n");
}

TEST(Triangulate, OnePointHasNoTriangles) {
  const Folder folder;
  const std::string points = folder.write("one.csv", "x,y\n5,5\n5,5\n");
  expect_success(run({"triangulate", points, "-o", folder / "o.tri"}));
  EXPECT_EQ(folder.read("o.tri"), "");
  expect_success(run({"triangulate", points, "-o", folder / "o.adj"}));
  EXPECT_EQ(numbers(folder.read("o.adj")), (std::vector<std::vector<int>>{{0}}));
}

/// The rows of a table in another order, and for each new row its old number.
std::pair<std::string, std::vector<int>> shuffled(const std::string& table) {
  std::vector<std::string> rows = lines(table);
  std::vector<int> order(rows.size() - 1);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::ranges::shuffle(order, std::mt19937(7));
  std::string text = rows[0] + "\n";
  for (const int i : order) text += rows[static_cast<std::size_t>(i) + 1] + "\n";
  return {text, order};
}

TEST(Triangulate, DoesNotDependOnTheOrderOfRows) {
  const Folder folder;
  const std::string table = scattered_csv(2000);
  const auto [other, order] = shuffled(table);
  expect_success(
      run({"triangulate", folder.write("a.csv", table), "-o", folder / "a.tri"}));
  expect_success(
      run({"triangulate", folder.write("b.csv", other), "-o", folder / "b.tri"}));
  auto renumbered = numbers(folder.read("b.tri"));
  for (auto& triangle : renumbered) {
    for (int& corner : triangle) corner = order[static_cast<std::size_t>(corner)];
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  }
  std::ranges::sort(renumbered);
  EXPECT_EQ(renumbered, numbers(folder.read("a.tri")));
}

TEST(Check, AcceptsWhatTriangulateWritesOnEveryDomain) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", scattered_csv(500, 3, "lon,lat,value"));
  for (const std::string domain : {"plane", "sphere", "ellipsoid"}) {
    for (const std::string name : {"p.tri", "p.ele"}) {
      expect_success(run({"triangulate", points, "-o", folder / name, "--on", domain}));
      const Outcome outcome = run({"check", points, folder / name, "--on", domain});
      expect_success(outcome);
      EXPECT_TRUE(outcome.out.starts_with("Delaunay: ")) << outcome.out;
    }
  }
}

TEST(Check, SaysWhatIsViolated) {
  const Folder folder;
  // The long diagonal of a flat rhombus: its circles hold the other corners.
  const std::string points = folder.write("p.csv", "x,y\n0,0\n5,1\n10,0\n5,-1\n");
  const std::string wrong = folder.write("w.tri", "0 2 1\n0 3 2\n");
  const Outcome outcome = run({"check", points, wrong});
  expect_failure(outcome, 1, {"w.tri", "p.csv"});
  EXPECT_TRUE(outcome.out.starts_with("not Delaunay: ")) << outcome.out;
  expect_success(run({"check", points, folder.write("r.tri", "0 3 1\n1 3 2\n")}));
}

TEST(Hull, IsCounterClockwiseWithThePointsOnItsEdges) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n2,2\n0,0\n1,1\n2,0\n1,0\n0,2\n");
  EXPECT_EQ(run({"hull", points}).out, "0\n5\n1\n4\n3\n");
}

TEST(Locate, GivesTheTriangleOrMinusOne) {
  const Folder folder;
  const std::string points = folder.write("p.csv", diamond);
  const std::string queries =
      folder.write("q.csv", "x,y,name\n0.05,0.5,a\n2,2,b\n0.5,0.1,c\n");
  const Outcome outcome = run({"locate", points, queries});
  expect_success(outcome);
  EXPECT_EQ(outcome.out, "x,y,name,triangle\n0.05,0.5,a,0\n2,2,b,-1\n0.5,0.1,c,2\n");
}

TEST(Nearest, GivesTheNodeAndItsDistance) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\n1,0\n0,1\n");
  const Outcome outcome =
      run({"nearest", points, folder.write("q.csv", "x,y\n4,4\n0,0\n4,0\n")});
  expect_success(outcome);
  EXPECT_EQ(outcome.out, "x,y,node,distance\n4,4,2,5\n0,0,0,0\n4,0,1,3\n");
}

TEST(Nearest, MeasuresKilometresOnTheGlobe) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "lon,lat\n0,0\n90,0\n0,-90\n");
  const std::string queries = folder.write("q.csv", "lon,lat\n0,1\n");
  const auto distance = [&](const std::string& domain) {
    const Outcome outcome = run({"nearest", points, queries, "--on", domain});
    expect_success(outcome);
    EXPECT_TRUE(outcome.out.starts_with("lon,lat,node,distance_km\n0,1,0,"))
        << outcome.out;
    return std::stod(outcome.out.substr(outcome.out.rfind(',') + 1));
  };
  EXPECT_NEAR(distance("sphere"), 111.19508, 1e-5);
  EXPECT_NEAR(distance("ellipsoid"), 110.57439,
              1e-5);  // one degree of the meridian at the equator
}

TEST(Info, CountsRowsRepeatsHullAndTriangles) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "x,y,v\n0,0,1\n3,0,2\n0,4,5\n0,0,7\n1,1,nan\n");
  const Outcome outcome = run({"info", points, "--value", "v", "--json"});
  expect_success(outcome);
  for (const std::string fact :
       {R"("rows":5)", R"("points":4)", R"("missing":1)", R"("positions":3)",
        R"("repeats":1)", R"("hull_nodes":3)", R"("triangles":1)", R"("x_range":[0,3])",
        R"("y_range":[0,4])", R"("value_range":[1,7])", R"("shortest_edge":3)",
        R"("longest_edge":5)", R"("on":"plane")"}) {
    EXPECT_NE(outcome.out.find(fact), std::string::npos) << fact << " in " << outcome.out;
  }
  EXPECT_EQ(lines(outcome.out).size(), 1U);
}

TEST(Info, TextAndJsonAgree) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(100, 1, "lon,lat,v"));
  const Outcome text = run({"info", points});
  expect_success(text);
  EXPECT_TRUE(std::regex_search(text.out, std::regex("\nrows +100\n"))) << text.out;
  EXPECT_TRUE(std::regex_search(text.out, std::regex("\non +sphere\n"))) << text.out;
}

}  // namespace
}  // namespace delone::test
