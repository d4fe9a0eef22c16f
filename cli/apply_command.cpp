#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/weights_command.hpp"
#include "io/output_file.hpp"
#include "io/table.hpp"
#include "io/weights_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  std::string weights, values;
  io::TableOptions columns;
  std::vector<std::string> value_columns;  ///< empty: all but the coordinates
  interp::ApplyOptions options;
  OutputSettings output;
};

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

const std::vector<Choice<interp::MissingRows>> missing_choices{
    {"propagate", interp::MissingRows::propagate},
    {"renormalise", interp::MissingRows::renormalise}};

/// Fields of a header.
std::vector<std::string> fields_of(const io::PointTable& table) {
  std::vector<std::string> fields{""};
  bool is_quoted = false;
  for (const char c : as_csv(table.header, table.delimiter)) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) {
    const auto first = field.find_first_not_of(" \t");
    field = first == std::string::npos
                ? ""
                : field.substr(first, field.find_last_not_of(" \t") - first + 1);
  }
  return fields;
}

/// The columns asked for, or all beside the coordinates; without a header the third.
std::vector<std::string> choose_columns(const Settings& settings,
                                        const io::PointTable& table) {
  if (!settings.value_columns.empty()) return settings.value_columns;
  if (table.header.empty()) return {"3"};
  std::vector<std::string> names;
  for (const std::string& name : fields_of(table))
    if (name != table.x_name && name != table.y_name) names.push_back(name);
  if (names.empty()) {
    throw io::ReadError(settings.values +
                        ": there is no column beside the coordinates; add one of values");
  }
  return names;
}

void check_rows(const Settings& settings, const io::PointTable& table,
                const io::WeightsFile& file) {
  const auto num_rows = file.weights.matrix().cols();
  if (table.num_rows != num_rows) {
    throw io::ReadError(fmt::format(
        "{}: there are {} data rows and {} is for {}; give one a source point, in their "
        "order",
        settings.values, table.num_rows, settings.weights, num_rows));
  }
  const io::WeightsSide& source = file.source;
  for (std::size_t i = 0; i < table.x.size() && !source.x.empty(); ++i) {
    const auto row = static_cast<std::size_t>(table.row_of(i));
    if (!source.mask.empty() && source.mask[row] == 0) continue;
    const double dx = source.space == io::Mesh::Space::plane
                          ? table.x[i] - source.x[row]
                          : std::remainder(table.x[i] - source.x[row], 360);
    if (dx == 0 && table.y[i] == source.y[row]) continue;
    if (std::abs(dx) < 1e-9 && std::abs(table.y[i] - source.y[row]) < 1e-9) continue;
    throw io::ReadError(
        fmt::format("{}, line {}: the point is not that of the same row in {}; give the "
                    "rows in the order of the points that the weights are for",
                    settings.values, table.line_of(i), settings.weights));
  }
}

/// One column of the matrix of fields for each column of values.
interp::Fields read_fields(const Settings& settings,
                           const std::vector<std::string>& columns,
                           std::int64_t num_rows) {
  interp::Fields fields =
      interp::Fields::Constant(num_rows, std::ssize(columns), missing);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    io::TableOptions options = settings.columns;
    options.value = columns[c];
    const io::PointTable table = io::read_table(settings.values, options);
    for (std::size_t i = 0; i < table.value.size(); ++i)
      fields(table.row_of(i), static_cast<Eigen::Index>(c)) = table.value[i];
  }
  return fields;
}

