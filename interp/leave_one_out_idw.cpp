#include <utility>

#include "interp/idw_method.hpp"
#include "interp/leave_one_out_scatter.hpp"
#include "interp/leave_one_out_scatter_frame.hpp"

namespace delone::interp {

namespace {

template <class Domain>
LeaveOneOut leave_out(const std::shared_ptr<const typename Domain::Triangulation>& t,
                      std::span<const double> row_values,
                      const InverseDistanceOptions& weights,
                      const SurfaceOptions& options, const RunOptions& run) {
  check(weights);
  const std::vector<double> values = checked_site_values(*t, row_values, options);
  const InverseDistance<Domain> method(t, Domain(t->points()), values, weights);
  const auto predict = [&](const RemovedSite<typename Domain::Triangulation>& removed) {
    return predicted_within(removed, values, options,
                            [&] { return method.without(removed.site()); });
  };
  return left_out_rows(t->sites(), predict_left_out(*t, run, predict), row_values);
}

}  // namespace

LeaveOneOut leave_out_inverse_distance(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights,
    const SurfaceOptions& options, const RunOptions& run) {
  return leave_out<PlaneDomain>(triangulation, row_values, weights, options, run);
}

LeaveOneOut leave_out_inverse_distance(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights,
    const SurfaceOptions& options, const RunOptions& run) {
  return leave_out<SphereDomain>(triangulation, row_values, weights, options, run);
}

}  // namespace delone::interp
