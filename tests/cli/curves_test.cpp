// grid and sample with segments: coasts and faults.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "cli/process.hpp"

namespace delone::test {
namespace {

/// A square of side 4 with a square hole of side 2; the value of vertex k is k.
const std::string frame =
    "8 2 1 0\n1 0 0 1\n2 4 0 2\n3 4 4 3\n4 0 4 4\n5 1 1 5\n6 3 1 6\n7 3 3 7\n8 1 3 8\n"
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n";
const std::string fault =
    R"({"type":"LineString","coordinates":[[5,-1],[5.2,4],[4.9,6],[5,11]]})";

/// A lattice from 0.5 to 9.5; 0 where x < 5, 10 beyond.
std::string step_csv(double beyond = 10) {
  std::string text = "x,y,depth\n";
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      text += std::to_string(i + 0.5) + "," + std::to_string(j + 0.5) + "," +
              std::to_string(i < 5 ? 0 : beyond) + "\n";
  return text;
}

/// The last field of every line but the header.
std::vector<std::string> last_fields(const std::string& csv) {
  std::vector<std::string> fields;
  for (const std::string& line : lines(csv))
    fields.push_back(line.substr(line.rfind(',') + 1));
  fields.erase(fields.begin());
  return fields;
}

TEST(Curves, PolyFileIsSampledInsideItsOutlineByItsFirstAttribute) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  const std::string queries = folder.write("q.csv", "x,y\n0.5,0.5\n2,2\n3,3\n9,9\n4,2\n");
  const Outcome outcome = run({"sample", poly, queries, "-o", folder / "s.csv"});
  expect_success(outcome);
  EXPECT_EQ(folder.read("s.csv"),
            "x,y,attribute_1\n0.5,0.5,3\n2,2,\n3,3,7\n9,9,\n4,2,2.5\n");
  EXPECT_NE(outcome.err.find("value is 'attribute_1'"), std::string::npos);
  EXPECT_NE(outcome.err.find("2 of 5 queries have no value: they are outside the domain"),
            std::string::npos);
}

TEST(Curves, KeepOutsideKeepsHolesOfAPolyFile) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  const std::string queries = folder.write("q.csv", "x,y\n2,2\n9,9\n");
  expect_success(
      run({"sample", poly, queries, "-o", folder / "s.csv", "--keep-outside"}));
  const auto values = last_fields(folder.read("s.csv"));
  EXPECT_FALSE(values[0].empty());
  EXPECT_TRUE(values[1].empty());
}

TEST(Curves, GridOfAPolyFileCoversItsDomain) {
  const Folder folder;
  const std::string poly = folder.write("frame.poly", frame);
  expect_success(run({"grid", poly, "-o", folder / "g.csv", "--size", "5/5"}));
  const auto values = last_fields(folder.read("g.csv"));
  ASSERT_EQ(values.size(), 25U);
  EXPECT_EQ(values[0], "1");
  EXPECT_EQ(values[6], "5");
  EXPECT_TRUE(values[12].empty());
  EXPECT_EQ(values[24], "3");
}

