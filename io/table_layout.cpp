#include "io/table_layout.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <tuple>
#include <utility>

#include "io/fields.hpp"
#include "io/line_reader.hpp"

namespace delone::io {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 4> longitude_names = {"lon", "longitude", "long",
                                                             "lng"};
constexpr std::array<std::string_view, 2> latitude_names = {"lat", "latitude"};
constexpr std::array<std::string_view, 2> x_names = {"x", "easting"};
constexpr std::array<std::string_view, 2> y_names = {"y", "northing"};

// Compound units first: "_m_s" also ends in "_s".
constexpr std::array<std::pair<std::string_view, std::string_view>, 27> unit_suffixes = {{
    {"_mw_m2", "mW m-2"},
    {"_w_m2", "W m-2"},
    {"_kg_m3", "kg m-3"},
    {"_mm_yr", "mm year-1"},
    {"_m_s2", "m s-2"},
    {"_km_h", "km h-1"},
    {"_m_s", "m s-1"},
    {"_mgal", "mGal"},
    {"_degc", "degC"},
    {"_celsius", "degC"},
    {"_c", "degC"},
    {"_kelvin", "K"},
    {"_k", "K"},
    {"_km", "km"},
    {"_cm", "cm"},
    {"_mm", "mm"},
    {"_m", "m"},
    {"_ft", "ft"},
    {"_hpa", "hPa"},
    {"_pa", "Pa"},
    {"_ppm", "ppm"},
    {"_pct", "percent"},
    {"_percent", "percent"},
    {"_deg", "degree"},
    {"_degrees", "degree"},
    {"_nt", "nT"},
    {"_s", "s"},
}};

/// The unit in `name [unit]` or `name (unit)`, and where its bracket opens.
std::optional<std::pair<std::string_view, std::size_t>> bracketed_unit(
    std::string_view name) {
  for (const std::string_view pair : {"[]", "()"}) {
    const std::size_t open = name.find(pair[0]);
    if (open == name.npos || open == 0 || !name.ends_with(pair[1])) continue;
    return std::pair{trim(name.substr(open + 1, name.size() - open - 2)), open};
  }
  return std::nullopt;
}

/// The last of the known suffixes of `name` (lower case), or nullptr.
const std::pair<std::string_view, std::string_view>* unit_suffix(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(unit_suffixes, [name](const auto& suffix) {
        return name.size() > suffix.first.size() && name.ends_with(suffix.first);
      });
  return found == unit_suffixes.end() ? nullptr : found;
}

/// "Longitude (deg)" -> "longitude", "x_m" -> "x".
std::string base_name(std::string_view name) {
  if (const auto unit = bracketed_unit(name)) name = trim(name.substr(0, unit->second));
  std::string result = to_lower(name);
  if (const auto* const suffix = unit_suffix(result))
    result.resize(result.size() - suffix->first.size());
  return result;
}

bool is_one_of(Names names, std::string_view name) {
  return std::ranges::find(names, base_name(name)) != names.end();
}

std::string list_of_columns(const TableLayout& layout) {
  if (layout.names.empty())
    return "the table has " + std::to_string(layout.num_columns) +
           " columns and no header";
  constexpr std::size_t most = 20;
  std::string list = "the columns are ";
  for (std::size_t i = 0; i < std::min(layout.names.size(), most); ++i)
    list += (i == 0 ? "" : ", ") + excerpt(layout.names[i]);
  if (layout.names.size() > most)
    list += ", ... (" + std::to_string(layout.names.size()) + " in all)";
  return list;
}

/// Finds columns of one table; its layout is complete but for the choice.
class ColumnFinder {
 public:
  ColumnFinder(const std::string& file_name, const TableLayout& layout)
      : file_name_(file_name), layout_(layout) {}

  /// The column that the user calls `choice`: a number from 1, or else a name.
  [[nodiscard]] std::size_t chosen(const std::string& choice) const {
    const auto number = parse_integer(choice);
    if (number && *number >= 1 && std::cmp_less_equal(*number, layout_.num_columns))
      return static_cast<std::size_t>(*number - 1);
    const auto same = [&](std::string_view name) { return name == choice; };
    const auto alike = [&](std::string_view name) {
      return to_lower(name) == to_lower(choice);
    };
    if (const auto found = only_column(choice, same)) return *found;
    if (const auto found = only_column(choice, alike)) return *found;
    fail("no column '" + excerpt(choice) + "'; " + list_of_columns(layout_));
  }

