#include <memory>
#include <vector>

#include "host/command_line/general_flags.h"
#include "host/command_line/setting_options.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/subdivide.h"

namespace offing::mesh_tools {

namespace {

struct SubdivideSettings {
  SubdivisionMethod method = SubdivisionMethod::loop;
  int levels = 1;
};

struct SubdivideArguments {
  MeshJob job;
  SettingOptions<SubdivideSettings> settings;
};

std::vector<scene::Row<SubdivideSettings>> subdivide_rows() {
  return {{scene::choice(&SubdivideSettings::method, {"loop", "sqrt3", "butterfly", "catmull-clark"}),
           {.key = "method", .help = "subdivision scheme; the list below describes each"}},
          {&SubdivideSettings::levels,
           {.key = "levels", .low = 1.0, .high = 12.0, .help = "number of times to subdivide"}}};
}

void run(const SubdivideArguments& arguments, const Options& options) {
  const auto [method, levels] = arguments.settings.read();
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const TriangleMesh result = subdivide(mesh, arguments.job.input, method, levels, options.cancel);
  arguments.job.write(result);
  arguments.job.tell(result, mesh.faces.size());
}

}  // namespace

void add_subdivide_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<SubdivideArguments>();
  CLI::App* command = program.add_subcommand("subdivide", "refine and smooth a mesh");
  arguments->job.add_to(*command);
  arguments->settings.add_to(*command, subdivide_rows());
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
  loop           smooth; splits each face into four
  sqrt3          smooth; splits each face into three, so levels are closer together
  butterfly      keeps the vertices of the mesh in place; splits each face into four
  catmull-clark  smooth; makes quadrilaterals, cut into triangles at the end; six faces from each, then four

The mesh must be a manifold: `offing-mesh repair` makes one. Its vertices keep their indices.

Example:
  offing-mesh subdivide cage.obj --method loop --levels 3 -o smooth.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
