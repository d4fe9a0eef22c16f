#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone grid POINTS -o OUT`
[[nodiscard]] Command add_grid_command(CLI::App& program);

}  // namespace delone::cli
