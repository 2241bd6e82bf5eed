#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/meshes/prepared_mesh.h"
#include "host/io/meshes/read_mesh.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/curvature/curvature.h"
#include "mesh_tools/curvature/curvature_colours.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {
namespace {

struct ValueRange {
  double least = 0.0, mean = 0.0, largest = 0.0;  ///< mean by area
};

/// Gauss and Bonnet: over a surface and along its border, curvature adds up to 2 pi times Euler's
/// characteristic.
struct GaussBonnet {
  double integral = 0.0;        ///< sum of k_max k_min area
  double absolute = 0.0;        ///< sum of |k_max k_min| area
  double border_turning = 0.0;  ///< sum over border vertices of pi - the angles of the corners there
  double expected = 0.0;        ///< 2 pi times vertices - edges + faces
  /// How far the first and the third are from the fourth, as a part of the larger of the absolute integral
  /// and 2 pi.
  double difference_share = 0.0;
};

struct CurvatureStatistics {
  std::size_t vertices = 0;         ///< places with faces around
  std::size_t border_vertices = 0;  ///< of these, with an edge of other than two faces
  bool is_manifold = true;          ///< no edge has three faces or more: Gauss and Bonnet hold
  double area_m2 = 0.0;
  ValueRange k_max_per_m, k_min_per_m;
  GaussBonnet gauss_bonnet;
};

/// Grows a range by a value of some area; `mean` is a sum until the end.
void grow(ValueRange& range, double value, double area_m2, bool is_first) {
  range.least = is_first ? value : std::min(range.least, value);
  range.largest = is_first ? value : std::max(range.largest, value);
  range.mean += value * area_m2;
}

/// The angles of all corners at a vertex.
double angle_around(const UnitMesh& mesh, std::uint32_t vertex) {
  double sum = 0.0;
  for (const std::uint32_t face : mesh.neighbours.vertex_faces.row(vertex)) {
    const TriangleIndices& corners = mesh.neighbours.faces[face];
    const std::size_t here = static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
    const glm::dvec3 a = mesh.positions[corners[(here + 1) % 3]] - mesh.positions[vertex];
    const glm::dvec3 b = mesh.positions[corners[(here + 2) % 3]] - mesh.positions[vertex];
    sum += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  return sum;
}

/// Vertices at one place count once. Where edges have three faces or more there is no theorem; the numbers
/// are given all the same.
CurvatureStatistics curvature_statistics(const UnitMesh& mesh, const VertexCurvatures& curvatures) {
  CurvatureStatistics statistics;
  GaussBonnet& gauss_bonnet = statistics.gauss_bonnet;
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (mesh.neighbours.vertex_faces.row(vertex).empty()) continue;
    const double k_max = curvatures.k_max_per_m[vertex], k_min = curvatures.k_min_per_m[vertex];
    const double area_m2 = curvatures.area_m2[vertex];
    grow(statistics.k_max_per_m, k_max, area_m2, statistics.vertices == 0);
    grow(statistics.k_min_per_m, k_min, area_m2, statistics.vertices == 0);
    ++statistics.vertices;
    statistics.area_m2 += area_m2;
    gauss_bonnet.integral += k_max * k_min * area_m2;
    gauss_bonnet.absolute += std::abs(k_max * k_min) * area_m2;
    if (mesh.on_border[vertex] == 0) continue;
    ++statistics.border_vertices;
    gauss_bonnet.border_turning += std::numbers::pi - angle_around(mesh, vertex);
  }
  for (ValueRange* range : {&statistics.k_max_per_m, &statistics.k_min_per_m}) {
    range->mean = statistics.area_m2 > 0.0 ? range->mean / statistics.area_m2 : 0.0;
  }
  for (std::size_t edge = 0; edge < mesh.neighbours.edge_faces.rows(); ++edge) {
    if (mesh.neighbours.edge_faces.row(edge).size() > 2) statistics.is_manifold = false;
  }
  constexpr double turn = 2.0 * std::numbers::pi;
  gauss_bonnet.expected = turn * static_cast<double>(euler_characteristic(mesh.neighbours));
  gauss_bonnet.difference_share =
      (gauss_bonnet.integral + gauss_bonnet.border_turning - gauss_bonnet.expected) /
      std::max(gauss_bonnet.absolute, turn);
  return statistics;
}

using Json = nlohmann::ordered_json;

struct CurvatureSettings {
  CurvatureOptions curvature;
  std::optional<CurvatureColour> colour;
};

struct CurvatureArguments {
  std::string input, output;
  SettingOptions<CurvatureSettings> settings;
  bool is_unsigned = false;
  bool stats = false;
  bool json = false;
  Trust trust = Trust::trusted;
  Existing existing = Existing::keep;
};

template <std::size_t count>
std::vector<std::string_view> names_in(const std::array<std::string_view, count>& names) {
  return {names.begin(), names.end()};
}

std::vector<scene::Row<CurvatureSettings>> curvature_rows() {
  using Options = CurvatureOptions;
  constexpr auto curvature = &CurvatureSettings::curvature;
  return {{scene::choice(scene::path(curvature, &Options::method), names_in(curvature_method_names)),
           {.key = "method", .help = "how to compute curvature; the list below describes each method"}},
          {scene::path(curvature, &Options::radius_edges),
           {.key = "radius_edges",
            .low = 0.01,
            .high = 100.0,
            .help = "radius of the ball around each vertex that is used, in mean edge lengths",
            .example = "3",
            .absent = "3.5 for fit, 6 to 14 if noisy; 3 for tensor, tensor-exact, paper"}},
          {scene::path(curvature, &Options::radius_m),
           {.key = "radius_m",
            .flag = "--radius-m,--radius",
            .unit = "m",
            .low = 1e-9,
            .high = 1e9,
            .help = "radius of the ball around each vertex that is used, in metres",
            .example = "0.05",
            .absent = "from --radius-edges"}},
          {scene::path(curvature, &Options::rounds),
           {.key = "rounds", .high = 1000.0, .help = "rounds of averaging (diffused)"}},
          {scene::choice_or("none", &CurvatureSettings::colour, names_in(curvature_colour_names)),
           {.key = "colour",
            .flag = "--colour,--color",
            .help = "curvature to show as vertex colours",
            .example = "mean"}},
          {scene::path(curvature, &Options::threads),
           {.key = "threads",
            .low = 1.0,
            .high = 4096.0,
            .help = "number of threads to use; it does not change the result",
            .example = "4",
            .absent = "all processors"}}};
}

/// Refuses a flag that the method ignores.
void require_unused(const char* flag, bool is_given, const char* methods, CurvatureMethod method) {
  if (!is_given) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected --method {}, got {}", flag, methods, name_of(method)),
              fmt::format("leave {} out, or choose that method", flag));
}

