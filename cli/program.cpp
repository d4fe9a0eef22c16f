#include "cli/program.hpp"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include "cli/block_command.hpp"
#include "cli/check_command.hpp"
#include "cli/grid_command.hpp"
#include "cli/hull_command.hpp"
#include "cli/info_command.hpp"
#include "cli/integrate_command.hpp"
#include "cli/locate_command.hpp"
#include "cli/nearest_command.hpp"
#include "cli/output.hpp"
#include "cli/plot_command.hpp"
#include "cli/reporter.hpp"
#include "cli/sample_command.hpp"
#include "cli/signals.hpp"
#include "cli/triangulate_command.hpp"
#include "cli/voronoi_command.hpp"
#include "cli/weights_command.hpp"

namespace delone::cli {
namespace {

std::vector<Command> add_commands(CLI::App& program) {
  return {add_grid_command(program),        add_sample_command(program),
          add_triangulate_command(program), add_voronoi_command(program),
          add_hull_command(program),        add_locate_command(program),
          add_nearest_command(program),     add_check_command(program),
          add_info_command(program),        add_plot_command(program),
          add_block_command(program),       add_weights_command(program),
          add_apply_command(program),       add_integrate_command(program)};
}

/// The subcommand asked for, with its options filled in.
const Command& parse(CLI::App& program, const std::vector<Command>& commands, int argc,
                     const char* const* argv) {
  program.parse(argc, argv);
  for (const Command& command : commands) {
    if (command.app->parsed()) return command;
  }
  throw UsageError("no subcommand; `delone --help` lists them");
}

/// What CLI11 says on success: help and version.
ExitCode print_answer(const CLI::App& program, const CLI::Success& answer) {
  const bool is_version = dynamic_cast<const CLI::CallForVersion*>(&answer) != nullptr;
  print(is_version ? std::string(answer.what()) + "\n" : program.help());
  return ExitCode::done;
}

std::string usage_hint(const CLI::App& program) {
  const auto subcommands = program.get_subcommands();
  return subcommands.empty()
             ? "delone --help"
             : fmt::format("delone {} --help", subcommands[0]->get_name());
}

ExitCode fail(ExitCode code, std::string_view message) {
  report_failure(message);
  return code;
}

ExitCode run(CLI::App& program, int argc, const char* const* argv,
             Reporter::Clock::time_point start) {
  RunSettings settings;
  const std::vector<Command> commands = add_commands(program);
  for (const Command& command : commands) add_run_options(*command.app, settings);
  const Command& command = parse(program, commands, argc, argv);
  Reporter reporter(settings, start);
  const ExitCode code = command.run(reporter);
  reporter.print_timings();
  return code;
}

ExitCode run_or_answer(CLI::App& program, int argc, const char* const* argv,
                       Reporter::Clock::time_point start) {
  try {
    return run(program, argc, argv, start);
  } catch (const CLI::Success& answer) {
    return print_answer(program, answer);
  }
}

/// `run_or_answer` with every failure turned into a line and an exit code.
ExitCode run_guarded(int argc, const char* const* argv) {
  const auto start = Reporter::Clock::now();
  CLI::App program("Scattered data on the plane, the sphere and the ellipsoid", "delone");
  program.set_version_flag("--version", "delone " DELONE_VERSION);
  program.require_subcommand(0, 1);
  program.footer(
      "`delone SUBCOMMAND --help` shows the options of each, with an example.");
  try {
    return run_or_answer(program, argc, argv, start);
  } catch (const CLI::ParseError& error) {
    return fail(ExitCode::wrong_usage,
                fmt::format("{}; see {}", error.what(), usage_hint(program)));
  } catch (const UsageError& error) {
    return fail(ExitCode::wrong_usage, error.what());
  } catch (const io::WriteError& error) {
    return fail(ExitCode::cannot_write, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::bad_input,
                "not enough memory; use fewer points or a coarser grid");
  } catch (const std::length_error&) {
    return fail(ExitCode::bad_input,
                "not enough memory; use fewer points or a coarser grid");
  }
}

}  // namespace

int run_program(int argc, const char* const* argv) noexcept {
  install_signal_handlers();
  try {
    return static_cast<int>(run_guarded(argc, argv));
  } catch (const std::exception& error) {
    // Library errors and io::ReadError, and whatever else there may be: the input cannot
    // be used.
    report_failure(error.what());
  }
  return static_cast<int>(ExitCode::bad_input);
}

}  // namespace delone::cli
