#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/grid_file.hpp"

namespace delone::test {

using Doubles = std::vector<double>;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// 3 x 2 nodes at x 10, 10.5, 11 and y -1, 0; one is missing.
inline io::GridFile small_grid() {
  io::GridFile grid;
  grid.field.grid.x = {.spacing = 0.5, .first_step = 20, .size = 3};
  grid.field.grid.y = {.spacing = 1, .first_step = -1, .size = 2};
  grid.field.values = {1, 2.5, -3, 0.1, nan, 1e10};
  grid.info.name = "geoid_m";
  grid.info.units = "m";
  grid.info.is_lonlat = true;
  return grid;
}

inline void expect_same_values(const Doubles& a, const Doubles& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]))
      EXPECT_TRUE(std::isnan(b[i])) << i;
    else
      EXPECT_EQ(a[i], b[i]) << i;
  }
}

inline Doubles coordinates(const interp::Axis& axis) {
  Doubles result;
  for (std::int64_t i = 0; i < axis.size; ++i) result.push_back(axis.coordinate(i));
  return result;
}

/// A NetCDF file made with the library, step by step, as strange as need be.
class NetcdfMaker {
 public:
  explicit NetcdfMaker(const std::string& path, int mode = NC_CLOBBER) {
    ok(nc_create(path.c_str(), mode, &id_));
  }
  ~NetcdfMaker() { EXPECT_EQ(nc_close(id_), NC_NOERR); }
  NetcdfMaker(const NetcdfMaker&) = delete;
  NetcdfMaker& operator=(const NetcdfMaker&) = delete;

  int dimension(const char* name, std::size_t size) {
    int result = 0;
    ok(nc_def_dim(id_, name, size, &result));
    return result;
  }
  int variable(const char* name, const std::vector<int>& dims, nc_type type = NC_DOUBLE) {
    int result = 0;
    ok(nc_def_var(id_, name, type, static_cast<int>(dims.size()), dims.data(), &result));
    return result;
  }
  void text(int variable, const char* name, const std::string& value) {
    ok(nc_put_att_text(id_, variable, name, value.size(), value.data()));
  }
  void number(int variable, const char* name, double value, nc_type type = NC_DOUBLE) {
    ok(nc_put_att_double(id_, variable, name, type, 1, &value));
  }
  /// Fills a variable; the first call ends the definitions.
  void put(int variable, const Doubles& values) {
    if (!is_defined_) ok(nc_enddef(id_));
    is_defined_ = true;
    ok(nc_put_var_double(id_, variable, values.data()));
  }

 private:
  static void ok(int status) { ASSERT_EQ(status, NC_NOERR) << nc_strerror(status); }
  int id_ = 0;
  bool is_defined_ = false;
};

}  // namespace delone::test
