// delone weights and delone apply: together what delone sample gives.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::vector<std::string> methods{"nearest", "linear", "natural", "natural-c1",
                                       "c1"};

// Two fields at scattered points.
std::string stations(const std::string& header, double wide) {
  std::ostringstream text;
  text.precision(17);
  text << header << '\n';
  for (int i = 0; i < 300; ++i) {
    const double x = wide * (std::fmod(i * 0.754877666, 1.0) - 0.5),
                 y = wide * (std::fmod(i * 0.569840291, 1.0) - 0.5) / 2;
    text << x << ',' << y << ',' << std::sin(3 * x / wide) << ',' << 1 + x - y << '\n';
  }
  return text.str();
}

std::string places(const std::string& header, double wide) {
  std::ostringstream text;
  text << header << '\n';
  for (int i = 0; i < 40; ++i)
    text << wide * (0.02 * i - 0.4) << ',' << wide * 0.2 * std::sin(i) << '\n';
  return text.str();
}

// Column `number`, from 0, of the rows behind the header.
std::vector<double> column(const std::string& csv, int number) {
  std::vector<double> result;
  const std::vector<std::string> rows = lines(csv);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::istringstream stream(rows[i]);
    std::string field;
    for (int k = 0; k <= number; ++k) std::getline(stream, field, ',');
    result.push_back(field.empty() ? NAN : std::stod(field));
  }
  return result;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b,
                 double most) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::isnan(a[i]), std::isnan(b[i])) << i;
    if (!std::isnan(a[i])) {
      EXPECT_NEAR(a[i], b[i], most) << i;
    }
  }
}

class Weights : public testing::TestWithParam<std::string> {};

// c1 and natural-c1 choose by the values unless they are weights.
double most_difference(const std::string& method) {
  return method == "c1" || method == "natural-c1" ? 0.02 : 1e-12;
}

