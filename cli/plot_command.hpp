#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone plot GRID.nc -o OUT`
[[nodiscard]] Command add_plot_command(CLI::App& program);

}  // namespace delone::cli
