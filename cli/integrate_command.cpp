#include "cli/integrate_command.hpp"

#include <fmt/format.h>

#include <concepts>
#include <iterator>
#include <memory>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/queries.hpp"
#include "cli/region_input.hpp"
#include "cli/surface.hpp"
#include "interp/region_integral.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  SurfaceSettings surface;
  OutputSettings output;
  std::string regions;  ///< empty: everything
  bool is_each_ring = false;
};

/// A line of the output.
struct Row {
  std::string name;
  interp::RegionIntegral value;
  double covered = 1;  ///< part of the region's area
};

void check(const Settings& settings) {
  if (settings.is_each_ring && settings.regions.empty())
    throw UsageError(
        "--each-ring needs a file of regions: delone integrate POINTS "
        "REGIONS --each-ring");
}

tripack::Point2 corner(const std::array<double, 2>& p, const interp::PlaneRegion*) {
  return {p[0], p[1]};
}
stripack::Direction corner(const std::array<double, 2>& p, const interp::SphereRegion*) {
  return stripack::Direction::from(stripack::LonLat{p[0], p[1]});
}

/// An error of a region's rings, naming its file and, of two sides that cross, where they
/// begin.
Error located(const std::string& path, const NamedRings& region, const Error& error) {
  const std::string where = fmt::format("{}: region {}", display_name(path), region.name);
  const auto rows = error.rows();
  std::vector<std::array<double, 2>> corners;
  for (const io::PlaneRing& ring : region.rings)
    corners.insert(corners.end(), ring.begin(), ring.end());
  const bool are_sides =
      rows.size() == 2 &&
      std::string_view(error.what()).find("cross") != std::string_view::npos;
  if (!are_sides) return Error(fmt::format("{}: {}", where, error.what()));
  const auto place = [&](std::size_t k) {
    const auto& p = corners.at(static_cast<std::size_t>(rows[k]));
    return fmt::format("({}, {})", p[0], p[1]);
  };
  return Error(fmt::format(
      "{}: the sides that begin at {} and {} cross; divide them where they meet", where,
      place(0), place(1)));
}

template <class Region>
Region region_of(const Settings& settings, const NamedRings& named) {
  try {
    std::vector<std::vector<decltype(corner({}, static_cast<Region*>(nullptr)))>> rings;
    for (const io::PlaneRing& ring : named.rings) {
      auto& corners = rings.emplace_back();
      for (const auto& p : ring)
        corners.push_back(corner(p, static_cast<Region*>(nullptr)));
    }
    return Region(rings);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw located(settings.regions, named, error);
  }
}

interp::AreaUnit unit_of(const Points& points) {
  return points.domain == Domain::ellipsoid ? interp::AreaUnit::km2_wgs84
                                            : interp::AreaUnit::km2_sphere;
}

interp::RegionIntegral integral(const auto& surface, const interp::PlaneRegion& region,
                                const Points&, const RunOptions& run) {
  return surface.integral(region, run);
}
interp::RegionIntegral integral(const auto& surface, const interp::SphereRegion& region,
                                const Points& points, const RunOptions& run) {
  return surface.integral(region, unit_of(points), run);
}

/// The part of a region's area that was integrated over.
double covered_part(const auto&, const interp::PlaneRegion& region,
                    const interp::RegionIntegral& value, const RunOptions&) {
  return value.area / region.area();
}
double covered_part(const auto& surface, const interp::SphereRegion& region,
                    const interp::RegionIntegral&, const RunOptions& run) {
  return surface.integral(region, interp::AreaUnit::steradian, run).area / region.area();
}

template <class Region>
std::vector<Row> rows_of(const auto& surface, const Settings& settings,
                         const std::vector<NamedRings>& regions, const Points& points,
                         Reporter& reporter) {
  const auto run = [&] { return reporter.run_options("integrating"); };
  if (settings.regions.empty())
    return {{"all", integral(surface, Region(), points, run())}};
  std::vector<Row> rows;
  for (const NamedRings& named : regions) {
    const Region region = region_of<Region>(settings, named);
    const auto value = integral(surface, region, points, run());
    rows.push_back({named.name, value, covered_part(surface, region, value, run())});
  }
  return rows;
}

