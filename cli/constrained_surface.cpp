#include "cli/constrained_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "cli/output.hpp"

namespace delone::cli {
namespace {

constexpr std::string_view attribute_prefix = "attribute_";

/// The index of the attribute that --value names: attribute_K, or the number of its
/// column: number, x and y come first, as in a .node file.
std::optional<std::size_t> attribute_index(const std::string& column) {
  if (column.empty()) return 0;
  const bool is_name = column.starts_with(attribute_prefix);
  const std::string_view digits =
      std::string_view(column).substr(is_name ? attribute_prefix.size() : 0);
  std::size_t number = 0;
  const auto [end, code] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const std::size_t before = is_name ? 1 : 4;
  if (code != std::errc() || end != digits.data() + digits.size() || number < before)
    return {};
  return number - before;
}

/// The value of a .poly file's vertices becomes the table's.
void choose_attribute(ConstrainedInput& input, const std::string& column,
                      const Reporter& reporter) {
  const std::string name = display_name(input.path);
  const auto count = input.attributes.size();
  if (count == 0) {
    throw Error(fmt::format(
        "{}: its vertices carry no attribute, so there is no value; give points with "
        "values and the segments with --constraints {}",
        name, input.path));
  }
  const auto index = attribute_index(column);
  if (!index || *index >= count) {
    throw UsageError(fmt::format(
        "--value '{}': {} has {}; name one of them, {}1 on", column, name,
        counted(static_cast<std::int64_t>(count), "attribute"), attribute_prefix));
  }
  input.points.table.value = input.attributes[*index];
  input.points.table.value_name = fmt::format("{}{}", attribute_prefix, *index + 1);
  reporter.say("{}: {}, value is '{}'", name, counted(input.points.size(), "point"),
               input.points.table.value_name);
}

template <class Triangulation, class Point>
std::shared_ptr<const Triangulation> corners_of_domain(const auto& constrained) {
  std::vector<bool> is_corner(static_cast<std::size_t>(constrained.num_rows()));
  for (const auto& triangle : constrained.triangles())
    for (const auto row : triangle) is_corner[static_cast<std::size_t>(row)] = true;
  const bool has_none = constrained.num_triangles() == 0;
  std::vector<Point> corners;
  for (delaunay::Node row = 0; row < constrained.num_rows(); ++row)
    if (has_none || is_corner[static_cast<std::size_t>(row)])
      corners.push_back(constrained.point(row));
  return std::make_shared<const Triangulation>(corners);
}

Triangulated corners_of_domain(const CurvedData& data) {
  if (const auto* plane = std::get_if<CurvedData::Plane>(&data.curves))
    return corners_of_domain<tripack::Triangulation, tripack::Point2>(**plane);
  return corners_of_domain<stripack::Triangulation, stripack::Direction>(
      *std::get<CurvedData::Globe>(data.curves));
}

interp::ConstrainedOptions options_of(const Points& points,
                                      const SurfaceSettings& settings) {
  interp::ConstrainedOptions options;
  options.kind = settings.method == Method::c1 ? interp::ConstrainedKind::c1
                                               : interp::ConstrainedKind::linear;
  options.duplicates = points.duplicates;
  options.max_distance = settings.max_distance;
  options.distance = points.domain == Domain::ellipsoid
                         ? interp::GlobeDistance::geodesic_wgs84
                         : interp::GlobeDistance::great_circle;
  options.bounds = settings.is_bounded ? interp::Bounds::local : interp::Bounds::widened;
  options.degree = settings.degree;
  options.tension = settings.tension;
  return options;
}

/// A .poly file has no lines for rows.
Error located(const CurvedData& data, const Error& error) {
  if (!is_poly(data.input.points.path) && data.input.path != data.input.points.path)
    return located(data.input.points, error);
  return Error(fmt::format("{}: {}", display_name(data.input.path), error.what()),
               {error.rows().begin(), error.rows().end()});
}

Surface fit_curved(const CurvedData& data, const interp::ConstrainedOptions& options,
                   const RunOptions& run) {
  if (const auto* plane = std::get_if<CurvedData::Plane>(&data.curves))
    return interp::PlaneConstrained(*plane, data.values, options, run);
  return interp::SphereConstrained(std::get<CurvedData::Globe>(data.curves), data.values,
                                   options, run);
}

/// What only tables have.
void check_poly_options(const PointSettings& points) {
  const auto refuse = [](std::string_view option) {
    throw UsageError(
        fmt::format("{} is for tables; a .poly file has vertices and attributes (--value "
                    "attribute_2 takes the second)",
                    option));
  };
  if (!points.columns.x.empty()) refuse("--x");
  if (!points.columns.y.empty()) refuse("--y");
  if (points.columns.skip_bad_rows) refuse("--skip-bad-rows");
  if (points.merge_within) refuse("--merge-within");
}

}  // namespace

void check_curved_options(const PointSettings& points, const SurfaceSettings& settings) {
  if (settings.method != Method::linear && settings.method != Method::c1) {
    throw UsageError(
        fmt::format("--method {} looks across segments; with segments take linear or c1",
                    name_of(settings.method)));
  }
  if (settings.outside != interp::Outside::missing) {
    throw UsageError(
        "--extrapolate does not go with segments: the surface ends at its domain; leave "
        "it out (--keep-outside keeps the whole hull)");
  }
  if (settings.smooth.is_given)
    throw UsageError("--smooth is for --method smooth, which looks across segments");
  if (points.has_errors)
    throw UsageError("--errors is for --method smooth, which looks across segments");
  check_c1_options(settings);
  if (settings.gradients == interp::Gradients::global)
    throw UsageError(
        "--gradients global looks across segments; with segments take local");
  if (is_poly(points.path)) check_poly_options(points);
}

CurvedData read_curved(const PointSettings& points, const ConstraintSettings& constraints,
                       Reporter& reporter) {
  CurvedData data{read_constrained(points, constraints.path, reporter), {}, {}, {}};
  if (is_poly(points.path)) choose_attribute(data.input, points.columns.value, reporter);
  std::visit(
      [&](auto&& t) {
        using Built = std::decay_t<decltype(t)>;
        data.curves = std::make_shared<const Built>(std::move(t));
      },
      build_domain(data.input, constraints, reporter));
  data.domain = reporter.timed(Phase::build, [&] { return corners_of_domain(data); });
  data.values = data.input.points.table.value;
  data.values.resize(data.input.graph.points.size(),
                     std::numeric_limits<double>::quiet_NaN());
  return data;
}

Surface fit(const CurvedData& data, const SurfaceSettings& settings, Reporter& reporter) {
  const interp::ConstrainedOptions options = options_of(data.input.points, settings);
  return reporter.timed(Phase::fit, [&] {
    try {
      return fit_curved(data, options, reporter.run_options("fitting"));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      throw located(data, error);
    }
  });
}

}  // namespace delone::cli
