#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone check POINTS TRIANGLES`
[[nodiscard]] Command add_check_command(CLI::App& program);

}  // namespace delone::cli
