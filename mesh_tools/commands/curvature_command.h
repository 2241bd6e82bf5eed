#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh curvature IN -o OUT.ply`: how a mesh bends at its vertices.
void add_curvature_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
