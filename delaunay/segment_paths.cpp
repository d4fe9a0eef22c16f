#include "delaunay/segment_paths.hpp"

namespace delone::delaunay {

std::vector<Site> SegmentPaths::path(Site a, Site b) const {
  std::vector<Site> sites{a};
  std::vector<Site> ahead{b};  // sites that the path still has to reach, nearest last
  while (!ahead.empty()) {
    const Site at = between(sites.back(), ahead.back());
    if (at != none) {
      ahead.push_back(at);
      continue;
    }
    sites.push_back(ahead.back());
    ahead.pop_back();
  }
  return sites;
}

}  // namespace delone::delaunay
