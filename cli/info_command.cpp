#include "cli/info_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "stripack/hash.hpp"
#include "stripack/measures.hpp"
#include "tripack/hash.hpp"
#include "tripack/measures.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  bool is_json = false;
};

/// One line of the report: a key for JSON, a label for people, and the value for each.
struct Fact {
  std::string key, label, json, text;
};

Fact number(const std::string& key, const std::string& label, double value) {
  return {key, label, fmt::format("{}", value), fmt::format("{:.6g}", value)};
}

Fact number(const std::string& key, const std::string& label, std::int64_t value) {
  return {key, label, fmt::format("{}", value), fmt::format("{}", value)};
}

Fact word(const std::string& key, const std::string& label, const std::string& value) {
  return {key, label, json_string(value), value};
}

void add_range(std::vector<Fact>& facts, const std::string& key, const std::string& label,
               const std::vector<double>& column) {
  const auto [low, high] = std::ranges::minmax(column);
  facts.push_back({key, label, fmt::format("[{},{}]", low, high),
                   fmt::format("{} to {}", low, high)});
}

std::vector<Fact> facts_of_table(const Points& points) {
  const io::PointTable& table = points.table;
  std::vector<Fact> facts{
      word("file", "file", display_name(points.path)),
      word("on", "on", std::string(name_of(points.domain))),
      number("rows", "rows", table.num_rows),
      number("points", "points", points.size()),
      number("missing", "missing values", table.num_missing),
      number("bad", "bad rows", table.num_bad),
      word("x_column", "x", table.x_name),
      word("y_column", "y", table.y_name),
  };
  add_range(facts, "x_range", "x range", table.x);
  add_range(facts, "y_range", "y range", table.y);
  if (!table.value.empty()) {
    facts.push_back(word("value_column", "value", table.value_name));
    add_range(facts, "value_range", "value range", table.value);
  }
  return facts;
}

delaunay::TriangleQuality quality_of(const Points& points,
                                     const Triangulated& triangulated) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated))
    return tripack::triangle_quality(**plane);
  const stripack::Triangulation& globe = *std::get<GlobeTriangulation>(triangulated);
  return points.domain == Domain::ellipsoid ? stripack::triangle_quality_wgs84(globe)
                                            : stripack::triangle_quality(globe);
}

void add_facts_of_mesh(std::vector<Fact>& facts, const Points& points,
                       const Triangulated& triangulated) {
  std::visit(
      [&](const auto& t) {
        facts.push_back(
            number("positions", "different positions", std::int64_t{t->num_sites()}));
        facts.push_back(number("repeats", "repeated rows",
                               std::int64_t{t->num_rows() - t->num_sites()}));
        facts.push_back(number("dimension", "dimension", std::int64_t{t->dimension()}));
        facts.push_back(
            number("hull_nodes", "nodes on the hull", std::ssize(t->boundary())));
        facts.push_back(number("triangles", "triangles", t->num_triangles()));
        facts.push_back(word("hash", "hash", delaunay::to_string(hash_of_positions(*t))));
      },
      triangulated);
  if (dimension(triangulated) < 2) return;
  const delaunay::TriangleQuality quality = quality_of(points, triangulated);
  const std::string unit = points.is_on_plane() ? "" : "_km",
                    spoken = points.is_on_plane() ? "" : " (km)";
  facts.push_back(
      number("shortest_edge" + unit, "shortest edge" + spoken, quality.shortest_edge));
  facts.push_back(
      number("longest_edge" + unit, "longest edge" + spoken, quality.longest_edge));
  facts.push_back(number("smallest_angle_deg", "smallest angle (degrees)",
                         quality.smallest_angle_deg));
}

std::string as_text(const std::vector<Fact>& facts) {
  std::string text;
  for (const Fact& fact : facts)
    text += fmt::format("{:<26}{}\n", fact.label, one_line(fact.text));
  return text;
}

std::string as_json(const std::vector<Fact>& facts) {
  std::vector<std::string> members;
  for (const Fact& fact : facts)
    members.push_back(fmt::format("\"{}\":{}", fact.key, fact.json));
  return fmt::format("{{{}}}\n", fmt::join(members, ","));
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const auto facts = reporter.timed(Phase::evaluate, [&] {
    std::vector<Fact> all = facts_of_table(points);
    add_facts_of_mesh(all, points, triangulated);
    return all;
  });
  print(settings.is_json ? as_json(facts) : as_text(facts));
  return ExitCode::done;
}

}  // namespace

Command add_info_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("info", "What a file of points holds");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::on_request);
  app.add_flag("--json", settings->is_json, "One JSON object instead of text");
  app.footer(
      "Rows, dropped rows, extent, repeated positions, hull, triangles and their "
      "quality. The hash is the same for\n"
      "the same positions in any order, and differs for different ones.\n\n"
      "Example:\n  delone info stations.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
