#include "mesh_tools/commands/mesh_commands.h"

#include <string>

#include "host/command_line/help_format.h"
#include "host/scene/file/version.h"

namespace offing::mesh_tools {

void add_commands(CLI::App& app, Options& options) {
  app.name("offing-mesh");
  format_help(app);
  app.description("offing-mesh: check, repair and prepare triangle meshes");
  app.set_version_flag("--version", "offing-mesh " + std::string(scene::version()), "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  add_check_command(app, options);
  add_curvature_command(app, options);
  add_generate_command(app, options);
  add_repair_command(app, options);
  add_remesh_command(app, options);
  add_simplify_command(app, options);
  add_subdivide_command(app, options);
  app.footer(R"(
Examples:
  offing-mesh check scan.ply
  offing-mesh curvature scan.ply -o scan_curvature.ply
  offing-mesh generate torus-knot -o knot.ply
  offing-mesh repair scan.obj -o scan.ply
  offing-mesh simplify scan.ply --faces 5000 -o coarse.ply

Exit codes: 0 done, 1 failed, 2 wrong usage or input, 130 interrupted.)");
}

}  // namespace offing::mesh_tools
