// Options of grid and sample that do not go together: none is ignored silently.

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/process.hpp"

namespace delone::test {
namespace {

using Words = std::vector<std::string>;

/// Arguments and what the message must name besides the exit code 2.
struct Pair {
  Words arguments;
  Words named;
};

class OptionPairs : public testing::Test {
 protected:
  OptionPairs() {
    folder_.write("p.csv", scattered_csv(20));
    folder_.write("q.csv", "x,y\n0.5,0.5\n");
    folder_.write("lonlat.csv", scattered_csv(20, 1, "lon,lat,value"));
    folder_.write("c.csv", "ring,x,y\n1,0,0\n1,1,0\n1,1,1\n1,0,1\n");
    folder_.write("d.poly",
                  "4 2 1 0\n0 0 0 1\n1 1 0 2\n2 1 1 3\n3 0 1 4\n"
                  "4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  }

  void expect_refused(Words arguments, const Words& named) {
    const auto before = folder_.names();
    const Outcome outcome = run(arguments, {.working_folder = folder_ / ""});
    expect_failure(outcome, 2, named);
    EXPECT_EQ(folder_.names(), before);
  }
  /// With grid and with sample.
  void expect_refused_twice(const std::string& points, const Pair& pair) {
    Words grid{"grid", points, "-o", "x.nc"},
        sample{"sample", points, "q.csv", "-o", "x.csv"};
    for (Words* const words : {&grid, &sample})
      words->insert(words->end(), pair.arguments.begin(), pair.arguments.end());
    expect_refused(grid, pair.named);
    expect_refused(sample, pair.named);
  }
  Outcome run_in_folder(const Words& arguments) {
    return run(arguments, {.working_folder = folder_ / ""});
  }

  const Folder folder_;
};

const std::vector<std::string> methods{"linear",  "nearest",    "c1",
                                       "natural", "natural-c1", "idw",
                                       "shepard", "rbf",        "smooth"};

const std::vector<Words> options_of_c1{
    {"--gradients", "auto"}, {"--tension", "0"}, {"--bounded"}, {"--fit-degree", "3"}};

TEST_F(OptionPairs, WhatIsForC1IsRefusedWithLinear) {
  for (const Words& option : options_of_c1)
    expect_refused_twice("p.csv", {option, {option[0], "--method c1", "linear"}});
}

TEST_F(OptionPairs, WhatIsForC1IsRefusedWithEveryOtherMethod) {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (methods[k] == "c1") continue;
    const Words& option = options_of_c1[k % options_of_c1.size()];
    Words arguments{"grid", "p.csv", "-o", "x.nc", "--method", methods[k]};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_refused(arguments, {option[0], "--method c1", methods[k]});
  }
}

TEST_F(OptionPairs, WhatIsForSmoothIsRefusedWithEveryOtherMethod) {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (methods[k] == "smooth") continue;
    const Words option =
        k % 2 == 0 ? Words{"--smooth", "auto"} : Words{"--errors", "value"};
    Words arguments{"sample", "p.csv", "q.csv", "-o", "x.csv", "--method", methods[k]};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_refused(arguments, {option[0], "--method smooth", methods[k]});
  }
}

TEST_F(OptionPairs, WithSegmentsOnlyWhatDoesNotLookAcrossThem) {
  for (const std::string& method : methods) {
    if (method == "c1" || method == "linear") continue;
    expect_refused_twice("p.csv", {{"--constraints", "c.csv", "--method", method},
                                   {"--method " + method, "linear or c1"}});
  }
  const std::vector<Pair> pairs{
      {{"--errors", "value"}, {"--errors", "across segments"}},
      {{"--smooth", "1"}, {"--smooth", "across segments"}},
      {{"--extrapolate", "nearest"}, {"--extrapolate", "segments"}},
      {{"--extrapolate", "linear"}, {"--extrapolate", "segments"}},
      {{"--cross-validate", "l.csv"}, {"--cross-validate", "segments"}},
      {{"--bounded"}, {"--bounded", "c1"}},
      {{"--tension", "0.5"}, {"--tension", "c1"}},
      {{"--gradients", "local"}, {"--gradients", "c1"}},
      {{"--fit-degree", "4"}, {"--fit-degree", "c1"}},
      {{"--method", "c1", "--errors", "value"}, {"--errors", "across segments"}},
      {{"--method", "c1", "--gradients", "global"}, {"global", "across segments"}}};
  for (Pair pair : pairs) {
    pair.arguments.insert(pair.arguments.begin(), {"--constraints", "c.csv"});
    expect_refused_twice("p.csv", pair);
  }
}

TEST_F(OptionPairs, PolyFilesTakeNoOptionsOfTables) {
  for (const Pair& pair :
       {Pair{{"--x", "1"}, {"--x", ".poly"}}, Pair{{"--y", "2"}, {"--y", ".poly"}},
        Pair{{"--skip-bad-rows"}, {"--skip-bad-rows", ".poly"}},
        Pair{{"--merge-within", "0.1"}, {"--merge-within", ".poly"}},
        Pair{{"--errors", "2"}, {"--errors"}}})
    expect_refused_twice("d.poly", pair);
  expect_success(run_in_folder({"grid", "d.poly", "-o", "x.nc"}));
}

TEST_F(OptionPairs, VectorsTakeWhatHasThemOnly) {
  for (const char* const method : {"nearest", "idw", "shepard", "rbf", "smooth"})
    expect_refused_twice("lonlat.csv", {{"--vector", "value,value", "--method", method},
                                        {"--vector", "linear, c1"}});
  for (const Pair& pair :
       {Pair{{"--value", "value"}, {"--vector", "--value"}},
        Pair{{"--errors", "value"}, {"--vector", "--errors"}},
        Pair{{"--smooth", "1"}, {"--smooth"}},
        Pair{{"--tension", "0"}, {"--tension", "c1"}},
        Pair{{"--constraints", "c.csv"}, {"--vector", "segments"}},
        Pair{{"--cross-validate", "l.csv"}, {"--vector", "--cross-validate"}},
        Pair{{"--duplicates", "median"}, {"--vector", "median"}}}) {
    Pair both = pair;
    both.arguments.insert(both.arguments.begin(), {"--vector", "value,value"});
    expect_refused_twice("lonlat.csv", both);
  }
  expect_refused({"sample", "lonlat.csv", "q.csv", "-o", "x.csv", "--vector",
                  "value,value", "--gradient"},
                 {"--gradient", "--derivatives"});
  expect_refused(
      {"grid", "lonlat.csv", "-o", "x.nc", "--vector", "value,value", "--map", "x.png"},
      {"--map", "--vector"});
}

TEST_F(OptionPairs, WhatNeedsSomethingElseSaysSo) {
  for (const Pair& pair :
       {Pair{{"--keep-outside"}, {"--keep-outside"}},
        Pair{{"--split-intersections"}, {"--split-intersections"}},
        Pair{{"--method", "smooth", "--smooth", "errors"}, {"--errors COLUMN"}},
        Pair{{"--method", "nearest", "--extrapolate", "linear"}, {"--extrapolate"}}})
    expect_refused_twice("p.csv", pair);
  expect_refused({"grid", "p.csv", "-o", "x.nc", "--points"}, {"--points", "--map"});
  expect_refused({"grid", "p.csv", "-o", "x.asc", "--derivatives"}, {"--derivatives"});
}

TEST_F(OptionPairs, EveryMethodTakesWhatAllTake) {
  for (const std::string& method : methods) {
    const Outcome outcome =
        run_in_folder({"grid", "p.csv", "-o", "x.nc", "--size", "5/5", "--method", method,
                       "--max-distance", "0.5", "--extrapolate", "nearest",
                       "--derivatives", "--cross-validate", "l.csv"});
    EXPECT_EQ(outcome.exit_code, 0) << method << outcome.err;
  }
}

}  // namespace
}  // namespace delone::test
