#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone nearest POINTS QUERIES`
[[nodiscard]] Command add_nearest_command(CLI::App& program);

}  // namespace delone::cli
