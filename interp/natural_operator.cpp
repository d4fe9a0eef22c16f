#include "interp/natural_operator.hpp"

#include <unordered_map>
#include <utility>
#include <vector>

#include "interp/natural_cells.hpp"
#include "interp/natural_gradients.hpp"
#include "interp/operator_assembly.hpp"

namespace delone::interp {

namespace {

double scale_of(std::span<const tripack::Point2> points) {
  return coordinate_scale(points);
}
double scale_of(std::span<const stripack::Direction>) { return 1; }

/// Rows of the operator in one chunk of targets. Remembers the nodes that it met.
template <class View>
class NaturalRows {
 public:
  using Cells = NaturalCells<View>;
  using Slopes = std::vector<typename View::Slope>;

  NaturalRows(const Cells& cells, double scale) : cells_(&cells), scale_(scale) {}

  /// Good until the next call.
  [[nodiscard]] const NodalTerms& operator()(const typename Cells::Point& p,
                                             Cursor& cursor) {
    row_.clear();
    cells_->add_terms(
        p, cursor, [this](Site s) -> const Slopes& { return slope_weights(s); }, row_);
    return row_;
  }

 private:
  const Slopes& slope_weights(Site s) {
    const auto found = slopes_.find(s);
    if (found != slopes_.end()) return found->second;
    return slopes_.emplace(s, natural_slope_weights(cells_->triangulation(), scale_, s))
        .first->second;
  }

  const Cells* cells_;
  double scale_;
  std::unordered_map<Site, Slopes> slopes_;
  NodalTerms row_;
};

template <class View, class Triangulation, class Point>
Operator make_operator(const std::shared_ptr<const Triangulation>& t,
                       std::span<const Point> targets, const NaturalOptions& options,
                       const RunOptions& run) {
  check_natural(options);
  const RowShares shares(*t, options.duplicates);
  const double scale = scale_of(t->points());
  const NaturalCells<View> cells(t, {}, {}, scale, options);
  return assemble_operator_in_chunks(targets, t->adjacency(), shares, t->num_rows(), run,
                                     [&] { return NaturalRows<View>(cells, scale); });
}

}  // namespace

Operator natural_operator(std::shared_ptr<const tripack::Triangulation> triangulation,
                          std::span<const tripack::Point2> targets,
                          const NaturalOptions& options, const RunOptions& run) {
  return make_operator<PlaneView>(triangulation, targets, options, run);
}

Operator natural_operator(std::shared_ptr<const stripack::Triangulation> triangulation,
                          std::span<const stripack::Direction> targets,
                          const NaturalOptions& options, const RunOptions& run) {
  return make_operator<SphereView>(triangulation, targets, options, run);
}

}  // namespace delone::interp
