#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain viewshed FILE --observer X,Z -o out.tif`: which ground is seen from a point.
void add_terrain_viewshed_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
