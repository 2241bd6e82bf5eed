#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "host/io/meshes/read_mesh.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/defects_text.h"
#include "mesh_tools/mesh_defects.h"

namespace offing::mesh_tools {

namespace {

struct CheckArguments {
  std::string input;
  bool json = false;
  Trust trust = Trust::trusted;
};

void run(const CheckArguments& arguments, const Options& options) {
  const MeshFile file = read_mesh_file(arguments.input, arguments.trust);
  const MeshDefects defects = find_defects(file.mesh, options.cancel);
  if (arguments.json) {
    warn_of_left_out(arguments.input, file.report);
    nlohmann::ordered_json json = to_json(defects);
    json.update(to_json(file.report));
    print_json(json);
    return;
  }
  fmt::print("{}: {}\n{}{}", one_line(arguments.input), file.report.format, text_of(file.report),
             text_of(defects));
}

}  // namespace

void add_check_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand("check", "report defects of a mesh");
  command->add_option("FILE", arguments->input, "mesh: .obj, .ply, .off, .stl, .gltf, .glb")->required();
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_trust_flag(*command, arguments->trust);
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
The check does not change the mesh. Vertices are told apart by index, not by position. Defects are results,
not errors: the exit code is 0.

  components             sets of faces connected by vertices
  boundary loops         sets of connected edges that have only one face
  non-manifold edges     edges of three or more faces
  non-manifold vertices  vertices whose faces form two or more fans that share no edge
  degenerate faces       faces without an area: corners exactly at one place or on one line
  duplicate faces        faces with the same three vertices as an earlier face
  isolated vertices      vertices that no face uses
  orientable             whether faces can be turned so that all neighbours agree
  self-intersections     pairs of faces that intersect outside their shared vertices and edges, exactly

Examples:
  offing-mesh check scan.ply
  offing-mesh check scan.ply --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
