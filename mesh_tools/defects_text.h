#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "host/io/meshes/mesh_file.h"
#include "mesh_tools/mesh_defects.h"

namespace offing::mesh_tools {

/// The counts that scripts read, by fixed names.
nlohmann::ordered_json to_json(const MeshDefects& defects);
/// What became of a file: its format, and what text_of() says.
nlohmann::ordered_json to_json(const MeshReport& report);

/// Lines for people.
std::string text_of(const MeshDefects& defects);

/// Lines about what became of the file; empty where it was taken as it is.
std::string text_of(const MeshReport& report);

}  // namespace offing::mesh_tools