  /// x and y: as chosen, else by their names, else (no header) the first two columns.
  [[nodiscard]] std::pair<std::size_t, std::size_t> coordinates(
      const TableOptions& options) const {
    const bool are_rings = options.content == TableOptions::Content::rings;
    if (are_rings && layout_.num_columns < 3)
      fail("a table of rings has three columns, ring number, x and y; " +
           list_of_columns(layout_));
    const std::size_t first = are_rings ? 1 : 0;
    std::optional<std::size_t> x, y;
    if (!options.x.empty()) x = chosen(options.x);
    if (!options.y.empty()) y = chosen(options.y);
    if (!layout_.has_header) return distinct(x.value_or(first), y.value_or(first + 1));
    if (x && y) return distinct(*x, *y);
    if (const auto pair = completed(x, y, longitude_names, latitude_names)) return *pair;
    if (const auto pair = completed(x, y, x_names, y_names)) return *pair;
    if (are_rings) return distinct(x.value_or(first), y.value_or(first + 1));
    fail("no columns called lon and lat, or x and y; choose with " + options.x_option +
         " and " + options.y_option + ": " + list_of_columns(layout_));
  }

  /// The first column other than x and y, whatever it holds.
  [[nodiscard]] std::size_t first_other() const {
    std::size_t i = 0;
    while (i == layout_.x || i == layout_.y) ++i;
    return i;
  }

  /// The first column of numbers other than x and y.
  [[nodiscard]] std::size_t first_numeric(std::span<const std::string_view> lines) const {
    std::optional<std::size_t> empty;  // nothing but missing values in the lines at hand
    std::vector<Number::Kind> kinds = column_kinds(lines);
    for (std::size_t i = 0; i < layout_.num_columns; ++i) {
      if (i == layout_.x || i == layout_.y) continue;
      if (kinds[i] == Number::Kind::finite || kinds[i] == Number::Kind::infinite)
        return i;
      if (kinds[i] == Number::Kind::missing && !empty) empty = i;
    }
    if (empty) return *empty;
    fail("no column of numbers besides " + column_name(layout_, layout_.x) + " and " +
         column_name(layout_, layout_.y) + " to take values from; " +
         list_of_columns(layout_));
  }

 private:
  template <std::predicate<std::string_view> Matches>
  [[nodiscard]] std::optional<std::size_t> only_column(const std::string& choice,
                                                       Matches matches) const {
    const auto& names = layout_.names;
    const auto found = std::ranges::find_if(names, matches);
    if (found == names.end()) return std::nullopt;
    if (std::find_if(found + 1, names.end(), matches) != names.end())
      fail("several columns are called '" + excerpt(choice) +
           "'; choose one by its number");
    return static_cast<std::size_t>(found - names.begin());
  }

  /// x and y from names of one sort; a column that the user chose stands, unless it is of
  /// the other.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> completed(
      std::optional<std::size_t> x, std::optional<std::size_t> y, Names xs,
      Names ys) const {
    const auto find = [&](Names wanted) -> std::optional<std::size_t> {
      const auto found = std::ranges::find_if(
          layout_.names,
          [&](const std::string& name) { return is_one_of(wanted, name); });
      if (found == layout_.names.end()) return std::nullopt;
      return static_cast<std::size_t>(found - layout_.names.begin());
    };
    const bool is_plane_x = x && is_one_of(x_names, layout_.names[*x]);
    const bool is_plane_y = y && is_one_of(y_names, layout_.names[*y]);
    if ((is_plane_x || is_plane_y) && xs.data() == longitude_names.data())
      return std::nullopt;
    if (!x) x = find(xs);
    if (!y) y = find(ys);
    if (!x || !y) return std::nullopt;
    return distinct(*x, *y);
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> distinct(std::size_t x,
                                                             std::size_t y) const {
    if (std::max(x, y) >= layout_.num_columns)
      fail(
          "one column only; a table of points needs two or more, separated by commas, "
          "semicolons, tabs or blanks");
    if (x == y)
      fail("x and y are both " + column_label(layout_, x) + "; choose two columns");
    return {x, y};
  }

  /// For each column what its first field that is not missing holds.
  [[nodiscard]] std::vector<Number::Kind> column_kinds(
      std::span<const std::string_view> lines) const {
    std::vector<Number::Kind> kinds(layout_.num_columns, Number::Kind::missing);
    for (const std::string_view line : lines) {
      if (!holds_data(line)) continue;
      const auto fields = split_fields(line, layout_.delimiter);
      if (!fields || fields->size() != kinds.size()) continue;
      for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i] == Number::Kind::missing) kinds[i] = parse_number((*fields)[i]).kind;
    }
    return kinds;
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(file_name_ + ": " + why);
  }

  const std::string& file_name_;
  const TableLayout& layout_;
};

