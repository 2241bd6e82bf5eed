#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain render FILE -o PNG`: a picture of a height map, and its depth.
void add_terrain_render_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
