#pragma once

#include <netcdf.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/output_file.hpp"

namespace delone::io {

/// A NetCDF file (classic format, 64-bit offsets) that the library builds in memory: so
/// it reaches devices and pipes too, and OutputFile sees every failure of the disk.
/// Throws WriteError where the library reports an error. Internal: includes netcdf.h.
class NetcdfImage {
 public:
  explicit NetcdfImage(std::string path);
  ~NetcdfImage();
  NetcdfImage(const NetcdfImage&) = delete;
  NetcdfImage& operator=(const NetcdfImage&) = delete;

  int add_dimension(const char* name, std::int64_t size);
  int add_variable(const std::string& name, const std::vector<int>& dimensions,
                   nc_type type = NC_DOUBLE);
  /// Attributes with nothing to say are left out.
  void add_text(int variable, const char* name, std::string_view text);
  void add_number(int variable, const char* name, std::int32_t number);
  void add_fill_value(int variable, double value);
  void add_fill_value(int variable, std::int32_t value);
  void end_definitions();
  void put(int variable, const std::vector<double>& values);
  void put(int variable, const std::vector<std::int32_t>& values);

  /// Ends the image and writes it to `file`.
  void write_to(OutputFile& file);

 private:
  void check(int status) const;

  std::string path_;
  int id_ = -1;
};

}  // namespace delone::io
