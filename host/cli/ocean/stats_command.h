#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean stats [SCENE]`: the sea-state certificate.
void add_stats_command(CLI::App& ocean, GlobalOptions& options);

}  // namespace offing::cli
