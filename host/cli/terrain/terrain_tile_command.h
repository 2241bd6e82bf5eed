#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain tile`: a height map of any size as a store of tiles.
void add_terrain_tile_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
