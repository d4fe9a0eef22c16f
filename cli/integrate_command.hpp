#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone integrate POINTS [REGIONS] [--method linear|c1]`
[[nodiscard]] Command add_integrate_command(CLI::App& program);

}  // namespace delone::cli
