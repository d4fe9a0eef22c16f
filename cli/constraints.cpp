#include "cli/constraints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/output.hpp"
#include "cli/triangle_output.hpp"
#include "io/poly_file.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "tripack/constrained_triangulation.hpp"
#include "tripack/refine.hpp"

namespace delone::cli {
namespace {

using delaunay::Node;

/// The columns of a table for positions that stand in a .poly file.
void fill_table(io::PointTable& table, const io::NodeFile& nodes) {
  table.x = nodes.x;
  table.y = nodes.y;
  table.num_rows = static_cast<std::int64_t>(nodes.x.size());
  table.x_name = "x";
  table.y_name = "y";
}

ConstrainedInput read_poly_alone(const PointSettings& settings, Reporter& reporter) {
  io::PolyFile file =
      reporter.timed(Phase::read, [&] { return io::read_poly(settings.path); });
  ConstrainedInput input;
  input.points.path = file.node_path.empty() ? settings.path : file.node_path;
  input.points.domain = settings.domain.value_or(Domain::plane);
  input.points.duplicates = settings.duplicates;
  fill_table(input.points.table, file.nodes);
  input.graph = std::move(file.graph);
  input.path = settings.path;
  input.segment_lines = std::move(file.segment_lines);
  input.file_base = file.nodes.base;
  return input;
}

/// Adds points to those of the table and segments between them.
void add_poly(ConstrainedInput& input, const std::string& path) {
  io::PolyFile file = io::read_poly(path);
  const auto first = static_cast<Node>(input.graph.points.size());
  input.graph.points.insert(input.graph.points.end(), file.graph.points.begin(),
                            file.graph.points.end());
  for (const auto& [from, to] : file.graph.segments)
    input.graph.segments.push_back({from + first, to + first});
  input.graph.holes = std::move(file.graph.holes);
  input.graph.regions = std::move(file.graph.regions);
  input.segment_lines = std::move(file.segment_lines);
}

/// Consecutive rows with one ring number are a ring; whether the last repeats the first
/// does not matter.
void add_rings(ConstrainedInput& input, const std::string& path) {
  const io::PointTable table = io::read_table(path, {.x = "2", .y = "3", .value = "1"});
  input.are_rings = true;
  const std::size_t first = input.graph.points.size();
  for (std::size_t begin = 0, i = 0; i < table.x.size(); ++i) {
    input.graph.points.push_back({table.x[i], table.y[i]});
    const bool is_last = i + 1 == table.x.size() || table.value[i + 1] != table.value[i];
    const std::size_t next = is_last ? begin : i + 1;
    const bool is_closed = is_last && i > begin && table.x[i] == table.x[begin] &&
                           table.y[i] == table.y[begin];
    if (!is_closed) {
      input.graph.segments.push_back(
          {static_cast<Node>(first + i), static_cast<Node>(first + next)});
      input.segment_lines.push_back(table.line_of(i));
    }
    if (is_last) begin = i + 1;
  }
}

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

std::string described(const delaunay::SegmentReport& report, std::int64_t num_added) {
  std::string text;
  const auto add = [&](std::size_t count, std::string_view noun, std::string_view rest) {
    if (count > 0)
      text +=
          fmt::format("; {} {}", counted(static_cast<std::int64_t>(count), noun), rest);
  };
  add(report.on_segment.size(), "point", "on segments divide them");
  add(report.repeated.size(), "segment", "repeated");
  add(report.overlapping.size(), "pair", "of segments overlapping");
  add(report.zero_length.size(), "segment", "of length zero left out");
  add(report.crossing.size(), "crossing",
      fmt::format("split ({})", counted(num_added, "added point")));
  return text;
}

/// A crossing with the lines of the file in the place of numbers.
Error located(const ConstrainedInput& input, const Error& error) {
  const auto rows = error.rows();
  const std::string file = display_name(input.path);
  if (rows.size() != 2)
    return Error(fmt::format("{}: {}", file, error.what()), {rows.begin(), rows.end()});
  const auto line = [&](std::int64_t segment) {
    return input.segment_lines[static_cast<std::size_t>(segment)];
  };
  return Error(
      fmt::format("{}: the segments of lines {} and {} cross; divide them where they "
                  "meet, or use --split-intersections",
                  file, line(rows[0]), line(rows[1])),
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

stripack::ConstrainedTriangulation build_globe(const ConstrainedInput& input,
                                               const ConstraintSettings& settings,
                                               Reporter& reporter) {
  stripack::SphereConstraintOptions options{.domain = domain_of(input, settings),
                                            .crossings = crossings_of(settings)};
  if (!settings.outside.empty()) {
    const auto numbers = parse_numbers("--outside", settings.outside, 2, 2);
    options.outside = direction({numbers[0], numbers[1]});
  }
  return blaming(input, [&] {
    stripack::SphereGraph graph;
    for (const auto& p : input.graph.points) graph.points.push_back(direction(p));
    graph.arcs = input.graph.segments;
    for (const auto& p : input.graph.holes) graph.holes.push_back(direction(p));
    for (const auto& seed : input.graph.regions)
      graph.regions.push_back({direction(seed.point), seed.attribute});
    return stripack::ConstrainedTriangulation(graph, options,
                                              reporter.run_options("triangulating"));
  });
}

tripack::Point2 coordinates(tripack::Point2 p) { return p; }
tripack::Point2 coordinates(const stripack::Direction& d) {
  const stripack::LonLat p = lonlat(d);
  return {p.lon_deg, p.lat_deg};
}

template <class Triangulation>
ConstrainedOutput output_of(const ConstrainedInput& input, const Triangulation& t,
                            std::int64_t num_refined, const Reporter& reporter) {
  const std::int64_t num_added = t.num_rows() - t.num_input_rows();
  reporter.say("{}, {} in {}{}", counted(t.num_segments(), "segment"),
               counted(t.num_triangles(), "triangle"),
               counted(std::ssize(t.regions()), "region"),
               described(t.report(), num_added - num_refined));
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
  return output;
}

}  // namespace

void add_constraint_options(CLI::App& app, ConstraintSettings& settings) {
  app.add_option("--constraints", settings.path,
                 "Segments to keep and the domain that they enclose: a .poly file, or a "
                 "table of rings (ring number, x, y)")
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

bool is_poly(const std::string& path) { return path.ends_with(".poly"); }

ConstrainedInput read_constrained(const PointSettings& points,
                                  const ConstraintSettings& settings,
                                  Reporter& reporter) {
  if (is_poly(points.path)) {
    if (!settings.path.empty())
      throw UsageError(
          "a .poly file carries its own segments; give points of another kind with "
          "--constraints");
    return read_poly_alone(points, reporter);
  }
  if (settings.path.ends_with(".geojson") || settings.path.ends_with(".json"))
    throw Error(settings.path +
                ": GeoJSON is not read here; give a .poly file, or a table of rings with "
                "the columns ring number, x, y");
  check_inputs(points.path, settings.path);
  ConstrainedInput input;
  input.points = read_points(points, reporter);
  input.graph.points = plane_points(input.points);
  input.path = settings.path;
  reporter.timed(Phase::read, [&] {
    is_poly(settings.path) ? add_poly(input, settings.path)
                           : add_rings(input, settings.path);
  });
  if (input.points.table.is_node_file) input.file_base = input.points.table.base;
  return input;
}

ConstrainedOutput triangulate(const ConstrainedInput& input,
                              const ConstraintSettings& settings, Reporter& reporter) {
  check_domain(input, settings);
  if (input.points.is_on_plane()) {
    const auto refined = reporter.timed(
        Phase::build, [&] { return build_plane(input, settings, reporter); });
    ConstrainedOutput output =
        output_of(input, refined.triangulation, refined.num_added, reporter);
    if (settings.refines()) say_refined(settings, refined, reporter);
    return output;
  }
  const auto t = reporter.timed(Phase::build,
                                [&] { return build_globe(input, settings, reporter); });
  return output_of(input, t, 0, reporter);
}

}  // namespace delone::cli
