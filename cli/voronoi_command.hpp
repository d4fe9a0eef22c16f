#pragma once

#include "cli/options.hpp"

namespace delone::cli {

/// `delone voronoi POINTS -o OUT`: the cells nearest to each point.
[[nodiscard]] Command add_voronoi_command(CLI::App& program);

}  // namespace delone::cli
