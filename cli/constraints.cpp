#include "cli/constraints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/output.hpp"
#include "cli/triangle_output.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "stripack/hole_points.hpp"
#include "tripack/constrained_triangulation.hpp"
#include "tripack/hole_points.hpp"
#include "tripack/refine.hpp"

namespace delone::cli {
namespace {

using delaunay::Node;

/// The output's number of a row of the triangulation.
class Numbering {
 public:
  explicit Numbering(const Points& points) : points_(points) {}
  [[nodiscard]] std::int32_t operator()(Node row) const {
    if (row < points_.size()) return node_number(points_.table, row);
    return static_cast<std::int32_t>(points_.table.num_rows + (row - points_.size()));
  }

 private:
  const Points& points_;
};

std::string described(const ConstrainedInput& input,
                      const delaunay::SegmentReport& report, std::int64_t num_added) {
  std::string text;
  const auto add = [&](std::int64_t count, std::string_view noun, std::string_view rest) {
    if (count > 0) text += fmt::format("; {} {}", counted(count, noun), rest);
  };
  add(std::ssize(report.on_segment), "point", "on segments divide them");
  add(std::ssize(report.repeated) - input.num_doubled, "segment", "repeated");
  add(std::ssize(report.overlapping), "pair", "of segments overlapping");
  add(std::ssize(report.zero_length), "segment", "of length zero left out");
  add(std::ssize(report.crossing), "crossing",
      fmt::format("split ({})", counted(num_added, "added point")));
  return text;
}

/// A crossing with the lines of the file in the place of numbers.
Error located(const ConstrainedInput& input, const Error& error) {
  const auto rows = error.rows();
  const std::string file = display_name(input.path);
  if (rows.size() != 2)
    return Error(fmt::format("{}: {}", file, error.what()), {rows.begin(), rows.end()});
  return Error(fmt::format("{}: the segments {} cross; divide them where they meet, or "
                           "use --split-intersections",
                           file, names_of_segments(input, rows[0], rows[1])),
               {rows.begin(), rows.end()});
}

/// Does `work`; an Error of the library comes out naming the file and its lines.
template <class Work>
decltype(auto) blaming(const ConstrainedInput& input, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw located(input, error);
  }
}

delaunay::Domain domain_of(const ConstrainedInput& input,
                           const ConstraintSettings& settings) {
  if (settings.keeps_outside) return delaunay::Domain::hull;
  return input.are_rings ? delaunay::Domain::even_odd : delaunay::Domain::enclosed;
}

delaunay::Crossings crossings_of(const ConstraintSettings& settings) {
  return settings.splits ? delaunay::Crossings::split : delaunay::Crossings::error;
}

/// Without a wish to refine, the triangulation as it is: nothing added, nothing counted.
tripack::Refinement build_plane(const ConstrainedInput& input,
                                const ConstraintSettings& settings, Reporter& reporter) {
  const delaunay::ConstraintOptions constraints{.domain = domain_of(input, settings),
                                                .crossings = crossings_of(settings)};
  return blaming(input, [&] {
    if (!settings.refines()) {
      return tripack::Refinement{tripack::ConstrainedTriangulation(
          input.graph, constraints, reporter.run_options("triangulating"))};
    }
    tripack::RefineOptions options{.max_area = settings.max_area.value_or(0),
                                   .constraints = constraints};
    if (settings.min_angle_deg) options.min_angle_deg = *settings.min_angle_deg;
    return tripack::refine(input.graph, options, reporter.run_options("refining"));
  });
}

/// What refinement did, and what it could not do.
void say_refined(const ConstraintSettings& settings, const tripack::Refinement& refined,
                 const Reporter& reporter) {
  const double angle =
      settings.min_angle_deg.value_or(tripack::RefineOptions().min_angle_deg);
  std::string text = fmt::format(
      "refined: {}; {} below {} degrees (smallest angle {:.4g})",
      counted(refined.num_added, "added point"),
      counted(refined.num_below_angle, "triangle"), angle, refined.smallest_angle_deg);
  if (refined.num_above_area > 0)
    text += fmt::format("; {} above the largest area",
                        counted(refined.num_above_area, "triangle"));
  reporter.say("{}", text);
}

/// Options that have no meaning where the points lie, or at all.
void check_domain(const ConstrainedInput& input, const ConstraintSettings& settings) {
  const bool is_on_plane = input.points.is_on_plane();
  if (is_on_plane && !settings.outside.empty())
    throw UsageError("--outside is for the globe; in the plane the outside is known");
  if (settings.max_area && !(*settings.max_area > 0))
    throw UsageError(
        fmt::format("--max-area {}: no triangle is as small; give an area above 0",
                    *settings.max_area));
  if (!is_on_plane && settings.refines())
    throw UsageError(
        "--min-angle and --max-area are for the plane; project the points, or say --on "
        "plane");
}

stripack::Direction direction(tripack::Point2 p) {
  return stripack::Direction::from(stripack::LonLat{p.x, p.y});
}

stripack::SphereConstraintOptions globe_options(const ConstrainedInput& input,
                                                const ConstraintSettings& settings) {
  stripack::SphereConstraintOptions options{.domain = domain_of(input, settings),
                                            .crossings = crossings_of(settings)};
  if (settings.outside.empty()) return options;
  const auto numbers = parse_numbers("--outside", settings.outside, 2, 2);
  if (!(numbers[1] >= -90 && numbers[1] <= 90))
    throw UsageError(
        fmt::format("--outside '{}': the latitude is outside -90..90", settings.outside));
  options.outside = direction({numbers[0], numbers[1]});
  return options;
}

stripack::SphereGraph globe_graph(const ConstrainedInput& input) {
  stripack::SphereGraph graph;
  graph.points = directions(input.points);  // names file and line of a bad latitude
  graph.arcs = input.graph.segments;
  return blaming(input, [&] {
    const auto& points = input.graph.points;
    for (std::size_t i = graph.points.size(); i < points.size(); ++i)
      graph.points.push_back(direction(points[i]));
    for (const auto& p : input.graph.holes) graph.holes.push_back(direction(p));
    for (const auto& seed : input.graph.regions)
      graph.regions.push_back({direction(seed.point), seed.attribute});
    return std::move(graph);
  });
}

/// Does the sense of the first ring of a table say where the inside is?
bool follows_sense(const ConstrainedInput& input, const ConstraintSettings& settings) {
  return input.is_sense_open && settings.outside.empty() && !settings.keeps_outside;
}

/// An Error that the choice of the inside may have caused, with the mend for it.
Error with_outside_hint(const Error& error) {
  return Error(fmt::format(
      "{} (inside is what lies left of the first ring, so a clockwise ring means all the "
      "rest of the globe: turn it round, or give a point outside of all rings with "
      "--outside LON/LAT)",
      error.what()));
}

stripack::ConstrainedTriangulation build_globe(const ConstrainedInput& input,
                                               const ConstraintSettings& settings,
                                               Reporter& reporter) {
  const auto options = globe_options(input, settings);
  const auto graph = globe_graph(input);
  const bool is_open = follows_sense(input, settings);
  if (is_open)
    reporter.say(
        "inside is what lies left of the first ring; if that is the wrong side, name a "
        "point outside of all rings with --outside LON/LAT");
  return blaming(input, [&] {
    try {
      return stripack::ConstrainedTriangulation(graph, options,
                                                reporter.run_options("triangulating"));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!is_open || !error.rows().empty()) throw;
      throw with_outside_hint(error);
    }
  });
}

