#include "cli/constrained_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "io/geojson_lines.hpp"
#include "io/output_file.hpp"
#include "io/poly_file.hpp"

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
  reporter.count_points(input.points.size());
  input.graph = std::move(file.graph);
  input.path = settings.path;
  input.segment_lines = std::move(file.segment_lines);
  input.file_base = file.nodes.base;
  input.attributes = std::move(file.nodes.attributes);
  return input;
}

/// Adds points to those of the table and segments between them.
void add_poly(ConstrainedInput& input) {
  io::PolyFile file = io::read_poly(input.path);
  const auto first = static_cast<Node>(input.graph.points.size());
  input.graph.points.insert(input.graph.points.end(), file.graph.points.begin(),
                            file.graph.points.end());
  for (const auto& [from, to] : file.graph.segments)
    input.graph.segments.push_back({from + first, to + first});
  input.graph.holes = std::move(file.graph.holes);
  input.graph.regions = std::move(file.graph.regions);
  input.segment_lines = std::move(file.segment_lines);
}

io::PointTable read_ring_table(const std::string& path) {
  try {
    return io::read_table(path, {.content = io::TableOptions::Content::rings});
  } catch (const io::ReadError& error) {
    if (path != "-" && !std::filesystem::exists(path)) throw;
    throw io::ReadError(
        fmt::format("{} (--constraints takes a .poly, GeoJSON, or a table of rings with "
                    "the columns ring number, x, y)",
                    error.what()));
  }
}

/// Rows begin .. end - 1 have one number: are they a ring?
void check_ring(const std::string& path, const io::PointTable& table, std::size_t begin,
                std::size_t end) {
  const double number = table.value[begin];
  if (number == std::floor(number) && end - begin >= 3) return;
  throw io::ReadError(fmt::format(
      "{}: line {}: '{}' in the place of a ring number has {}, and a ring needs three; "
      "the columns must be ring number, x, y (they are '{}', '{}', '{}')",
      display_name(path), table.line_of(begin), number,
      counted(static_cast<std::int64_t>(end - begin), "row"), table.value_name,
      table.x_name, table.y_name));
}

/// Consecutive rows with one ring number are a ring; whether the last repeats the first
/// does not matter.
void add_ring(ConstrainedInput& input, const io::PointTable& table, std::size_t begin,
              std::size_t end) {
  const std::size_t first = input.graph.points.size();
  const bool repeats =
      table.x[begin] == table.x[end - 1] && table.y[begin] == table.y[end - 1];
  const std::size_t size = end - begin - (repeats ? 1 : 0);
  for (std::size_t i = begin; i < end; ++i)
    input.graph.points.push_back({table.x[i], table.y[i]});
  for (std::size_t k = 0; k < size; ++k) {
    input.graph.segments.push_back(
        {static_cast<Node>(first + k), static_cast<Node>(first + (k + 1) % size)});
    input.segment_lines.push_back(table.line_of(begin + k));
  }
}

void add_rings(ConstrainedInput& input, const Reporter& reporter) {
  const io::PointTable table = read_ring_table(input.path);
  std::int64_t num_rings = 0;
  for (std::size_t begin = 0, end = 0; begin < table.x.size(); begin = end, ++num_rings) {
    while (end < table.x.size() && table.value[end] == table.value[begin]) ++end;
    check_ring(input.path, table, begin, end);
    add_ring(input, table, begin, end);
  }
  input.are_rings = true;
  input.is_sense_open = true;
  reporter.say("{}: {} of {} ('{}', '{}', '{}'){}", display_name(input.path),
               counted(num_rings, "ring"), counted(std::ssize(table.x), "row"),
               table.value_name, table.x_name, table.y_name,
               table.num_missing == 0
                   ? ""
                   : fmt::format(", {} without a number dropped", table.num_missing));
}

enum class Line { open, closed };

