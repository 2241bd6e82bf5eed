#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "mesh_tools/commands/fineness_flags.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/remesh.h"

namespace offing::mesh_tools {

namespace {

struct RemeshArguments {
  MeshJob job;
  FinenessFlags fineness;
  SettingOptions<RemeshSettings> settings;
};

std::vector<scene::Row<RemeshSettings>> remesh_rows() {
  return {{&RemeshSettings::rounds,
           {.key = "rounds",
            .low = 1.0,
            .high = 100.0,
            .help = "rounds of splitting, collapsing, flipping and smoothing"}},
          {&RemeshSettings::sharp_rad,
           {.key = "sharp_deg",
            .unit = "deg",
            .low = 1.0,
            .high = 180.0,
            .help = "keep edges that bend by more than this in place",
            .example = "40",
            .absent = "none",
            .scale = std::numbers::pi / 180.0}}};
}

/// Far too short edges would fill the memory, and no edge makes faces of nothing.
void require_few_faces(const TriangleMesh& mesh, double edge_m) {
  if (!(edge_m > 0.0)) {
    throw Error(ErrorKind::bad_input, "offing-mesh remesh: expected faces with an area, got none",
                "`offing-mesh check` shows what the mesh contains");
  }
  const double faces = most_faces_at(mesh, edge_m);
  if (faces <= most_faces) return;  // not of an edge of 0
  throw Error(
      ErrorKind::bad_input,
      fmt::format("offing-mesh remesh: expected edges that make fewer than 1e8 faces, got about {:.2g} with "
                  "edges of {:.3g} m",
                  faces, edge_m),
      "choose longer edges or fewer faces; `offing-mesh check` counts faces without an area");
}

void run(const RemeshArguments& arguments, const Options& options) {
  const Fineness fineness = arguments.fineness.read("remesh");
  RemeshSettings settings = arguments.settings.read();
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const auto remeshed = [&] {
    require_few_faces(mesh, settings.edge_m);
    return remesh(mesh, arguments.job.input, settings, options.cancel, options.verbosity);
  };
  settings.edge_m = fineness.edge_m ? *fineness.edge_m : edge_length_for(mesh, fineness.faces);
  TriangleMesh result = remeshed();
  if (!fineness.edge_m) {
    // Edges come out a little shorter than asked; the first mesh shows by how much.
    settings.edge_m *= std::sqrt(static_cast<double>(result.faces.size()) / fineness.faces);
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
  CLI::App* command = program.add_subcommand("remesh", "rebuild a surface with edges of about equal length");
  arguments->job.add_to(*command);
  arguments->fineness.add_to(*command, "target edge length", "approximate number of faces");
  arguments->settings.add_to(*command, remesh_rows());
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
New border vertices lie on the old borders. With --sharp-deg, new vertices of sharp edges lie on the old sharp
edges. The mesh must be a manifold: `offing-mesh repair` makes one.

Examples:
  offing-mesh remesh scan.ply --faces 20000 -o even.ply
  offing-mesh remesh part.stl --edge-m 0.002 --sharp-deg 40 -o even.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
