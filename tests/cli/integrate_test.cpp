// delone integrate: integrals, means and areas over regions.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

constexpr double mean_sphere_km2 = 4 * std::numbers::pi * 6371.0088 * 6371.0088;

struct Row {
  std::string region;
  double area, integral, mean, covered;
};

std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  const std::vector<std::string> text = lines(csv);
  for (std::size_t i = 1; i < text.size(); ++i) {
    std::istringstream stream(text[i]);
    std::vector<std::string> fields(5);
    for (std::string& field : fields) std::getline(stream, field, ',');
    const auto number = [&](std::size_t k) {
      return fields[k].empty() ? NAN : std::stod(fields[k]);
    };
    rows.push_back({fields[0], number(1), number(2), number(3), number(4)});
  }
  return rows;
}

// 1 + x + 2 y on the unit square.
std::string square() {
  std::ostringstream text;
  text.precision(17);
  text << "x,y,z\n";
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; j <= 6; ++j)
      text << i / 6.0 << ',' << j / 6.0 << ',' << 1 + i / 6.0 + 2 * j / 6.0 << '\n';
  return text.str();
}

std::string globe() {
  std::ostringstream text;
  text << "lon,lat,z\n";
  for (int lat = -90; lat <= 90; lat += 10)
    for (int lon = -180; lon < 180; lon += 10) text << lon << ',' << lat << ",3\n";
  return text.str();
}

TEST(Integrate, WithoutRegionsIsOverAllThatIsTriangulated) {
  const Folder folder;
  const std::string points = folder.write("p.csv", square());
  for (const std::string method : {"linear", "c1"}) {
    const Outcome outcome = run({"integrate", points, "--method", method});
    expect_success(outcome);
    EXPECT_EQ(lines(outcome.out)[0], "region,area,integral,mean,covered");
    const auto rows = rows_of(outcome.out);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].region, "all");
    EXPECT_NEAR(rows[0].area, 1, 1e-5);
    EXPECT_NEAR(rows[0].integral, 2.5, 1e-4);
  }
}

TEST(Integrate, TakesEveryPolygonOfGeoJson) {
  const Folder folder;
  const std::string points = folder.write("p.csv", square());
  const std::string regions = folder.write("r.geojson",
                                           R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
          "coordinates": [[[0.1,0.1],[0.9,0.1],[0.9,0.9],[0.1,0.9],[0.1,0.1]],
                          [[0.2,0.2],[0.4,0.2],[0.4,0.4],[0.2,0.4],[0.2,0.2]]]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon",
          "coordinates": [[[[0,0],[0.5,0],[0,0.5],[0,0]]],
                          [[[1,1],[2,1],[2,0],[1,0],[1,1]]],
                          [[[0.5,0],[1,0],[1,1],[0.5,0]]]]}}]})");
  expect_success(run({"integrate", points, regions, "-o", folder / "out.csv"}));
  const auto rows = rows_of(folder.read("out.csv"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].region, "0");
  EXPECT_NEAR(rows[0].area, 0.6, 1e-14);
  EXPECT_NEAR(rows[0].integral, 0.64 * 2.5 - 0.04 * 1.9, 1e-14);
  EXPECT_NEAR(rows[0].covered, 1, 1e-14);
  EXPECT_NEAR(rows[1].area, 0.125 + 0.25, 1e-14);
  EXPECT_NEAR(rows[1].covered, 0.375 / 1.375, 1e-14);
}

TEST(Integrate, TakesTheRingsOfATableTogetherOrOneByOne) {
  const Folder folder;
  const std::string points = folder.write("p.csv", square());
  const std::string rings = folder.write("r.csv",
                                         "ring,x,y\n7,0,0\n7,1,0\n7,1,1\n7,0,1\n"
                                         "9,0.2,0.2\n9,0.2,0.4\n9,0.4,0.4\n9,0.4,0.2\n");
  const Outcome together = run({"integrate", points, rings});
  expect_success(together);
  ASSERT_EQ(rows_of(together.out).size(), 1u);
  EXPECT_NEAR(rows_of(together.out)[0].area, 0.96, 1e-14);
  const Outcome each = run({"integrate", points, rings, "--each-ring"});
  expect_success(each);
  const auto rows = rows_of(each.out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].region, "7");
  EXPECT_EQ(rows[1].region, "9");
  EXPECT_NEAR(rows[1].area, 0.04, 1e-14);
  EXPECT_NEAR(rows[1].mean, 1.9, 1e-14);
}

