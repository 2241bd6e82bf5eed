#include "mesh_tools/commands/mesh_job.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "host/io/meshes/read_mesh.h"
#include "host/io/meshes/write_mesh.h"

namespace offing::mesh_tools {

void MeshJob::add_to(CLI::App& command) {
  command.add_option("FILE", input, "mesh: .obj, .ply, .off, .stl, .gltf, .glb")->required();
  command.add_option("-o,--output", output, "mesh to write: .ply (binary), .obj, .off, .stl")
      ->type_name("FILE")
      ->required();
  add_force_flag(command, existing);
  command.add_flag("--json", json, "print the results as JSON");
  add_trust_flag(command, trust);
}

void MeshJob::require_output() const {
  require_mesh_extension(output);
  require_new(output, existing, {{input}, trust});
}

TriangleMesh MeshJob::read() const {
  return read_mesh(input, trust);
}

void MeshJob::write(const TriangleMesh& mesh) const {
  write_mesh(output, mesh, existing);
}

std::string MeshJob::told(const TriangleMesh& mesh) const {
  return fmt::format("{}: {} vertices, {} faces", one_line(output), mesh.positions_m.size(),
                     mesh.faces.size());
}

void MeshJob::tell(const TriangleMesh& mesh, std::size_t faces_before) const {
  if (json) {
    print_json({{"file", output},
                {"vertices", mesh.positions_m.size()},
                {"faces", mesh.faces.size()},
                {"faces_before", faces_before}});
  } else {
    print_summary("{} of {}\n", told(mesh), faces_before);
  }
}

}  // namespace offing::mesh_tools
