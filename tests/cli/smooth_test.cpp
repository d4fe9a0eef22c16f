// --method smooth: how smooth, and what belongs to it.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

// A slope with a wave of +-0.5 from row to row, and a column of its size.
std::string zigzag_csv(const std::string& header) {
  std::ostringstream text;
  text << header << '\n';
  for (int i = 0; i < 300; ++i) {
    const double x = 10 * std::fmod(i * 0.754877666, 1.0),
                 y = 10 * std::fmod(i * 0.569840291, 1.0);
    text << x << ',' << y << ',' << x + 2 * y + (i * 7 % 4 < 2 ? 0.5 : -0.5) << ",0.5\n";
  }
  return text.str();
}

double value_at(const Folder& folder, const std::string& points,
                std::vector<std::string> more) {
  const std::string query = folder.write("q.csv", "x,y\n5,5\n");
  std::vector<std::string> all{"sample",         points,     query,   "-o",
                               folder / "s.csv", "--method", "smooth"};
  all.insert(all.end(), more.begin(), more.end());
  expect_success(run(all));
  const std::string row = lines(folder.read("s.csv"))[1];
  return std::stod(row.substr(row.rfind(',') + 1));
}

TEST(SmoothMethod, FindsASlopeUnderNoise) {
  const Folder folder;
  const std::string points = folder.write("p.csv", zigzag_csv("x,y,z,sigma"));
  EXPECT_NEAR(value_at(folder, points, {}), 15, 0.25);
  EXPECT_NEAR(value_at(folder, points, {"--smooth", "auto"}), 15, 0.25);
  EXPECT_NEAR(value_at(folder, points, {"--smooth", "1000"}), 15, 0.1);
  EXPECT_NEAR(value_at(folder, points, {"--smooth", "errors", "--errors", "sigma"}), 15,
              0.25);
}

TEST(SmoothMethod, SaysWhatItChose) {
  const Folder folder;
  const std::string plane = folder.write("p.csv", zigzag_csv("x,y,z,sigma")),
                    globe = folder.write("g.csv", zigzag_csv("lon,lat,z,sigma"));
  const Outcome by_score =
      run({"grid", globe, "-o", folder / "g_grid.csv", "--method", "smooth"});
  expect_success(by_score);
  EXPECT_NE(by_score.err.find(" km, chosen by cross-validation; "), std::string::npos)
      << by_score.err;
  const Outcome by_errors = run({"grid", plane, "-o", folder / "p_grid.csv", "--method",
                                 "smooth", "--smooth", "errors", "--errors", "sigma"});
  expect_success(by_errors);
  EXPECT_NE(by_errors.err.find("with errors 'sigma'"), std::string::npos)
      << by_errors.err;
  EXPECT_NE(by_errors.err.find("of the errors)"), std::string::npos) << by_errors.err;
}

TEST(SmoothMethod, RefusesWhatDoesNotBelongToIt) {
  const Folder folder;
  const std::string points = folder.write("p.csv", zigzag_csv("x,y,z,sigma"));
  const auto grid = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"grid", points, "-o", folder / "g.csv"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  expect_failure(grid({"--smooth", "3"}), 2, {"--method smooth", "linear"});
  expect_failure(grid({"--errors", "sigma"}), 2, {"--method smooth"});
  expect_failure(grid({"--method", "smooth", "--smooth", "-1"}), 2,
                 {"--smooth takes auto, errors or a length"});
  expect_failure(grid({"--method", "smooth", "--smooth", "much"}), 2, {"'much'"});
  expect_failure(grid({"--method", "smooth", "--smooth", "errors"}), 2,
                 {"--errors COLUMN"});
  expect_failure(grid({"--method", "smooth", "--tension", "0.5"}), 2, {"--method c1"});
  const std::string bad = folder.write("b.csv", "x,y,z,e\n0,0,1,1\n1,0,2,-1\n0,1,3,1\n");
  expect_failure(
      run({"grid", bad, "-o", folder / "g.csv", "--method", "smooth", "--errors", "e"}),
      3, {"b.csv: line 3", "positive"});
}

}  // namespace
}  // namespace delone::test
