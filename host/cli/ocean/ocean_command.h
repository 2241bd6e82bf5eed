#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean bake | stats | query | spectrum`. `options` must outlive the application.
void add_ocean_command(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
