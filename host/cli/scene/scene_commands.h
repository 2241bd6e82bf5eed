#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing scene`: commands for those who write scene files.
void add_scene_command(CLI::App& app, GlobalOptions& options);

void add_new_command(CLI::App& scene, GlobalOptions& options);
void add_import_command(CLI::App& scene, GlobalOptions& options);
void add_check_command(CLI::App& scene, GlobalOptions& options);
void add_keys_command(CLI::App& scene, GlobalOptions& options);
void add_schema_command(CLI::App& scene, GlobalOptions& options);

}  // namespace offing::cli
