// `offing scene import`: a scene of the meshes, the camera and the lights of a glTF.
#include <memory>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/cli/scene/scene_commands.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/meshes/read_mesh.h"
#include "host/scene/file/gltf_import.h"
#include "host/scene/file/scene_writer.h"

namespace offing::cli {

namespace {

struct ImportArguments {
  std::string file, output;
  scene::GltfChoice choice;
  SettingOptions<scene::GltfChoice> choice_flags;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

std::string number_of(std::size_t count, const char* what) {
  if (count == 0) return fmt::format("no {}s", what);
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void run(const ImportArguments& arguments) {
  const scene::GltfChoice choice = arguments.choice_flags.read(arguments.choice);
  require_new(arguments.output, arguments.existing, {{arguments.file}, arguments.trust});
  const scene::ImportedScene imported = scene::import_gltf(arguments.file, choice, arguments.trust);
  warn_of_left_out(arguments.file, {.format = {}, .left_out = imported.left_out});
  scene::save_scene(imported.scene, arguments.output, arguments.existing);
  const scene::Scene& scene = imported.scene;
  print_summary("{}: {}, {}, {}, {} with keyframes, {:g} s\n", one_line(arguments.output),
                number_of(scene.meshes.size(), "mesh file"), number_of(scene.lights.size(), "light"),
                number_of(scene.bookmarks.size(), "bookmark"), number_of(scene.tracks.size(), "value"),
                scene.time.end_s);
}

}  // namespace

void add_import_command(CLI::App& scene, GlobalOptions& options) {
  const auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command =
      scene.add_subcommand("import", "make a scene of a glTF: meshes, camera, lights, animation");
  command->add_option("FILE", arguments->file, "glTF to read: .gltf, .glb")->required();
  constexpr const char* group = "Output";
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  add("-o,--output", arguments->output, "SCENE", "scene file to write (.toml)")->required();
  add("--camera", arguments->choice.camera, "NAME",
      "camera to use; default: the first. The others become bookmarks");
  arguments->choice_flags.add_to(
      *command,
      {{&scene::GltfChoice::animation, like_scene("mesh.animation", "--animation")},
       {&scene::GltfChoice::frames_per_s,
        like_scene("time.fps", "--fps", "frames per second of the scene and of its keyframes")}},
      group);
  add_force_flag(*command, arguments->existing);
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
The file becomes a mesh of the scene and deforms as its animation says. The camera and lights that move get
keyframes. If the file has lights, the sun is put below the horizon. Warnings list what a scene cannot have,
such as materials.

Example:
  offing scene import walk.glb -o walk.toml)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
