#pragma once

#include <cstddef>
#include <string>

#include <CLI/App.hpp>

#include "host/base/triangle_mesh.h"
#include "host/command_line/new_output.h"
#include "host/io/file_trust.h"
#include "host/io/meshes/mesh_file.h"

namespace offing::mesh_tools {

/// What commands share that make a mesh of a mesh: `IN -o OUT [--force] [--json]`.
struct MeshJob {
  std::string input, output;
  Existing existing = Existing::keep;
  bool json = false;
  Trust trust = Trust::trusted;

  void add_to(CLI::App& command);

  /// Throws Error for an output that no format fits or that is there already. Call it before work begins.
  void require_output() const;
  /// The mesh of the input; what it cannot hold is logged as a warning.
  TriangleMesh read() const;
  void write(const TriangleMesh& mesh) const;

  /// "out.ply: 1200 vertices, 2396 faces".
  std::string told(const TriangleMesh& mesh) const;
  /// Prints what was made of so many faces, for people or with --json for scripts.
  void tell(const TriangleMesh& mesh, std::size_t faces_before) const;
};

}  // namespace offing::mesh_tools
