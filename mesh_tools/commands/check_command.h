#pragma once

#include <CLI/App.hpp>

#include "mesh_tools/commands/options.h"

namespace offing::mesh_tools {

/// `offing-mesh check IN`: what is to know about a mesh before it is used.
void add_check_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
