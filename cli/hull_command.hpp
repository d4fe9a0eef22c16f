#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone hull POINTS`
[[nodiscard]] Command add_hull_command(CLI::App& program);

}  // namespace delone::cli
