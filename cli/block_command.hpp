#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone block POINTS -o OUT.csv --spacing DX[/DY]`
[[nodiscard]] Command add_block_command(CLI::App& program);

}  // namespace delone::cli