void add_line(ConstrainedInput& input, const io::PlaneRing& line, Line kind) {
  tripack::PlanarGraph& graph = input.graph;
  const auto first = static_cast<Node>(graph.points.size());
  for (const auto& [x, y] : line) graph.points.push_back({x, y});
  for (Node i = first; i + 1 < std::ssize(graph.points); ++i)
    graph.segments.push_back({i, i + 1});
  if (kind == Line::closed)
    graph.segments.push_back({static_cast<Node>(graph.points.size()) - 1, first});
}

/// A line has no inside. Among rings, which are counted, it is given a second time: what
/// two rings share does not count.
void double_lines(ConstrainedInput& input, std::size_t first) {
  auto& [points, segments, holes, regions] = input.graph;
  for (std::size_t i = first, end = segments.size(); i < end; ++i) {
    const auto [from, to] = segments[i];
    if (points[static_cast<std::size_t>(from)] == points[static_cast<std::size_t>(to)])
      continue;
    segments.push_back({to, from});
    ++input.num_doubled;
  }
}

void add_geojson(ConstrainedInput& input, const Reporter& reporter) {
  const io::GeoJsonLines file = io::read_geojson_lines(input.path);
  const std::string name = display_name(input.path);
  if (file.rings.empty() && file.lines.empty())
    throw io::ReadError(
        fmt::format("{}: it holds {} and no line or polygon; constraints are LineStrings "
                    "and Polygons",
                    name, counted(file.num_points, "point")));
  for (const io::PlaneRing& ring : file.rings) add_line(input, ring, Line::closed);
  const std::size_t first_line = input.graph.segments.size();
  for (const io::PlaneRing& line : file.lines) add_line(input, line, Line::open);
  input.are_rings = !file.rings.empty();
  if (input.are_rings) double_lines(input, first_line);
  reporter.say("{}: {}, {}{}", name, counted(std::ssize(file.rings), "ring"),
               counted(std::ssize(file.lines), "line"),
               file.num_points == 0
                   ? ""
                   : fmt::format("; {} left out", counted(file.num_points, "point")));
}

bool is_geojson(const std::string& path) {
  const std::string format = io::file_format(path);
  return format == "geojson" || format == "json";
}

void add_constraints(ConstrainedInput& input, const Reporter& reporter) {
  if (is_poly(input.path))
    add_poly(input);
  else if (is_geojson(input.path))
    add_geojson(input, reporter);
  else
    add_rings(input, reporter);
}

}  // namespace

bool is_poly(const std::string& path) { return path.ends_with(".poly"); }

ConstrainedInput read_constrained(const PointSettings& points,
                                  const std::string& constraints, Reporter& reporter) {
  if (is_poly(points.path)) {
    if (!constraints.empty())
      throw UsageError(
          "a .poly file carries its own segments; give points of another kind with "
          "--constraints");
    return read_poly_alone(points, reporter);
  }
  check_inputs(points.path, constraints);
  ConstrainedInput input;
  input.points = read_points(points, reporter);
  input.graph.points = plane_points(input.points);
  input.path = constraints;
  reporter.timed(Phase::read, [&] { add_constraints(input, reporter); });
  if (input.points.table.is_node_file) input.file_base = input.points.table.base;
  return input;
}

std::string names_of_segments(const ConstrainedInput& input, std::int64_t first,
                              std::int64_t second) {
  const auto line = [&](std::int64_t i) {
    return input.segment_lines.at(static_cast<std::size_t>(i));
  };
  if (!input.segment_lines.empty())
    return fmt::format("of lines {} and {}", line(first), line(second));
  const auto name = [&](std::int64_t i) {
    const auto [from, to] = input.graph.segments.at(static_cast<std::size_t>(i));
    const auto& a = input.graph.points[static_cast<std::size_t>(from)];
    const auto& b = input.graph.points[static_cast<std::size_t>(to)];
    return fmt::format("({}, {}) - ({}, {})", a.x, a.y, b.x, b.y);
  };
  return fmt::format("{} and {}", name(first), name(second));
}

}  // namespace delone::cli
