#include "mesh_tools/generate_command.h"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "host/base/error_report.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_json.h"
#include "host/command_line/print_summary.h"
#include "host/command_line/verbosity_flags.h"
#include "host/io/meshes/write_mesh.h"
#include "host/mesh_shapes/shape.h"

namespace offing::mesh_tools {

namespace {

using namespace mesh_shapes;

struct GenerateArguments {
  std::string output;
  bool json = false;
  Overwriting overwriting = Overwriting::refused;
  int level = 5;
  Grid grid;
  bool random_diagonals = false;
  Roughness roughness;
};

void write(const Shape& shape, const GenerateArguments& arguments) {
  if (shape.truth && std::filesystem::path(arguments.output).extension() == ".ply") {
    const VertexCurvatures& truth = *shape.truth;
    write_ply(arguments.output, shape.mesh,
              {.properties = {{"true_k_max", truth.k_max_per_m}, {"true_k_min", truth.k_min_per_m}},
               .colours = {},
               .comments = {"curvatures of the smooth surface in 1/m, positive where convex"}});
  } else {
    write_mesh(arguments.output, shape.mesh);
  }
  const std::size_t vertices = shape.mesh.positions_m.size(), faces = shape.mesh.faces.size();
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"vertices", vertices},
                {"faces", faces},
                {"has_true_curvature", shape.truth.has_value()}});
  } else {
    print_summary("{}: {} vertices, {} faces\n", one_line(arguments.output), vertices, faces);
  }
}

/// Adds one shape: its own flags come from `add_flags`, its mesh from `make`.
template <typename Make>
CLI::App* add_shape(CLI::App& generate, Options& options, const std::shared_ptr<GenerateArguments>& arguments,
                    const std::string& name, const std::string& description, Make make) {
  CLI::App* command = generate.add_subcommand(name, description);
  command
      ->add_option("-o,--output", arguments->output,
                   "mesh: .ply (with the true curvatures), .obj, .off, .stl")
      ->required()
      ->type_name("OUT");
  command->add_flag("--json", arguments->json, "results for scripts");
  add_force_flag(*command, arguments->overwriting);
  add_verbosity_flags(*command, options.verbosity);
  command->callback([arguments, make] {
    require_mesh_extension(arguments->output);
    require_new(arguments->output, arguments->overwriting);
    if (arguments->random_diagonals) arguments->grid.diagonals = Diagonals::random;
    write(make(), *arguments);
  });
  return command;
}

void add_roughness(CLI::App& command, GenerateArguments& arguments) {
  command
      .add_option("--jitter", arguments.roughness.jitter,
                  "vertices move along the surface by up to so many edge lengths")
      ->type_name("0 ... 0.45");
  command
      .add_option("--noise", arguments.roughness.normal_noise,
                  "and off it, a standard deviation in edge lengths")
      ->type_name("0 ... 1");
  command.add_option("--seed", arguments.roughness.seed, "of what is drawn")->capture_default_str();
}

void add_level(CLI::App& command, GenerateArguments& arguments) {
  command.add_option("--level", arguments.level, "20 * 4^level faces, 0 ... 9")->capture_default_str();
  add_roughness(command, arguments);
}

void add_grid(CLI::App& command, GenerateArguments& arguments, const Grid& grid, const char* along_u,
              const char* along_v) {
  // Flags of each shape have defaults of their own: the shape that is asked for sets them first.
  command.preparse_callback([&arguments, grid](std::size_t) { arguments.grid = grid; });
  command.add_option("--u-cells", arguments.grid.u_cells,
                     fmt::format("cells {} [{}]", along_u, grid.u_cells));
  command.add_option("--v-cells", arguments.grid.v_cells,
                     fmt::format("cells {} [{}]", along_v, grid.v_cells));
}

void add_diagonals(CLI::App& command, GenerateArguments& arguments) {
  command.add_flag("--random-diagonals", arguments.random_diagonals,
                   "cut cells either way, as the seed has it");
  add_roughness(command, arguments);
}

/// Sizes of all shapes, with their defaults.
struct Sizes {
  double sphere_radius_m = 1.0, head_radius_m = 0.1;
  glm::dvec3 semi_axes_m{1.0, 0.75, 0.5};
  double torus_radius_m = 1.0, torus_tube_m = 0.4;
  TorusKnot knot;
  double half_width_m = 1.0, length_m = 30.0, span_m = 1.6;
};

void add_size(CLI::App& command, const std::string& flag, double& size_m, const std::string& description) {
  command.add_option(flag, size_m, description + ", m")->capture_default_str();
}

