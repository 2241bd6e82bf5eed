#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean bake | stats | query | modes | spectrum`. `options` must outlive the application.
void add_ocean_command(CLI::App& app, GlobalOptions& options);

/// `offing ocean bake [SCENE] -o DIR`: frames of ocean maps as OpenEXR.
void add_bake_command(CLI::App& ocean, GlobalOptions& options);

/// `offing ocean stats [SCENE]`: the sea-state certificate.
void add_stats_command(CLI::App& ocean, GlobalOptions& options);

/// `offing ocean query [SCENE] --at X,Z --time T | --points FILE --times A:B:DT [-o FILE]`.
void add_query_command(CLI::App& ocean, GlobalOptions& options);

/// `offing ocean modes [SCENE] -o FILE`: all single waves of a sea.
void add_modes_command(CLI::App& ocean, GlobalOptions& options);

/// `offing ocean spectrum FILE`: lists, draws and exports measured spectra.
void add_spectrum_command(CLI::App& ocean, GlobalOptions& options);

}  // namespace offing::cli
