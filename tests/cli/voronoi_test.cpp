// voronoi.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string diamond =
    "x,y\n0.0,0.0\n0.0,1.0\n0.2,0.5\n0.3,0.6\n0.4,0.5\n0.6,0.3\n0.6,0.5\n1.0,0.0\n1.0,1."
    "0\n";

using Row = std::vector<std::string>;

/// The fields of a CSV without its header.
std::vector<Row> rows(const std::string& text) {
  std::vector<Row> result;
  for (const std::string& line : lines(text)) {
    Row& row = result.emplace_back();
    std::istringstream stream(line + ",");
    for (std::string field; std::getline(stream, field, ',');) row.push_back(field);
  }
  result.erase(result.begin());
  return result;
}

double sum_of_areas(const std::string& text) {
  double sum = 0;
  for (const Row& row : rows(text)) sum += std::stod(row[1]);
  return sum;
}

TEST(VoronoiCommand, DiamondHasItsAreasAndCentroids) {
  const Folder folder;
  const std::string points = folder.write("diamond.csv", diamond);
  expect_success(run({"voronoi", points, "-o", folder / "cells.csv"}));
  const std::string text = folder.read("cells.csv");
  EXPECT_EQ(lines(text)[0], "node,area,centroid_x,centroid_y,corners,bounded");
  const std::vector<Row> cells = rows(text);
  ASSERT_EQ(cells.size(), 9U);
  EXPECT_EQ(cells[4][0], "4");
  EXPECT_NEAR(std::stod(cells[4][1]), 0.06, 1e-15);
  EXPECT_NEAR(std::stod(cells[4][2]), 0.4, 1e-15);
  EXPECT_NEAR(std::stod(cells[4][3]), 0.45, 1e-15);
  EXPECT_EQ(cells[4][4], "4");
  EXPECT_EQ(cells[4][5], "1");
  EXPECT_EQ(cells[0][1], "");  // unbounded
  EXPECT_EQ(cells[0][5], "0");
}

TEST(VoronoiCommand, RegionClipsTheCells) {
  const Folder folder;
  const std::string points = folder.write("diamond.csv", diamond);
  expect_success(
      run({"voronoi", points, "-o", folder / "cells.csv", "--region", "0/1/0/1"}));
  const std::string text = folder.read("cells.csv");
  EXPECT_NEAR(sum_of_areas(text), 1, 1e-15);
  EXPECT_EQ(rows(text)[0][5], "0");
}

TEST(VoronoiCommand, NodesAreDataRowsAndRepeatsHaveOneCell) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "x,y\n0,0\nbad,9\n2,0\n0,2\n2,0\n2,2\n1,1\n");
  expect_success(run({"voronoi", points, "-o", folder / "cells.csv", "--skip-bad-rows"}));
  std::string nodes;
  for (const Row& row : rows(folder.read("cells.csv"))) nodes += row[0] + " ";
  EXPECT_EQ(nodes, "0 2 3 5 6 ");
}

TEST(VoronoiCommand, CellsOfTheGlobeSumToItsSurface) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", scattered_csv(300, 3, "lon,lat,value"));
  for (const std::string domain : {"sphere", "ellipsoid"}) {
    expect_success(run({"voronoi", points, "-o", folder / "cells.csv", "--on", domain}));
    const std::string text = folder.read("cells.csv");
    EXPECT_EQ(lines(text)[0], "node,area_km2,centroid_lon,centroid_lat,corners,bounded");
    const double surface = domain == "sphere" ? 510065881.45 : 510065621.724;
    EXPECT_NEAR(sum_of_areas(text) / surface, 1, 1e-6) << domain;
  }
}

TEST(VoronoiCommand, DegenerateSetsHaveCellsToo) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"one.csv", "x,y\n5,5\n5,5\n"},
      {"line.csv", "x,y\n0,0\n2,2\n1,1\n"},
      {"pole.csv", "lon,lat\n0,90\n50,90\n"},
      {"two.csv", "lon,lat\n0,0\n180,0\n"},
      {"equator.csv", "lon,lat\n0,0\n90,0\n180,0\n"}};
  for (const auto& [name, text] : files) {
    const std::string points = folder.write(name, text);
    for (const std::string output : {"c.csv", "c.geojson", "c.svg"})
      expect_success(run({"voronoi", points, "-o", folder / output}));
    const Outcome mesh = run({"voronoi", points, "-o", folder / "c.nc"});
    if (name != "pole.csv") expect_success(mesh);
  }
}

TEST(VoronoiCommand, GeoJsonHasAPolygonForEveryCell) {
  const Folder folder;
  const std::string points = folder.write("diamond.csv", diamond);
  expect_success(run({"voronoi", points, "-o", folder / "cells.geojson"}));
  const std::string text = folder.read("cells.geojson");
  const auto count = [&](const std::string& word) {
    int n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count("\"type\":\"Polygon\""), 9);
  EXPECT_EQ(count("\"bounded\":false"), 4);
  EXPECT_NE(text.find("\"node\":4,\"area\":0.06"), std::string::npos);
  EXPECT_EQ(count("inf") + count("nan"), 0);
}

