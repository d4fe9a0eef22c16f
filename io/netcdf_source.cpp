#include "io/netcdf_source.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "io/classic_header.hpp"
#include "io/table.hpp"

namespace delone::io {

NetcdfSource::NetcdfSource(const std::string& path) : path_(path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail("cannot be read: " + error.message());
  if (fs::is_directory(status)) fail("cannot be read: it is a folder; name a file");
  if (!fs::is_regular_file(status))
    fail("cannot be read: NetCDF needs a file, not a pipe");
  num_bytes_ = fs::file_size(path, error);
  check_classic_header(path);
  // Absolute, because the library takes names such as http://... for addresses.
  check(nc_open(fs::absolute(path, error).c_str(), NC_NOWRITE, &id_));
}

int NetcdfSource::num_variables() const {
  int count = 0;
  check(nc_inq_nvars(id_, &count));
  return count;
}

std::optional<std::size_t> NetcdfSource::dimension_size(const std::string& name) const {
  int dimension = 0;
  if (nc_inq_dimid(id_, name.c_str(), &dimension) != NC_NOERR) return std::nullopt;
  std::size_t size = 0;
  check(nc_inq_dimlen(id_, dimension, &size));
  return size;
}

std::optional<int> NetcdfSource::find_variable(const std::string& name) const {
  int variable = 0;
  if (nc_inq_varid(id_, name.c_str(), &variable) != NC_NOERR) return std::nullopt;
  return variable;
}

std::string NetcdfSource::variable_name(int variable) const {
  std::array<char, NC_MAX_NAME + 1> name{};
  check(nc_inq_varname(id_, variable, name.data()));
  return name.data();
}

nc_type NetcdfSource::type(int variable) const {
  nc_type type = NC_NAT;
  check(nc_inq_vartype(id_, variable, &type));
  return type;
}

std::vector<Dimension> NetcdfSource::dimensions(int variable) const {
  int count = 0;
  check(nc_inq_varndims(id_, variable, &count));
  std::vector<int> ids(static_cast<std::size_t>(count));
  check(nc_inq_vardimid(id_, variable, ids.data()));
  std::vector<Dimension> result;
  for (const int id : ids) {
    std::array<char, NC_MAX_NAME + 1> name{};
    std::size_t size = 0;
    check(nc_inq_dim(id_, id, name.data(), &size));
    result.push_back({id, name.data(), size});
  }
  return result;
}

std::string NetcdfSource::text(int variable, const char* attribute) const {
  constexpr std::size_t longest = 4096;
  nc_type type = NC_NAT;
  std::size_t size = 0;
  if (nc_inq_att(id_, variable, attribute, &type, &size) != NC_NOERR) return "";
  if (type == NC_STRING && size == 1) {
    char* string = nullptr;
    check(nc_get_att_string(id_, variable, attribute, &string));
    const std::string result(string == nullptr ? "" : string);
    nc_free_string(1, &string);
    return result;
  }
  if (type != NC_CHAR || size > longest) return "";
  std::string result(size, '\0');
  check(nc_get_att_text(id_, variable, attribute, result.data()));
  return result.substr(0, result.find('\0'));
}

std::optional<double> NetcdfSource::number(int variable, const char* attribute) const {
  nc_type type = NC_NAT;
  std::size_t size = 0;
  if (nc_inq_att(id_, variable, attribute, &type, &size) != NC_NOERR) return std::nullopt;
  if (size != 1 || type == NC_CHAR || type > NC_UINT64) return std::nullopt;
  double value = 0;
  check(nc_get_att_double(id_, variable, attribute, &value));
  return value;
}

/// A header can claim any size. Values that are compressed take about a thousandth at the
/// least (the limit of deflate); classic files were checked when they were opened.
void NetcdfSource::check_size(int variable, std::size_t num_values) const {
  constexpr double most_compression = 1100;
  std::size_t value_bytes = 0;
  check(nc_inq_type(id_, type(variable), nullptr, &value_bytes));
  const double num_bytes =
      static_cast<double>(num_values) * static_cast<double>(value_bytes);
  if (num_bytes > most_compression * static_cast<double>(num_bytes_))
    fail("damaged or cut short: variable '" + variable_name(variable) + "' claims " +
         std::to_string(num_values) + " values, more than the file can hold");
}

std::vector<double> NetcdfSource::values(int variable) const {
  const auto dims = dimensions(variable);
  std::vector<std::size_t> start(dims.size(), 0), count(dims.size(), 1);
  std::size_t num_values = 1;
  for (std::size_t d = dims.size() - std::min<std::size_t>(dims.size(), 2);
       d < dims.size(); ++d) {
    count[d] = dims[d].size;
    if (__builtin_mul_overflow(num_values, dims[d].size, &num_values))
      fail("variable '" + variable_name(variable) + "' is too large");
  }
  check_size(variable, num_values);
  std::vector<double> result(num_values);
  check(nc_get_vara_double(id_, variable, start.data(), count.data(), result.data()));
  return result;
}

bool is_numeric(nc_type type) noexcept {
  return type != NC_CHAR && type <= NC_UINT64 && type != NC_NAT;
}

}  // namespace delone::io
