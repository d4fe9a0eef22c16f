// --vector: winds and velocities on the globe.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// Rotation about a slanted axis, in the components at a longitude and latitude; the
// third is its curl on the unit sphere.
std::array<double, 3> rotation(double lon_deg, double lat_deg) {
  const double lon = lon_deg * std::numbers::pi / 180,
               lat = lat_deg * std::numbers::pi / 180;
  constexpr double wx = 3, wy = -5, wz = 7;
  const double along = wx * std::cos(lon) + wy * std::sin(lon);
  return {std::cos(lat) * wz - std::sin(lat) * along,
          wx * std::sin(lon) - wy * std::cos(lon),
          2 * (std::cos(lat) * along + std::sin(lat) * wz)};
}

// A global table with whole rows at the poles: one wind there, said once for every
// longitude.
std::string wind_csv() {
  std::ostringstream text;
  text.precision(17);
  text << "lon,lat,u_m_s,v_m_s\n";
  for (int lat = -90; lat <= 90; lat += 15) {
    for (int lon = -180; lon < 180; lon += 15) {
      const auto v = rotation(lon, lat);
      text << lon << ',' << lat << ',' << v[0] << ',' << v[1] << '\n';
    }
  }
  return text.str();
}

std::vector<std::vector<double>> numbers(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : lines(csv)) {
    rows.emplace_back();
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');)
      rows.back().push_back(
          std::isalpha(static_cast<unsigned char>(field[0])) != 0 ? 0 : std::stod(field));
  }
  return rows;
}

void expect_rotation(const std::string& csv, double radius_km) {
  const auto rows = numbers(csv);
  ASSERT_GT(rows.size(), 3U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 6U);
    const auto expected = rotation(rows[i][0], rows[i][1]);
    EXPECT_NEAR(rows[i][2], expected[0], 1e-5) << rows[i][0] << " " << rows[i][1];
    EXPECT_NEAR(rows[i][3], expected[1], 1e-5) << rows[i][0] << " " << rows[i][1];
    EXPECT_NEAR(rows[i][4] * radius_km, 0, 1e-3);
    EXPECT_NEAR(rows[i][5] * radius_km, expected[2], 1e-3);
  }
}

const char* const queries =
    "lon,lat\n33,90\n-77,-90\n180,12\n-180,12\n10,89.9\n-123.4,-89.99\n15,30\n";

TEST(Vector, SampleIsExactForARotationOverPolesAndDateLine) {
  const Folder folder;
  const Outcome outcome =
      run({"sample", folder.write("w.csv", wind_csv()), folder.write("q.csv", queries),
           "--vector", "u_m_s,v_m_s", "--method", "c1", "--derivatives", "-o",
           folder / "s.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("'u_m_s' towards east and 'v_m_s' towards north"),
            std::string::npos);
  EXPECT_EQ(lines(folder.read("s.csv"))[0],
            "lon,lat,u_m_s,v_m_s,divergence_per_km,curl_per_km");
  expect_rotation(folder.read("s.csv"), 6371.0088);
}

TEST(Vector, GridIsExactForARotationOverPolesAndDateLine) {
  const Folder folder;
  expect_success(
      run({"grid", folder.write("w.csv", wind_csv()), "--vector", "3,4", "--method", "c1",
           "--derivatives", "--size", "17/9", "-o", folder / "g.csv"}));
  EXPECT_EQ(lines(folder.read("g.csv"))[0],
            "lon,lat,u_m_s,v_m_s,divergence_per_km,curl_per_km");
  expect_rotation(folder.read("g.csv"), 6371.0088);
}

TEST(Vector, RatesOnTheEllipsoidTakeItsRadii) {
  const Folder folder;
  const std::string winds = folder.write("w.csv", wind_csv()),
                    equator = folder.write("q.csv", "lon,lat\n0,0\n");
  const auto curl = [&](const char* domain) {
    expect_success(run({"sample", winds, equator, "--vector", "3,4", "--method", "c1",
                        "--on", domain, "--derivatives", "-o", folder / "s.csv"}));
    return numbers(folder.read("s.csv"))[1][5];
  };
  // The east-west and the north-south half of the curl, 3 each, over N and over M.
  EXPECT_NEAR(curl("sphere"), 6 / 6371.0088, 1e-8);
  EXPECT_NEAR(curl("ellipsoid"), 3 / 6378.137 + 3 / 6335.439, 1e-8);
}

TEST(Vector, EveryMethodThatKnowsVectorsTakesThem) {
  const Folder folder;
  const std::string winds = folder.write("w.csv", wind_csv());
  for (const char* const method : {"linear", "c1", "natural", "natural-c1"}) {
    expect_success(run({"sample", winds, winds, "--vector", "u_m_s,v_m_s", "--method",
                        method, "-o", folder / "s.csv"}));
    const auto rows = numbers(folder.read("s.csv"));
    for (std::size_t i = 1; i < rows.size(); ++i) {
      EXPECT_NEAR(rows[i][4], rows[i][2], 1e-13);
      EXPECT_NEAR(rows[i][5], rows[i][3], 1e-13);
    }
  }
}

TEST(Vector, RowsThatLackAComponentAreDroppedAndCounted) {
  const Folder folder;
  const std::string winds =
      folder.write("w.csv", "lon,lat,u,v\n0,0,1,0\n10,0,1,NA\n0,10,,1\n10,10,2,2\n");
  const Outcome outcome = run({"sample", winds, folder.write("q.csv", "lon,lat\n0,0\n"),
                               "--vector", "u,v", "-o", folder / "s.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("2 points, 2 with missing values dropped"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(lines(folder.read("s.csv"))[1], "0,0,1,0");
}

TEST(Vector, RefusesWhatDoesNotGoWithVectors) {
  const Folder folder;
  const std::string winds = folder.write("w.csv", wind_csv());
  const auto refuses = [&](std::vector<std::string> options,
                           const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"grid", winds, "-o", folder / "g.nc"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_failure(run(arguments), 2, words);
  };
  refuses({"--vector", "u_m_s"}, {"--vector u,v", "'u_m_s'"});
  refuses({"--vector", "3,4", "--on", "plane"}, {"sphere or ellipsoid", "--value"});
  refuses({"--vector", "3,4", "--method", "rbf"}, {"linear, c1, natural"});
  refuses({"--vector", "3,4", "--duplicates", "max"}, {"max", "mean"});
  refuses({"--vector", "3,4", "--value", "3"}, {"--vector"});
  refuses({"--vector", "3,4", "--map", folder / "m.png"}, {"--map", "plot"});
  refuses({"--vector", "3,4", "--format", "asc"}, {"nc, csv"});
  expect_failure(run({"grid", winds, "-o", folder / "g.nc", "--vector", "3,9"}), 3,
                 {"w.csv"});
  expect_failure(run({"sample", winds, winds, "-o", folder / "s.csv", "--vector", "3,4",
                      "--gradient"}),
                 2, {"--derivatives"});
}

}  // namespace
}  // namespace delone::test
