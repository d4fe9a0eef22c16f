// Arguments, help, version, exit code 2.

#include <gtest/gtest.h>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::vector<std::string> subcommands{"grid",   "sample",  "triangulate", "hull",
                                           "locate", "nearest", "check",       "info",
                                           "plot",   "block",   "voronoi"};

TEST(Usage, VersionIsTheProjects) {
  const Outcome outcome = run({"--version"});
  expect_success(outcome);
  EXPECT_EQ(outcome.out, "delone " DELONE_VERSION "\n");
}

TEST(Usage, HelpNamesEverySubcommand) {
  const Outcome outcome = run({"--help"});
  expect_success(outcome);
  for (const std::string& name : subcommands)
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
}

TEST(Usage, HelpOfEverySubcommandHasAnExampleOfIt) {
  for (const std::string& name : subcommands) {
    const Outcome outcome = run({name, "--help"});
    expect_success(outcome);
    EXPECT_NE(outcome.out.find("Example:\n  delone " + name + " "), std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
}

class WrongUsage : public testing::TestWithParam<std::vector<std::string>> {};

// The first word is what the message must name, the others are the arguments. The file
// exists, so that nothing but the arguments is wrong.
TEST_P(WrongUsage, EndsWithCode2AndNamesTheOption) {
  const Folder folder;
  folder.write("p.csv", scattered_csv(20));
  folder.write("lonlat.csv", scattered_csv(20, 1, "lon,lat,value"));
  std::vector<std::string> arguments = GetParam();
  const std::string named = arguments.front();
  arguments.erase(arguments.begin());
  const auto before = folder.names();
  expect_failure(run(arguments, {.working_folder = folder / ""}), 2, {named});
  EXPECT_EQ(folder.names(), before);
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongUsage,
    testing::Values(
        std::vector<std::string>{"subcommand"},
        std::vector<std::string>{"krige", "krige", "p.csv", "-o", "x.csv"},
        std::vector<std::string>{"--nonsense", "grid", "p.csv", "-o", "x.nc",
                                 "--nonsense"},
        std::vector<std::string>{"--output", "grid", "p.csv"},
        std::vector<std::string>{"POINTS", "grid", "-o", "x.nc"},
        std::vector<std::string>{"x.foo", "grid", "p.csv", "-o", "x.foo"},
        std::vector<std::string>{"nc, csv, asc, png", "grid", "p.csv", "-o", "x.tif"},
        std::vector<std::string>{"--format", "grid", "p.csv", "-o", "x.nc", "--format",
                                 "gif"},
        std::vector<std::string>{"--method", "grid", "p.csv", "-o", "x.nc", "--method",
                                 "kriging"},
        std::vector<std::string>{"--region", "grid", "p.csv", "-o", "x.nc", "--region",
                                 "0/1/0"},
        std::vector<std::string>{"--region", "grid", "p.csv", "-o", "x.nc", "--region",
                                 "0/1/0/north"},
        std::vector<std::string>{"region", "grid", "p.csv", "-o", "x.nc", "--region",
                                 "1/0/0/1"},
        std::vector<std::string>{"--spacing", "grid", "p.csv", "-o", "x.nc", "--spacing",
                                 "1/2/3"},
        std::vector<std::string>{"--spacing", "grid", "p.csv", "-o", "x.nc", "--spacing",
                                 "inf"},
        std::vector<std::string>{"spacing", "grid", "p.csv", "-o", "x.nc", "--spacing",
                                 "0"},
        std::vector<std::string>{"spacing", "grid", "p.csv", "-o", "x.nc", "--spacing",
                                 "-1"},
        std::vector<std::string>{"nodes", "grid", "p.csv", "-o", "x.nc", "--spacing",
                                 "1e-300"},
        std::vector<std::string>{"--size", "grid", "p.csv", "-o", "x.nc", "--size",
                                 "10.5/10"},
        std::vector<std::string>{"--size", "grid", "p.csv", "-o", "x.nc", "--size",
                                 "0/10"},
        std::vector<std::string>{"--size", "grid", "p.csv", "-o", "x.nc", "--size", "9/9",
                                 "--spacing", "1"},
        std::vector<std::string>{"latitude", "grid", "lonlat.csv", "-o", "x.nc",
                                 "--region", "0/9/0/91"},
        std::vector<std::string>{"--extrapolate", "grid", "lonlat.csv", "-o", "x.nc",
                                 "--extrapolate", "linear"},
        std::vector<std::string>{"--max-distance", "grid", "p.csv", "-o", "x.nc",
                                 "--max-distance", "-1"},
        std::vector<std::string>{"--max-distance", "grid", "p.csv", "-o", "x.nc",
                                 "--max-distance", "nan"},
        std::vector<std::string>{"--on", "grid", "p.csv", "-o", "x.nc", "--on", "torus"},
        std::vector<std::string>{"--duplicates", "grid", "p.csv", "-o", "x.nc",
                                 "--duplicates", "sum"},
        std::vector<std::string>{"--threads", "grid", "p.csv", "-o", "x.nc", "--threads",
                                 "0"},
        std::vector<std::string>{"--threads", "grid", "p.csv", "-o", "x.nc", "--threads",
                                 "two"},
        std::vector<std::string>{"overwrite", "grid", "p.csv", "-o", "p.csv"},
        std::vector<std::string>{"standard input", "sample", "-", "-", "-o", "x.csv"},
        std::vector<std::string>{"--base", "triangulate", "p.csv", "-o", "x.tri",
                                 "--base", "2"},
        std::vector<std::string>{"--neighbors", "triangulate", "p.csv", "-o", "x.tri",
                                 "--neighbors"},
        std::vector<std::string>{"TRIANGLES", "check", "p.csv"},
        std::vector<std::string>{"svg", "plot", "x.nc", "-o", "x.gif"}));

}  // namespace
}  // namespace delone::test
