#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean bake [SCENE] -o DIR`: frames of ocean maps as OpenEXR.
void add_bake_command(CLI::App& ocean, GlobalOptions& options);

}  // namespace offing::cli
