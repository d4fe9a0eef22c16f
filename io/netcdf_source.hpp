#pragma once

#include <netcdf.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/table.hpp"

namespace delone::io {

/// A dimension of a variable.
struct Dimension {
  int id = 0;
  std::string name;
  std::size_t size = 0;
};

/// An open NetCDF file, classic or NetCDF-4. Every call throws ReadError where the
/// library reports an error. Sizes that a header claims are held against the file's
/// before memory is taken. Internal: includes netcdf.h.
class NetcdfSource {
 public:
  explicit NetcdfSource(const std::string& path);
  ~NetcdfSource() { nc_close(id_); }
  NetcdfSource(const NetcdfSource&) = delete;
  NetcdfSource& operator=(const NetcdfSource&) = delete;

  [[nodiscard]] int num_variables() const;
  [[nodiscard]] std::optional<std::size_t> dimension_size(const std::string& name) const;
  [[nodiscard]] std::optional<int> find_variable(const std::string& name) const;
  [[nodiscard]] std::string variable_name(int variable) const;
  [[nodiscard]] nc_type type(int variable) const;
  [[nodiscard]] std::vector<Dimension> dimensions(int variable) const;
  /// Empty where there is none; NC_GLOBAL for the file's own.
  [[nodiscard]] std::string text(int variable, const char* attribute) const;
  [[nodiscard]] std::optional<double> number(int variable, const char* attribute) const;
  /// The last `count` (one or two) dimensions of a variable, index 0 of those before.
  [[nodiscard]] std::vector<double> values(int variable) const;

  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(path_ + ": " + why);
  }

 private:
  void check(int status) const {
    if (status != NC_NOERR)
      fail(std::string("cannot be read as NetCDF: ") + nc_strerror(status));
  }
  void check_size(int variable, std::size_t num_values) const;

  std::string path_;
  std::uintmax_t num_bytes_ = 0;
  int id_ = -1;
};

[[nodiscard]] bool is_numeric(nc_type type) noexcept;

}  // namespace delone::io