TEST_P(Weights, AppliedAreWhatSampleGivesOnPlaneAndGlobe) {
  const Folder folder;
  for (const bool is_globe : {false, true}) {
    const double wide = is_globe ? 80 : 2;
    const std::string points =
        folder.write("p.csv", stations(is_globe ? "lon,lat,a,b" : "x,y,a,b", wide));
    const std::string queries =
        folder.write("q.csv", places(is_globe ? "lon,lat" : "x,y", wide));
    expect_success(run({"weights", points, queries, "-o", folder / "w.nc", "--method",
                        GetParam(), "--threads", "2"}));
    expect_success(run({"apply", folder / "w.nc", points, "-o", folder / "out.csv"}));
    const std::string applied = folder.read("out.csv");
    EXPECT_EQ(lines(applied)[0], is_globe ? "lon,lat,a,b" : "x,y,a,b");
    for (const std::string name : {"a", "b"}) {
      expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--method",
                          GetParam(), "--value", name}));
      const int number = name == "a" ? 2 : 3;
      const double scale = name == "a" ? 1 : wide;
      expect_near(column(applied, number), column(folder.read("s.csv"), 2),
                  scale * most_difference(GetParam()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Weights, testing::ValuesIn(methods),
                         [](const auto& method) {
                           std::string name = method.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST(WeightsForAGrid, AreWhatGridGives) {
  const Folder folder;
  const std::string points = folder.write("p.csv", stations("x,y,a,b", 2));
  expect_success(run({"weights", points, "-o", folder / "w.nc", "--method", "linear",
                      "--region", "-1/1/-0.5/0.5", "--size", "9/7"}));
  expect_success(
      run({"apply", folder / "w.nc", points, "-o", folder / "out.csv", "--value", "a"}));
  expect_success(run({"grid", points, "-o", folder / "g.csv", "--region", "-1/1/-0.5/0.5",
                      "--size", "9/7"}));
  const std::vector<double> applied = column(folder.read("out.csv"), 2);
  EXPECT_EQ(applied.size(), 63u);
  expect_near(applied, column(folder.read("g.csv"), 2), 1e-12);
}

TEST(WeightsApplied, MissingValuesPropagateUnlessRenormalised) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,v\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n"),
                    values =
                        folder.write("v.csv", "x,y,v\n0,0,1\n1,0,NA\n0,1,3\n1,1,4\n"),
                    queries = folder.write("q.csv", "x,y\n0.1,0.3\n0,1\n");
  expect_success(
      run({"weights", points, queries, "-o", folder / "w.nc", "--method", "natural"}));
  expect_success(run({"apply", folder / "w.nc", values, "-o", folder / "a.csv"}));
  EXPECT_EQ(lines(folder.read("a.csv"))[1], "0.1,0.3,");
  EXPECT_EQ(lines(folder.read("a.csv"))[2], "0,1,3");
  expect_success(run({"apply", folder / "w.nc", values, "-o", folder / "a.csv",
                      "--missing", "renormalise"}));
  const double shared = column(folder.read("a.csv"), 2)[0];
  EXPECT_GT(shared, 1);
  EXPECT_LT(shared, 3);
}

TEST(WeightsApplied, ColumnsAreTheDataRowsThoughBadOnesWereDropped) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y\n0,0\nbad,1\n1,0\n0,1\n"),
                    values = folder.write("v.csv", "x,y,v\n0,0,1\n7,7,9\n1,0,2\n0,1,3\n"),
                    queries = folder.write("q.csv", "x,y\n0.5,0.5\n");
  expect_success(run({"weights", points, queries, "-o", folder / "w.nc", "--method",
                      "linear", "--skip-bad-rows"}));
  expect_success(run({"apply", folder / "w.nc", values, "-o", folder / "a.csv"}));
  EXPECT_EQ(column(folder.read("a.csv"), 2)[0], 2.5);
}

// smooth goes on between the points as the weights of c1 do.
TEST(WeightsOfDenseMethods, AppliedAreNearlyWhatSampleGives) {
  const Folder folder;
  for (const bool is_globe : {false, true}) {
    const double wide = is_globe ? 80 : 2;
    const std::string points =
        folder.write("p.csv", stations(is_globe ? "lon,lat,a,b" : "x,y,a,b", wide));
    const std::string queries =
        folder.write("q.csv", places(is_globe ? "lon,lat" : "x,y", wide));
    const std::string length = is_globe ? "800" : "0.2";
    for (const std::vector<std::string>& method :
         {std::vector<std::string>{"--method", "smooth", "--smooth", length},
          std::vector<std::string>{"--method", "c1", "--gradients", "global"}}) {
      std::vector<std::string> weights{"weights", points, queries, "-o", folder / "w.nc"},
          sample{"sample", points, queries, "-o", folder / "s.csv", "--value", "a"};
      weights.insert(weights.end(), method.begin(), method.end());
      sample.insert(sample.end(), method.begin(), method.end());
      const Outcome outcome = run(weights);
      expect_success(outcome);
      EXPECT_NE(outcome.err.find("1e-06"), std::string::npos) << outcome.err;
      expect_success(run(
          {"apply", folder / "w.nc", points, "-o", folder / "out.csv", "--value", "a"}));
      expect_success(run(sample));
      expect_near(column(folder.read("out.csv"), 2), column(folder.read("s.csv"), 2),
                  0.02);
    }
  }
}

TEST(WeightsOfDenseMethods, ToleranceLeavesOutSmallWeights) {
  const Folder folder;
  const std::string points = folder.write("p.csv", stations("x,y,a,b", 2)),
                    queries = folder.write("q.csv", places("x,y", 2));
  std::vector<std::vector<double>> results;
  std::vector<std::size_t> sizes;
  for (const std::string tolerance : {"0", "1e-3"}) {
    expect_success(run({"weights", points, queries, "-o", folder / "w.nc", "--method",
                        "smooth", "--smooth", "0.2", "--tolerance", tolerance}));
    expect_success(run(
        {"apply", folder / "w.nc", points, "-o", folder / "out.csv", "--value", "a"}));
    results.push_back(column(folder.read("out.csv"), 2));
    sizes.push_back(folder.read("w.nc").size());
  }
  EXPECT_LT(2 * sizes[1], sizes[0]);
  expect_near(results[0], results[1], 2e-3);
}

TEST(WeightsUsage, SaysInOneLineWhatIsWrong) {
  const Folder folder;
  const std::string points = folder.write("p.csv", stations("x,y,a,b", 2)),
                    queries = folder.write("q.csv", places("x,y", 2)),
                    w = folder / "w.nc";
  const auto fails = [&](const std::vector<std::string>& arguments, int code,
                         const std::string& mend) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(mend), std::string::npos) << outcome.err;
  };
  fails({"weights", points, queries, "-o", w, "--method", "idw"}, 2, "take nearest");
  fails({"weights", points, queries, "-o", w, "--method", "c1", "--bounded"}, 2,
        "leave it out");
  fails({"weights", points, queries, "-o", w, "--method", "smooth"}, 2,
        "give --smooth L");
  fails({"weights", points, queries, "-o", w, "--method", "smooth", "--smooth", "auto"},
        2, "give --smooth L");
  fails({"weights", points, queries, "-o", w, "--method", "c1", "--smooth", "1"}, 2,
        "--method smooth");
  fails({"weights", points, queries, "-o", w, "--tolerance", "1e-3"}, 2, "leave it out");
  fails({"weights", points, queries, "-o", w, "--method", "smooth", "--smooth", "1",
         "--tolerance", "1"},
        2, "0.01");
  fails({"weights", points, queries, "-o", w, "--size", "3/3"}, 2, "TARGETS");
  fails({"weights", points, "-o", w, "--query-x", "x"}, 2, "TARGETS");
  fails({"weights", points, queries, "-o", folder / "w.csv"}, 2, "nc");
  fails({"weights", folder.write("g.csv", stations("lon,lat,a,b", 80)), "--spacing", "30",
         "-o", w, "--method", "c1", "--extrapolate", "linear"},
        2, "take --extrapolate nearest");
  fails({"weights", folder / "none.csv", queries, "-o", w}, 3, "none.csv");
  expect_success(run({"weights", points, queries, "-o", w}));
  fails({"apply", w, queries, "-o", folder / "a.csv"}, 3, "40 data rows");
  fails({"apply", points, points, "-o", folder / "a.csv"}, 3, "p.csv");
  fails({"apply", w, points, "-o", folder / "a.csv", "--value", "none"}, 3, "none");
  fails({"apply", w, points, "-o", folder / "a.csv", "--missing", "guess"}, 2,
        "renormalise");
  std::string moved = stations("x,y,a,b", 2);
  moved.replace(moved.find('\n') + 1, 1, "9");
  fails({"apply", w, folder.write("moved.csv", moved), "-o", folder / "a.csv"}, 3,
        "in the order of the points");
}

}  // namespace
}  // namespace delone::test
