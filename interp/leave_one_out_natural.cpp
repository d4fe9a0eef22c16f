#include "interp/leave_one_out_natural.hpp"

#include <utility>
#include <vector>

#include "interp/leave_one_out_frame.hpp"
#include "interp/leave_one_out_stars.hpp"
#include "interp/natural_cells.hpp"
#include "interp/natural_gradients.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

double scale_of(std::span<const Point2> points) { return coordinate_scale(points); }
double scale_of(std::span<const Direction>) { return 1; }

template <class View>
class LeftOutNatural {
 public:
  using Triangulation = typename NaturalRoom<View>::Triangulation;

  LeftOutNatural(const Triangulation& t, std::span<const double> site_values,
                 const NaturalOptions& options)
      : t_(t), values_(site_values), options_(options), scale_(scale_of(t.points())) {}

  [[nodiscard]] double operator()(const RemovedSite<Triangulation>& removed) const {
    if (spot_left_by(removed).kind == Spot::Kind::outside)
      return predicted_outside(removed, values_, options_.surface());
    const RemainingStars<Triangulation> stars(removed);
    const auto& sites = *stars.hole();
    std::vector<double> values;
    std::vector<typename View::Slope> slopes;
    for (const delaunay::Node k : sites.rows()) {
      const Site s = stars.rim()[at(k)];
      values.push_back(values_[at(s)]);
      if (options_.kind == NaturalKind::sibson_c1) slopes.push_back(slope(stars, s));
    }
    const NaturalCells<View> cells(stars.hole(), std::move(values), std::move(slopes),
                                   scale_, options_);
    Cursor cursor;
    return cells.value(removed.position(), cursor);
  }

 private:
  [[nodiscard]] typename View::Slope slope(const RemainingStars<Triangulation>& stars,
                                           Site s) const {
    return natural_gradient(t_, scale_, values_,
                            {s, stars.neighbors(s), stars.is_boundary(s)});
  }

  const Triangulation& t_;
  std::span<const double> values_;
  NaturalOptions options_;
  double scale_;
};

template <class Surface, class View, class Triangulation>
LeaveOneOut leave_out(std::shared_ptr<const Triangulation> t,
                      std::span<const double> row_values, NaturalOptions options,
                      const RunOptions& run) {
  NaturalOptions without_gradients = options;
  without_gradients.kind = NaturalKind::sibson;
  const Surface checked(t, row_values, without_gradients);  // throws for bad input
  if (t->dimension() < 2)
    return leave_out_linear(std::move(t), row_values, options.surface(), run);
  const std::vector<double> values =
      values_at_sites(t->sites(), t->num_sites(), row_values, options.duplicates);
  return left_out_rows(
      t->sites(), predict_left_out(*t, run, LeftOutNatural<View>(*t, values, options)),
      row_values);
}

}  // namespace

LeaveOneOut leave_out_natural(std::shared_ptr<const tripack::Triangulation> triangulation,
                              std::span<const double> row_values,
                              const NaturalOptions& options, const RunOptions& run) {
  return leave_out<PlaneNatural, PlaneView>(std::move(triangulation), row_values, options,
                                            run);
}

LeaveOneOut leave_out_natural(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const NaturalOptions& options,
    const RunOptions& run) {
  return leave_out<SphereNatural, SphereView>(std::move(triangulation), row_values,
                                              options, run);
}

}  // namespace delone::interp
