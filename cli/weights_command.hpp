#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone weights POINTS [TARGETS] -o W.nc`
[[nodiscard]] Command add_weights_command(CLI::App& program);

/// `delone apply W.nc VALUES -o OUT.csv`
[[nodiscard]] Command add_apply_command(CLI::App& program);

}  // namespace delone::cli
