#include "io/netcdf_image.hpp"

#include <netcdf_mem.h>

#include <cstdlib>
#include <memory>
#include <utility>

#include "io/table.hpp"

namespace delone::io {

NetcdfImage::NetcdfImage(std::string path) : path_(std::move(path)) {
  check(nc_create_mem("delone", NC_64BIT_OFFSET, 0, &id_));
  int previous_mode = 0;
  check(nc_set_fill(id_, NC_NOFILL, &previous_mode));  // every value gets written
}

NetcdfImage::~NetcdfImage() {
  if (id_ >= 0) nc_abort(id_);
}

int NetcdfImage::add_dimension(const char* name, std::int64_t size) {
  int dimension = 0;
  check(nc_def_dim(id_, name, static_cast<std::size_t>(size), &dimension));
  return dimension;
}

int NetcdfImage::add_variable(const std::string& name, const std::vector<int>& dimensions,
                              nc_type type) {
  int variable = 0;
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()),
                   dimensions.data(), &variable));
  return variable;
}

void NetcdfImage::add_text(int variable, const char* name, std::string_view text) {
  if (!text.empty())
    check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
}

void NetcdfImage::add_number(int variable, const char* name, std::int32_t number) {
  check(nc_put_att_int(id_, variable, name, NC_INT, 1, &number));
}

void NetcdfImage::add_fill_value(int variable, double value) {
  check(nc_put_att_double(id_, variable, "_FillValue", NC_DOUBLE, 1, &value));
}

void NetcdfImage::add_fill_value(int variable, std::int32_t value) {
  add_number(variable, "_FillValue", value);
}

void NetcdfImage::end_definitions() { check(nc_enddef(id_)); }

void NetcdfImage::put(int variable, const std::vector<double>& values) {
  if (!values.empty()) check(nc_put_var_double(id_, variable, values.data()));
}

void NetcdfImage::put(int variable, const std::vector<std::int32_t>& values) {
  if (!values.empty()) check(nc_put_var_int(id_, variable, values.data()));
}

void NetcdfImage::write_to(OutputFile& file) {
  NC_memio memory{};
  check(nc_close_memio(std::exchange(id_, -1), &memory));
  const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
  file.write({static_cast<const char*>(memory.memory), memory.size});
}

void NetcdfImage::check(int status) const {
  if (status != NC_NOERR)
    throw WriteError(path_ + ": cannot be written: " + nc_strerror(status));
}

}  // namespace delone::io
