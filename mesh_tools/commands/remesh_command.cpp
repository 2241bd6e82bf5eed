#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/remesh.h"

namespace offing::mesh_tools {

namespace {

struct RemeshArguments {
  MeshJob job;
  std::string edge, faces, rounds, sharp;
};

constexpr double longest_edge_m = 1e9, most_faces = 1e8;

/// How fine the mesh should be: one of the two.
struct Fineness {
  std::optional<double> edge_m, faces;
};

Fineness fineness_of(const RemeshArguments& arguments) {
  if (arguments.edge.empty() == arguments.faces.empty()) {
    throw Error(ErrorKind::bad_usage, "offing-mesh remesh: expected --edge-m or --faces, got neither",
                "say how fine the mesh should be, such as --faces 5000");
  }
  if (!arguments.edge.empty()) {
    return {.edge_m = read_number("--edge-m", arguments.edge, "m", 1e-9, longest_edge_m, "0.05"),
            .faces = {}};
  }
  const std::int64_t faces =
      read_whole("--faces", arguments.faces, 4, static_cast<std::int64_t>(most_faces), "5000");
  return {.edge_m = {}, .faces = static_cast<double>(faces)};
}

RemeshSettings settings_of(const RemeshArguments& arguments) {
  RemeshSettings settings;
  if (!arguments.rounds.empty()) {
    settings.rounds = static_cast<int>(read_whole("--rounds", arguments.rounds, 1, 100, "5"));
  }
  if (!arguments.sharp.empty()) {
    settings.sharp_rad =
        read_number("--sharp-deg", arguments.sharp, "degrees", 1.0, 180.0, "40") * std::numbers::pi / 180.0;
  }
  return settings;
}

/// Far too short edges would fill the memory, and no edge makes faces of nothing.
void require_few_faces(const TriangleMesh& mesh, double edge_m) {
  if (!(edge_m > 0.0)) {
    throw Error(ErrorKind::bad_input, "offing-mesh remesh: expected faces with an area, got none",
                "`offing-mesh check` tells what the mesh holds");
  }
  const double faces = most_faces_at(mesh, edge_m);
  if (faces <= most_faces) return;  // not of an edge of 0
  throw Error(
      ErrorKind::bad_input,
      fmt::format("offing-mesh remesh: expected edges that make fewer than 1e8 faces, got about {:.2g} with "
                  "edges of {:.3g} m",
                  faces, edge_m),
      "choose longer edges or fewer faces; `offing-mesh check` tells of faces without an area");
}

void run(const RemeshArguments& arguments, const Options& options) {
  const Fineness fineness = fineness_of(arguments);
  RemeshSettings settings = settings_of(arguments);
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const auto remeshed = [&] {
    require_few_faces(mesh, settings.edge_m);
    return remesh(mesh, arguments.job.input, settings, options.cancel, options.verbosity);
  };
  settings.edge_m = fineness.edge_m ? *fineness.edge_m : edge_length_for(mesh, *fineness.faces);
  TriangleMesh result = remeshed();
  if (fineness.faces) {
    // Edges come out a little shorter than asked: by how much is seen from the first mesh.
    settings.edge_m *= std::sqrt(static_cast<double>(result.faces.size()) / *fineness.faces);
    result = remeshed();
  }
  arguments.job.write(result);
  if (arguments.job.json) {
    print_json({{"file", arguments.job.output},
                {"vertices", result.positions_m.size()},
                {"faces", result.faces.size()},
                {"edge_m", settings.edge_m}});
  } else {
    print_summary("{}, edges of about {:.4g} m\n", arguments.job.told(result), settings.edge_m);
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
New vertices of borders lie on the old ones, and with --sharp-deg those of sharp edges. The mesh must be a
manifold: `offing-mesh repair` makes one.

Examples:
  offing-mesh remesh scan.ply --faces 20000 -o even.ply
  offing-mesh remesh part.stl --edge-m 0.002 --sharp-deg 40 -o even.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
