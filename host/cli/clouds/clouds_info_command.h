#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing clouds info`: what a file of a cloud or a scene holds.
void add_clouds_info_command(CLI::App& parent, GlobalOptions& options);

}  // namespace offing::cli