tripack::Point2 coordinates(tripack::Point2 p) { return p; }
tripack::Point2 coordinates(const stripack::Direction& d) {
  const stripack::LonLat p = lonlat(d);
  return {p.lon_deg, p.lat_deg};
}

template <class Triangulation>
void say_domain(const ConstrainedInput& input, const Triangulation& t,
                std::int64_t num_crossings, const Reporter& reporter) {
  reporter.say("{}, {} in {}{}", counted(t.num_segments() - input.num_doubled, "segment"),
               counted(t.num_triangles(), "triangle"),
               counted(std::ssize(t.regions()), "region"),
               described(input, t.report(), num_crossings));
}

/// Segments were given for a domain; nobody wants none.
template <class Triangulation>
void require_domain(const ConstrainedInput& input, const Triangulation& t) {
  if (t.num_triangles() > 0 || t.mesh().num_faces() == 0) return;
  throw Error(fmt::format(
      "{}: its {} no domain, so no triangle is left; close the rings, or keep the whole "
      "hull with --keep-outside",
      display_name(input.path),
      t.num_segments() - input.num_doubled == 1
          ? "1 segment encloses"
          : fmt::format("{} segments enclose", t.num_segments() - input.num_doubled)));
}

template <class Triangulation>
ConstrainedOutput output_of(const ConstrainedInput& input, const Triangulation& t,
                            std::int64_t num_refined, const Reporter& reporter) {
  require_domain(input, t);
  const std::int64_t num_added = t.num_rows() - t.num_input_rows();
  say_domain(input, t, num_added - num_refined, reporter);
  ConstrainedOutput output;
  output.num_added = num_added;
  if (input.points.size() > 0) output.nodes = output_nodes(input.points);
  for (Node row = static_cast<Node>(input.points.size()); row < t.num_rows(); ++row) {
    const tripack::Point2 p = row < t.num_input_rows()
                                  ? input.graph.points[static_cast<std::size_t>(row)]
                                  : coordinates(t.point(row));
    output.nodes.x.push_back(p.x);
    output.nodes.y.push_back(p.y);
  }
  output.triangles = t.triangles();
  const Numbering number(input.points);
  for (io::Triangle& triangle : output.triangles) {
    for (std::int32_t& corner : triangle) corner = number(corner);
  }
  for (const auto& [from, to] : t.constraint_edges())
    output.pieces.push_back({number(from), number(to)});
  return output;
}

}  // namespace

