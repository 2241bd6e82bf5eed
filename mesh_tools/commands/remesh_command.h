#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh remesh IN -o OUT`: the same surface with edges of about one length.
void add_remesh_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