CurvatureSettings settings_of(const CurvatureArguments& arguments) {
  CurvatureSettings settings = arguments.settings.read();
  CurvatureOptions& options = settings.curvature;
  const CurvatureMethod method = options.method;
  const bool is_ball = method == CurvatureMethod::fit || method == CurvatureMethod::tensor ||
                       method == CurvatureMethod::tensor_exact || method == CurvatureMethod::paper;
  const char* balls = "fit, tensor, tensor-exact or paper";
  require_unused("--radius-edges", !is_ball && arguments.settings.is_given("--radius-edges"), balls, method);
  require_unused("--radius-m", !is_ball && arguments.settings.is_given("--radius-m"), balls, method);
  require_unused("--rounds", method != CurvatureMethod::diffused && arguments.settings.is_given("--rounds"),
                 "diffused", method);
  require_unused("--unsigned", method != CurvatureMethod::paper && arguments.is_unsigned, "paper", method);
  if (arguments.is_unsigned) options.angles = EdgeAngles::unsigned_as_printed;
  return settings;
}

Json to_json(const ValueRange& range) {
  return {{"min", range.least}, {"mean", range.mean}, {"max", range.largest}};
}

Json to_json(const CurvatureStatistics& statistics) {
  const GaussBonnet& check = statistics.gauss_bonnet;
  return {{"k_max_per_m", to_json(statistics.k_max_per_m)},
          {"k_min_per_m", to_json(statistics.k_min_per_m)},
          {"area_m2", statistics.area_m2},
          {"border_vertices", statistics.border_vertices},
          {"is_manifold", statistics.is_manifold},
          {"gauss_bonnet",
           {{"integral", check.integral},
            {"absolute_integral", check.absolute},
            {"border_turning", check.border_turning},
            {"expected", check.expected},
            {"difference_share", check.difference_share}}}};
}

std::string text_of(const CurvatureStatistics& statistics) {
  const auto range = [](const char* name, const ValueRange& values) {
    return fmt::format("  {}  {:.6g} ... {:.6g} 1/m, mean {:.6g}\n", name, values.least, values.largest,
                       values.mean);
  };
  const GaussBonnet& check = statistics.gauss_bonnet;
  const std::string_view remark =
      statistics.is_manifold ? "" : "  (some edges have three or more faces: there is no expected value)\n";
  return range("k_max", statistics.k_max_per_m) + range("k_min", statistics.k_min_per_m) +
         fmt::format(
             "  area   {:.6g} m2\n  Gauss-Bonnet  {:.6g} over the surface + {:.6g} along borders, expected "
             "{:.6g} "
             "({:+.2f} %)\n",
             statistics.area_m2, check.integral, check.border_turning, check.expected,
             100.0 * check.difference_share) +
         std::string(remark);
}