bool is_text(std::string_view field) {
  return parse_number(field).kind == Number::Kind::text;
}

/// See find_layout: which fields of the first line tell a header from data.
bool is_header(const std::vector<std::string_view>& fields, const TableOptions& options) {
  const auto x = parse_integer(options.x), y = parse_integer(options.y);
  const auto value = parse_integer(options.value),
             second = parse_integer(options.second_value);
  const bool all_by_number = x && y && (value || !options.needs_value) &&
                             (second || options.second_value.empty());
  if (!all_by_number) return std::ranges::any_of(fields, is_text);
  const auto is_text_column = [&](std::int64_t column) {
    return column >= 1 && std::cmp_less_equal(column, fields.size()) &&
           is_text(fields[static_cast<std::size_t>(column - 1)]);
  };
  return is_text_column(*x) || is_text_column(*y) || (value && is_text_column(*value)) ||
         (second && is_text_column(*second));
}

}  // namespace

TableLayout find_layout(const std::string& file_name, std::string_view first_line,
                        const std::vector<std::string_view>& following,
                        const TableOptions& options) {
  TableLayout layout;
  layout.delimiter = detect_delimiter(first_line);
  const auto fields = split_fields(first_line, layout.delimiter);
  if (!fields)
    throw ReadError(file_name + ": the first line has a quote that does not close: " +
                    excerpt(first_line));
  constexpr std::size_t most_columns = 100000;
  if (fields->size() > most_columns)
    throw ReadError(file_name + ": the first line has " + std::to_string(fields->size()) +
                    " fields; this is not a table of points");
  layout.num_columns = fields->size();
  layout.has_header = is_header(*fields, options);
  if (layout.has_header)
    for (const std::string_view field : *fields) layout.names.push_back(unquote(field));

  const ColumnFinder finder(file_name, layout);
  std::tie(layout.x, layout.y) = finder.coordinates(options);
  std::vector<std::string_view> lines = following;
  if (!layout.has_header) lines.insert(lines.begin(), first_line);
  if (!options.value.empty())
    layout.value = finder.chosen(options.value);
  else if (options.content == TableOptions::Content::rings)
    layout.value = finder.first_other();
  else if (options.needs_value)
    layout.value = finder.first_numeric(lines);
  if (!options.second_value.empty())
    layout.second_value = finder.chosen(options.second_value);
  return layout;
}

std::string column_name(const TableLayout& layout, std::size_t column) {
  return layout.has_header ? layout.names[column]
                           : "column " + std::to_string(column + 1);
}

std::string column_label(const TableLayout& layout, std::size_t column) {
  const std::string number = "column " + std::to_string(column + 1);
  return layout.has_header ? number + " (" + excerpt(layout.names[column]) + ")" : number;
}

bool is_lonlat(const TableLayout& layout) {
  return layout.has_header && is_one_of(longitude_names, layout.names[layout.x]) &&
         is_one_of(latitude_names, layout.names[layout.y]);
}

std::string guess_units(std::string_view column_name) {
  if (const auto unit = bracketed_unit(column_name)) return std::string(unit->first);
  const auto* const suffix = unit_suffix(to_lower(column_name));
  return suffix == nullptr ? "" : std::string(suffix->second);
}

}  // namespace delone::io
