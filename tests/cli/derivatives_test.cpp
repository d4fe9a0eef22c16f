// --derivatives of one value, at queries and on grids.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

constexpr double earth_radius_km = 6371.0088, radian = 0.017453292519943295;

// Points all over the region, enough for local fits, with values of a function.
template <class F>
std::string table_of(const std::string& header, double wide, F f) {
  std::ostringstream text;
  text.precision(17);
  text << header << '\n';
  for (int i = 0; i < 900; ++i) {
    const double x = wide * (2 * std::fmod(i * 0.754877666, 1.0) - 1),
                 y = wide * (2 * std::fmod(i * 0.569840291, 1.0) - 1) / 2;
    text << x << ',' << y << ',' << f(x, y) << '\n';
  }
  return text.str();
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');)
    numbers.push_back(std::stod(field));
  return numbers;
}

double quadratic(double x, double y) { return x * x - 3 * x * y + 2 * y * y + x; }

const char* const plane_header = "x,y,z,dz_dx,dz_dy,d2z_dx2,d2z_dxdy,d2z_dy2,z_laplacian";

void expect_quadratic(const std::string& line) {
  const std::vector<double> n = numbers_of(line);
  ASSERT_EQ(n.size(), 9U) << line;
  const double x = n[0], y = n[1];
  const std::vector<double> wanted{
      x, y, quadratic(x, y), 2 * x - 3 * y + 1, 4 * y - 3 * x, 2, -3, 4, 6};
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(n[k], wanted[k], 1e-4) << k;
}

TEST(Derivatives, OfAQuadraticAreExactAtQueriesAndOnGrids) {
  const Folder folder;
  const std::string points = folder.write("p.csv", table_of("x,y,z", 2, quadratic)),
                    queries = folder.write("q.csv", "x,y\n0.3,0.2\n-0.7,-0.4\n");
  expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--method", "c1",
                      "--tension", "0", "--derivatives"}));
  const std::vector<std::string> rows = lines(folder.read("s.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], plane_header);
  expect_quadratic(rows[1]);
  expect_quadratic(rows[2]);
  expect_success(
      run({"grid", points, "-o", folder / "g.csv", "--method", "c1", "--tension", "0",
           "--derivatives", "--region", "-1/1/-0.5/0.5", "--size", "3/3"}));
  const std::vector<std::string> nodes = lines(folder.read("g.csv"));
  ASSERT_EQ(nodes.size(), 10U);
  EXPECT_EQ(nodes[0], plane_header);
  for (std::size_t i = 1; i < nodes.size(); ++i) expect_quadratic(nodes[i]);
}

TEST(Derivatives, OnTheGlobeAreByKilometreAlongGeodesics) {
  const Folder folder;
  const auto height = [](double, double lat) { return std::sin(lat * radian); };
  const std::string points = folder.write("p.csv", table_of("lon,lat,z", 40, height)),
                    queries = folder.write("q.csv", "lon,lat\n10,12\n");
  expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--method", "c1",
                      "--tension", "0", "--derivatives"}));
  const std::vector<std::string> rows = lines(folder.read("s.csv"));
  EXPECT_EQ(rows[0],
            "lon,lat,z,z_east_per_km,z_north_per_km,z_east_east_per_km2,"
            "z_east_north_per_km2,z_north_north_per_km2,z_laplacian_per_km2");
  const std::vector<double> n = numbers_of(rows[1]);
  ASSERT_EQ(n.size(), 9U);
  const double r = earth_radius_km, sine = std::sin(12 * radian);
  EXPECT_NEAR(n[3], 0, 1e-5 / r);
  EXPECT_NEAR(n[4], std::cos(12 * radian) / r, 1e-5 / r);
  EXPECT_NEAR(n[5], -sine / (r * r), 1e-4 / (r * r));
  EXPECT_NEAR(n[6], 0, 1e-4 / (r * r));
  EXPECT_NEAR(n[7], -sine / (r * r), 1e-4 / (r * r));
  EXPECT_NEAR(n[8], -2 * sine / (r * r), 1e-4 / (r * r));
}

TEST(Derivatives, OfTheFirstOrderAreThoseOfTheGradient) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(80, 3, "lon,lat,z")),
                    queries = folder.write("q.csv", "lon,lat\n0.4,0.5\n0.6,0.3\n");
  for (const char* const domain : {"plane", "ellipsoid"}) {
    for (const char* const method : {"linear", "natural"}) {
      const Outcome found = run({"sample", points, queries, "-o", folder / "d.csv",
                                 "--on", domain, "--method", method, "--derivatives"});
      expect_success(found);
      EXPECT_NE(found.err.find("first ones only"), std::string::npos);
      expect_success(run({"sample", points, queries, "-o", folder / "g.csv", "--on",
                          domain, "--method", method, "--gradient"}));
      const auto derivatives = lines(folder.read("d.csv")),
                 gradients = lines(folder.read("g.csv"));
      ASSERT_EQ(derivatives.size(), 3U);
      EXPECT_EQ(derivatives[0], gradients[0]);
      for (std::size_t i = 1; i < 3; ++i) {
        const auto d = numbers_of(derivatives[i]), g = numbers_of(gradients[i]);
        ASSERT_EQ(d.size(), 5U);
        for (std::size_t k = 0; k < 5; ++k)
          EXPECT_NEAR(d[k], g[k], 1e-12 * std::abs(g[k]));
      }
    }
  }
}

TEST(Derivatives, HaveTheirUnitsInNetcdf) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", scattered_csv(80, 3, "lon,lat,height_m"));
  expect_success(run({"grid", points, "-o", folder / "g.nc", "--size", "5/5", "--method",
                      "c1", "--derivatives"}));
  const std::string bytes = folder.read("g.nc");
  for (const char* const words :
       {"height_m_east_per_km", "height_m_laplacian_per_km2", "m km-1", "m km-2"})
    EXPECT_NE(bytes.find(words), std::string::npos) << words;
  expect_success(run({"grid", points, "-o", folder / "h.nc", "--size", "5/5",
                      "--derivatives", "--units", "feet"}));
  EXPECT_NE(folder.read("h.nc").find("feet km-1"), std::string::npos);
}

TEST(Derivatives, AreRefusedWhereTheFormatHoldsOneVariable) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(20));
  for (const char* const name : {"g.asc", "g.png"})
    expect_failure(run({"grid", points, "-o", folder / name, "--derivatives"}), 2,
                   {"--derivatives", ".nc or .csv"});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"p.csv"});
}

}  // namespace
}  // namespace delone::test
