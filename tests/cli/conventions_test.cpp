// What cli.md promises of every subcommand: tables, columns, messages, timings, threads,
// order.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <regex>

#include "cli/process.hpp"

namespace delone::test {
namespace {

const std::string rows = "0,0,1\n4,0,9\n4,4,-3\n0,4,-11\n";

/// Grids a table and returns the CSV grid; `more` are further arguments.
std::string gridded(const std::string& table, std::vector<std::string> more = {}) {
  const Folder folder;
  std::vector<std::string> arguments{
      "grid", folder.write("p.csv", table), "-o", folder / "g.csv", "--spacing", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  expect_success(run(arguments));
  return folder.read("g.csv");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;
       at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(Table, EveryLayoutGivesTheSameGrid) {
  const std::string expected = gridded("x,y,z\n" + rows);
  const std::string tabbed = "x\ty\tz\n" + replaced(rows, ",", "\t");
  EXPECT_EQ(gridded("\xEF\xBB\xBFx,y,z\r\n" + replaced(rows, "\n", "\r\n")), expected);
  EXPECT_EQ(gridded(tabbed), expected);
  EXPECT_EQ(gridded("x y z\n" + replaced(rows, ",", "   ")), expected);
  EXPECT_EQ(gridded("x;y;z\n" + replaced(rows, ",", ";")), expected);
  EXPECT_EQ(gridded("# a comment\nx,y,z\n" + replaced(rows, "\n", "\n# another\n\n")),
            expected);
  EXPECT_EQ(gridded("\"x\",\"y\",\"z\"\n" + replaced(rows, "4,4,", "\"4\",\"4\",")),
            expected);
  EXPECT_EQ(gridded("x,y,z\n" + rows.substr(0, rows.size() - 1)), expected);
  EXPECT_EQ(gridded("z,y,x\n1,0,0\n9,0,4\n-3,4,4\n-11,4,0\n"), expected);
}

TEST(Table, WithoutAHeaderTakesTheFirstThreeColumns) {
  const auto expected = lines(gridded("x,y,z\n" + rows));
  const auto actual = lines(gridded(rows));
  EXPECT_TRUE(
      std::equal(actual.begin() + 1, actual.end(), expected.begin() + 1, expected.end()));
}

TEST(Table, StandardInputIsADash) {
  const Folder folder;
  const std::string out = folder / "g.csv";
  const Outcome outcome =
      run({"grid", "-", "-o", out, "--spacing", "1"}, {.input = "x,y,z\n" + rows});
  expect_success(outcome);
  EXPECT_EQ(folder.read("g.csv"), gridded("x,y,z\n" + rows));
  EXPECT_NE(outcome.err.find("standard input"), std::string::npos);
  expect_failure(run({"grid", "-", "-o", out}, {.input = "x,y,z\n1,2,oops\n"}), 3,
                 {"standard input"});
}

TEST(Columns, AreChosenByNameOrNumber) {
  const std::string expected = gridded("x,y,z\n" + rows);
  const std::string table = "id,z,east,north\n7,1,0,0\n8,9,4,0\n9,-3,4,4\n6,-11,0,4\n";
  const auto same_numbers = [&](const std::string& actual) {
    const auto a = lines(actual), e = lines(expected);
    return std::equal(a.begin() + 1, a.end(), e.begin() + 1, e.end());
  };
  EXPECT_TRUE(
      same_numbers(gridded(table, {"--x", "east", "--y", "north", "--value", "z"})));
  EXPECT_TRUE(same_numbers(gridded(table, {"--x", "3", "--y", "4", "--value", "2"})));
}

TEST(Columns, ChosenOnesAreSaidInOneLine) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "time,lon,lat,temp_c\n1,0,0,1\n1,9,0,1\n1,0,9,1\n");
  const Outcome outcome =
      run({"grid", points, "--value", "temp_c", "-o", folder / "g.nc"});
  expect_success(outcome);
  const auto said = lines(outcome.err);
  const auto names_all = [](const std::string& line) {
    return line.find("'lon'") != std::string::npos &&
           line.find("'lat'") != std::string::npos &&
           line.find("'temp_c'") != std::string::npos &&
           line.find("sphere") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(said, names_all), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Domain, FollowsTheNamesOfTheColumnsUnlessSaid) {
  const Folder folder;
  const auto domain = [&](const std::string& header, std::vector<std::string> more = {}) {
    more.insert(more.begin(),
                {"info", folder.write("p.csv", scattered_csv(9, 1, header)), "--json"});
    const Outcome outcome = run(more);
    expect_success(outcome);
    std::smatch match;
    std::regex_search(outcome.out, match, std::regex(R"re("on":"(\w+)")re"));
    return match[1].str();
  };
  EXPECT_EQ(domain("lon,lat,v"), "sphere");
  EXPECT_EQ(domain("Longitude,Latitude,v"), "sphere");
  EXPECT_EQ(domain("x,y,v"), "plane");
  EXPECT_EQ(domain("lon,lat,v", {"--on", "plane"}), "plane");
  EXPECT_EQ(domain("x,y,v", {"--on", "ellipsoid"}), "ellipsoid");
}

TEST(Domain, LongitudesMayWrapEitherWay) {
  const Folder folder;
  const auto triangles = [&](const std::string& lon) {
    const std::string points = folder.write(
        "p.csv", "lon,lat\n" + lon + ",0\n10,0\n0,10\n180,80\n0,-90\n77,-90\n");
    expect_success(run({"triangulate", points, "-o", folder / "t.tri"}));
    return folder.read("t.tri");
  };
  EXPECT_EQ(triangles("-170"), triangles("190"));
  EXPECT_EQ(triangles("-170"), triangles("550"));
}

TEST(MissingValues, AreDroppedAndCounted) {
  const Folder folder;
  const std::string with_gaps =
      "x,y,z\n0,0,1\n1,1,nan\n4,0,9\n1,2,NaN\n1,3,NA\n2,2,\n4,4,-3\n2,1,inf\n0,4,-11\n";
  const Outcome outcome = run({"grid", folder.write("p.csv", with_gaps), "-o",
                               folder / "g.csv", "--spacing", "1"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("4 points"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("5 with missing values dropped"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(folder.read("g.csv"), gridded("x,y,z\n" + rows));
}

TEST(BadRows, AreSkippedAndCountedOnRequest) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n" + rows + "1,1,oops\n1,2\n");
  const Outcome outcome =
      run({"grid", points, "-o", folder / "g.csv", "--spacing", "1", "--skip-bad-rows"});
  expect_success(outcome);
  EXPECT_NE(outcome.err.find("2 bad rows skipped"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.read("g.csv"), gridded("x,y,z\n" + rows));
}

TEST(Duplicates, AreCombinedAsAskedCountedAndSaid) {
  const Folder folder;
  const std::string points =
      folder.write("p.csv", "x,y,z\n0,0,6\n1,0,0\n0,1,0\n0,0,1\n0,0,2\n0,0,3\n");
  const std::string queries = folder.write("q.csv", "x,y\n0,0\n");
  const auto value = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"sample", points, queries, "-o", folder / "s.csv"});
    const Outcome outcome = run(more);
    expect_success(outcome);
    EXPECT_NE(outcome.err.find("3 rows repeat"), std::string::npos) << outcome.err;
    return folder.read("s.csv");
  };
  EXPECT_EQ(value({}), "x,y,z\n0,0,3\n");
  EXPECT_EQ(value({"--duplicates", "mean"}), "x,y,z\n0,0,3\n");
  EXPECT_EQ(value({"--duplicates", "median"}), "x,y,z\n0,0,2.5\n");
  EXPECT_EQ(value({"--duplicates", "first"}), "x,y,z\n0,0,6\n");
  EXPECT_EQ(value({"--duplicates", "last"}), "x,y,z\n0,0,3\n");
  EXPECT_EQ(value({"--duplicates", "min"}), "x,y,z\n0,0,1\n");
  EXPECT_EQ(value({"--duplicates", "max"}), "x,y,z\n0,0,6\n");
}

TEST(Quiet, SaysNothing) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n" + rows + "0,0,5\n1,1,nan\n");
  const std::string queries = folder.write("q.csv", "x,y\n1,1\n9,9\n");
  const std::vector<std::vector<std::string>> runs{
      {"grid", points, "-o", folder / "g.nc"},
      {"sample", points, queries, "-o", folder / "s.csv"},
      {"triangulate", points, "-o", folder / "t.tri"},
      {"check", points, folder / "t.tri"},
      {"hull", points},
      {"locate", points, queries},
      {"nearest", points, queries},
      {"info", points},
      {"plot", folder / "g.nc", "-o", folder / "g.png"}};
  for (std::vector<std::string> arguments : runs) {
    EXPECT_NE(run(arguments).err, "") << arguments[0];
    arguments.push_back("--quiet");
    const Outcome outcome = run(arguments);
    expect_success(outcome);
    EXPECT_EQ(outcome.err, "") << arguments[0];
  }
}

TEST(Quiet, DoesNotSilenceErrors) {
  expect_failure(run({"grid", "none.csv", "-o", "x.nc", "--quiet"}), 3, {"none.csv"});
}

TEST(Progress, StaysOffWhereThereIsNoTerminal) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(1000));
  const Outcome outcome = run({"grid", points, "-o", folder / "g.nc"});
  EXPECT_EQ(outcome.err.find_first_of("\r\x1b"), std::string::npos);
}

/// The members of a flat JSON object of numbers; empty if `text` is anything else.
std::map<std::string, double> flat_json(const std::string& text) {
  const std::regex object(R"re(\{("\w+":[0-9.]+(e-?\d+)?,)*"\w+":[0-9.]+\})re");
  std::map<std::string, double> members;
  if (!std::regex_match(text, object)) return members;
  const std::regex member(R"re("(\w+)":([0-9.e-]+))re");
  for (std::sregex_iterator it(text.begin(), text.end(), member), end; it != end; ++it) {
    members[(*it)[1]] = std::stod((*it)[2]);
  }
  return members;
}

std::vector<std::string> keys(const std::map<std::string, double>& members) {
  std::vector<std::string> result;
  for (const auto& [key, value] : members) result.push_back(key);
  return result;
}

TEST(Timings, AreTheLastLineAndHaveTheirFields) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(1000));
  const Outcome outcome =
      run({"grid", points, "-o", folder / "g.nc", "--timings", "--threads", "2"});
  expect_success(outcome);
  const auto members = flat_json(lines(outcome.err).back());
  EXPECT_EQ(keys(members),
            (std::vector<std::string>{"build", "evaluate", "fit", "peak_bytes", "points",
                                      "read", "threads", "total", "write"}));
  EXPECT_EQ(members.at("points"), 1000);
  EXPECT_EQ(members.at("threads"), 2);
  EXPECT_GT(members.at("peak_bytes"), 1e6);
  const double phases = members.at("read") + members.at("build") + members.at("fit") +
                        members.at("evaluate") + members.at("write");
  EXPECT_GT(phases, 0);
  EXPECT_LE(phases, members.at("total"));
}

