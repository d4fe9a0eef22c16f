// grid, sample, plot: values in, values out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// Corners and middle of a square with the values of the plane z = 1 + 2x - 3y.
const std::string plane_csv = "x,y,z\n0,0,1\n4,0,9\n4,4,-3\n0,4,-11\n2,2,-1\n";

/// The fields of a CSV without header, as numbers; NaN where a field is empty.
std::vector<std::vector<double>> table_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  const std::vector<std::string> all = lines(text);
  for (std::size_t i = 1; i < all.size(); ++i) {
    auto& row = rows.emplace_back();
    std::istringstream stream(all[i] + ",");
    for (std::string field; std::getline(stream, field, ',');) {
      row.push_back(field.empty() ? std::nan("") : std::stod(field));
    }
  }
  return rows;
}

TEST(Grid, ReproducesAPlane) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  expect_success(run({"grid", points, "-o", folder / "g.csv", "--spacing", "0.5"}));
  const auto rows = table_of(folder.read("g.csv"));
  EXPECT_EQ(lines(folder.read("g.csv"))[0], "x,y,z");
  ASSERT_EQ(rows.size(), 81U);
  for (const auto& row : rows) EXPECT_NEAR(row[2], 1 + 2 * row[0] - 3 * row[1], 1e-14);
}

TEST(Grid, TakesRegionAndSize) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  expect_success(run(
      {"grid", points, "-o", folder / "g.csv", "--region", "-1/3/1/2", "--size", "5/3"}));
  const auto rows = table_of(folder.read("g.csv"));
  ASSERT_EQ(rows.size(), 15U);
  const auto [west, east] =
      std::ranges::minmax(rows, {}, [](const auto& row) { return row[0]; });
  EXPECT_EQ(west[0], -1);
  EXPECT_EQ(east[0], 3);
  for (const auto& row : rows)
    EXPECT_EQ(std::isnan(row[2]), row[0] < 0) << row[0] << ' ' << row[1];
}

TEST(Grid, WithoutSpacingSaysWhatItChose) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(400));
  const Outcome outcome = run({"grid", points, "-o", folder / "g.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("by 0.02"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--spacing"), std::string::npos) << outcome.err;
}

TEST(Grid, ExtrapolatesOnRequest) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  const auto corner = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "grid", points, "-o", folder / "g.csv", "--region", "-2/4/0/4", "--spacing", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_success(run(arguments));
    for (const auto& row : table_of(folder.read("g.csv"))) {
      if (row[0] == -2 && row[1] == 0) return row[2];
    }
    ADD_FAILURE() << "no such node";
    return 0.0;
  };
  EXPECT_TRUE(std::isnan(corner({})));
  EXPECT_EQ(corner({"--extrapolate", "nearest"}), 1);
  EXPECT_NEAR(corner({"--extrapolate", "linear"}), -3, 1e-14);
  EXPECT_EQ(corner({"--extrapolate", "nearest", "--max-distance", "2"}), 1);
  EXPECT_TRUE(std::isnan(corner({"--extrapolate", "nearest", "--max-distance", "1.9"})));
}

TEST(Grid, CollinearPointsAreGriddedByNearest) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,1\n1,1,2\n2,2,3\n");
  expect_success(run({"grid", points, "-o", folder / "g.csv", "--spacing", "2",
                      "--extrapolate", "nearest"}));
  EXPECT_EQ(table_of(folder.read("g.csv")).size(), 4U);
}

TEST(Grid, GlobalGridHasPolesAndNoSecondDateLine) {
  const Folder folder;
  std::string table = "lon,lat,v\n";
  for (int lat = -90; lat <= 90; lat += 30) {
    for (int lon = 0; lon < 360; lon += 30) {
      table += std::to_string(lon) + "," + std::to_string(lat) + "," +
               std::to_string(lat) + "\n";
    }
  }
  const std::string points = folder.write("p.csv", table);
  expect_success(run({"grid", points, "-o", folder / "g.csv", "--spacing", "30"}));
  const auto rows = table_of(folder.read("g.csv"));
  ASSERT_EQ(rows.size(), 12U * 7U);
  for (const auto& row : rows) EXPECT_EQ(row[2], row[1]);
}

TEST(Grid, RegionMayCrossTheDateLine) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat,v\n170,-10,1\n-170,-10,1\n-170,10,1\n170,10,1\n");
  expect_success(run({"grid", points, "-o", folder / "g.csv", "--region", "175/-175/0/5",
                      "--spacing", "5"}));
  const auto rows = table_of(folder.read("g.csv"));
  ASSERT_EQ(rows.size(), 6U);
  for (const auto& row : rows) EXPECT_DOUBLE_EQ(row[2], 1);
}

