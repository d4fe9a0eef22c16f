#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone info FILE`
[[nodiscard]] Command add_info_command(CLI::App& program);

}  // namespace delone::cli
