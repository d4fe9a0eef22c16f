#pragma once

#include <string>

#include "delaunay/adjacency.hpp"

namespace delone::io {

/// TRIPACK's and STRIPACK's lists as text: a line with the number of nodes and LNEW - 1,
/// then LIST and LPTR, a pair a line, then LEND, one a line. Everything counts from 1, as
/// in Fortran. Throws WriteError.
void write_renka(const std::string& path, const delaunay::RenkaLists& lists);

/// Reads what write_renka writes. Counts are held against the bytes left, pointers are
/// checked to lie within the lists; that they form lists is delaunay::from_renka's to
/// check. Throws ReadError naming the line.
[[nodiscard]] delaunay::RenkaLists read_renka(const std::string& path);

}  // namespace delone::io