TEST(Grid, WritesEveryFormat) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  const std::vector<std::pair<std::string, std::string>> formats{
      {"g.nc", "CDF"}, {"g.csv", "x,y,z"}, {"g.asc", "ncols"}, {"g.png", "\x89PNG"}};
  for (const auto& [name, magic] : formats) {
    expect_success(run({"grid", points, "-o", folder / name}));
    EXPECT_TRUE(folder.read(name).starts_with(magic)) << name;
  }
  expect_success(run({"grid", points, "-o", folder / "data", "--format", "nc"}));
  EXPECT_EQ(folder.read("data"), folder.read("g.nc"));
}

TEST(Grid, DrawsAMapBesides) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  expect_success(run(
      {"grid", points, "-o", folder / "g.nc", "--map", folder / "g.svg", "--points"}));
  EXPECT_NE(folder.read("g.svg").find("<svg"), std::string::npos);
}

TEST(Plot, DrawsAGridFile) {
  const Folder folder;
  expect_success(run({"grid", folder.write("p.csv", plane_csv), "-o", folder / "g.nc"}));
  for (const std::string name : {"g.png", "g.svg", "g.pdf", "g.eps"}) {
    expect_success(
        run({"plot", folder / "g.nc", "-o", folder / name, "--title", "A plane"}));
    EXPECT_GT(folder.read(name).size(), 1000U) << name;
  }
}

TEST(Sample, KeepsRowsColumnsAndOrderOfTheQueries) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  const std::string queries =
      folder.write("q.csv", "name,x,y\n\"b, c\",3,1\nfar,9,9\na,1,1\n");
  expect_success(run({"sample", points, queries, "-o", folder / "s.csv"}));
  EXPECT_EQ(folder.read("s.csv"), "name,x,y,z\n\"b, c\",3,1,4\nfar,9,9,\na,1,1,0\n");
}

TEST(Sample, GivesGradientsOnThePlane) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv);
  const std::string queries = folder.write("q.csv", "x,y\n3,1\n9,9\n");
  expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--gradient"}));
  EXPECT_EQ(folder.read("s.csv"), "x,y,z,dz_dx,dz_dy\n3,1,4,2,-3\n9,9,,,\n");
}

TEST(Sample, GivesGradientsOfTheGlobeForEachKilometre) {
  const Folder folder;
  // The value is the height above the plane of the equator in radii: its northward slope
  // is cos(lat) for each radian, and every linear surface on flat triangles has it
  // exactly at the middle.
  const std::string points = folder.write(
      "p.csv", "lon,lat,h\n-0.01,-0.01,-0.01\n0.01,-0.01,-0.01\n0,0.01,0.01\n");
  const std::string queries = folder.write("q.csv", "lon,lat\n0,0\n");
  const auto north = [&](const std::string& domain) {
    expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--gradient",
                        "--on", domain}));
    EXPECT_EQ(lines(folder.read("s.csv"))[0], "lon,lat,h,h_east_per_km,h_north_per_km");
    const auto row = table_of(folder.read("s.csv")).at(0);
    EXPECT_NEAR(row[3], 0, 1e-12);
    return row[4];
  };
  // A degree of latitude is 111.195 km on the sphere and 110.574 km on the ellipsoid
  // here.
  EXPECT_NEAR(north("sphere"), 1 / 111.195, 1e-6);
  EXPECT_NEAR(north("ellipsoid"), 1 / 110.574, 1e-6);
}

TEST(Sample, TurnsOtherDelimitersIntoCommas) {
  const Folder folder;
  const std::string points = folder.write("p.csv", plane_csv), out = folder / "s.csv";
  // Without a header none is written.
  expect_success(
      run({"sample", points, folder.write("q.txt", "  3 1  70\n1\t1 80\n"), "-o", out}));
  EXPECT_EQ(folder.read("s.csv"), "3,1,70,4\n1,1,80,0\n");
  const std::string tabbed = "x\ty\tn\n3\t1\ta,b\n1\t1\t\n";
  expect_success(run({"sample", points, folder.write("q.tsv", tabbed), "-o", out}));
  EXPECT_EQ(folder.read("s.csv"), "x,y,n,z\n3,1,\"a,b\",4\n1,1,,0\n");
}

TEST(Sample, OfALineOfPointsWorksAlongIt) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,0\n2,2,4\n4,4,0\n");
  const std::string queries = folder.write("q.csv", "x,y\n1,1\n1,2\n");
  expect_success(run({"sample", points, queries, "-o", folder / "s.csv"}));
  EXPECT_EQ(folder.read("s.csv"), "x,y,z\n1,1,2\n1,2,\n");
}

}  // namespace
}  // namespace delone::test
