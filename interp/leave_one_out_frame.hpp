#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/index.hpp"
#include "interp/removed_site.hpp"

namespace delone::interp {

/// `predict(removed)` for every site: the frame for methods that predict a removed site
/// from its RemovedSite in closed form, as natural neighbours can from the rim. Any
/// dimension; called from several threads, for `chunk` sites at a time.
template <class Triangulation, class Predict>
[[nodiscard]] std::vector<double> predict_left_out(const Triangulation& t,
                                                   const RunOptions& run, Predict predict,
                                                   std::int64_t chunk = 1024) {
  std::vector<double> predicted(at(t.num_sites()));
  delaunay::parallel_chunks(
      t.num_sites(), chunk, run, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t s = first; s < last; ++s)
          predicted[at(s)] = predict(RemovedSite<Triangulation>(t, static_cast<Site>(s)));
      });
  return predicted;
}

/// What a surface over the other sites within `rings` steps says at a removed site:
/// `make(triangulation, values)` gives a surface over them (shared_ptr and one value a
/// row). For any method whose value at a point depends on sites nearby only; two rings
/// hold every triangle that meets the hole and, at a boundary, the new hull edges with
/// their triangles. Some microseconds a ring of six.
template <class Triangulation, class Make>
[[nodiscard]] double rebuilt_prediction(const RemovedSite<Triangulation>& removed,
                                        std::span<const double> site_values, int rings,
                                        Make make) {
  const std::vector<Site> sites = removed.surroundings(rings);
  std::vector<typename RemovedSite<Triangulation>::Point> points;
  std::vector<double> values;
  for (const Site s : sites) {
    points.push_back(removed.triangulation().points()[at(s)]);
    values.push_back(site_values[at(s)]);
  }
  const RunOptions alone{.num_threads = 1, .progress = {}};
  const auto local = std::make_shared<const Triangulation>(points, alone);
  return make(local, values).value(removed.position());
}

}  // namespace delone::interp
