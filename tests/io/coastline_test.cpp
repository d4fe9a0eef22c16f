#include "io/coastline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "io/coastline_table.hpp"

namespace delone::io {
namespace {

/// Distance in degrees of latitude to the nearest point of the coast on the whole globe.
double distance_to_coast(stripack::LonLat place) {
  double nearest = 360;
  for (const CoastLine& line : coast_in({}))
    for (const auto& p : line) {
      const double lon = std::remainder(p.lon_deg - place.lon_deg, 360) *
                         std::cos(place.lat_deg * 3.14159265358979 / 180);
      nearest = std::min(nearest, std::hypot(lon, p.lat_deg - place.lat_deg));
    }
  return nearest;
}

std::size_t num_points(const std::vector<CoastLine>& lines) {
  std::size_t count = 0;
  for (const CoastLine& line : lines) count += line.size();
  return count;
}

TEST(Coastline, PassesNearKnownCapes) {
  EXPECT_LT(distance_to_coast({18.5, -34.4}), 1) << "Cape of Good Hope";
  EXPECT_LT(distance_to_coast({-9.5, 38.8}), 1) << "Cabo da Roca";
  EXPECT_LT(distance_to_coast({77.5, 8.1}), 1) << "Cape Comorin";
  EXPECT_LT(distance_to_coast({-169.7, 66.1}), 1.5)
      << "Cape Dezhnev, east of the date line";
  EXPECT_LT(distance_to_coast({173, -34.4}), 1) << "North Cape";
}

TEST(Coastline, IsFarFromTheMiddleOfOceansAndContinents) {
  EXPECT_GT(distance_to_coast({-140, -30}), 10);
  EXPECT_GT(distance_to_coast({86.7, 46.3}), 10) << "the pole of inaccessibility";
  EXPECT_TRUE(coast_in({-145, -35, -135, -25}).empty());
}

TEST(Coastline, HoldsTheWholeTable) {
  std::ifstream file(std::string(DELONE_DATA_DIR) + "/coastline/ne_110m_coastline.csv");
  ASSERT_TRUE(file.is_open());
  std::size_t num_rows = 0;
  for (std::string row; std::getline(file, row);) ++num_rows;
  EXPECT_EQ(coast_points().size(), num_rows - 1);
  EXPECT_GT(coast_points().size(), 5000u);
}

TEST(Coastline, HasNoLinesAcrossTheMap) {
  for (const CoastLine& line : coast_in({}))
    for (std::size_t i = 1; i < line.size(); ++i)
      EXPECT_LT(std::abs(line[i].lon_deg - line[i - 1].lon_deg), 30);
}

TEST(Coastline, HasNoEdgesAlongTheDateLine) {
  for (const CoastLine& line : coast_in({170, -90, 190, 90}))
    for (std::size_t i = 1; i < line.size(); ++i)
      EXPECT_FALSE(line[i].lon_deg == 180 && line[i - 1].lon_deg == 180)
          << line[i].lat_deg << ' ' << line[i - 1].lat_deg;
}

TEST(Coastline, RunsOnAcrossTheDateLine) {
  const auto lines = coast_in({170, 60, 190, 75});
  const auto crosses = [](const CoastLine& line) {
    const auto [west, east] = std::minmax_element(
        line.begin(), line.end(), [](auto a, auto b) { return a.lon_deg < b.lon_deg; });
    return west->lon_deg < 179 && east->lon_deg > 181;
  };
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), crosses)) << "Chukotka";
}

TEST(Coastline, ComesInTheLongitudesOfTheBox) {
  for (const LonLatBox box :
       {LonLatBox{0, -90, 360, 90}, {160, -50, 200, 0}, {-200, -50, -160, 0}})
    for (const CoastLine& line : coast_in(box))
      for (const auto& p : line) {
        EXPECT_GE(p.lon_deg, box.west_deg - 30);
        EXPECT_LE(p.lon_deg, box.east_deg + 30);
      }
}

TEST(Coastline, IsTheSameAWholeTurnAway) {
  const auto lines = coast_in({-20, 30, 40, 60}), turned = coast_in({340, 30, 400, 60});
  ASSERT_EQ(lines.size(), turned.size());
  ASSERT_GT(num_points(lines), 100u);
  ASSERT_EQ(num_points(lines), num_points(turned));
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < lines[i].size(); ++j)
      EXPECT_EQ(lines[i][j].lon_deg + 360, turned[i][j].lon_deg);
}

TEST(Coastline, ShowsEveryPointToAGlobeOfAnySeam) {
  EXPECT_GE(num_points(coast_in({})), coast_points().size());
  EXPECT_GE(num_points(coast_in({0, -90, 360, 90})), coast_points().size());
}

}  // namespace
}  // namespace delone::io
