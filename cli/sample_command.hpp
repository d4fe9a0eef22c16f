#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone sample POINTS QUERIES -o OUT.csv`
[[nodiscard]] Command add_sample_command(CLI::App& program);

}  // namespace delone::cli
