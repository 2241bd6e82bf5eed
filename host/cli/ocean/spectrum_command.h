#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean spectrum FILE`: lists, draws and exports measured spectra.
void add_spectrum_command(CLI::App& ocean, GlobalOptions& options);

}  // namespace offing::cli
