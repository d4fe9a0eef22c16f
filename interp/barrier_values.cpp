#include "interp/barrier_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/nodal_fit.hpp"

namespace delone::interp {

namespace {

using delaunay::Node;
using delaunay::none;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Values of rows that have one, merged where they share a site.
template <class Constrained>
std::vector<double> data_of_sites(const Constrained& t,
                                  std::span<const double> row_values, Duplicates policy) {
  const auto num_values = static_cast<std::int64_t>(row_values.size());
  if (num_values != t.num_input_rows() && num_values != t.num_rows()) {
    throw Error("there are " + std::to_string(num_values) + " values for " +
                std::to_string(t.num_input_rows()) +
                " points; give one value a point, NaN for a vertex without");
  }
  // A row without a value gets a site of its own, so that errors name the caller's rows.
  std::vector<Site> sites(t.sites().begin(), t.sites().begin() + num_values);
  std::vector<double> values(row_values.begin(), row_values.end());
  std::vector<double> result(at(t.num_sites()), missing);
  Site num_sites = t.num_sites();
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isnan(values[row])) {
      result[at(sites[row])] = 0;
      continue;
    }
    sites[row] = num_sites++;
    values[row] = 0;
  }
  const std::vector<double> merged = values_at_sites(sites, num_sites, values, policy);
  for (std::size_t s = 0; s < result.size(); ++s)
    if (!std::isnan(result[s])) result[s] = merged[s];
  return result;
}

/// A value that a segment gives to an added vertex on it.
struct Added {
  Node row;
  double value;
};

/// Added vertices from path[low] to path[high], which have data: linear by length.
template <BlendSpace Space>
void add_between(std::vector<Added>& found, const Space& space,
                 const ConstrainedIn<Space>& t, std::span<const Node> path,
                 std::span<const double> values) {
  std::vector<double> lengths{0};
  for (std::size_t k = 1; k < path.size(); ++k) {
    const auto d = Space::difference(space.vector(t.point(path[k])),
                                     space.vector(t.point(path[k - 1])));
    lengths.push_back(lengths.back() + std::sqrt(Space::dot(d, d)));
  }
  const double first = values[at(t.sites()[at(path.front())])],
               last = values[at(t.sites()[at(path.back())])], all = lengths.back();
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    if (path[k] >= t.num_input_rows())
      found.push_back(
          {path[k], first + (last - first) * (all > 0 ? lengths[k] / all : 0)});
  }
}

/// What segments give to the added vertices between their data, sorted.
template <BlendSpace Space>
std::vector<Added> values_along_segments(const Space& space,
                                         const ConstrainedIn<Space>& t,
                                         std::span<const double> values) {
  std::vector<Added> found;
  for (std::int64_t i = 0; i < t.num_segments(); ++i) {
    std::vector<Node> path = t.path(i);
    // The same way whichever way it was given: roundings.
    if (t.sites()[at(path.front())] > t.sites()[at(path.back())])
      std::reverse(path.begin(), path.end());
    std::optional<std::size_t> low;
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (std::isnan(values[at(t.sites()[at(path[k])])])) continue;
      if (low)
        add_between(found, space, t, std::span(path).subspan(*low, k - *low + 1), values);
      low = k;
    }
  }
  std::sort(found.begin(), found.end(), [](const Added& a, const Added& b) {
    return std::tie(a.row, a.value) < std::tie(b.row, b.value);
  });
  // Of repeated segments one counts.
  const auto end =
      std::unique(found.begin(), found.end(), [](const Added& a, const Added& b) {
        return a.row == b.row && a.value == b.value;
      });
  found.erase(end, found.end());
  return found;
}

/// Added vertices between the data of one segment: linear along it, the mean where two
/// segments cross.
template <BlendSpace Space>
void fill_added(const Space& space, const ConstrainedIn<Space>& t,
                std::vector<double>& values) {
  if (t.num_rows() == t.num_input_rows()) return;
  const std::vector<Added> found = values_along_segments(space, t, values);
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    double sum = 0;
    for (; end < found.size() && found[end].row == found[begin].row; ++end)
      sum += found[end].value - found[begin].value;
    double& value = values[at(t.sites()[at(found[begin].row)])];
    if (std::isnan(value))
      value = found[begin].value + sum / static_cast<double>(end - begin);
  }
}

