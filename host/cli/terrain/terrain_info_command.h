#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain info FILE`: size, spacing, range, voids and place of a height map.
void add_terrain_info_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
