#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing clouds build`: the clouds of a scene as OpenVDB volumes or PLY particles.
void add_clouds_build_command(CLI::App& parent, GlobalOptions& options);

}  // namespace offing::cli