std::string as_text(const io::WeightsFile& file, const std::vector<std::string>& names,
                    const interp::Fields& applied) {
  fmt::memory_buffer buffer;
  const auto to = std::back_inserter(buffer);
  const io::WeightsSide& target = file.target;
  const bool has_places = !target.x.empty();
  fmt::format_to(to, "{}",
                 !has_places                              ? "target"
                 : target.space == io::Mesh::Space::plane ? "x,y"
                                                          : "lon,lat");
  for (const std::string& name : names) fmt::format_to(to, ",{}", csv_field(name));
  buffer.push_back('\n');
  for (Eigen::Index i = 0; i < applied.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    has_places ? fmt::format_to(to, "{},{}", target.x[k], target.y[k])
               : fmt::format_to(to, "{}", i);
    for (Eigen::Index f = 0; f < applied.cols(); ++f)
      append_number(buffer, applied(i, f));
    buffer.push_back('\n');
  }
  return {buffer.data(), buffer.size()};
}

/// A table's name for a column given by its number.
std::string title_of(const std::string& column, const io::PointTable& table) {
  const bool is_number = !column.empty() && std::ranges::all_of(column, [](char c) {
    return c >= '0' && c <= '9';
  });
  if (!is_number) return column;
  if (table.header.empty()) return "value_" + column;
  const std::vector<std::string> names = fields_of(table);
  const auto number = std::stoul(column);
  return number >= 1 && number <= names.size() ? names[number - 1] : column;
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  static_cast<void>(choose_format(settings.output, {"csv"}));
  if (settings.weights == "-" || settings.values == "-")
    throw UsageError("apply reads files, not standard input; name them");
  check_output(settings.output.path, {settings.weights, settings.values});
  const io::WeightsFile file =
      reporter.timed(Phase::read, [&] { return io::read_weights(settings.weights); });
  io::TableOptions columns = settings.columns;
  columns.keep_text = true;
  const io::PointTable table = reporter.timed(
      Phase::read, [&] { return io::read_table(settings.values, columns); });
  check_rows(settings, table, file);
  const std::vector<std::string> chosen = choose_columns(settings, table);
  const interp::Fields fields = reporter.timed(
      Phase::read, [&] { return read_fields(settings, chosen, table.num_rows); });
  reporter.count_points(table.num_rows);
  const interp::Fields applied = reporter.timed(Phase::evaluate, [&] {
    return file.weights.apply_fields(fields, settings.options,
                                     reporter.run_options("applying"));
  });
  std::vector<std::string> names;
  for (const std::string& column : chosen) names.push_back(title_of(column, table));
  reporter.say("{}: {} at {}", settings.values, counted(std::ssize(names), "column"),
               counted(applied.rows(), "target"));
  reporter.timed(Phase::write, [&] {
    io::write_text(settings.output.path, as_text(file, names, applied));
  });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_apply_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("apply", "Apply the weights of a file to values");
  const auto settings = std::make_shared<Settings>();
  settings->columns.needs_value = false;
  app.add_option("WEIGHTS", settings->weights,
                 "NetCDF file of weights: of delone weights, ESMF, CDO or SCRIP")
      ->required()
      ->type_name("");
  app.add_option(
         "VALUES", settings->values,
         "Table with a row for each source point, in their order: coordinates and "
         "columns of values")
      ->required()
      ->type_name("");
  app.add_option("--x,--lon", settings->columns.x, "Column of x or longitude")
      ->type_name("COLUMN");
  app.add_option("--y,--lat", settings->columns.y, "Column of y or latitude")
      ->type_name("COLUMN");
  app.add_option("--value", settings->value_columns,
                 "Column of values; may be given several times (default: all columns "
                 "beside the coordinates)")
      ->type_name("COLUMN")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_choice<interp::MissingRows>(
      app, "--missing", settings->options.missing, missing_choices,
      "Targets some of whose values are missing: propagate (default: missing too) or "
      "renormalise (the others share the weight, if they hold half of it)");
  add_output_options(app, settings->output,
                     ".csv: the places of the targets, a column for each one of values");
  app.footer(
      "Missing values (nan, NA, empty) may differ from column to column.\n\n"
      "Example:\n  delone weights stations.csv cities.csv --method natural -o w.nc\n"
      "  delone apply w.nc months.csv -o cities_months.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
