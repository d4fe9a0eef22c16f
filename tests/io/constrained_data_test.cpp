// Planar straight-line graphs with exact counts for each, which other codes stumbled on.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "io/poly_file.hpp"
#include "tripack/constrained_defect.hpp"
#include "tripack/constrained_triangulation.hpp"
#include "tripack/refine.hpp"

namespace delone::io {
namespace {

using tripack::ConstrainedTriangulation;
using tripack::ConstraintOptions;
using tripack::Crossings;
using tripack::Domain;

const std::filesystem::path folder =
    std::filesystem::path(DELONE_SHARED_DATA_DIR) / "pslg";

/// The rows of a CSV file by the names of its columns.
std::vector<std::map<std::string, std::string>> rows_of(
    const std::filesystem::path& path) {
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
  };
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const auto names = split(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(file, line)) {
    auto& row = rows.emplace_back();
    const auto fields = split(line);
    for (std::size_t i = 0; i < fields.size(); ++i) row[names[i]] = fields[i];
  }
  return rows;
}

double area(const ConstrainedTriangulation& t) {
  double sum = 0;
  for (const auto& [i, j, k] : t.triangles()) {
    const auto a = t.point(i), b = t.point(j), c = t.point(k);
    sum += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return sum / 2;
}

std::string defect_of(const ConstrainedTriangulation& t) {
  return find_defect(t).value_or("none");
}

TEST(ConstrainedData, HasTheExactCountsAndAreas) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (auto row : rows_of(folder / "expected.csv")) {
    SCOPED_TRACE(row["file"]);
    const PolyFile file = read_poly((folder / row["file"]).string());
    EXPECT_EQ(file.graph.points.size(), std::stoul(row["vertices"]));
    EXPECT_EQ(file.graph.segments.size(), std::stoul(row["segments"]));
    const ConstrainedTriangulation hull(file.graph, {.domain = Domain::hull});
    EXPECT_EQ(defect_of(hull), "none");
    EXPECT_EQ(hull.num_triangles(), std::stol(row["triangles_in_hull"]));
    EXPECT_NEAR(area(hull), std::stod(row["hull_area"]), 1e-12 * area(hull));
    const ConstrainedTriangulation domain(file.graph);
    EXPECT_EQ(defect_of(domain), "none");
    if (row["triangles_in_domain"].empty()) continue;
    EXPECT_EQ(domain.num_triangles(), std::stol(row["triangles_in_domain"]));
    EXPECT_NEAR(area(domain), std::stod(row["domain_area"]), 1e-12 * area(domain));
    // Every hole is a ring in the outline, so counting rings finds them as well.
    tripack::PlanarGraph rings = file.graph;
    rings.holes.clear();
    const ConstrainedTriangulation odd(rings, {.domain = Domain::even_odd});
    EXPECT_EQ(odd.triangles(), domain.triangles());
  }
}

TEST(ConstrainedData, RefinesToTwentyDegreesButAtSharpCornersOfTheInput) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (auto row : rows_of(folder / "expected.csv")) {
    if (row["triangles_in_domain"].empty() || row["file"] == "australia_high.poly")
      continue;
    SCOPED_TRACE(row["file"]);
    const PolyFile file = read_poly((folder / row["file"]).string());
    const auto refined = tripack::refine(file.graph, {.max_added = 200000});
    EXPECT_EQ(defect_of(refined.triangulation), "none");
    EXPECT_LT(refined.num_added, 30 * std::stol(row["vertices"]));
    EXPECT_LT(refined.num_below_angle, std::stol(row["vertices"]) / 10 + 10);
    const double expected = std::stod(row["domain_area"]);
    EXPECT_NEAR(area(refined.triangulation), expected, 1e-12 * expected);
  }
}

TEST(ConstrainedData, ReportsWhatIsAwkward) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  for (auto row : rows_of(folder / "awkward" / "expected.csv")) {
    SCOPED_TRACE(row["file"]);
    const PolyFile file = read_poly((folder / row["file"]).string());
    const ConstraintOptions split{.domain = Domain::hull, .crossings = Crossings::split};
    const ConstrainedTriangulation t(file.graph, split);
    EXPECT_EQ(defect_of(t), "none");
    const auto& report = t.report();
    EXPECT_EQ(t.num_input_rows(), std::stol(row["vertices"]));
    EXPECT_EQ(report.crossing.size(), std::stoul(row["crossing_pairs"]));
    EXPECT_EQ(report.repeated.size() + report.overlapping.size(),
              std::stoul(row["overlapping_pairs"]));
    EXPECT_EQ(report.on_segment.size(), std::stoul(row["vertices_inside_a_segment"]));
    if (report.crossing.empty()) {
      EXPECT_EQ(t.num_triangles(), std::stol(row["triangles_in_hull"]));
    } else {
      EXPECT_THROW(ConstrainedTriangulation(file.graph), Error);
    }
  }
}

}  // namespace
}  // namespace delone::io
