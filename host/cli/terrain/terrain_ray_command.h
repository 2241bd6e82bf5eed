#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain ray FILE --from X,Y,Z --to X,Y,Z`: what a ray hits first.
void add_terrain_ray_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
