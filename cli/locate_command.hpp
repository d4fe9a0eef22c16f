#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone locate POINTS QUERIES`
[[nodiscard]] Command add_locate_command(CLI::App& program);

}  // namespace delone::cli
