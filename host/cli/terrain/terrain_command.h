#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain`: what can be done with height maps.
void add_terrain_command(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
