#pragma once

#include <string>

namespace delone::io {

/// Walks the header of a NetCDF classic file (CDF-1, CDF-2 or CDF-5) and holds every
/// count, length and offset in it against the file. Other files pass.
///
/// The library trusts a header: a damaged count makes it ask for gigabytes, and where a
/// file was cut short it gives zeros for the values that are gone. Throws ReadError
/// naming the byte of the header, or the variable, that the file does not bear out. Cost:
/// reads the header only. Source: NetCDF User's Guide, "File Format Specifications".
void check_classic_header(const std::string& path);

}  // namespace delone::io
