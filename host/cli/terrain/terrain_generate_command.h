#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain generate -o FILE.r32`: made ground, row by row, of any size.
void add_terrain_generate_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
