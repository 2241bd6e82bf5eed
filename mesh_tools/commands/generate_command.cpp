#include <memory>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/meshes/write_mesh.h"
#include "host/mesh_shapes/shape_table.h"
#include "mesh_tools/commands/mesh_commands.h"

namespace offing::mesh_tools {

namespace {

using namespace mesh_shapes;

struct GenerateArguments {
  std::string output;
  bool json = false;
  Existing existing = Existing::keep;
  bool random_diagonals = false;
  ShapeOrder order;
};

void write(const Shape& shape, const GenerateArguments& arguments) {
  if (shape.truth && std::filesystem::path(arguments.output).extension() == ".ply") {
    const VertexCurvatures& truth = *shape.truth;
    write_ply(arguments.output, shape.mesh,
              {.properties = {{"true_k_max", truth.k_max_per_m}, {"true_k_min", truth.k_min_per_m}},
               .colours = {},
               .comments = {"curvatures of the smooth surface in 1/m, positive where convex"}},
              arguments.existing);
  } else {
    write_mesh(arguments.output, shape.mesh, arguments.existing);
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

void add_roughness(CLI::App& command, Roughness& roughness) {
  command
      .add_option("--jitter", roughness.jitter,
                  "moves vertices along the surface by up to this many edge lengths")
      ->type_name("0 ... 0.45");
  command
      .add_option("--noise", roughness.normal_noise,
                  "moves vertices off the surface: standard deviation in edge lengths")
      ->type_name("0 ... 1");
  command.add_option("--seed", roughness.seed, "of the random numbers");
}

/// Adds an option and puts its default into the help, which does not show it by itself.
template <typename Value>
CLI::Option* add_value(CLI::App& command, std::string_view flag, Value& value, std::string_view help) {
  return command.add_option(std::string(flag), value, fmt::format("{} [{}]", help, value));
}

void add_sizes(CLI::App& command, const ShapeRow& row, ShapeOrder& order) {
  const std::string which = row.size_help.empty() ? "" : fmt::format(" {}", row.size_help);
  add_value(command, row.size_flag, order.size_m, fmt::format("{}{}, m", row.size, which));
  for (std::size_t i = 0; i < row.numbers.size(); ++i) {
    const ShapeNumber& number = row.numbers[i];
    if (number.kind == ShapeNumber::Kind::count) {
      add_value(command, number.flag, order.numbers[i], number.help)
          ->check(CLI::TypeValidator<int>(""))
          ->type_name("INT");
    } else {
      add_value(command, number.flag, order.numbers[i], fmt::format("{}, m", number.help));
    }
  }
}

void add_fineness(CLI::App& command, const ShapeRow& row, GenerateArguments& arguments) {
  ShapeOrder& order = arguments.order;
  if (row.level > 0) add_value(command, "--level", order.level, "20 * 4^level faces, 0 ... 9");
  if (!row.u_help.empty())
    add_value(command, "--u-cells", order.grid.u_cells, fmt::format("cells {}", row.u_help));
  if (!row.v_help.empty())
    add_value(command, "--v-cells", order.grid.v_cells, fmt::format("cells {}", row.v_help));
  if (!row.has_truth) return;
  if (row.level == 0)
    command.add_flag("--random-diagonals", arguments.random_diagonals,
                     "cut each cell along a random diagonal");
  add_roughness(command, order.roughness);
}

void add_shape(CLI::App& generate, Options& options, const ShapeRow& row) {
  const auto arguments = std::make_shared<GenerateArguments>();
  arguments->order = order_of(row, 1.0, row.generated_detail);
  CLI::App* command = generate.add_subcommand(std::string(row.name), std::string(row.help));
  if (!row.other_name.empty()) command->alias(std::string(row.other_name));
  command
      ->add_option("-o,--output", arguments->output,
                   row.has_truth ? "mesh: .ply (with the true curvatures), .obj, .off, .stl"
                                 : "mesh: .ply, .obj, .off, .stl")
      ->required()
      ->type_name("OUT");
  command->add_flag("--json", arguments->json, "results for scripts");
  add_force_flag(*command, arguments->existing);
  add_verbosity_flags(*command, options.verbosity);
  add_sizes(*command, row, arguments->order);
  add_fineness(*command, row, *arguments);
  command->callback([arguments, &row] {
    require_mesh_extension(arguments->output);
    require_new(arguments->output, arguments->existing);
    if (arguments->random_diagonals) arguments->order.grid.diagonals = Diagonals::random;
    write(row.make(arguments->order), *arguments);
  });
}

}  // namespace

void add_generate_command(CLI::App& program, Options& options) {
  CLI::App* generate =
      program.add_subcommand("generate", "meshes made by formulas, with their true curvatures");
  generate->require_subcommand(1);
  for (const ShapeRow& row : shapes()) add_shape(*generate, options, row);
  generate->footer(R"(
Scenes make the same shapes: shape = "box" in a [[mesh]]. A PLY of a shape without edges has true_k_max and
true_k_min for each vertex, the curvatures of the smooth surface.

Examples:
  offing-mesh generate torus-knot -o knot.ply
  offing-mesh generate cylinder --radius-m 0.5 --height-m 3 -o post.ply
  offing-mesh generate sphere --level 6 --jitter 0.25 -o sphere.ply)");
}

}  // namespace offing::mesh_tools
