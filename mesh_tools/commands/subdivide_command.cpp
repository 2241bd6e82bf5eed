#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "host/base/argument.h"
#include "host/command_line/general_flags.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/subdivide.h"

namespace offing::mesh_tools {

namespace {

struct SubdivideArguments {
  MeshJob job;
  std::string method = "loop", levels;
};

struct NamedMethod {
  std::string_view name;
  SubdivisionMethod method;
};

constexpr std::array<NamedMethod, 4> methods = {{{"loop", SubdivisionMethod::loop},
                                                 {"sqrt3", SubdivisionMethod::sqrt3},
                                                 {"butterfly", SubdivisionMethod::butterfly},
                                                 {"catmull-clark", SubdivisionMethod::catmull_clark}}};

SubdivisionMethod read_method(const std::string& name) {
  const auto* const found = std::find_if(methods.begin(), methods.end(),
                                         [&](const NamedMethod& known) { return known.name == name; });
  if (found == methods.end()) {
    throw bad_argument("--method", "loop, sqrt3, butterfly or catmull-clark", name, "loop");
  }
  return found->method;
}

void run(const SubdivideArguments& arguments, const Options& options) {
  const SubdivisionMethod method = read_method(arguments.method);
  constexpr int most_levels = 12;
  const int levels = arguments.levels.empty()
                         ? 1
                         : static_cast<int>(read_whole("--levels", arguments.levels, 1, most_levels, "2"));
  arguments.job.require_output();
  const TriangleMesh mesh = arguments.job.read();
  const TriangleMesh result = subdivide(mesh, arguments.job.input, method, levels, options.cancel);
  arguments.job.write(result);
  arguments.job.tell(result, mesh.faces.size());
}

}  // namespace

void add_subdivide_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<SubdivideArguments>();
  CLI::App* command = program.add_subcommand("subdivide", "a finer, smoother mesh");
  arguments->job.add_to(*command);
  command->add_option("--method", arguments->method, "loop (default), sqrt3, butterfly or catmull-clark")
      ->type_name("M");
  command->add_option("--levels", arguments->levels, "how often (default 1)")->type_name("N");
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
  loop           smooth; four faces of one
  sqrt3          smooth; three faces of one, so that levels are closer together
  butterfly      through the vertices of the mesh, which stay where they are; four faces of one
  catmull-clark  smooth; quadrilaterals, cut into triangles in the end; six faces of one, then four

The mesh must be a manifold: `offing-mesh repair` makes one. Its vertices keep their numbers.

Example:
  offing-mesh subdivide cage.obj --method loop --levels 3 -o smooth.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
