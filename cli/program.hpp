#pragma once

namespace delone::cli {

/// The whole program: parses the arguments, runs the subcommand, turns every failure into
/// one line on standard error and an exit status (ExitCode). Never throws.
[[nodiscard]] int run_program(int argc, const char* const* argv) noexcept;

}  // namespace delone::cli
