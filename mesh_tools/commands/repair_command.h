#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh repair IN -o OUT`: an oriented manifold of any triangles, and what had to be changed.
void add_repair_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
