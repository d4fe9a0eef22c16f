// --cross-validate: what the other points say of each one, as a table and a report.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

using Fields = std::vector<std::string>;

Fields fields_of(const std::string& line) {
  Fields fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

constexpr const char* header = "row,x,y,value,predicted,residual,standardised,outlier";
constexpr std::size_t value = 3, predicted = 4, residual = 5, outlier = 7;

/// The points without one row.
std::string without(const std::string& csv, std::size_t row) {
  std::string rest;
  const std::vector<std::string> rows = lines(csv);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i != row + 1) rest += rows[i] + "\n";
  return rest;
}

class CrossValidate : public testing::TestWithParam<std::string> {};

TEST_P(CrossValidate, PredictsEachPointAsTheOthersDo) {
  const Folder folder;
  const std::string csv = scattered_csv(60), points = folder.write("p.csv", csv);
  expect_success(run({"grid", points, "-o", folder / "g.nc", "--method", GetParam(),
                      "--cross-validate", folder / "left.csv"}));
  const std::vector<std::string> table = lines(folder.read("left.csv"));
  ASSERT_EQ(table.size(), 61U);
  EXPECT_EQ(table[0], header);
  std::size_t num_predicted = 0;
  for (std::size_t row = 0; row < 60; row += 17) {
    const Fields left = fields_of(table[row + 1]);
    EXPECT_EQ(left[0], std::to_string(row));
    const std::string others = folder.write("o.csv", without(csv, row)),
                      query = folder.write("q.csv", "x,y\n" + left[1] + "," + left[2]);
    expect_success(
        run({"sample", others, query, "-o", folder / "s.csv", "--method", GetParam()}));
    const Fields found = fields_of(lines(folder.read("s.csv"))[1]);
    ASSERT_EQ(found.size() < 3, left[predicted].empty()) << row;
    if (found.size() < 3) continue;
    ++num_predicted;
    EXPECT_NEAR(std::stod(left[predicted]), std::stod(found[2]), 1e-9) << row;
    EXPECT_NEAR(std::stod(left[residual]),
                std::stod(left[predicted]) - std::stod(left[value]), 1e-12);
  }
  EXPECT_GT(num_predicted, 1U);
}

INSTANTIATE_TEST_SUITE_P(Method, CrossValidate,
                         testing::Values("nearest", "linear", "natural", "natural-c1",
                                         "idw", "shepard", "rbf"),
                         [](const auto& method) {
                           return method.param == "natural-c1" ? "natural_c1"
                                                               : method.param;
                         });

TEST(CrossValidation, OfSmoothIsAboutWhatTheSurfaceExpects) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(100));
  const Outcome outcome =
      run({"grid", points, "-o", folder / "g.nc", "--method", "smooth", "--smooth", "0.3",
           "--extrapolate", "linear", "--cross-validate", folder / "left.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("cross-validation of smooth: 100 points predicted"),
            std::string::npos)
      << outcome.err;
}

TEST(CrossValidation, SaysTheErrorsOfItsTable) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(200));
  const Outcome outcome = run({"grid", points, "-o", folder / "g.nc", "--method", "c1",
                               "--cross-validate", folder / "left.csv"});
  expect_success(outcome);
  double sum = 0;
  int count = 0;
  for (const std::string& line : lines(folder.read("left.csv"))) {
    const Fields left = fields_of(line);
    if (line == header || left[residual].empty()) continue;
    const double r = std::stod(left[residual]);
    sum += r * r;
    ++count;
  }
  std::ostringstream words;
  words.precision(4);
  words << "RMS error " << std::sqrt(sum / count);
  EXPECT_NE(outcome.err.find(words.str()), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(std::to_string(count) + " points predicted"),
            std::string::npos);
  EXPECT_NE(outcome.err.find("--extrapolate nearest predicts these too"),
            std::string::npos);
}

TEST(CrossValidation, FlagsTheRowThatIsWrong) {
  const Folder folder;
  std::string csv = scattered_csv(300);
  std::vector<std::string> rows = lines(csv);
  const auto is_inside = [](const std::string& line) {
    const Fields f = fields_of(line);
    return f[0].starts_with("0.5") && f[1].starts_with("0.5");
  };
  const auto found = std::find_if(rows.begin() + 1, rows.end(), is_inside);
  ASSERT_NE(found, rows.end());
  const std::string number = std::to_string(found - rows.begin() - 1);
  *found = fields_of(*found)[0] + "," + fields_of(*found)[1] + ",77";
  csv.clear();
  for (const std::string& row : rows) csv += row + "\n";
  const Outcome outcome =
      run({"sample", folder.write("p.csv", csv), folder.write("q.csv", "x,y\n0.5,0.5\n"),
           "-o", folder / "s.csv", "--cross-validate", folder / "left.csv"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("1 outlier "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("outlier 1: row " + number + ", line"), std::string::npos)
      << outcome.err;
  for (const std::string& line : lines(folder.read("left.csv"))) {
    const Fields left = fields_of(line);
    if (line != header) {
      EXPECT_EQ(left[outlier], left[0] == number ? "1" : "0") << line;
    }
  }
}

TEST(CrossValidation, CountsRowsOfTheFileThatWereDropped) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "lon,lat,v\n0,0,1\n1,1,\n9,0,2\n0,9,3\n4,4,4\n");
  expect_success(run({"grid", points, "-o", folder / "g.nc", "--size", "3/3",
                      "--cross-validate", folder / "left.csv"}));
  const std::vector<std::string> table = lines(folder.read("left.csv"));
  ASSERT_EQ(table.size(), 5U);
  EXPECT_EQ(table[0], "row,lon,lat,value,predicted,residual,standardised,outlier");
  EXPECT_EQ(table[2].substr(0, 10), "2,9,0,2,,,");
  EXPECT_EQ(fields_of(table[4])[0], "4");
  EXPECT_FALSE(fields_of(table[4])[predicted].empty());
}

TEST(CrossValidation, ItsTableIsGriddedAsAMap) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(100));
  expect_success(run(
      {"grid", points, "-o", folder / "g.nc", "--cross-validate", folder / "left.csv"}));
  const Outcome outcome = run({"grid", folder / "left.csv", "--value", "residual", "-o",
                               folder / "e.nc", "--map", folder / "e.png"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("value is 'residual'"), std::string::npos);
  EXPECT_NE(outcome.err.find("with missing values dropped"), std::string::npos);
}

TEST(CrossValidation, IsRefusedBeforeAnythingIsWritten) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(20)),
                    curves = folder.write("c.csv", "ring,x,y\n1,0,0\n1,1,0\n1,1,1\n"),
                    left = folder / "left.csv", grid = folder / "g.csv";
  const auto refuse = [&](std::vector<std::string> more,
                          const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"grid", points, "-o", grid};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_failure(run(arguments), 2, words);
  };
  refuse({"--cross-validate", folder / "left.nc"}, {"left.nc", ".csv"});
  refuse({"--cross-validate", grid}, {"another output"});
  refuse({"--cross-validate", folder / "./g.csv"}, {"another output"});
  refuse({"--cross-validate", points}, {"overwrite the input"});
  refuse({"--constraints", curves, "--cross-validate", left}, {"segments"});
  refuse({"--vector", "x,y", "--cross-validate", left}, {"--vector"});
  expect_failure(run({"grid", points, "-o", grid, "--cross-validate",
                      folder / "no_folder/left.csv"}),
                 4, {"no_folder"});
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"c.csv", "p.csv"}));
}

}  // namespace
}  // namespace delone::test
