// Weight files as other programs read them: CDO and NCO, where they are installed.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "cli/process.hpp"

namespace delone::test {
namespace {

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

int shell(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str());
}

double field_at(double lon, double lat) {
  const double degree = std::acos(-1.0) / 180;
  return std::sin(lon * degree) * std::cos(lat * degree) + lat / 90;
}

// The points of a grid of 12 x 9 cells over the globe, row by row from the south.
struct Source {
  std::string table = "lon,lat,v\n", values;
};
Source source_grid() {
  Source source;
  std::ostringstream table, values;
  table.precision(17);
  values.precision(17);
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 12; ++i) {
      const double lon = 30 * i, lat = -80 + 20 * j, v = field_at(lon, lat);
      table << lon << ',' << lat << ',' << v << '\n';
      values << v << '\n';
    }
  }
  source.table += table.str();
  source.values = values.str();
  return source;
}

const std::string source_description =
    "gridtype = lonlat\nxsize = 12\nysize = 9\nxfirst = 0\nxinc = 30\nyfirst = -80\n"
    "yinc = 20\n";
const std::string target_description =
    "gridtype = lonlat\nxsize = 8\nysize = 5\nxfirst = -170\nxinc = 40\nyfirst = -70\n"
    "yinc = 35\n";

std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  std::istringstream stream(text);
  for (double v = 0; stream >> v;) result.push_back(v);
  return result;
}

std::vector<double> last_column(const std::string& csv) {
  std::vector<double> result;
  const std::vector<std::string> rows = lines(csv);
  for (std::size_t i = 1; i < rows.size(); ++i)
    result.push_back(std::stod(rows[i].substr(rows[i].rfind(',') + 1)));
  return result;
}

class WeightsPeers : public testing::TestWithParam<std::string> {
 protected:
  // Weights and their values at the targets by delone apply.
  std::vector<double> applied(const Folder& folder, const std::string& layout) {
    const Source source = source_grid();
    const std::string points = folder.write("p.csv", source.table);
    folder.write("v.txt", source.values);
    folder.write("source.grid", source_description);
    folder.write("target.grid", target_description);
    expect_success(
        run({"weights", points, "-o", folder / "w.nc", "--method", GetParam(), "--region",
             "-170/110/-70/70", "--size", "8/5", "--layout", layout}));
    expect_success(run({"apply", folder / "w.nc", points, "-o", folder / "a.csv"}));
    return last_column(folder.read("a.csv"));
  }
};

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 4e-15) << i;
}

TEST_P(WeightsPeers, CdoAppliesThemToTheSameValues) {
  if (!is_installed("cdo")) GTEST_SKIP() << "cdo is not installed";
  const Folder folder;
  const std::vector<double> wanted = applied(folder, "scrip");
  ASSERT_EQ(wanted.size(), 40u);
  const std::string field = folder / "f.nc", output = folder / "out.nc";
  ASSERT_EQ(shell("cdo -s -f nc -b F64 input," + (folder / "source.grid") + " " + field +
                  " < " + (folder / "v.txt")),
            0);
  for (const std::string& source : {field, "-setgridtype,unstructured " + field}) {
    ASSERT_EQ(shell("cdo -s -b F64 remap," + (folder / "target.grid") + "," +
                    (folder / "w.nc") + " " + source + " " + output),
              0);
    ASSERT_EQ(
        std::system(
            ("cdo -s outputf,%.17g,1 " + output + " > " + (folder / "out.txt")).c_str()),
        0);
    expect_near(numbers(folder.read("out.txt")), wanted);
  }
}

TEST_P(WeightsPeers, NcoAppliesThemToTheSameValues) {
  if (!is_installed("ncks") || !is_installed("ncgen") || !is_installed("ncdump"))
    GTEST_SKIP() << "ncks (NCO), ncgen or ncdump is not installed";
  for (const std::string layout : {"esmf", "scrip"}) {
    const Folder folder;
    const std::vector<double> wanted = applied(folder, layout);
    std::string values = source_grid().values;
    for (char& c : values)
      if (c == '\n') c = ',';
    values.back() = ';';
    const std::string text = folder.write(
        "f.cdl",
        "netcdf f { dimensions: ncol = 108; variables: double v(ncol); data: "
        "v = " +
            values + " }");
    const std::string field = folder / "f.nc", output = folder / "out.nc";
    ASSERT_EQ(shell("ncgen -o " + field + " " + text), 0);
    ASSERT_EQ(
        shell("ncks -O -t 1 --map=" + (folder / "w.nc") + " " + field + " " + output), 0);
    ASSERT_EQ(
        std::system(("ncdump -p 9,17 -v v " + output +
                     " | sed -e '1,/^ v =/d' -e 's/[,;}]/ /g' > " + (folder / "out.txt"))
                        .c_str()),
        0);
    expect_near(numbers(folder.read("out.txt")), wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, WeightsPeers,
                         testing::Values("nearest", "linear", "natural", "c1"));

TEST(WeightsLayouts, ScripIsOfTheGlobeAndIsReadBack) {
  const Folder folder;
  const std::string plane = folder.write("p.csv", "x,y,v\n0,0,1\n1,0,2\n0,1,3\n");
  const Outcome refused =
      run({"weights", plane, "-o", folder / "w.nc", "--layout", "scrip"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("leave it out"), std::string::npos) << refused.err;
  const std::string globe = folder.write("g.csv", source_grid().table);
  std::string applied;
  for (const std::string layout : {"esmf", "scrip"}) {
    expect_success(run({"weights", globe, "-o", folder / "w.nc", "--layout", layout,
                        "--method", "natural", "--spacing", "45"}));
    expect_success(run({"apply", folder / "w.nc", globe, "-o", folder / "a.csv"}));
    if (applied.empty()) applied = folder.read("a.csv");
    EXPECT_EQ(folder.read("a.csv"), applied);
  }
}

}  // namespace
}  // namespace delone::test
