// The smooth surface on real data: no set makes it worse than the linear one, or explode.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "interp/blend_cells.hpp"
#include "interp/c1_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

struct DataSet {
  const char* file;         ///< in the folder of shared data
  std::size_t x, y, value;  ///< columns
};

struct Table {
  std::vector<double> x, y, values;
};

Table read_table(const std::string& path, const DataSet& set) {
  Table table;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    if (fields.size() <= set.value || fields[set.value].empty()) continue;
    table.x.push_back(std::stod(fields[set.x]));
    table.y.push_back(std::stod(fields[set.y]));
    table.values.push_back(std::stod(fields[set.value]));
  }
  return table;
}

template <BlendSpace Space>
void expect_safe(const std::vector<typename Space::Point>& points,
                 const std::vector<double>& values) {
  const auto t = support::triangulated(points);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const BlendCells<Space, 3> cells(t, merged, {}, {});
  EXPECT_LE(cells.fit().left_out_rms, 1.01 * cells.fit().linear_left_out_rms);
  EXPECT_GT(cells.fit().num_tested, 20);
  const double least = *std::ranges::min_element(merged),
               most = *std::ranges::max_element(merged), wider = 0.25 * (most - least);
  // Everywhere: eight places in every triangle, slivers and all.
  support::SplitMix64 random(1);
  t->adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto facet = cells.facet(arc);
    const auto corners = t->adjacency().left(arc);
    const auto corner = [&](std::size_t k) {
      return Space{}.vector(t->points()[at(corners[k])]);
    };
    for (int i = 0; i < 8; ++i) {
      const double s = random.uniform(), u = random.uniform() * (1 - s);
      auto p = corner(0);
      const auto to_b = Space::difference(corner(1), p),
                 to_c = Space::difference(corner(2), p);
      double v = 0;
      if constexpr (std::same_as<Space, PlaneSpace>) {
        v = facet(Point2{p.x + s * to_b.x + u * to_c.x, p.y + s * to_b.y + u * to_c.y});
      } else {
        p = p + s * to_b + u * to_c;
        v = facet((1 / length(p)) * p);
      }
      ASSERT_TRUE(v >= least - wider && v <= most + wider) << v;
    }
  });
}

class C1OnRealData : public testing::TestWithParam<DataSet> {};

TEST_P(C1OnRealData, IsNeverMuchWorseThanLinearAndStaysNearTheData) {
  const DataSet& set = GetParam();
  const std::string path = std::string(DELONE_SHARED_DATA_DIR "/") + set.file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << set.file;
  const Table table = read_table(path, set);
  ASSERT_GT(table.values.size(), 40U);
  if (std::string(set.file).starts_with("plane/")) {
    std::vector<tripack::Point2> points;
    for (std::size_t i = 0; i < table.x.size(); ++i)
      points.push_back({table.x[i], table.y[i]});
    expect_safe<PlaneSpace>(points, table.values);
  } else {
    std::vector<stripack::Direction> points;
    for (std::size_t i = 0; i < table.x.size(); ++i)
      points.push_back(support::at_lonlat(table.x[i], table.y[i]));
    expect_safe<SphereSpace>(points, table.values);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, C1OnRealData,
    testing::Values(DataSet{"sphere/argo_temperature_2016.csv", 0, 1, 3},
                    DataSet{"sphere/jason3_wind_speed.csv", 0, 1, 3},
                    DataSet{"sphere/winter_temperature_1981.csv", 0, 1, 2},
                    DataSet{"sphere/heat_flow_2010.csv", 0, 1, 3},
                    DataSet{"sphere/earthquakes_m55.csv", 0, 1, 2},
                    DataSet{"sphere/southern_africa_gravity.csv", 0, 1, 3},
                    DataSet{"sphere/alps_gps_velocity.csv", 0, 1, 5},
                    DataSet{"sphere/mars_radius_370.csv", 0, 1, 2},
                    DataSet{"sphere/polar_points.csv", 0, 1, 2},
                    DataSet{"truth/geoid_samples_uniform.csv", 0, 1, 2},
                    DataSet{"truth/geoid_samples_clustered.csv", 0, 1, 2},
                    DataSet{"plane/meuse.csv", 0, 1, 5},
                    DataSet{"plane/davis_topo.csv", 0, 1, 2},
                    DataSet{"plane/akima.csv", 0, 1, 2},
                    DataSet{"plane/baja_bathymetry.csv", 0, 1, 2}),
    [](const auto& param_info) {
      return std::filesystem::path(param_info.param.file).stem().string();
    });

}  // namespace
}  // namespace delone::interp
