#include "cli/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace delone::cli {
namespace {

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string count_of_numbers(std::size_t least, std::size_t most) {
  return least == most ? fmt::format("{}", least) : fmt::format("{} or {}", least, most);
}

void add_format_option(CLI::App& app, OutputSettings& settings) {
  app.add_option("--format", settings.format,
                 "Format, where the extension does not say it")
      ->type_name("WORD");
}

}  // namespace

void add_run_options(CLI::App& app, RunSettings& settings) {
  app.add_flag("--quiet", settings.is_quiet, "Say nothing but errors");
  app.add_option("--threads", settings.num_threads, "Threads (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  app.add_flag("--timings", settings.prints_timings,
               "Last line on standard error: seconds of each phase as JSON");
}

void add_table_options(CLI::App& app, PointSettings& settings) {
  app.add_option("--x,--lon", settings.columns.x,
                 "Column of x or longitude: name or number from 1")
      ->type_name("COLUMN");
  app.add_option("--y,--lat", settings.columns.y, "Column of y or latitude")
      ->type_name("COLUMN");
  add_choice<Domain>(
      app, "--on", settings.domain, domain_choices(),
      "plane, sphere or ellipsoid (WGS84); default: sphere if the columns are called "
      "longitude/latitude, else plane");
  app.add_flag("--skip-bad-rows", settings.columns.skip_bad_rows,
               "Drop rows that do not parse, and count them");
  add_choice<interp::Duplicates>(
      app, "--duplicates", settings.duplicates, duplicates_choices(),
      "Rows at one position: mean (default), first, last, median, min, max, error");
  app.add_option("--merge-within", settings.merge_within,
                 "Move points at most D apart to one position (unit of x and y, on the "
                 "globe km)")
      ->type_name("D")
      ->check(refuse_negative);
}

void add_point_options(CLI::App& app, PointSettings& settings, Values values) {
  const char* const about =
      values == Values::needed
          ? "Table of points: CSV, TSV or blanks; - reads standard input"
          : "Table of points: CSV, TSV or blanks; - reads standard input; or a mesh "
            "(.off, "
            ".ply, .vtu, UGRID .nc), for its nodes";
  app.add_option("POINTS", settings.path, about)->required()->type_name("");
  add_table_options(app, settings);
  if (values != Values::ignored) {
    app.add_option("--value", settings.columns.value, "Column of the values")
        ->type_name("COLUMN");
  }
  settings.columns.needs_value = values == Values::needed;
}

void add_output_options(CLI::App& app, OutputSettings& settings,
                        const std::string& formats) {
  app.add_option("-o,--output", settings.path, "File to write: " + formats)
      ->required()
      ->type_name("FILE");
  add_format_option(app, settings);
}

void add_optional_output_options(CLI::App& app, OutputSettings& settings,
                                 const std::string& formats) {
  settings.path = "-";
  app.add_option("-o,--output", settings.path,
                 "File to write (default: standard output): " + formats)
      ->type_name("FILE");
  add_format_option(app, settings);
}

std::vector<double> parse_numbers(std::string_view option, std::string_view text,
                                  std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t slash = rest.find('/');
    const auto number = parse_number(rest.substr(0, slash));
    if (!number) {
      throw UsageError(fmt::format("{} '{}': '{}' is not a number", option, text,
                                   rest.substr(0, slash)));
    }
    numbers.push_back(*number);
    if (slash == std::string_view::npos) break;
    rest.remove_prefix(slash + 1);
  }
  if (numbers.size() < least || numbers.size() > most) {
    throw UsageError(fmt::format("{} '{}' has {} numbers; it takes {}, separated by /",
                                 option, text, numbers.size(),
                                 count_of_numbers(least, most)));
  }
  return numbers;
}

std::string refuse_negative(const std::string& text) {
  const auto number = parse_number(text);
  if (!number) return fmt::format("'{}' is not a number", text);
  return *number < 0 ? fmt::format("{} is below 0", text) : std::string();
}

std::array<std::int64_t, 2> parse_counts(std::string_view option, std::string_view text) {
  constexpr double limit =
      1099511627776;  // 2^40, beyond any memory and exact in a double
  const std::vector<double> numbers = parse_numbers(option, text, 2, 2);
  for (const double number : numbers) {
    if (number != std::floor(number) || number < 1 || number > limit) {
      throw UsageError(
          fmt::format("{} '{}': {} is not a number of nodes", option, text, number));
    }
  }
  return {static_cast<std::int64_t>(numbers[0]), static_cast<std::int64_t>(numbers[1])};
}

void refuse_choice(std::string_view option, std::string_view text,
                   const std::vector<std::string_view>& words) {
  throw UsageError(
      fmt::format("{} takes one of {}, not '{}'", option, fmt::join(words, ", "), text));
}

}  // namespace delone::cli
