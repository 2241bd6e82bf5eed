#include <string>

#include <CLI/App.hpp>

#include "host/base/process.h"
#include "host/command_line/parse_arguments.h"
#include "host/scene/file/version.h"
#include "mesh_tools/commands/mesh_commands.h"

namespace {

namespace mesh_tools = offing::mesh_tools;

void build(CLI::App& app, mesh_tools::Options& options) {
  app.name("offing-mesh");
  offing::format_help(app);
  app.description("Offing's mesh tools: checks, repairs and prepares triangle meshes");
  app.set_version_flag("--version", "offing-mesh " + std::string(offing::scene::version()),
                       "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  mesh_tools::add_check_command(app, options);
  mesh_tools::add_curvature_command(app, options);
  mesh_tools::add_generate_command(app, options);
  mesh_tools::add_repair_command(app, options);
  mesh_tools::add_remesh_command(app, options);
  mesh_tools::add_simplify_command(app, options);
  mesh_tools::add_subdivide_command(app, options);
  app.footer(R"(
Examples:
  offing-mesh check scan.ply
  offing-mesh curvature scan.ply -o scan_curvature.ply
  offing-mesh generate torus-knot -o knot.ply
  offing-mesh repair scan.obj -o scan.ply
  offing-mesh simplify scan.ply --faces 5000 -o coarse.ply

Exit codes: 0 done, 1 failed, 2 wrong usage or input, 130 interrupted.)");
}

int run(int argc, char** argv, const offing::CancelToken& cancel) {
  mesh_tools::Options options{.cancel = cancel};
  offing::configure_log(options.verbosity);
  CLI::App app;
  build(app, options);
  offing::parse_arguments(app, argc, argv);
  offing::finish_output();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return offing::run_program([&](const offing::CancelToken& cancel) { return run(argc, argv, cancel); });
}
