#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain profile FILE --from X,Z --to X,Z`: heights along a line.
void add_terrain_profile_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
