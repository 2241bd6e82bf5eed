#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing bodies`: what floats in a scene.
void add_bodies_command(CLI::App& app, GlobalOptions& options);

/// `offing bodies info`: how bodies float, and their hydrodynamic data.
void add_bodies_info_command(CLI::App& parent, GlobalOptions& options);

/// `offing bodies rao`: how they answer regular waves.
void add_bodies_rao_command(CLI::App& parent, GlobalOptions& options);

/// `offing bodies motion`: how they move in the scene's sea.
void add_bodies_motion_command(CLI::App& parent, GlobalOptions& options);

}  // namespace offing::cli
