#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/meshes/write_mesh.h"
#include "host/mesh_shapes/shape_table.h"
#include "mesh_tools/commands/mesh_commands.h"

namespace offing::mesh_tools {

namespace {

using namespace mesh_shapes;

constexpr std::size_t most_numbers = 4;

/// An order, and its numbers at fixed offsets, which rows need.
struct ShapeSettings {
  ShapeOrder order;
  std::array<double, most_numbers> lengths_m{};
  std::array<int, most_numbers> counts{};
};

ShapeSettings usual_settings(const ShapeRow& row) {
  ShapeSettings settings{.order = order_of(row, 1.0, row.generated_detail)};
  for (std::size_t i = 0; i < row.numbers.size(); ++i) {
    settings.lengths_m.at(i) = settings.order.numbers[i];
    settings.counts.at(i) = static_cast<int>(settings.order.numbers[i]);
  }
  return settings;
}

ShapeOrder order_of(const ShapeRow& row, const ShapeSettings& settings) {
  ShapeOrder order = settings.order;
  for (std::size_t i = 0; i < row.numbers.size(); ++i) {
    order.numbers[i] =
        row.numbers[i].kind == ShapeNumber::Kind::count ? settings.counts.at(i) : settings.lengths_m.at(i);
  }
  return order;
}

struct GenerateArguments {
  std::string output;
  bool json = false;
  Existing existing = Existing::keep;
  bool random_diagonals = false;
  std::string size_help;
  SettingOptions<ShapeSettings> settings;
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

using Rows = std::vector<scene::Row<ShapeSettings>>;

/// One of the numbers of a shape.
template <class Value>
scene::Path<ShapeSettings, Value> number_at(std::array<Value, most_numbers> ShapeSettings::*numbers,
                                            std::size_t index) {
  return {scene::path(numbers).offset + index * sizeof(Value)};
}

void add_sizes(Rows& rows, const ShapeRow& row, std::string_view size_help) {
  rows.push_back({scene::path(&ShapeSettings::order, &ShapeOrder::size_m),
                  like_scene("mesh.size_m", row.size_flag, size_help)});
  for (std::size_t i = 0; i < row.numbers.size(); ++i) {
    const ShapeNumber& number = row.numbers[i];
    if (number.kind == ShapeNumber::Kind::count) {
      rows.push_back(
          {number_at(&ShapeSettings::counts, i),
           {.key = "windings", .flag = number.flag, .low = 1.0, .high = most_windings, .help = number.help}});
    } else {
      rows.push_back(
          {number_at(&ShapeSettings::lengths_m, i), like_scene("mesh.size_m", number.flag, number.help)});
    }
  }
}

void add_fineness(Rows& rows, const ShapeRow& row) {
  constexpr auto order = &ShapeSettings::order;
  if (row.level > 0) {
    rows.push_back({scene::path(order, &ShapeOrder::level),
                    {.key = "level",
                     .high = finest_level,
                     .help = "level of subdivision, which gives 20 * 4^level faces"}});
  }
  const auto add_cells = [&](int Grid::*cells, std::string_view key, std::string_view help) {
    if (help.empty()) return;
    rows.push_back({scene::path(order, &ShapeOrder::grid, cells),
                    {.key = key, .low = 1.0, .high = most_cells, .help = help}});
  };
  add_cells(&Grid::u_cells, "u_cells", row.u_help);
  add_cells(&Grid::v_cells, "v_cells", row.v_help);
}

void add_roughness(Rows& rows) {
  constexpr auto order = &ShapeSettings::order;
  constexpr auto roughness = &ShapeOrder::roughness;
  rows.push_back({scene::path(order, roughness, &Roughness::jitter),
                  {.key = "jitter",
                   .high = largest_jitter,
                   .help = "move vertices along the surface by up to this many edge lengths"}});
  rows.push_back({scene::path(order, roughness, &Roughness::normal_noise),
                  {.key = "noise",
                   .high = largest_noise,
                   .help = "move vertices off the surface: standard deviation in edge lengths"}});
  rows.push_back({scene::path(order, roughness, &Roughness::seed),
                  like_scene("terrain.seed", "--seed", "seed of the random numbers")});
}

void add_shape(CLI::App& generate, Options& options, const ShapeRow& row) {
  const auto arguments = std::make_shared<GenerateArguments>();
  const ShapeSettings usual = usual_settings(row);
  CLI::App* command = generate.add_subcommand(std::string(row.name), std::string(row.help));
  if (!row.other_name.empty()) command->alias(std::string(row.other_name));
  command
      ->add_option("-o,--output", arguments->output,
                   row.has_truth ? "mesh: .ply (with the true curvatures), .obj, .off, .stl"
                                 : "mesh: .ply, .obj, .off, .stl")
      ->required()
      ->type_name("OUT");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_force_flag(*command, arguments->existing);
  add_verbosity_flags(*command, options.verbosity);
  if (row.has_truth && row.level == 0) {
    command->add_flag("--random-diagonals", arguments->random_diagonals,
                      "cut each cell along a random diagonal");
  }
  arguments->size_help = fmt::format("{}{}{}", row.size, row.size_help.empty() ? "" : " ", row.size_help);
  Rows rows;
  add_sizes(rows, row, arguments->size_help);
  add_fineness(rows, row);
  if (row.has_truth) add_roughness(rows);
  arguments->settings.add_to(*command, std::move(rows), "Options", usual);
  command->callback([arguments, &row, usual] {
    require_mesh_extension(arguments->output);
    require_new(arguments->output, arguments->existing);
    ShapeOrder order = order_of(row, arguments->settings.read(usual));
    if (arguments->random_diagonals) order.grid.diagonals = Diagonals::random;
    write(row.make(order), *arguments);
  });
}

}  // namespace

void add_generate_command(CLI::App& program, Options& options) {
  CLI::App* generate =
      program.add_subcommand("generate", "generate meshes from formulas, with their true curvatures");
  generate->require_subcommand(1);
  for (const ShapeRow& row : shapes()) add_shape(*generate, options, row);
  generate->footer(R"(
Scenes can make the same shapes: write shape = "box" in a [[mesh]]. For shapes without sharp edges, a PLY has
true_k_max and true_k_min for each vertex: the curvatures of the exact smooth surface.

Examples:
  offing-mesh generate torus-knot -o knot.ply
  offing-mesh generate cylinder --radius-m 0.5 --height-m 3 -o post.ply
  offing-mesh generate sphere --level 6 --jitter 0.25 -o sphere.ply)");
}

}  // namespace offing::mesh_tools
