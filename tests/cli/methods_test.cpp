// --method and what belongs to it, on the plane and on the globe.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::vector<std::string> methods{"nearest",    "linear", "c1",      "natural",
                                       "natural-c1", "idw",    "shepard", "rbf"};

// A smooth function at scattered points, the third column of the output in the same
// places.
std::string smooth_csv(const std::string& header, double wide) {
  std::ostringstream text;
  text.precision(17);
  text << header << '\n';
  for (int i = 0; i < 400; ++i) {
    const double x = wide * (std::fmod(i * 0.754877666, 1.0) - 0.5),
                 y = wide * (std::fmod(i * 0.569840291, 1.0) - 0.5) / 2;
    text << x << ',' << y << ',' << std::sin(3 * x / wide) * std::cos(5 * y / wide)
         << '\n';
  }
  return text.str();
}

double largest_difference(const std::string& csv, double wide) {
  double largest = 0;
  const std::vector<std::string> rows = lines(csv);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::istringstream stream(rows[i]);
    double x = 0, y = 0, v = 0;
    char comma = 0;
    if (!(stream >> x >> comma >> y >> comma >> v)) return 1e300;
    const double expected = std::sin(3 * x / wide) * std::cos(5 * y / wide);
    largest = std::max(largest, std::abs(v - expected));
  }
  return largest;
}

class Methods : public testing::TestWithParam<std::string> {};

TEST_P(Methods, GridASmoothFunctionOnPlaneAndGlobe) {
  const Folder folder;
  const std::string plane = folder.write("p.csv", smooth_csv("x,y,z", 2)),
                    globe = folder.write("g.csv", smooth_csv("lon,lat,z", 80));
  const double most = GetParam() == "nearest" ? 0.3 : GetParam() == "idw" ? 0.15 : 0.03;
  expect_success(run({"grid", plane, "-o", folder / "p_grid.csv", "--region",
                      "-0.8/0.8/-0.4/0.4", "--size", "17/9", "--method", GetParam()}));
  EXPECT_LT(largest_difference(folder.read("p_grid.csv"), 2), most);
  expect_success(run({"grid", globe, "-o", folder / "g_grid.csv", "--region",
                      "-30/30/-15/15", "--size", "13/7", "--method", GetParam()}));
  EXPECT_LT(largest_difference(folder.read("g_grid.csv"), 80), most);
}

TEST_P(Methods, SampleGivesTheValuesOfTheData) {
  const Folder folder;
  const std::string points = folder.write("p.csv", smooth_csv("x,y,z", 2));
  expect_success(run({"sample", points, points, "-o", folder / "s.csv", "--method",
                      GetParam(), "--gradient"}));
  const std::vector<std::string> rows = lines(folder.read("s.csv"));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string& row = rows[i];
    std::vector<std::string> fields;
    std::istringstream stream(row);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    ASSERT_EQ(fields.size(), 6U) << row;
    EXPECT_EQ(std::stod(fields[2]), std::stod(fields[3]));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Methods, testing::ValuesIn(methods),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(C1Method, SaysWhatItChose) {
  const Folder folder;
  const std::string points = folder.write("p.csv", smooth_csv("x,y,z", 2));
  const Outcome outcome = run({"grid", points, "-o", folder / "g.csv", "--method", "c1"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("c1: local gradients and tension 0, chosen by leaving out"),
            std::string::npos)
      << outcome.err;
}

TEST(C1Method, TakesTensionBoundsAndDegree) {
  const Folder folder;
  const std::string points = folder.write("p.csv", smooth_csv("x,y,z", 2));
  const Outcome outcome = run({"grid", points, "-o", folder / "g.csv", "--method", "c1",
                               "--tension", "0.5", "--bounded", "--fit-degree", "4",
                               "--extrapolate", "linear", "--gradients", "global"});
  expect_success(outcome);
  EXPECT_EQ(outcome.err.find("chosen by"), std::string::npos);
  EXPECT_NE(outcome.err.find(", 0 of "), std::string::npos) << outcome.err;
}

TEST(C1Method, OptionsOfItsOwnAreRefusedElsewhere) {
  const Folder folder;
  const std::string points = folder.write("p.csv", smooth_csv("x,y,z", 2));
  expect_failure(run({"grid", points, "-o", folder / "g.csv", "--tension", "0.5"}), 2,
                 {"--method c1"});
  expect_failure(
      run({"grid", points, "-o", folder / "g.csv", "--method", "idw", "--bounded"}), 2,
      {"idw"});
  expect_failure(
      run({"grid", points, "-o", folder / "g.csv", "--method", "c1", "--tension", "1.1"}),
      2, {"--tension", "0 (smooth) to 1"});
  expect_failure(run({"grid", points, "-o", folder / "g.csv", "--method", "natural",
                      "--extrapolate", "linear"}),
                 2, {"natural", "--extrapolate nearest"});
}

}  // namespace
}  // namespace delone::test