TEST(Timings, LeaveOutPhasesThatDidNotHappen) {
  const Folder folder;
  const std::string points = folder.write("p.csv", scattered_csv(100));
  const Outcome outcome =
      run({"triangulate", points, "-o", folder / "t.tri", "--timings", "--quiet"});
  expect_success(outcome);
  EXPECT_EQ(keys(flat_json(outcome.err.substr(0, outcome.err.find('\n')))),
            (std::vector<std::string>{"build", "peak_bytes", "points", "read", "threads",
                                      "total", "write"}));
  EXPECT_EQ(lines(outcome.err).size(), 1U);
}

TEST(Threads, DoNotChangeABit) {
  const Folder folder;
  for (const std::string header : {"x,y,v", "lon,lat,v"}) {
    const std::string points = folder.write("p.csv", scattered_csv(3000, 5, header));
    const std::string queries = folder.write("q.csv", scattered_csv(3000, 6, header));
    const auto results = [&](const std::string& threads) {
      expect_success(run({"grid", points, "-o", folder / "g.nc", "--threads", threads}));
      expect_success(
          run({"triangulate", points, "-o", folder / "t.adj", "--threads", threads}));
      expect_success(run({"sample", points, queries, "-o", folder / "s.csv", "--gradient",
                          "--threads", threads}));
      return folder.read("g.nc") + folder.read("t.adj") + folder.read("s.csv");
    };
    const std::string with_one = results("1");
    EXPECT_EQ(results("2"), with_one) << header;
    EXPECT_EQ(results("7"), with_one) << header;
  }
}