void add_round_shapes(CLI::App& generate, Options& options,
                      const std::shared_ptr<GenerateArguments>& arguments,
                      const std::shared_ptr<Sizes>& sizes) {
  CLI::App* sphere = add_shape(generate, options, arguments, "sphere", "an icosphere", [arguments, sizes] {
    return make_sphere(sizes->sphere_radius_m, arguments->level, arguments->roughness);
  });
  add_size(*sphere, "--radius-m", sizes->sphere_radius_m, "radius");
  add_level(*sphere, *arguments);

  CLI::App* ellipsoid =
      add_shape(generate, options, arguments, "ellipsoid", "an icosphere, stretched", [arguments, sizes] {
        return make_ellipsoid(sizes->semi_axes_m, arguments->level, arguments->roughness);
      });
  add_size(*ellipsoid, "--x-m", sizes->semi_axes_m.x, "semi-axis along x");
  add_size(*ellipsoid, "--y-m", sizes->semi_axes_m.y, "semi-axis along y");
  add_size(*ellipsoid, "--z-m", sizes->semi_axes_m.z, "semi-axis along z");
  add_level(*ellipsoid, *arguments);

  CLI::App* head = add_shape(
      generate, options, arguments, "head", "a blob like a character's head",
      [arguments, sizes] { return make_head(sizes->head_radius_m, arguments->level, arguments->roughness); });
  add_size(*head, "--radius-m", sizes->head_radius_m, "radius of the skull");
  add_level(*head, *arguments);
}

void add_grid_shapes(CLI::App& generate, Options& options,
                     const std::shared_ptr<GenerateArguments>& arguments,
                     const std::shared_ptr<Sizes>& sizes) {
  CLI::App* torus = add_shape(generate, options, arguments, "torus", "a torus about z", [arguments, sizes] {
    return make_torus(sizes->torus_radius_m, sizes->torus_tube_m, arguments->grid, arguments->roughness);
  });
  add_size(*torus, "--radius-m", sizes->torus_radius_m, "radius of the tube's middle");
  add_size(*torus, "--tube-m", sizes->torus_tube_m, "radius of the tube");
  add_grid(*torus, *arguments, {160, 64}, "around z", "around the tube");
  add_diagonals(*torus, *arguments);

  CLI::App* knot = add_shape(
      generate, options, arguments, "torus-knot", "a knotted tube",
      [arguments, sizes] { return make_torus_knot(sizes->knot, arguments->grid, arguments->roughness); });
  knot->add_option("--around", sizes->knot.around, "windings about z")->capture_default_str();
  knot->add_option("--through", sizes->knot.through, "windings through the hole")->capture_default_str();
  add_size(*knot, "--radius-m", sizes->knot.radius_m, "radius of the torus that it lies on");
  add_size(*knot, "--winding-m", sizes->knot.winding_m, "radius of that torus's tube");
  add_size(*knot, "--tube-m", sizes->knot.tube_radius_m, "radius of the knot's own tube");
  add_grid(*knot, *arguments, {120, 12}, "along the tube", "around it");
  add_diagonals(*knot, *arguments);

  CLI::App* saddle = add_shape(
      generate, options, arguments, "saddle", "an open patch with its border",
      [arguments, sizes] { return make_saddle(sizes->half_width_m, arguments->grid, arguments->roughness); });
  add_size(*saddle, "--half-width-m", sizes->half_width_m, "half of its width");
  add_grid(*saddle, *arguments, {100, 100}, "along x", "along y");
  add_diagonals(*saddle, *arguments);

  CLI::App* ship = add_shape(generate, options, arguments, "ship", "a hull with its deck",
                             [arguments, sizes] { return make_ship(sizes->length_m, arguments->grid); });
  add_size(*ship, "--length-m", sizes->length_m, "length");
  add_grid(*ship, *arguments, {120, 64}, "along the hull", "around it");

  CLI::App* bird = add_shape(generate, options, arguments, "bird", "a bird that soars",
                             [arguments, sizes] { return make_bird(sizes->span_m, arguments->grid); });
  add_size(*bird, "--span-m", sizes->span_m, "from tip to tip of its wings");
  add_grid(*bird, *arguments, {120, 24}, "from tip to tip", "around its wings and body");
}

}  // namespace

void add_generate_command(CLI::App& program, Options& options) {
  CLI::App* generate =
      program.add_subcommand("generate", "meshes made by formulas, with their true curvatures");
  generate->require_subcommand(1);
  const auto arguments = std::make_shared<GenerateArguments>();
  const auto sizes = std::make_shared<Sizes>();
  add_round_shapes(*generate, options, arguments, sizes);
  add_grid_shapes(*generate, options, arguments, sizes);
  generate->footer(R"(
A PLY has true_k_max and true_k_min for each vertex, those of the smooth surface, but for ship and bird, whose edges have none.

Examples:
  offing-mesh generate torus-knot -o knot.ply
  offing-mesh generate sphere --level 6 --jitter 0.25 -o sphere.ply)");
}

}  // namespace offing::mesh_tools
