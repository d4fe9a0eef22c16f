#include "cli/vector_field.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "interp/ellipsoid_derivatives.hpp"

namespace delone::cli {
namespace {

using interp::EastNorth;
using stripack::LonLat;

/// "U,V" as two columns.
std::pair<std::string, std::string> parse_columns(const std::string& text) {
  const std::size_t comma = text.find(',');
  const bool has_two = comma != std::string::npos && comma > 0 &&
                       comma + 1 < text.size() &&
                       text.find(',', comma + 1) == std::string::npos;
  if (!has_two)
    throw UsageError(
        fmt::format("--vector takes two columns, towards east and north, as in --vector "
                    "u,v; not '{}'",
                    text));
  return {text.substr(0, comma), text.substr(comma + 1)};
}

void check_domain(const Points& points) {
  if (!points.is_on_plane()) return;
  throw UsageError(
      "--vector is for --on sphere or ellipsoid, where east and north turn; on the plane "
      "interpolate each component alone, with --value");
}

void check_duplicates(const Points& points) {
  using interp::Duplicates;
  const Duplicates d = points.duplicates;
  if (d != Duplicates::median && d != Duplicates::min && d != Duplicates::max) return;
  throw UsageError(
      fmt::format("--duplicates {} does not go with --vector; take mean, first, last or "
                  "error",
                  name_of(d)));
}

std::vector<EastNorth> row_vectors(const Points& points) {
  const io::PointTable& table = points.table;
  std::vector<EastNorth> vectors(table.value.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    vectors[i] = interp::without_longitude({table.value[i], table.second_value[i]},
                                           LonLat{table.x[i], table.y[i]});
  }
  return vectors;
}

std::string_view name_of(interp::Gradients gradients) {
  return gradients == interp::Gradients::global ? "global" : "local";
}

void say_fits(const std::array<interp::C1Fit, 3>& fits, const Reporter& reporter) {
  if (fits[0].num_tested == 0) return;
  double squared = 0, linear_squared = 0;
  for (const interp::C1Fit& fit : fits) {
    squared += fit.left_out_rms * fit.left_out_rms;
    linear_squared += fit.linear_left_out_rms * fit.linear_left_out_rms;
  }
  reporter.say(
      "c1: parts of the vectors along their principal axes: {} gradients, tension "
      "{:.2g}; "
      "{}, {:.2g}; {}, {:.2g}; chosen by leaving out {} points: RMS error {:.4g} (linear "
      "{:.4g})",
      name_of(fits[0].gradients), fits[0].tension, name_of(fits[1].gradients),
      fits[1].tension, name_of(fits[2].gradients), fits[2].tension, fits[0].num_tested,
      std::sqrt(squared), std::sqrt(linear_squared));
}

interp::SphereVectorField make_field(const Points& points,
                                     const GlobeTriangulation& triangulation,
                                     const SurfaceSettings& settings,
                                     const RunOptions& run) {
  using interp::SphereVectorField;
  const GlobeOptions options = globe_options(points, settings);
  const std::vector<EastNorth> vectors = row_vectors(points);
  switch (settings.method) {
    case Method::linear:
      return SphereVectorField::linear(triangulation, vectors, options.common);
    case Method::c1:
      return SphereVectorField::c1(triangulation, vectors, options.c1, run);
    case Method::natural:
    case Method::natural_c1:
      return SphereVectorField::natural(triangulation, vectors, options.natural);
    default:
      throw UsageError("--vector goes with --method linear, c1, natural or natural-c1");
  }
}

/// Of a domain's surface, by kilometre.
interp::VectorDerivatives per_km(const interp::VectorDerivatives& d, Domain domain,
                                 double lat_deg) {
  if (domain == Domain::ellipsoid) {
    interp::VectorDerivatives result = interp::per_metre_wgs84(d, lat_deg);
    for (double* part : {&result.east_by_east, &result.east_by_north,
                         &result.north_by_east, &result.north_by_north})
      *part *= 1000;
    return result;
  }
  interp::VectorDerivatives result = d;
  for (double* part : {&result.east_by_east, &result.east_by_north, &result.north_by_east,
                       &result.north_by_north})
    *part /= stripack::earth_radius_km;
  return result;
}

std::string rate_units(const std::string& units) {
  return units.empty() ? "" : units + " km-1";
}

/// Divergence and curl at `places`.
std::vector<io::GridVariable> rates(const interp::SphereVectorField& field,
                                    std::span<const stripack::Direction> places,
                                    const Points& points, const RunOptions& run) {
  const std::string units = rate_units(points.table.value_units);
  io::GridVariable divergence{"divergence_per_km", units, {}},
      curl{"curl_per_km", units, {}};
  for (std::size_t i = 0; const auto& d : field.derivatives(places, run)) {
    const double lat_deg = stripack::lonlat(places[i++]).lat_deg;
    const interp::VectorDerivatives rate = per_km(d, points.domain, lat_deg);
    divergence.values.push_back(rate.divergence());
    curl.values.push_back(rate.curl());
  }
  return {std::move(divergence), std::move(curl)};
}

}  // namespace

void add_vector_option(CLI::App& app, PointSettings& points, VectorSettings& settings) {
  const auto set = [&points, &settings](const std::string& text) {
    std::tie(points.columns.value, points.columns.second_value) = parse_columns(text);
    settings.is_wanted = true;
  };
  app.add_option_function<std::string>(
         "--vector", set,
         "Columns of a vector's components towards east and north (winds, velocities), "
         "interpolated as a vector, over poles too; globe only; instead of --value")
      ->type_name("U,V")
      ->excludes(app.get_option("--value"));
}

interp::SphereVectorField fit_vectors(const Points& points,
                                      const Triangulated& triangulated,
                                      const SurfaceSettings& settings,
                                      Reporter& reporter) {
  check_domain(points);
  check_duplicates(points);
  return reporter.timed(Phase::fit, [&] {
    return blaming(points, [&] {
      auto field = make_field(points, std::get<GlobeTriangulation>(triangulated),
                              settings, reporter.run_options("fitting"));
      say_fits(field.fits(), reporter);
      return field;
    });
  });
}

std::vector<io::GridVariable> vectors_at(const interp::SphereVectorField& field,
                                         const VectorSettings& settings,
                                         const Points& points, const Points& queries,
                                         Reporter& reporter) {
  const io::PointTable& table = points.table;
  const std::vector<stripack::Direction> places = directions(queries);
  return reporter.timed(Phase::evaluate, [&] {
    std::vector<io::GridVariable> columns{
        {table.value_name, table.value_units, {}},
        {table.second_value_name, table.second_value_units, {}}};
    const auto found = field.values(places, reporter.run_options("sampling"));
    for (std::size_t i = 0; i < found.size(); ++i) {
      const EastNorth v = interp::with_longitude(
          found[i], LonLat{queries.table.x[i], queries.table.y[i]});
      columns[0].values.push_back(v.east);
      columns[1].values.push_back(v.north);
    }
    if (!settings.wants_derivatives) return columns;
    for (auto& column : rates(field, places, points, reporter.run_options("derivatives")))
      columns.push_back(std::move(column));
    return columns;
  });
}

io::GridFile vectors_on(const interp::SphereVectorField& field,
                        const VectorSettings& settings, const Points& points,
                        const interp::Grid& grid, Reporter& reporter) {
  const io::PointTable& table = points.table;
  return reporter.timed(Phase::evaluate, [&] {
    interp::VectorGrid found = field.grid(grid, reporter.run_options("gridding"));
    io::GridFile file{std::move(found.east), {}, {}};
    file.info.name = file.info.long_name = table.value_name;
    file.info.units = table.value_units;
    file.info.is_lonlat = true;
    file.more.push_back({table.second_value_name, table.second_value_units,
                         std::move(found.north.values)});
    if (!settings.wants_derivatives) return file;
    const auto nodes = interp::globe_nodes(grid);
    for (auto& variable :
         rates(field, nodes, points, reporter.run_options("derivatives")))
      file.more.push_back(std::move(variable));
    return file;
  });
}

}  // namespace delone::cli
