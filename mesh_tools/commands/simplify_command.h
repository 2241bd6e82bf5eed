#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh simplify IN -o OUT`: fewer faces of the same shape.
void add_simplify_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
