// --shape, --range and --arc-tension: tension splines over the edges.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

/// A cliff from 0 to 1 with level ground on both sides, in quasi-random points.
std::string cliff_csv(const std::string& header) {
  std::ostringstream text;
  text << header << '\n';
  for (int i = 0; i < 200; ++i) {
    const double x = std::fmod(i * 0.754877666, 1.0), y = std::fmod(i * 0.569840291, 1.0);
    text << x << ',' << y << ',' << std::min(1.0, std::max(0.0, 5 * (x - 0.4))) << '\n';
  }
  return text.str();
}

Outcome grid(const Folder& folder, const std::string& points,
             const std::vector<std::string>& more) {
  std::vector<std::string> all{"grid", points, "-o", folder / "g.csv", "--method", "c1"};
  all.insert(all.end(), more.begin(), more.end());
  return run(all);
}

TEST(ArcTension, SaysHowManyEdgesWereTightened) {
  const Folder folder;
  for (const char* header : {"x,y,z", "lon,lat,z"}) {
    const std::string points = folder.write("p.csv", cliff_csv(header));
    for (const char* shape : {"monotone", "convex"}) {
      const Outcome outcome = grid(folder, points, {"--shape", shape});
      expect_success(outcome);
      EXPECT_NE(outcome.err.find("edges tightened, largest factor "), std::string::npos)
          << outcome.err;
      EXPECT_EQ(outcome.err.find("c1: 0 of"), std::string::npos) << outcome.err;
    }
  }
}

TEST(ArcTension, TightensEveryEdgeByTheFactor) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,0\n1,0,1\n0,1,0\n1,1,3\n");
  const Outcome outcome =
      grid(folder, points, {"--arc-tension", "20", "--extrapolate", "linear"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("c1: 5 of 5 edges tightened, largest factor 20"),
            std::string::npos)
      << outcome.err;
  const Outcome none = grid(folder, points, {"--arc-tension", "0"});
  expect_success(none);
  EXPECT_NE(none.err.find("c1: 0 of 5 edges tightened"), std::string::npos) << none.err;
}

TEST(ArcTension, KeepsSamplesOnAnEdgeInTheRange) {
  const Folder folder;
  const std::string points = folder.write("p.csv", cliff_csv("x,y,z")),
                    queries = folder.write("q.csv", "x,y\n0.5,0.5\n0.2,0.3\n");
  const Outcome outcome = run({"sample", points, queries, "-o", folder / "s.csv",
                               "--method", "c1", "--range", "0/1", "--derivatives"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("gradients shortened to stay in the range"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(lines(folder.read("s.csv")).size(), 3);
  expect_success(grid(folder, points, {"--range", "0/inf"}));
  expect_success(grid(folder, points, {"--range", "-inf/1", "--shape", "convex"}));
}

TEST(ArcTension, ValuesOutsideTheRangeAreNamed) {
  const Folder folder;
  const std::string points = folder.write("p.csv", cliff_csv("x,y,z"));
  expect_failure(grid(folder, points, {"--range", "0.1/1"}), 3,
                 {"p.csv", "outside the range", "widen"});
}

TEST(ArcTension, BadValuesAreRefusedWithTheMend) {
  const Folder folder;
  const std::string points = folder.write("p.csv", cliff_csv("x,y,z"));
  expect_failure(grid(folder, points, {"--shape", "round"}), 2, {"--shape"});
  for (const char* range : {"1", "1/0", "a/b", "0/1/2", "nan/1", "/", "0/"})
    expect_failure(grid(folder, points, {"--range", range}), 2, {"--range", "0/100"});
  for (const char* factor : {"-1", "86", "nan"})
    expect_failure(grid(folder, points, {"--arc-tension", factor}), 2,
                   {"--arc-tension", "0", "85"});
}

TEST(ArcTension, DoesNotGoWithWhatItsSurfaceDoesNotHave) {
  const Folder folder;
  const std::string points = folder.write("p.csv", cliff_csv("x,y,z")),
                    winds =
                        folder.write("w.csv", "lon,lat,u,v\n0,0,1,1\n9,0,1,2\n0,9,1,3\n"),
                    coast = folder.write("c.csv", "ring,x,y\n1,0,0\n1,1,0\n1,1,1\n");
  expect_failure(grid(folder, points, {"--shape", "convex", "--tension", "0.5"}), 2,
                 {"--shape", "--tension"});
  expect_failure(grid(folder, points, {"--range", "0/1", "--bounded"}), 2,
                 {"--range", "--bounded"});
  expect_failure(grid(folder, points, {"--arc-tension", "5", "--fit-degree", "4"}), 2,
                 {"--arc-tension", "--fit-degree 4"});
  expect_failure(
      grid(folder, points, {"--shape", "convex", "--cross-validate", folder / "e.csv"}),
      2, {"--shape", "--cross-validate"});
  expect_failure(grid(folder, points, {"--shape", "convex", "--constraints", coast}), 2,
                 {"--shape", "segments"});
  expect_failure(grid(folder, winds, {"--shape", "convex", "--vector", "u,v"}), 2,
                 {"--shape", "--vector"});
  const std::string globe = folder.write("d.csv", cliff_csv("lon,lat,z"));
  expect_failure(grid(folder, globe, {"--shape", "convex", "--extrapolate", "linear"}), 2,
                 {"--shape", "--extrapolate linear"});
  expect_failure(run({"grid", points, "-o", folder / "g.csv", "--shape", "convex"}), 2,
                 {"--shape", "--method c1", "linear"});
  const std::string queries = folder.write("q.csv", "x,y\n0.5,0.5\n");
  expect_failure(run({"sample", points, queries, "-o", folder / "s.csv", "--method",
                      "idw", "--range", "0/1"}),
                 2, {"--range", "--method c1", "idw"});
  expect_failure(run({"sample", points, queries, "-o", folder / "s.csv", "--method", "c1",
                      "--shape", "monotone", "--cross-validate", folder / "e.csv"}),
                 2, {"--shape", "--cross-validate"});
}

TEST(ArcTension, HelpNamesTheOptions) {
  for (const char* command : {"grid", "sample"}) {
    const Outcome outcome = run({command, "--help"});
    for (const char* option : {"--shape", "--range", "--arc-tension"})
      EXPECT_NE(outcome.out.find(option), std::string::npos) << command;
  }
}

}  // namespace
}  // namespace delone::test
