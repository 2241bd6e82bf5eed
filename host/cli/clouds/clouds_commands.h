#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing clouds`: clouds of scenes as files of other programs, and what such files hold.
void add_clouds_command(CLI::App& app, GlobalOptions& options);

/// `offing clouds build`: the clouds of a scene as OpenVDB volumes or PLY particles.
void add_clouds_build_command(CLI::App& parent, GlobalOptions& options);

/// `offing clouds info`: what a file of a cloud or a scene holds.
void add_clouds_info_command(CLI::App& parent, GlobalOptions& options);

}  // namespace offing::cli
