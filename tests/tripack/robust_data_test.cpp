// Point sets that broke other codes, with exact counts for each (tests/corpus holds those
// we may copy).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/exact.hpp"
#include "tripack/defect.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(DELONE_SHARED_DATA_DIR) / "robust";

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) rows.push_back(split(line));
  return rows;
}

std::vector<Point2> points_of(const std::filesystem::path& path) {
  std::vector<Point2> points;
  for (const auto& row : rows_of(path))
    points.push_back({std::stod(row.at(0)), std::stod(row.at(1))});
  return points;
}

std::size_t num_corners(const std::vector<Point2>& points,
                        const std::vector<Node>& hull) {
  std::size_t num = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return points[static_cast<std::size_t>(hull[k % hull.size()])];
    };
    num += support::exact_orientation(at(i), at(i + 1), at(i + 2)) > 0 ? 1 : 0;
  }
  return num;
}

TEST(RobustData, HasTheExactCounts) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  const auto expected = rows_of(folder / "expected.csv");
  ASSERT_FALSE(expected.empty());
  for (const auto& row : expected) {
    SCOPED_TRACE(row.at(0));
    const auto points = points_of(folder / row[0]);
    const Triangulation t(points);
    EXPECT_EQ(find_defect(t).value_or("none"), "none");
    const std::vector<Node> hull = t.boundary();
    const std::array<std::size_t, 6> counts{
        points.size(),
        static_cast<std::size_t>(t.num_sites()),
        num_corners(points, hull),
        hull.size(),
        static_cast<std::size_t>(t.adjacency().num_arcs() / 2),
        static_cast<std::size_t>(t.num_triangles())};
    for (std::size_t k = 0; k < counts.size(); ++k)
      EXPECT_EQ(counts[k], std::stoull(row.at(k + 1)));
    const double area = support::exact_hull_area2(points) / 2;
    EXPECT_NEAR(area, std::stod(row.at(7)), 1e-14 * area);
    if (points.size() < 3000) {
      EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
    }
  }
}

}  // namespace
}  // namespace delone::tripack
