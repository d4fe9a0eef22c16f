#include "interp/leave_one_out.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/leave_one_out_frame.hpp"
#include "interp/linear_surface.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/plane_cells.hpp"
#include "interp/sphere_cells.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr int rings = 2;

using Plane = tripack::Triangulation;
using Sphere = stripack::Triangulation;

double value_on(const PlaneCells& cells, const Spot& spot, Point2 p) {
  if (spot.kind == Spot::Kind::triangle) return cells.facet(spot.sites)(cells.scaled(p));
  return cells.edge_facet(spot.sites[0], spot.sites[1])(cells.scaled(p));
}
double value_on(const SphereCells& cells, const Spot& spot, const Direction& p) {
  if (spot.kind == Spot::Kind::triangle) return cells.facet(spot.sites)(vector(p));
  return cells.edge_value(spot.sites[0], spot.sites[1], p);
}

// On the sphere the boundary may turn by half a turn at a site without any of the other
// sites being within half a turn of each other.
bool has_plain_spot(const RemovedSite<Plane>&) { return true; }
bool has_plain_spot(const RemovedSite<Sphere>& removed) {
  return !removed.is_on_straight_boundary();
}

template <class Surface, class Triangulation>
double rebuilt(const RemovedSite<Triangulation>& removed, std::span<const double> values,
               SurfaceOptions options) {
  options.duplicates = Duplicates::mean;  // sites do not repeat
  return rebuilt_prediction(removed, values, rings,
                            [&](auto local, const std::vector<double>& local_values) {
                              return Surface(std::move(local), local_values, options);
                            });
}

/// Is the prediction read off the triangulation, without building a small one?
template <class Triangulation>
bool is_direct(const RemovedSite<Triangulation>& removed, const SurfaceOptions& options) {
  const bool is_limited = options.max_distance < std::numeric_limits<double>::infinity();
  if (is_limited || removed.triangulation().dimension() < 2) return false;
  if (removed.is_boundary() && options.outside == Outside::linear) return false;
  return has_plain_spot(removed);
}

template <class Surface, class Cells, class Triangulation>
double predict_linear(const RemovedSite<Triangulation>& removed, const Cells& cells,
                      std::span<const double> values, const SurfaceOptions& options) {
  if (!is_direct(removed, options)) return rebuilt<Surface>(removed, values, options);
  const Spot spot = removed.spot();
  if (spot.kind != Spot::Kind::outside) return value_on(cells, spot, removed.position());
  return options.outside == Outside::nearest ? values[at(removed.nearest())] : missing;
}

template <class Surface, class Triangulation>
double predict_nearest(const RemovedSite<Triangulation>& removed,
                       std::span<const double> values, const SurfaceOptions& options) {
  if (!is_direct(removed, options)) return rebuilt<Surface>(removed, values, options);
  const bool is_missing =
      options.outside == Outside::missing && removed.spot().kind == Spot::Kind::outside;
  return is_missing ? missing : values[at(removed.nearest())];
}

template <class Triangulation>
std::vector<double> site_values(const Triangulation& t, std::span<const double> values,
                                const SurfaceOptions& options) {
  return values_at_sites(t.sites(), t.num_sites(), values, options.duplicates);
}

template <class Surface, class Cells, class Triangulation>
LeaveOneOut linear(std::shared_ptr<const Triangulation> t,
                   std::span<const double> row_values, const SurfaceOptions& options,
                   const RunOptions& run) {
  const std::vector<double> values = site_values(*t, row_values, options);
  const Cells cells(t, values, options);
  return left_out_rows(t->sites(),
                       predict_left_out(*t, run,
                                        [&](const RemovedSite<Triangulation>& removed) {
                                          return predict_linear<Surface>(removed, cells,
                                                                         values, options);
                                        }),
                       row_values);
}

template <class Surface, class Triangulation>
LeaveOneOut nearest(const std::shared_ptr<const Triangulation>& t,
                    std::span<const double> row_values, const SurfaceOptions& options,
                    const RunOptions& run) {
  const Surface checked(t, row_values, options);  // throws for options and values
  const std::vector<double> values = site_values(*t, row_values, options);
  return left_out_rows(t->sites(),
                       predict_left_out(*t, run,
                                        [&](const RemovedSite<Triangulation>& removed) {
                                          return predict_nearest<Surface>(removed, values,
                                                                          options);
                                        }),
                       row_values);
}

}  // namespace

LeaveOneOut left_out_rows(std::span<const Site> sites,
                          std::span<const double> site_predictions,
                          std::span<const double> row_values) {
  if (row_values.size() != sites.size()) {
    throw Error("there are " + std::to_string(row_values.size()) + " values for " +
                std::to_string(sites.size()) + " points; give one value a point");
  }
  LeaveOneOut result;
  result.predicted.reserve(sites.size());
  result.residual.reserve(sites.size());
  for (std::size_t row = 0; row < sites.size(); ++row) {
    const double predicted = site_predictions[at(sites[row])];
    result.predicted.push_back(predicted);
    result.residual.push_back(predicted - row_values[row]);
    if (std::isnan(predicted)) ++result.num_missing;
  }
  return result;
}

LeaveOneOut leave_out_linear(std::shared_ptr<const tripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const SurfaceOptions& options, const RunOptions& run) {
  return linear<PlaneLinear, PlaneCells>(std::move(triangulation), row_values, options,
                                         run);
}

LeaveOneOut leave_out_linear(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const SurfaceOptions& options, const RunOptions& run) {
  return linear<SphereLinear, SphereCells>(std::move(triangulation), row_values, options,
                                           run);
}

LeaveOneOut leave_out_nearest(std::shared_ptr<const tripack::Triangulation> triangulation,
                              std::span<const double> row_values,
                              const SurfaceOptions& options, const RunOptions& run) {
  return nearest<PlaneNearest>(triangulation, row_values, options, run);
}

LeaveOneOut leave_out_nearest(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const SurfaceOptions& options,
    const RunOptions& run) {
  return nearest<SphereNearest>(triangulation, row_values, options, run);
}

}  // namespace delone::interp
