#include "cli/block_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <unordered_map>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/queries.hpp"
#include "io/output_file.hpp"
#include "stripack/blocks.hpp"
#include "tripack/blocks.hpp"

namespace delone::cli {
namespace {

using delaunay::BlockPosition;
using delaunay::Blocks;
using delaunay::BlockStatistic;

struct Settings {
  PointSettings points;
  OutputSettings output;
  std::string weight;  ///< column
  delaunay::BlockOptions blocks;
};

/// The weights of the points that were kept, from a second look at the file.
std::vector<double> read_weights(const Settings& settings, const Points& points) {
  if (settings.weight.empty()) return {};
  if (settings.points.path == "-")
    throw UsageError("--weight needs a file: standard input is read once only");
  io::TableOptions columns = settings.points.columns;
  columns.value = settings.weight;
  const io::PointTable table = io::read_table(settings.points.path, columns);
  std::unordered_map<std::int64_t, double> weight_of;
  for (std::size_t i = 0; i < table.value.size(); ++i)
    weight_of.emplace(table.row_of(i), table.value[i]);
  std::vector<double> weights;
  for (std::size_t i = 0; i < points.table.x.size(); ++i) {
    const auto found = weight_of.find(points.table.row_of(i));
    // A missing weight is none.
    weights.push_back(found == weight_of.end() ? 0 : found->second);
  }
  return weights;
}

Blocks reduce(const Settings& settings, const Points& points,
              const std::vector<double>& weights) {
  const io::PointTable& table = points.table;
  return blaming(points, [&] {
    if (points.is_on_plane()) {
      return tripack::block_reduce(plane_points(points), table.value, weights,
                                   settings.blocks);
    }
    std::vector<stripack::LonLat> positions;
    for (std::size_t i = 0; i < table.x.size(); ++i)
      positions.push_back({table.x[i], table.y[i]});
    delaunay::BlockOptions options = settings.blocks;
    // 170/-170 is the way people write a region across the date line.
    if (options.region && options.region->east <= options.region->west)
      options.region->east += 360;
    return stripack::block_reduce(positions, table.value, weights, options);
  });
}

std::string as_text(const Settings& settings, const Points& points,
                    const Blocks& blocks) {
  const io::PointTable& table = points.table;
  const bool is_lonlat = !points.is_on_plane();
  fmt::memory_buffer buffer;
  const auto to = std::back_inserter(buffer);
  fmt::format_to(to, "{},{}", is_lonlat ? "lon" : "x", is_lonlat ? "lat" : "y");
  if (!table.value.empty()) fmt::format_to(to, ",{}", csv_field(table.value_name));
  fmt::format_to(to, ",count{}\n", settings.weight.empty() ? "" : ",weight");
  for (std::size_t i = 0; i < blocks.x.size(); ++i) {
    fmt::format_to(to, "{},{}", blocks.x[i], blocks.y[i]);
    if (!table.value.empty()) fmt::format_to(to, ",{}", blocks.value[i]);
    fmt::format_to(to, ",{}", blocks.count[i]);
    if (!settings.weight.empty()) fmt::format_to(to, ",{}", blocks.weight[i]);
    buffer.push_back('\n');
  }
  return {buffer.data(), buffer.size()};
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  static_cast<void>(choose_format(settings.output, {"csv"}));
  check_output(settings.output.path, {settings.points.path});
  const Points points = read_points(settings.points, reporter);
  const auto weights =
      reporter.timed(Phase::read, [&] { return read_weights(settings, points); });
  const Blocks blocks =
      reporter.timed(Phase::evaluate, [&] { return reduce(settings, points, weights); });
  std::int64_t num_used = 0;
  for (const std::int64_t count : blocks.count) num_used += count;
  reporter.say("{} in {}; {} left out", counted(num_used, "point"),
               counted(std::ssize(blocks.x), "block"), points.size() - num_used);
  reporter.timed(Phase::write, [&] {
    io::write_text(settings.output.path, as_text(settings, points, blocks));
  });
  if (!is_standard_output(settings.output))
    reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

void set_spacing(delaunay::BlockOptions& blocks, const std::string& text) {
  const auto numbers = parse_numbers("--spacing", text, 1, 2);
  for (const double number : numbers) {
    if (!(number > 0))
      throw UsageError(fmt::format("--spacing '{}': {} is not positive", text, number));
  }
  blocks.dx = numbers.front();
  blocks.dy = numbers.back();
}

void set_region(delaunay::BlockOptions& blocks, const std::string& text) {
  const auto n = parse_numbers("--region", text, 4, 4);
  if (!(n[2] < n[3]))
    throw UsageError(
        fmt::format("--region '{}' is empty; give west/east/south/north", text));
  blocks.region = delaunay::BlockRegion{n[0], n[1], n[2], n[3]};
}

void add_block_options(CLI::App& app, Settings& settings) {
  app.add_option_function<std::string>(
         "--spacing",
         [&settings](const std::string& text) { set_spacing(settings.blocks, text); },
         "Size of the blocks")
      ->required()
      ->type_name("DX[/DY]");
  app.add_option_function<std::string>(
         "--region",
         [&settings](const std::string& text) { set_region(settings.blocks, text); },
         "Where blocks begin and end; default: all points, blocks from 0 (globe: "
         "-180/-90) on")
      ->type_name("W/E/S/N");
  add_choice<BlockStatistic>(app, "--statistic", settings.blocks.statistic,
                             {{"mean", BlockStatistic::mean},
                              {"median", BlockStatistic::median},
                              {"mode", BlockStatistic::mode}},
                             "mean (default), median or mode (middle of the shortest "
                             "half)");
  add_choice<BlockPosition>(
      app, "--position", settings.blocks.position,
      {{"reduced", BlockPosition::reduced}, {"center", BlockPosition::center}},
      "reduced as the values are (default), or center of the block");
  app.add_option("--weight", settings.weight, "Column of weights; 0 leaves a row out")
      ->type_name("COLUMN");
}

}  // namespace

Command add_block_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "block", "Block means, medians or modes: one point for each cell of a grid");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::on_request);
  settings->points.columns.needs_value = true;
  add_block_options(app, *settings);
  add_optional_output_options(app, settings->output,
                              ".csv: position, value, count and, with --weight, weight");
  app.footer(
      "Blocks that hold nothing are absent; the others come row by row from south to "
      "north. A block\n"
      "holds its western and southern edge.\n\n"
      "Example:\n  delone block soundings.csv -o thinned.csv --spacing 0.5 --statistic "
      "median");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
