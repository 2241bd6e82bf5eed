#include "mesh_tools/remesh_command.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/print_json.h"
#include "host/command_line/verbosity_flags.h"
#include "mesh_tools/mesh_job.h"
#include "mesh_tools/remesh.h"

namespace offing::mesh_tools {

namespace {

struct RemeshArguments {
  MeshJob job;
  std::string edge, faces, rounds, sharp;
};

constexpr double longest_edge_m = 1e9;
constexpr std::int64_t most_faces = 100'000'000;

RemeshSettings settings_of(const RemeshArguments& arguments, const TriangleMesh& mesh) {
  RemeshSettings settings;
  settings.edge_m =
      arguments.edge.empty()
          ? edge_length_for(
                mesh, static_cast<double>(read_whole("--faces", arguments.faces, 4, most_faces, "5000")))
          : read_number("--edge-m", arguments.edge, "m", 1e-9, longest_edge_m, "0.05");
  if (!arguments.rounds.empty()) {
    settings.rounds = static_cast<int>(read_whole("--rounds", arguments.rounds, 1, 100, "5"));
  }
  if (!arguments.sharp.empty()) {
    settings.sharp_rad =
        read_number("--sharp-deg", arguments.sharp, "degrees", 1.0, 180.0, "40") * std::numbers::pi / 180.0;
  }
  return settings;
}

void run(const RemeshArguments& arguments, const Options& options) {
  if (arguments.edge.empty() == arguments.faces.empty()) {
    throw Error(ErrorKind::bad_usage, "offing-mesh remesh: expected --edge-m or --faces, got neither",
                "say how fine the mesh should be, such as --faces 5000");
  }
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  RemeshSettings settings = settings_of(arguments, mesh);
  // A far too short edge would fill the memory.
  if (edge_length_for(mesh, static_cast<double>(most_faces)) > settings.edge_m) {
    throw bad_argument("--edge-m",
                       fmt::format("at least {:.3g} m, for 1e8 faces",
                                   edge_length_for(mesh, static_cast<double>(most_faces))),
                       arguments.edge, fmt::format("{:.3g}", edge_length_for(mesh, 1e5)));
  }
  TriangleMesh result = remesh(mesh, arguments.job.input, settings, options.cancel, options.verbosity);
  if (!arguments.faces.empty()) {
    // Edges come out a little shorter than asked: how much is seen from the first mesh.
    const double asked = static_cast<double>(read_whole("--faces", arguments.faces, 4, most_faces, "5000"));
    settings.edge_m *= std::sqrt(static_cast<double>(result.faces.size()) / asked);
    result = remesh(mesh, arguments.job.input, settings, options.cancel, options.verbosity);
  }
  arguments.job.write(result);
  if (arguments.job.json) {
    print_json({{"file", arguments.job.output},
                {"vertices", result.positions_m.size()},
                {"faces", result.faces.size()},
                {"edge_m", settings.edge_m}});
  } else {
    fmt::print("{}, edges of about {:.4g} m\n", arguments.job.told(result), settings.edge_m);
  }
}

}  // namespace

void add_remesh_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<RemeshArguments>();
  CLI::App* command = program.add_subcommand("remesh", "the same surface with edges of about one length");
  arguments->job.add_to(*command);
  CLI::Option* edge =
      command->add_option("--edge-m", arguments->edge, "length that edges should have, m")->type_name("L");
  command->add_option("--faces", arguments->faces, "about how many faces to make")
      ->type_name("N")
      ->excludes(edge);
  command
      ->add_option("--rounds", arguments->rounds, "of splitting, collapsing, flipping, smoothing (default 3)")
      ->type_name("N");
  command->add_option("--sharp-deg", arguments->sharp, "edges bent by more stay where they are")
      ->type_name("A");
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
Borders stay where they are, and with --sharp-deg sharp edges. The mesh must be a manifold: `offing-mesh repair`
makes one.

Examples:
  offing-mesh remesh scan.ply --faces 20000 -o even.ply
  offing-mesh remesh part.stl --edge-m 0.002 --sharp-deg 40 -o even.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