TEST(RowOrder, DoesNotChangeABitOfAGrid) {
  const Folder folder;
  for (const std::string header : {"x,y,v", "lon,lat,v"}) {
    // Each row twice with different values, so that combining repeats is part of it.
    std::vector<std::string> table = lines(scattered_csv(1500, 5, header));
    for (std::size_t i = 1; i < 1501; ++i) {
      table.push_back(table[i].substr(0, table[i].rfind(',')) + "," +
                      std::to_string(0.1 * static_cast<double>(i)));
    }
    const auto grid_of = [&] {
      std::string text;
      for (const std::string& row : table) text += row + "\n";
      expect_success(run({"grid", folder.write("p.csv", text), "-o", folder / "g.nc"}));
      return folder.read("g.nc");
    };
    const std::string in_order = grid_of();
    std::ranges::shuffle(table.begin() + 1, table.end(), std::mt19937(11));
    EXPECT_EQ(grid_of(), in_order) << header;
  }
}

TEST(Output, ReplacesAnEarlierFileAndLeavesNothingElse) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n" + rows);
  folder.write("g.csv", "earlier");
  expect_success(run({"grid", points, "-o", folder / "g.csv"}));
  EXPECT_TRUE(folder.read("g.csv").starts_with("x,y,z\n"));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"g.csv", "p.csv"}));
}

TEST(Output, FailedRunLeavesTheEarlierFile) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n0,0,1\n1,1,2\n2,2,3\n");
  folder.write("g.csv", "earlier");
  expect_failure(run({"grid", points, "-o", folder / "g.csv"}), 3, {"p.csv"});
  EXPECT_EQ(folder.read("g.csv"), "earlier");
}

TEST(Output, DashIsStandardOutput) {
  const Folder folder;
  const std::string points = folder.write("p.csv", "x,y,z\n" + rows);
  const Outcome outcome =
      run({"grid", points, "-o", "-", "--format", "csv", "--spacing", "1"});
  expect_success(outcome);
  EXPECT_EQ(outcome.out, gridded("x,y,z\n" + rows));
}

}  // namespace
}  // namespace delone::test
