#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// Makes the command line of offing: its help and all of its commands. `options` must outlive it.
void add_commands(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
