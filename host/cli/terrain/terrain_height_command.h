#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain height FILE --at X,Z`: height, normal and slope of the ground at a point.
void add_terrain_height_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
