#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh subdivide IN -o OUT`: a finer, smoother mesh.
void add_subdivide_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
