#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh generate SHAPE -o OUT.ply`: meshes made by formulas.
void add_generate_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
