#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain los FILE --from X,Z,H --to X,Z,H`: whether two points see each other.
void add_terrain_los_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