template <class Surface>
concept PlaneIntegrable = requires(const Surface& surface) {
  {
    surface.integral(interp::PlaneRegion(), RunOptions())
    } -> std::same_as<interp::RegionIntegral>;
};
template <class Surface>
concept SphereIntegrable = requires(const Surface& surface) {
  {
    surface.integral(interp::SphereRegion(), interp::AreaUnit::steradian, RunOptions())
    } -> std::same_as<interp::RegionIntegral>;
};

std::vector<Row> integrate(const Surface& surface, const Settings& settings,
                           const std::vector<NamedRings>& regions, const Points& points,
                           Reporter& reporter) {
  return std::visit(
      [&]<class S>(const S& s) -> std::vector<Row> {
        if constexpr (PlaneIntegrable<S>) {
          return rows_of<interp::PlaneRegion>(s, settings, regions, points, reporter);
        } else if constexpr (SphereIntegrable<S>) {
          return rows_of<interp::SphereRegion>(s, settings, regions, points, reporter);
        } else {
          throw UsageError("this surface has no integral; use --method linear or c1");
        }
      },
      surface);
}

void say_uncovered(const std::vector<Row>& rows, const Reporter& reporter) {
  const auto is_partly = [](const Row& row) { return row.covered < 1 - 1e-9; };
  const auto count = std::ranges::count_if(rows, is_partly);
  if (count > 0)
    reporter.say("{} of {} beyond the triangulated area: see the column 'covered'", count,
                 rows.size() == 1 ? "1 region reaches"
                                  : fmt::format("{} regions reach", rows.size()));
}

std::string as_text(const std::vector<Row>& rows, const Points& points) {
  const char* const area = points.is_on_plane() ? "area" : "area_km2";
  const char* const total = points.is_on_plane() ? "integral" : "integral_km2";
  fmt::memory_buffer buffer;
  fmt::format_to(std::back_inserter(buffer), "region,{},{},mean,covered\n", area, total);
  for (const Row& row : rows) {
    fmt::format_to(std::back_inserter(buffer), "{}", row.name);
    for (const double number :
         {row.value.area, row.value.integral, row.value.mean(), row.covered})
      append_number(buffer, number);
    buffer.push_back('\n');
  }
  return {buffer.data(), buffer.size()};
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check(settings);
  static_cast<void>(choose_format(settings.output, {"csv"}));
  check_inputs(settings.points.path, settings.regions);
  check_output(settings.output.path, {settings.points.path, settings.regions});
  const Points points = read_points(settings.points, reporter);
  std::vector<NamedRings> regions;
  if (!settings.regions.empty()) {
    const auto rings = settings.is_each_ring ? TableRings::each : TableRings::together;
    regions = reporter.timed(
        Phase::read, [&] { return read_regions(settings.regions, rings, reporter); });
  }
  const Triangulated triangulated = triangulate(points, reporter);
  const Surface surface = fit(points, triangulated, settings.surface, reporter);
  const std::vector<Row> rows = reporter.timed(Phase::evaluate, [&] {
    return integrate(surface, settings, regions, points, reporter);
  });
  say_uncovered(rows, reporter);
  reporter.timed(Phase::write,
                 [&] { io::write_text(settings.output.path, as_text(rows, points)); });
  return ExitCode::done;
}

}  // namespace

Command add_integrate_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "integrate", "Integral, mean and area of the surface, over regions or everything");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::needed);
  app.add_option("REGIONS", settings->regions,
                 "GeoJSON, whose polygons are a region each, or a table of rings (ring "
                 "number, x, y); without it everything that is triangulated")
      ->type_name("REGIONS");
  add_triangle_surface_options(app, settings->surface);
  app.add_flag("--each-ring", settings->is_each_ring,
               "Every ring of a table is a region; else all together are one, of what an "
               "odd number of rings enclose");
  add_optional_output_options(app, settings->output,
                              ".csv: region, area, integral, mean, covered");
  app.footer(
      "Only what is triangulated counts: 'covered' is that part of the region's area. "
      "Areas are in squared\n"
      "units of x and y, on the globe in square kilometres, integrals in the value's "
      "unit "
      "times that. On the\n"
      "globe sides are great circles, the inside on the left of the first ring (GeoJSON: "
      "as drawn on the map).\n\n"
      "Example:\n  delone integrate rain.csv catchments.geojson -o rain_by_catchment.csv "
      "--method c1\n"
      "  delone integrate geoid.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
