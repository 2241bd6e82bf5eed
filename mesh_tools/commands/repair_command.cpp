#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "mesh_tools/commands/mesh_commands.h"
#include "mesh_tools/commands/mesh_job.h"
#include "mesh_tools/defects_text.h"
#include "mesh_tools/mesh_defects.h"
#include "mesh_tools/repair.h"

namespace offing::mesh_tools {

namespace {

struct RepairArguments {
  MeshJob job;
  SettingOptions<RepairSettings> settings;
  bool outward = false;
};

/// Adds --fill-edges, which also takes `all`.
void add_fill_edges(CLI::App& command, SettingOptions<RepairSettings>& settings) {
  constexpr int most = 1'000'000'000;  // a loop of more would not fit into memory
  settings.add_to(command, {{&RepairSettings::most_hole_edges,
                             {.key = "fill_edges",
                              .high = most,
                              .help = "fill holes with up to this many edges; all: every hole"}}});
  command.get_option("--fill-edges")->transform([](const std::string& text) {
    return text == "all" ? std::to_string(most) : text;
  });
}

RepairSettings settings_of(const RepairArguments& arguments) {
  RepairSettings settings = arguments.settings.read();
  if (arguments.outward) settings.facing = Facing::outward;
  return settings;
}

struct NamedChange {
  const char* key;
  const char* label;
  std::size_t count;
};

std::vector<NamedChange> named(const RepairChanges& changes) {
  return {
      {"merged_vertices", "merged vertices", changes.merged_vertices},
      {"removed_repeating_faces", "removed faces that named a vertex twice", changes.removed_repeating_faces},
      {"removed_duplicate_faces", "removed duplicate faces", changes.removed_duplicate_faces},
      {"turned_faces", "turned faces", changes.turned_faces},
      {"split_vertices", "vertices added by splitting edges and fans", changes.split_vertices},
      {"removed_degenerate_faces", "removed faces without an area", changes.removed_degenerate_faces},
      {"collapsed_vertices", "vertices removed with these faces", changes.collapsed_vertices},
      {"filled_holes", "filled holes", changes.filled_holes},
      {"added_faces", "faces added in holes", changes.added_faces},
      {"open_loops", "boundary loops left open", changes.open_loops},
      {"removed_vertices", "removed vertices of no face", changes.removed_vertices}};
}

void run(const RepairArguments& arguments, const Options& options) {
  const RepairSettings settings = settings_of(arguments);
  arguments.job.require_output();
  TriangleMesh mesh = arguments.job.read();
  const MeshDefects before = find_defects(mesh, options.cancel);
  const RepairChanges changes = repair(mesh, settings, options.cancel);
  const MeshDefects after = find_defects(mesh, options.cancel);
  arguments.job.write(mesh);
  if (arguments.job.json) {
    nlohmann::ordered_json changed;
    for (const NamedChange& change : named(changes)) changed[change.key] = change.count;
    print_json({{"file", arguments.job.output},
                {"changed", std::move(changed)},
                {"before", to_json(before)},
                {"after", to_json(after)}});
    return;
  }
  print_summary("{}\n", arguments.job.told(mesh));
  bool has_changed = false;
  for (const NamedChange& change : named(changes)) {
    if (change.count == 0) continue;
    print_summary("  {:<46} {}\n", change.label, change.count);
    has_changed = true;
  }
  if (!has_changed) print_summary("  nothing to repair\n");
  for (const auto& [label, count] : {std::pair("faces without an area that remain", after.degenerate_faces),
                                     {"self-intersections that remain", after.self_intersections}}) {
    if (count > 0) print_summary("  {:<46} {}\n", label, count);
  }
}

}  // namespace

void add_repair_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<RepairArguments>();
  CLI::App* command = program.add_subcommand("repair", "turn any triangle mesh into an oriented manifold");
  arguments->job.add_to(*command);
  add_fill_edges(*command, arguments->settings);
  command->add_flag("--outward", arguments->outward, "turn closed components to face outward");
  add_verbosity_flags(*command, options.verbosity);
  command->footer(R"(
The steps of a repair, in order: Merge border vertices at exactly the same place, which closes seams.
Remove faces that name a vertex twice or repeat another face. Turn faces so that neighbours agree; most
faces of each component keep their side. Split edges of three or more faces and vertices of two or more
fans. Remove faces without an area. Fill small holes. Remove vertices that no face uses.

Other vertices keep their place and order. Normals are dropped. Self-intersections stay; `offing-mesh
check` counts them.

Examples:
  offing-mesh repair scan.obj -o scan.ply
  offing-mesh repair scan.obj -o scan.ply --fill-edges 200 --outward --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::mesh_tools
