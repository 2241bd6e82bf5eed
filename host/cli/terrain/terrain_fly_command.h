#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain fly`: a flight over a tile store or a height map, and what its frames cost.
void add_terrain_fly_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