void run(const CurvatureArguments& arguments, const Options& program_options) {
  const CurvatureSettings settings = settings_of(arguments);
  const std::string_view method = name_of(settings.curvature.method);
  if (std::filesystem::path(arguments.output).extension() != ".ply") {
    throw bad_argument("--output", "a name that ends in .ply", arguments.output, "out.ply");
  }
  require_new(arguments.output, arguments.existing, {{arguments.input}, arguments.trust});

  PreparedMesh prepared{read_mesh(arguments.input, arguments.trust), {}};
  program_options.cancel.throw_if_cancelled();
  const UnitMesh unit = unit_mesh(prepared.mesh);
  program_options.cancel.throw_if_cancelled();
  const auto start = std::chrono::steady_clock::now();
  CurvatureResult result = vertex_curvatures(unit, settings.curvature);
  const std::chrono::duration<double, std::micro> taken_us = std::chrono::steady_clock::now() - start;
  program_options.cancel.throw_if_cancelled();
  prepared.mesh.normals = std::move(result.normals);
  prepared.curvatures = std::move(result.curvatures);

  VertexAttributes attributes;
  attributes.comments.push_back(fmt::format("curvature method {}", method));
  ColouredVertices coloured;
  if (settings.colour) {
    coloured = colour_vertices(prepared.curvatures, *settings.colour);
    attributes.colours = coloured.colours;
    attributes.comments.push_back(
        fmt::format("colour {}, full at {:.6g}",
                    curvature_colour_names[static_cast<std::size_t>(*settings.colour)], coloured.limit));
  }
  write_prepared(arguments.output, prepared, attributes, arguments.existing);

  const CurvatureStatistics statistics = curvature_statistics(unit, prepared.curvatures);
  const double us_a_vertex =
      taken_us.count() / static_cast<double>(std::max<std::size_t>(1, unit.vertex_count()));
  if (arguments.json) {
    Json json{{"file", arguments.output},
              {"method", method},
              {"vertices", unit.vertex_count()},
              {"faces", prepared.mesh.faces.size()},
              {"mean_edge_m", unit.mean_edge * unit.scale_m},
              {"us_per_vertex", us_a_vertex}};
    if (settings.colour) json["colour_limit"] = coloured.limit;
    json.update(to_json(statistics));
    print_json(json);
    return;
  }
  print_summary("{}: {} vertices, {} faces, {}, {:.2f} us per vertex\n", one_line(arguments.output),
                unit.vertex_count(), prepared.mesh.faces.size(), method, us_a_vertex);
  if (arguments.stats) fmt::print("{}", text_of(statistics));
}

}  // namespace

void add_curvature_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<CurvatureArguments>();
  CLI::App* command = program.add_subcommand(
      "curvature", "compute the curvature of a mesh at its vertices, which highlights use");
  command->add_option("FILE", arguments->input, "mesh: .obj, .ply, .off, .stl, .gltf, .glb")->required();
  command->add_option("-o,--output", arguments->output, "PLY file to write, with curvatures")
      ->required()
      ->type_name("OUT.ply");
  arguments->settings.add_to(*command, curvature_rows());
  command->get_option("--radius-m")->excludes(command->get_option("--radius-edges"));
  command->add_flag("--unsigned", arguments->is_unsigned,
                    "take edge angles without a sign, as in the published formula (paper)");
  command->add_flag("--stats", arguments->stats, "print ranges of curvature and the Gauss-Bonnet check");
  command->add_flag("--json", arguments->json,
                    "print the results as JSON: ranges, Gauss-Bonnet check and timing");
  add_force_flag(*command, arguments->existing);
  add_trust_flag(*command, arguments->trust);
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
The PLY keeps the order of the vertices. Vertices at exactly the same position count as one. For each
vertex it has: normal; k_max and k_min in 1/m, positive where the surface is convex (a ball of radius r has
1/r); their directions e_max and e_min, where e_max x e_min is the normal; area in m2; confidence.
Confidence, from 0 to 1, says how far to trust the directions: 0 where the curvature is the same in all
directions, halved on borders.

  fit           fits a quadric to the vertices within a ball; the most accurate
  tensor        sums edge angles within a ball; edges on its rim count half
  tensor-exact  the same, with edges clipped to the ball; slower
  diffused      takes angles of the edges around each vertex, averaged with neighbours; the fastest
  paper         follows the published formula, for comparison; about 8 % too large however fine the mesh
  jet           fits a quadratic by CGAL; accurate on clean meshes, not on noisy ones

Examples:
  offing-mesh curvature knot.obj -o knot.ply
  offing-mesh curvature scan.ply --method diffused --rounds 10 --colour mean -o smooth.ply
  offing-mesh curvature scan.ply --radius-m 0.02 --stats -o scan_curvature.ply)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
