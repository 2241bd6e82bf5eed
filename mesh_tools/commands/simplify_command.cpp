#include <cstddef>
#include <memory>
#include <string>

#include "host/command_line/general_flags.h"
#include "mesh_tools/commands/fineness_flags.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/simplify.h"

namespace offing::mesh_tools {

namespace {

struct SimplifyArguments {
  MeshJob job;
  FinenessFlags fineness;
};

TriangleMesh simplified(const std::string& name, const Fineness& fineness, const TriangleMesh& mesh,
                        const Options& options) {
  if (fineness.edge_m) {
    return simplify_to_edges(mesh, name, *fineness.edge_m, options.cancel, options.verbosity);
  }
  return simplify_to_faces(mesh, name, static_cast<std::size_t>(fineness.faces), options.cancel,
                           options.verbosity);
}

void run(const SimplifyArguments& arguments, const Options& options) {
  const Fineness fineness = arguments.fineness.read("simplify");
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const TriangleMesh result = simplified(arguments.job.input, fineness, mesh, options);
  arguments.job.write(result);
  arguments.job.tell(result, mesh.faces.size());
}

}  // namespace

void add_simplify_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<SimplifyArguments>();
  CLI::App* command = program.add_subcommand("simplify", "reduce the number of faces, keeping the shape");
  arguments->job.add_to(*command);
  arguments->fineness.add_to(*command, "collapse edges until none is shorter",
                             "collapse edges until this many faces are left");
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
With --faces, the edges that change the surface least collapse first; with --edge-m, the shortest. Faces
never turn over, so a few more faces may be left than you asked for. The mesh must be a manifold:
`offing-mesh repair` makes one.

Examples:
  offing-mesh simplify scan.ply --faces 5000 -o coarse.ply
  offing-mesh simplify scan.ply --edge-m 0.01 -o coarse.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
