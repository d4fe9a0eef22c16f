#pragma once

#include <cstddef>
#include <vector>

#include "delaunay/huge_pages.hpp"

namespace delone::interp {

/// `size` times `value`, on huge pages where the system has them: results are written in
/// the order of triangles, all over the place.
template <class T>
[[nodiscard]] std::vector<T> fresh_values(std::size_t size, const T& value = {}) {
  std::vector<T> values;
  values.reserve(size);
  delaunay::prefer_huge_pages(values.data(), size * sizeof(T));
  values.resize(size, value);
  return values;
}

}  // namespace delone::interp