/// How values go on beyond a wedge with data.
template <BlendSpace Space>
struct Continuation {
  typename Space::Axes axes{};
  double u = 0, v = 0;         // slope
  double least = 0, most = 0;  // of the values it was fitted to
};

template <BlendSpace Space>
class Estimator {
 public:
  Estimator(const Space& space, const BarrierMeshIn<Space>& mesh,
            std::vector<double>& values, Bounds bounds)
      : space_(space),
        mesh_(mesh),
        values_(values),
        part_(bounds == Bounds::widened ? 0.5 : 0),
        is_done_(values.size()),
        distances_(values.size(), infinity) {}

  void estimate_all() {
    find_sources();
    std::vector<std::optional<Continuation<Space>>> continuations(values_.size());
    std::vector<double> estimates(values_.size(), missing);
    for (std::size_t w = 0; w < values_.size(); ++w) {
      for (const WedgeSource& s : sources_[w]) {
        auto& place = continuations[at(s.wedge)];
        if (!place) place = continuation(s.wedge);
      }
      if (!sources_[w].empty())
        estimates[w] = estimate(static_cast<Wedge>(w), continuations);
    }
    for (std::size_t w = 0; w < values_.size(); ++w)
      if (!std::isnan(estimates[w])) values_[w] = estimates[w];
  }
  [[nodiscard]] std::vector<std::vector<WedgeSource>> take_sources() {
    return std::move(sources_);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_sources = 3, num_samples = 12;
  using Vector = typename Space::Vector;

  [[nodiscard]] bool has_data(Wedge w) const { return !std::isnan(values_[at(w)]); }
  [[nodiscard]] Vector point(Wedge w) const { return space_.vector(mesh_.point_of(w)); }
  [[nodiscard]] double length(Wedge a, Wedge b) const {
    const Vector d = Space::difference(point(a), point(b));
    return std::sqrt(Space::dot(d, d));
  }

  // Nearest first, from all data at once, through wedges without data only: every wedge
  // lets the first few sources pass.
  void find_sources() {
    struct Front {
      double distance;
      Wedge source, at;
      bool operator>(const Front& b) const {
        return std::tie(distance, source, at) > std::tie(b.distance, b.source, b.at);
      }
    };
    sources_.resize(values_.size());
    std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts;
    const auto advance = [&](const Front& from) {
      mesh_.for_each_neighbor(from.at, [&](Wedge w) {
        if (!has_data(w) && sources_[at(w)].size() < most_sources)
          fronts.push({from.distance + length(from.at, w), from.source, w});
      });
    };
    for (Wedge w = 0; w < mesh_.num_wedges(); ++w)
      if (has_data(w)) advance({0, w, w});
    while (!fronts.empty()) {
      const Front front = fronts.top();
      fronts.pop();
      auto& sources = sources_[at(front.at)];
      const bool is_known =
          std::any_of(sources.begin(), sources.end(),
                      [&](const WedgeSource& s) { return s.wedge == front.source; });
      if (is_known || sources.size() == most_sources) continue;
      sources.push_back({front.distance, front.source});
      advance(front);
    }
  }

  // The nearest data of a wedge along edges.
  [[nodiscard]] std::vector<WedgeSource> nearest_data(Wedge from) {
    struct Front {
      double distance;
      Wedge at;
      bool operator>(const Front& b) const {
        return std::tie(distance, at) > std::tie(b.distance, b.at);
      }
    };
    std::vector<WedgeSource> found;
    std::vector<Wedge> touched{from};
    std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts;
    fronts.push({0, from});
    distances_[at(from)] = 0;
    while (!fronts.empty() && found.size() < num_samples) {
      const Front front = fronts.top();
      fronts.pop();
      if (is_done_[at(front.at)]) continue;
      is_done_[at(front.at)] = true;
      if (front.at != from && has_data(front.at))
        found.push_back({front.distance, front.at});
      mesh_.for_each_neighbor(front.at, [&](Wedge w) {
        const double distance = front.distance + length(front.at, w);
        if (is_done_[at(w)] || distance >= distances_[at(w)]) return;
        distances_[at(w)] = distance;
        touched.push_back(w);
        fronts.push({distance, w});
      });
    }
    for (const Wedge w : touched) is_done_[at(w)] = false, distances_[at(w)] = infinity;
    return found;
  }

  [[nodiscard]] Continuation<Space> continuation(Wedge from) {
    const double value = values_[at(from)];
    Continuation<Space> result{Space::axes(point(from)), 0, 0, value, value};
    std::vector<NodalSample> samples;
    for (const WedgeSource& s : nearest_data(from)) {
      const double z = values_[at(s.wedge)];
      result.least = std::min(result.least, z);
      result.most = std::max(result.most, z);
      if (mesh_.site_of(s.wedge) == mesh_.site_of(from)) continue;
      const auto d = displacement(result, from, s.wedge);
      samples.push_back({d.u, d.v, z - value, 1 / s.distance});
    }
    if (samples.empty()) return result;
    const NodalPolynomial plane = fit_polynomial(samples, 1);
    result.u = plane[0], result.v = plane[1];
    return result;
  }

  [[nodiscard]] LocalPosition<double> displacement(const Continuation<Space>& c,
                                                   Wedge from, Wedge to) const {
    return Space::local(c.axes,
                        Space::position(Space::difference(point(to), point(from))), 1);
  }

  [[nodiscard]] double estimate(
      Wedge w, const std::vector<std::optional<Continuation<Space>>>& all) const {
    const auto& sources = sources_[at(w)];
    const double base = values_[at(sources.front().wedge)];
    double least = base, most = base, sum = 0, weights = 0;
    for (const WedgeSource& s : sources) {
      const Continuation<Space>& c = *all[at(s.wedge)];
      const LocalPosition<double> d = displacement(c, s.wedge, w);
      const double near = sources.front().distance / s.distance, weight = near * near;
      sum += weight * (values_[at(s.wedge)] - base + (c.u * d.u + c.v * d.v));
      weights += weight;
      least = std::min(least, c.least), most = std::max(most, c.most);
    }
    const double room = part_ * (most - least);
    // In this order NaN becomes a bound.
    return std::max(least - room, std::min(most + room, base + sum / weights));
  }

  const Space& space_;
  const BarrierMeshIn<Space>& mesh_;
  std::vector<double>& values_;
  double part_;
  std::vector<std::vector<WedgeSource>> sources_;
  std::vector<bool> is_done_;
  std::vector<double> distances_;
};

}  // namespace

template <BlendSpace Space>
BarrierValues barrier_values(const Space& space, const BarrierMeshIn<Space>& mesh,
                             std::span<const double> row_values, Duplicates policy,
                             Bounds bounds) {
  const ConstrainedIn<Space>& t = mesh.constrained();
  BarrierValues result;
  result.of_sites = data_of_sites(t, row_values, policy);
  fill_added(space, t, result.of_sites);
  for (Wedge w = 0; w < mesh.num_wedges(); ++w)
    result.of_wedges.push_back(result.of_sites[at(mesh.site_of(w))]);
  Estimator<Space> estimator(space, mesh, result.of_wedges, bounds);
  estimator.estimate_all();
  result.sources = estimator.take_sources();
  return result;
}

template BarrierValues barrier_values<PlaneSpace>(const PlaneSpace&,
                                                  const BarrierMeshIn<PlaneSpace>&,
                                                  std::span<const double>, Duplicates,
                                                  Bounds);
template BarrierValues barrier_values<SphereSpace>(const SphereSpace&,
                                                   const BarrierMeshIn<SphereSpace>&,
                                                   std::span<const double>, Duplicates,
                                                   Bounds);

}  // namespace delone::interp
