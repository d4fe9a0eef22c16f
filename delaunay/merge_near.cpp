#include "delaunay/merge_near.hpp"

#include <string>

#include "delaunay/error.hpp"

namespace delone::delaunay {

void check_merge_distance(double distance) {
  if (distance >= 0 && std::isfinite(distance)) return;
  throw Error("a distance of " + std::to_string(distance) +
              " cannot be merged within; give a finite one that is not negative");
}

MergedRows spread_to_rows(std::span<const Node> stands_for, std::span<const Site> sites) {
  MergedRows result;
  result.stands_for.reserve(sites.size());
  std::vector<bool> is_kept(sites.size(), false);
  for (const Site s : sites) {
    const Node row = stands_for[static_cast<std::size_t>(s)];
    result.stands_for.push_back(row);
    is_kept[static_cast<std::size_t>(row)] = true;
  }
  for (const bool kept : is_kept) result.num_kept += kept ? 1 : 0;
  return result;
}

}  // namespace delone::delaunay
