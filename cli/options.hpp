#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/exit_code.hpp"
#include "cli/settings.hpp"

namespace delone::cli {

class Reporter;

/// What a subcommand does with the value column.
enum class Values : std::uint8_t { needed, on_request, ignored };

/// A subcommand: its arguments (owned by the application) and what it does with them.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode(Reporter&)> run;
};

/// --quiet, --threads, --timings.
void add_run_options(CLI::App& app, RunSettings& settings);
/// --x, --y, --on, --skip-bad-rows, --duplicates, --merge-within: how a table of points
/// is read.
void add_table_options(CLI::App& app, PointSettings& settings);
/// The positional POINTS and --x, --y, --value, --on, --skip-bad-rows, --duplicates,
/// --merge-within.
void add_point_options(CLI::App& app, PointSettings& settings, Values values);
/// -o and --format, with `formats` named in the help.
void add_output_options(CLI::App& app, OutputSettings& settings,
                        const std::string& formats);
/// The same where standard output is the default.
void add_optional_output_options(CLI::App& app, OutputSettings& settings,
                                 const std::string& formats);

/// The numbers of "1/2/3"; throws UsageError unless there are between `least` and `most`.
[[nodiscard]] std::vector<double> parse_numbers(std::string_view option,
                                                std::string_view text, std::size_t least,
                                                std::size_t most);

/// For CLI::Option::check: what is wrong with a distance, empty if nothing.
[[nodiscard]] std::string refuse_negative(const std::string& text);

/// The two whole numbers of "20/10"; throws UsageError unless both are positive.
[[nodiscard]] std::array<std::int64_t, 2> parse_counts(std::string_view option,
                                                       std::string_view text);

/// "--option takes a, b or c, not 'text'".
[[noreturn]] void refuse_choice(std::string_view option, std::string_view text,
                                const std::vector<std::string_view>& words);

template <class T>
[[nodiscard]] T parse_choice(std::string_view option, std::string_view text,
                             const std::vector<Choice<T>>& choices) {
  std::vector<std::string_view> words;
  for (const auto& [word, meaning] : choices) {
    if (word == text) return meaning;
    words.push_back(word);
  }
  refuse_choice(option, text, words);
}

/// An option that takes one of a few words. `target` is a T or an optional<T>.
template <class T, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Target& target,
                        std::vector<Choice<T>> choices, const std::string& description) {
  const auto set = [option, &target,
                    choices = std::move(choices)](const std::string& text) {
    target = parse_choice<T>(option, text, choices);
  };
  return app.add_option_function<std::string>(option, set, description)
      ->type_name("WORD");
}

}  // namespace delone::cli