TEST(Curves, ValueNamesTheAttributeOfAPolyFile) {
  const Folder folder;
  const std::string poly = folder.write("two.poly",
                                        "3 2 2 0\n0 0 0 1 10\n1 4 0 2 20\n2 0 4 3 30\n"
                                        "3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
  const std::string queries = folder.write("q.csv", "x,y\n4,0\n");
  expect_success(
      run({"sample", poly, queries, "-o", folder / "s.csv", "--value", "attribute_2"}));
  EXPECT_EQ(folder.read("s.csv"), "x,y,attribute_2\n4,0,20\n");
  expect_success(run({"sample", poly, queries, "-o", folder / "s.csv", "--value", "5"}));
  EXPECT_EQ(folder.read("s.csv"), "x,y,attribute_2\n4,0,20\n");
  expect_failure(run({"sample", poly, queries, "-o", folder / "s.csv", "--value", "z"}),
                 2, {"--value 'z'", "2 attributes"});
}

TEST(Curves, NothingIsInterpolatedAcrossAFault) {
  const Folder folder;
  const std::string points = folder.write("p.csv", step_csv()),
                    line = folder.write("fault.geojson", fault);
  for (const std::string method : {"linear", "c1"}) {
    expect_success(run({"grid", points, "--constraints", line, "--keep-outside", "-o",
                        folder / "g.csv", "--region", "1/9/1/9", "--spacing", "0.25",
                        "--method", method}));
    for (const std::string& value : last_fields(folder.read("g.csv")))
      ASSERT_TRUE(value == "0" || value == "10") << value;
  }
}

TEST(Curves, DataBeyondAFaultDoNotMatter) {
  const Folder folder;
  const std::string line = folder.write("fault.geojson", fault);
  const std::string queries = folder.write("q.csv", "x,y\n4.8,2\n1,1\n4.85,6\n");
  const auto sampled = [&](double beyond) {
    const std::string points = folder.write("p.csv", step_csv(beyond));
    expect_success(run({"sample", points, queries, "--constraints", line,
                        "--keep-outside", "-o", folder / "s.csv"}));
    return folder.read("s.csv");
  };
  EXPECT_EQ(sampled(10), sampled(-3000));
}

TEST(Curves, ALineAloneEnclosesNoDomain) {
  const Folder folder;
  const std::string points = folder.write("p.csv", step_csv()),
                    line = folder.write("fault.geojson", fault);
  expect_failure(run({"grid", points, "--constraints", line, "-o", folder / "g.csv"}), 3,
                 {"fault.geojson", "3 segments enclose no domain", "--keep-outside"});
}

TEST(Curves, RingsOfATableAreACoastWithALake) {
  const Folder folder;
  const std::string points = folder.write("p.csv", step_csv());
  const std::string rings = folder.write(
      "rings.csv", "ring,x,y\n1,1,1\n1,9,1\n1,9,9\n1,1,9\n2,4,4\n2,6,4\n2,6,6\n2,4,6\n");
  const std::string queries = folder.write("q.csv", "x,y\n2,2\n5,5\n0.6,5\n8,8\n");
  expect_success(
      run({"sample", points, queries, "--constraints", rings, "-o", folder / "s.csv"}));
  EXPECT_EQ(last_fields(folder.read("s.csv")),
            (std::vector<std::string>{"0", "", "", "10"}));
}

TEST(Curves, ACoastOnTheGlobeRunsRoundThePole) {
  const Folder folder;
  std::string points = "lon,lat,t\n", rings = "ring,lon,lat\n";
  for (int lon = -180; lon < 180; lon += 20) {
    for (int lat = 40; lat < 90; lat += 10)
      points += std::to_string(lon) + "," + std::to_string(lat) + "," +
                (lat > 60 ? "1" : "7") + "\n";
    rings += "1," + std::to_string(lon) + ",65\n";
  }
  const std::string p = folder.write("p.csv", points), r = folder.write("r.csv", rings);
  const std::string queries =
      folder.write("q.csv", "lon,lat\n5,90\n179.5,80\n-180,68\n0,50\n0,-80\n");
  expect_success(run({"sample", p, queries, "--constraints", r, "-o", folder / "s.csv"}));
  EXPECT_EQ(last_fields(folder.read("s.csv")),
            (std::vector<std::string>{"1", "1", "1", "", ""}));
  expect_success(run({"sample", p, queries, "--constraints", r, "--outside", "0/-90",
                      "--keep-outside", "-o", folder / "s.csv"}));
  EXPECT_EQ(last_fields(folder.read("s.csv")),
            (std::vector<std::string>{"1", "1", "1", "7", ""}));
  expect_success(run({"grid", p, "--constraints", r, "-o", folder / "g.nc"}));
}

TEST(Curves, GradientsAreOfTheSideOfTheQuery) {
  const Folder folder;
  const std::string points = folder.write("p.csv", step_csv()),
                    line = folder.write("fault.geojson", fault);
  const std::string queries = folder.write("q.csv", "x,y\n5,2\n5.1,8\n");
  expect_success(run({"sample", points, queries, "--constraints", line, "--keep-outside",
                      "--gradient", "-o", folder / "s.csv"}));
  const std::vector<std::string> rows = lines(folder.read("s.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], "x,y,depth,ddepth_dx,ddepth_dy");
  for (std::size_t row = 1; row < 3; ++row) {
    std::istringstream fields(rows[row]);
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');)
      numbers.push_back(std::stod(field));
    ASSERT_EQ(numbers.size(), 5U);
    EXPECT_EQ(numbers[2], row == 1 ? 0 : 10);
    EXPECT_EQ(numbers[3], 0);
    EXPECT_EQ(numbers[4], 0);
  }
}

TEST(Curves, WhatGoesWithNoSegmentsIsRefused) {
  const Folder folder;
  const std::string points = folder.write("p.csv", step_csv()),
                    line = folder.write("fault.geojson", fault),
                    queries = folder.write("q.csv", "x,y\n4.8,2\n");
  const auto sample = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"sample", points, queries, "-o", folder / "s.csv"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command);
  };
  for (const std::string method :
       {"nearest", "natural", "natural-c1", "idw", "shepard", "rbf"}) {
    expect_failure(sample({"--constraints", line, "--method", method}), 2,
                   {"--method " + method, "take linear or c1"});
  }
  expect_failure(sample({"--constraints", line, "--extrapolate", "nearest"}), 2,
                 {"--extrapolate", "--keep-outside"});
  expect_failure(sample({"--keep-outside"}), 2, {"need segments"});
  expect_failure(sample({"--constraints", line, "--keep-outside", "--tension", "0.5"}), 2,
                 {"--tension", "--method c1, not linear"});
  expect_failure(sample({"--constraints", line, "--keep-outside", "--method", "c1",
                         "--gradients", "global"}),
                 2, {"--gradients global", "take local"});
  expect_success(
      sample({"--constraints", line, "--keep-outside", "--method", "c1", "--bounded"}));
  const std::string bare = folder.write(
      "bare.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
  expect_failure(run({"grid", bare, "-o", folder / "g.csv"}), 3,
                 {"bare.poly", "no attribute", "--constraints"});
  const std::string cross = folder.write(
      "cross.geojson",
      R"({"type":"MultiLineString","coordinates":[[[0,0.1],[9,9.2]],[[0,9.3],[9,0.2]]]})");
  expect_failure(sample({"--constraints", cross, "--keep-outside"}), 3,
                 {"cross.geojson", "--split-intersections"});
  expect_success(
      sample({"--constraints", cross, "--keep-outside", "--split-intersections"}));
}

TEST(Curves, HelpHasAnExample) {
  for (const std::string command : {"grid", "sample"}) {
    const Outcome outcome = run({command, "--help"});
    EXPECT_NE(outcome.out.find("--constraints"), std::string::npos);
    EXPECT_NE(outcome.out.find("coasts and faults"), std::string::npos);
  }
}

}  // namespace
}  // namespace delone::test