TEST(Integrate, MeasuresTheGlobeInSquareKilometres) {
  const Folder folder;
  const std::string points = folder.write("p.csv", globe());
  const Outcome sphere = run({"integrate", points});
  expect_success(sphere);
  EXPECT_EQ(lines(sphere.out)[0], "region,area_km2,integral_km2,mean,covered");
  EXPECT_NEAR(rows_of(sphere.out)[0].area, mean_sphere_km2, 1);
  const Outcome ellipsoid = run({"integrate", points, "--on", "ellipsoid"});
  expect_success(ellipsoid);
  EXPECT_NEAR(rows_of(ellipsoid.out)[0].area, 510065621.7, 1);
  EXPECT_NEAR(rows_of(ellipsoid.out)[0].mean, 3, 1e-12);
  // Half of it, from the date line over the pole.
  const std::string half =
      folder.write("half.csv", "ring,lon,lat\n1,180,0\n1,270,0\n1,0,0\n1,90,0\n");
  const Outcome northern = run({"integrate", points, half});
  expect_success(northern);
  EXPECT_NEAR(rows_of(northern.out)[0].area, mean_sphere_km2 / 2, 1);
}

TEST(Integrate, SaysInOneLineWhatIsWrong) {
  const Folder folder;
  const std::string points = folder.write("p.csv", square());
  const auto with = [&](const std::string& text, const std::string& name = "r.csv") {
    return run({"integrate", points, folder.write(name, text)});
  };
  expect_failure(with("1,0,0\n1,1,1\n1,1,0\n1,0,1\n"), 3, {"r.csv", "(0, 0)", "cross"});
  expect_failure(with("1,0,0\n1,1,1\n"), 3, {"r.csv", "line 1", "three"});
  expect_failure(with(""), 3, {"r.csv"});
  expect_failure(with("{\"type\": \"Point\", \"coordinates\": [1, 2]}", "r.geojson"), 3,
                 {"r.geojson", "no polygon"});
  expect_failure(with("{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[1,1]]]}",
                      "r.geojson"),
                 3, {"r.geojson"});
  expect_failure(run({"integrate", points, folder / "none.csv"}), 3, {"none.csv"});
  expect_failure(run({"integrate", points, "--method", "natural"}), 2,
                 {"--method", "linear", "c1"});
  expect_failure(run({"integrate", points, "--extrapolate", "nearest"}), 2,
                 {"--extrapolate"});
  expect_failure(run({"integrate", points, "--each-ring"}), 2, {"REGIONS"});
  const std::string lonlat = folder.write("g.csv", globe());
  expect_failure(
      run({"integrate", lonlat, folder.write("bad.csv", "1,0,0\n1,5,95\n1,9,0\n")}), 3,
      {"bad.csv", "95"});
}

TEST(Extrapolate, LinearContinuesC1BeyondAHemisphere) {
  const Folder folder;
  std::ostringstream text;
  text << "lon,lat,z\n";
  for (int lat = 20; lat < 80; lat += 10)
    for (int lon = 0; lon < 90; lon += 10)
      text << lon << ',' << lat << ',' << lat << '\n';
  const std::string points = folder.write("p.csv", text.str());
  expect_success(
      run({"grid", points, "-o", folder / "g.csv", "--region", "-180/180/-90/90",
           "--spacing", "30", "--method", "c1", "--extrapolate", "linear"}));
  const std::vector<std::string> grid = lines(folder.read("g.csv"));
  EXPECT_GT(grid.size(), 80u);
  for (const std::string& line : grid) {
    EXPECT_EQ(line.find("nan"), std::string::npos);
    EXPECT_NE(line.back(), ',');
  }
  expect_failure(run({"grid", points, "-o", folder / "g.csv", "--extrapolate", "linear"}),
                 2, {"--method c1"});
}

}  // namespace
}  // namespace delone::test