TEST(VoronoiCommand, GeoJsonStaysBetweenTheDateLines) {
  const Folder folder;
  std::string table = "lon,lat\n";
  for (int lon = -180; lon < 180; lon += 20)
    for (int lat = -80; lat <= 80; lat += 20)
      table += std::to_string(lon) + "," + std::to_string(lat) + "\n";
  const std::string points = folder.write("grid.csv", table);
  expect_success(run({"voronoi", points, "-o", folder / "cells.geojson"}));
  const std::string text = folder.read("cells.geojson");
  EXPECT_NE(text.find("MultiPolygon"), std::string::npos);
  for (std::size_t at = text.find('['); at != std::string::npos;
       at = text.find('[', at + 1)) {
    double lon = 0, lat = 0;
    if (std::sscanf(text.c_str() + at, "[%lf,%lf]", &lon, &lat) != 2) continue;
    EXPECT_LE(std::abs(lon), 180);
    EXPECT_LE(std::abs(lat), 90);
  }
}

TEST(VoronoiCommand, DoesNotDependOnThreads) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(3000));
  for (const std::string threads : {"1", "3"})
    expect_success(run(
        {"voronoi", points, "-o", folder / (threads + ".csv"), "--threads", threads}));
  EXPECT_EQ(folder.read("1.csv"), folder.read("3.csv"));
}

TEST(VoronoiCommand, DrawsCells) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(50));
  expect_success(run({"voronoi", points, "-o", folder / "cells.svg"}));
  expect_success(
      run({"voronoi", points, "-o", folder / "points.svg", "--show", "points"}));
  EXPECT_GT(folder.read("cells.svg").size(), folder.read("points.svg").size());
}

TEST(VoronoiCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string plane = folder.write("p.csv", diamond),
                    globe = folder.write("g.csv", "lon,lat\n0,0\n1,1\n");
  expect_failure(run({"voronoi", plane, "-o", folder / "c.tri"}), 2, {"csv"});
  expect_failure(run({"voronoi", plane, "-o", folder / "c.csv", "--region", "0/1/1/0"}),
                 2, {"--region"});
  expect_failure(run({"voronoi", plane, "-o", folder / "c.csv", "--region", "0/1/1"}), 2,
                 {"--region"});
  expect_failure(run({"voronoi", globe, "-o", folder / "c.csv", "--region", "0/1/0/1"}),
                 2, {"--region"});
  expect_failure(run({"voronoi", folder / "none.csv", "-o", folder / "c.csv"}), 3,
                 {"none.csv"});
  expect_failure(
      run({"voronoi", folder.write("b.csv", "lon,lat\n0,95\n"), "-o", folder / "c.csv"}),
      3, {"b.csv", "line 2"});
  // One place of the globe has all of it, and no corners.
  expect_failure(
      run({"voronoi", folder.write("b.csv", "lon,lat\n0,90\n"), "-o", folder / "c.nc"}),
      3, {".csv"});
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"b.csv", "g.csv", "p.csv"}));
}

TEST(VoronoiCommand, WritesTrianglesVerticesAndEdges) {
  const Folder folder;
  const std::string points = folder.write("diamond.csv", diamond);
  expect_success(run({"voronoi", points, "-o", folder / "d.v.node"}));
  expect_success(run({"voronoi", points, "-o", folder / "d.v.edge"}));
  const auto vertices = lines(folder.read("d.v.node")),
             edges = lines(folder.read("d.v.edge"));
  ASSERT_EQ(vertices.size(), 13U);
  EXPECT_EQ(vertices[0], "12 2 0 0");
  EXPECT_EQ(vertices[1], "0 0.5 -0.25");
  ASSERT_EQ(edges.size(), 21U);
  EXPECT_EQ(edges[0], "20 0");
  EXPECT_EQ(edges[1], "0 0 -1 0 -1");  // the ray below (0.5, -0.25)
  const Outcome outcome = run({"voronoi", points, "-o", "-", "--format", "v.edge"});
  EXPECT_EQ(outcome.out, folder.read("d.v.edge"));
}

TEST(VoronoiCommand, VerticesKeepTheBaseOfANodeFile) {
  const Folder folder;
  const std::string points =
      folder.write("p.node", "4 2 0 0\n1 0 0\n2 4 0\n3 0 2\n4 5 5\n");
  expect_success(run({"voronoi", points, "-o", folder / "p.v.node"}));
  EXPECT_TRUE(lines(folder.read("p.v.node"))[1].starts_with("1 "));
  expect_success(run({"voronoi", points, "-o", folder / "p.v.edge"}));
  EXPECT_TRUE(lines(folder.read("p.v.edge"))[1].starts_with("1 1 "));
}

TEST(VoronoiCommand, DiagramsOfTriangleAreForThePlaneAndWhole) {
  const Folder folder;
  const std::string globe = folder.write("g.csv", "lon,lat\n0,0\n9,0\n0,9\n");
  expect_failure(run({"voronoi", globe, "-o", folder / "g.v.node"}), 2,
                 {"v.node", "plane", ".geojson"});
  const std::string points = folder.write("diamond.csv", diamond);
  expect_failure(
      run({"voronoi", points, "-o", folder / "d.v.edge", "--region", "0/1/0/1"}), 2,
      {"--region", "v.edge"});
}

}  // namespace
}  // namespace delone::test
