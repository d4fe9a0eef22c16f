#include "cli/queries.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cli/output.hpp"

namespace delone::cli {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// One past the end of the field that begins at `begin`; delimiters inside double quotes
/// do not end it.
std::size_t field_end(std::string_view line, std::size_t begin, char delimiter) {
  bool is_quoted = false;
  for (std::size_t i = begin; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    const bool is_end = delimiter == ' ' ? is_blank(line[i]) : line[i] == delimiter;
    if (is_end && !is_quoted) return i;
  }
  return line.size();
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Are columns called x and y, so that nothing but their use says what they are?
bool are_plain(const io::PointTable& table) {
  return !table.header.empty() && !table.is_lonlat;
}

std::string columns_of(const Points& points) {
  return fmt::format("{} has the columns '{}' and '{}'", display_name(points.path),
                     points.table.x_name, points.table.y_name);
}

/// Distances and triangles of the plane mean nothing for longitudes and latitudes, nor
/// the other way round. Whoever says --on knows what the numbers are.
void check_spaces(const PointSettings& settings, const Points& points,
                  const Points& queries, const Reporter& reporter) {
  if (settings.domain) return;
  if (points.is_on_plane() && queries.table.is_lonlat)
    throw UsageError(
        fmt::format("{}, and {}: longitudes and latitudes among points of the plane; say "
                    "--on sphere, or --on plane if both are in one plane",
                    columns_of(queries), columns_of(points)));
  if (!points.is_on_plane() && are_plain(queries.table))
    reporter.say(
        "{}, taken as longitude and latitude like those of {}; say --on sphere "
        "if that is right, --on plane if not",
        columns_of(queries), display_name(points.path));
}

}  // namespace

std::string csv_field(std::string_view field) {
  const bool is_cut = field.find(',') != std::string_view::npos && field.front() != '"';
  return is_cut ? fmt::format("\"{}\"", field) : std::string(field);
}

void add_query_options(CLI::App& app, QuerySettings& settings) {
  app.add_option("QUERIES", settings.path,
                 "Table of query points, like POINTS; columns that are not "
                 "coordinates may be anything")
      ->required()
      ->type_name("");
  app.add_option("--query-x", settings.x, "Column of x or longitude of the queries")
      ->type_name("COLUMN");
  app.add_option("--query-y", settings.y, "Column of y or latitude of the queries")
      ->type_name("COLUMN");
}

Points read_queries(const QuerySettings& settings, const PointSettings& point_settings,
                    const Points& points, Reporter& reporter) {
  PointSettings query_settings;
  query_settings.path = settings.path;
  query_settings.domain = points.domain;
  query_settings.columns.x = settings.x;
  query_settings.columns.y = settings.y;
  query_settings.columns.x_option = "--query-x";
  query_settings.columns.y_option = "--query-y";
  query_settings.columns.needs_value = false;
  query_settings.columns.keep_text = true;
  query_settings.columns.skip_bad_rows = point_settings.columns.skip_bad_rows;
  Points queries = read_points(query_settings, reporter);
  check_spaces(point_settings, points, queries, reporter);
  reporter.count_points(points.size());
  return queries;
}

std::string as_csv(std::string_view line, char delimiter) {
  if (delimiter == ',') return std::string(line);
  std::string csv;
  for (std::size_t begin = 0;;) {
    // A run of blanks is one delimiter, also in front of the first field.
    while (delimiter == ' ' && begin < line.size() && is_blank(line[begin])) ++begin;
    const std::size_t end = field_end(line, begin, delimiter);
    csv += csv_field(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
    if (delimiter == ' ' && trimmed(line.substr(std::min(end, line.size()))).empty())
      break;
    if (end == line.size()) break;
    csv += ',';
  }
  return csv;
}

void append_number(fmt::memory_buffer& buffer, double number) {
  buffer.push_back(',');
  if (!std::isnan(number)) fmt::format_to(std::back_inserter(buffer), "{}", number);
}

}  // namespace delone::cli