void add_domain_options(CLI::App& app, ConstraintSettings& settings) {
  app.add_option("--constraints", settings.path,
                 "Segments to keep and the domain that they enclose: a .poly file, "
                 "GeoJSON (lines and polygons), or a table of rings (ring number, x, y)")
      ->type_name("FILE");
  app.add_flag("--keep-outside", settings.keeps_outside,
               "With segments: triangulate the whole hull, holes too");
  app.add_option("--outside", settings.outside,
                 "On the globe: a point outside of all rings (else the left of the first "
                 "segment is inside)")
      ->type_name("LON/LAT");
  app.add_flag("--split-intersections", settings.splits,
               "Segments that cross both go through an added vertex; else they are an "
               "error");
}

void add_refinement_options(CLI::App& app, ConstraintSettings& settings) {
  app.add_option("--min-angle", settings.min_angle_deg,
                 "Plane, with segments: add points until no angle is smaller, as far as "
                 "those of the segments allow (default with --max-area: 20.7; up to "
                 "about 33 works in practice)")
      ->type_name("DEG")
      ->check(CLI::Range(0.0, 34.0));
  app.add_option(
         "--max-area", settings.max_area,
         "Plane, with segments: add points until no triangle is larger (squared "
         "units of x and y); regions of a .poly file may have limits of their own")
      ->type_name("A");
}

bool has_segments(const std::string& points, const ConstraintSettings& settings) {
  if (is_poly(points) || !settings.path.empty()) return true;
  if (settings.needs_segments())
    throw UsageError(
        "--keep-outside, --split-intersections, --outside, --min-angle and --max-area "
        "need segments: a .poly file or --constraints FILE");
  return false;
}

Constrained build_constrained(const ConstrainedInput& input,
                              const ConstraintSettings& settings, Reporter& reporter) {
  check_domain(input, settings);
  return reporter.timed(Phase::build, [&]() -> Constrained {
    if (!input.points.is_on_plane()) return build_globe(input, settings, reporter);
    return build_plane(input, settings, reporter).triangulation;
  });
}

Constrained build_domain(const ConstrainedInput& input,
                         const ConstraintSettings& settings, Reporter& reporter) {
  Constrained built = build_constrained(input, settings, reporter);
  std::visit(
      [&](const auto& t) {
        require_domain(input, t);
        say_domain(input, t, t.num_rows() - t.num_input_rows(), reporter);
      },
      built);
  return built;
}

ConstrainedOutput triangulate(const ConstrainedInput& input,
                              const ConstraintSettings& settings, Reporter& reporter) {
  check_domain(input, settings);
  if (input.points.is_on_plane()) {
    auto refined = reporter.timed(Phase::build,
                                  [&] { return build_plane(input, settings, reporter); });
    ConstrainedOutput output =
        output_of(input, refined.triangulation, refined.num_added, reporter);
    if (settings.refines()) say_refined(settings, refined, reporter);
    output.triangulation = std::move(refined.triangulation);
    return output;
  }
  auto t = reporter.timed(Phase::build,
                          [&] { return build_globe(input, settings, reporter); });
  ConstrainedOutput output = output_of(input, t, 0, reporter);
  output.triangulation = std::move(t);
  return output;
}

std::vector<tripack::Point2> hole_points(const ConstrainedInput& input,
                                         const ConstraintSettings& settings,
                                         const ConstrainedOutput& output) {
  const bool are_named = !input.are_rings && settings.outside.empty();
  if (are_named || settings.keeps_outside) return input.graph.holes;
  return blaming(input, [&] {
    std::vector<tripack::Point2> points;
    const auto add = [&](const auto& t) {
      for (const auto& [x, y] : hole_points(t)) points.push_back({x, y});
    };
    std::visit(add, output.triangulation);
    return points;
  });
}

}  // namespace delone::cli
