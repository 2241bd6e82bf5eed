#include <cstdint>
#include <memory>
#include <string>

#include <CLI/Option.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/simplify.h"

namespace offing::mesh_tools {

namespace {

struct SimplifyArguments {
  MeshJob job;
  std::string edge, faces;
};

constexpr double longest_edge_m = 1e9;
constexpr std::int64_t most_faces = 100'000'000;

TriangleMesh simplified(const SimplifyArguments& arguments, const TriangleMesh& mesh,
                        const Options& options) {
  const std::string& name = arguments.job.input;
  if (!arguments.faces.empty()) {
    const std::int64_t faces = read_whole("--faces", arguments.faces, 4, most_faces, "5000");
    return simplify_to_faces(mesh, name, static_cast<std::size_t>(faces), options.cancel, options.verbosity);
  }
  const double edge_m = read_number("--edge-m", arguments.edge, "m", 1e-9, longest_edge_m, "0.05");
  return simplify_to_edges(mesh, name, edge_m, options.cancel, options.verbosity);
}

void run(const SimplifyArguments& arguments, const Options& options) {
  if (arguments.edge.empty() == arguments.faces.empty()) {
    throw Error(ErrorKind::bad_usage, "offing-mesh simplify: expected --edge-m or --faces, got neither",
                "say how fine the mesh should be, such as --faces 5000");
  }
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const TriangleMesh result = simplified(arguments, mesh, options);
  arguments.job.write(result);
  arguments.job.tell(result, mesh.faces.size());
}

}  // namespace

void add_simplify_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<SimplifyArguments>();
  CLI::App* command = program.add_subcommand("simplify", "fewer faces of the same shape");
  arguments->job.add_to(*command);
  CLI::Option* edge =
      command->add_option("--edge-m", arguments->edge, "collapse edges until none is shorter, m")
          ->type_name("L");
  command->add_option("--faces", arguments->faces, "collapse edges until there are so many faces")
      ->type_name("N")
      ->excludes(edge);
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
With --faces edges collapse first where that changes the surface least, with --edge-m the shortest ones. No face
turns over, so that a few faces more than asked may be left. The mesh must be a manifold: `offing-mesh repair`
makes one.

Examples:
  offing-mesh simplify scan.ply --faces 5000 -o coarse.ply
  offing-mesh simplify scan.ply --edge-m 0.01 -o coarse.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
