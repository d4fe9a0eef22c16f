#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone triangulate POINTS -o OUT`
[[nodiscard]] Command add_triangulate_command(CLI::App& program);

}  // namespace delone::cli
