#include "host/cli/highlights/highlights_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/highlights/highlight_recorder.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/prepare/scene_frames.h"

namespace offing::cli {
namespace {

struct HighlightsArguments {
  std::string scene, output, frames, frames_per_second;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

/// Pictures and meshes as a file in that folder names them.
void name_from(const std::filesystem::path& folder, animations::HighlightAnimation& animation) {
  const auto rename = [&](std::string& file) {
    if (file.empty()) return;
    std::error_code failure;
    const std::filesystem::path name = std::filesystem::relative(file, folder, failure);
    if (!failure && !name.empty()) file = name.generic_string();
  };
  for (animations::AnimatedTexture& texture : animation.textures) rename(texture.file);
  for (animations::AnimatedMesh& mesh : animation.meshes) rename(mesh.file);
}

struct Counts {
  std::size_t highlights = 0;  ///< different ones, of all meshes
  std::size_t most = 0;        ///< projectors of one frame
};

Counts counts_of(const animations::HighlightAnimation& animation) {
  Counts counts;
  std::set<std::tuple<std::size_t, std::uint64_t>> names;
  std::vector<std::size_t> per_frame;
  for (std::size_t mesh = 0; mesh < animation.meshes.size(); ++mesh) {
    const std::vector<animations::MeshFrame>& frames = animation.meshes[mesh].frames;
    per_frame.resize(frames.size(), 0);
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
      per_frame[frame] += frames[frame].projectors.size();
      for (const animations::ProjectorSample& sample : frames[frame].projectors)
        names.insert({mesh, sample.id});
    }
  }
  counts.highlights = names.size();
  for (const std::size_t count : per_frame) counts.most = std::max(counts.most, count);
  return counts;
}

void run(const HighlightsArguments& arguments, const GlobalOptions& options) {
  const std::filesystem::path output = arguments.output;
  animations::require_animation_name(output);
  scene::Scene scene = scene::load_scene(arguments.scene, arguments.trust);
  GivenInputs inputs{scene::files_of(scene), arguments.trust};
  inputs.names.push_back(arguments.scene);
  require_new(arguments.output, arguments.existing, inputs);
  if (!arguments.frames_per_second.empty())
    scene.frames_per_second = read_number("--fps", arguments.frames_per_second, "frames/s", 0.001, 1e6, "30");
  const FrameRange frames = arguments.frames.empty()
                                ? scene::frames_in_time_span(scene, scene.frames_per_second)
                                : read_frame_range("--frames", arguments.frames);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  animations::HighlightAnimation animation = [&] {
    Progress progress(frames.last - frames.first + 1, "frames", options.verbosity);
    return record_highlights(device, scene, frames, progress, options.cancel);
  }();
  name_from(std::filesystem::absolute(output).parent_path(), animation);
  animations::write_highlights(output, animation, arguments.existing);
  const Counts counts = counts_of(animation);
  const int frame_count = frames.last - frames.first + 1;
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"frames", frame_count},
                {"frames_per_s", animation.frames_per_s},
                {"meshes", animation.meshes.size()},
                {"highlights", counts.highlights},
                {"most_in_a_frame", counts.most},
                {"bytes", std::filesystem::file_size(output)}});
  } else {
    print_summary("{}: {} frame{}, {} highlight{} on {} mesh{}, up to {} projectors at once\n",
                  one_line(arguments.output), frame_count, frame_count == 1 ? "" : "s", counts.highlights,
                  counts.highlights == 1 ? "" : "s", animation.meshes.size(),
                  animation.meshes.size() == 1 ? "" : "es", counts.most);
  }
}

}  // namespace

void add_highlights_command(CLI::App& app, GlobalOptions& options) {
  const auto arguments = std::make_shared<HighlightsArguments>();
  CLI::App* command =
      app.add_subcommand("highlights", "the moving highlights of a scene's meshes, for other programs");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[mesh]]")->required();
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group("Output");
  };
  add("-o,--output", arguments->output, "FILE",
      "of .json: every number, in the world's axes; of .glb or .gltf: a node a projector, for engines")
      ->required();
  add("--frames", arguments->frames, "A:B",
      "frames to write, A to B or A alone; time = frame / fps (default: the scene's)");
  add("--fps", arguments->frames_per_second, "F", "frames a second (default: the scene's)");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "a summary for scripts");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
A projector is a box that casts its texture along -normal onto the faces of its mesh: -1 ... 1 along right and
up over its width and height, transparent beyond. In glTF its node's +x, +y, +z are right, up and normal, and
the node's scale is the box; a scale of 0 is no highlight.

Examples:
  offing highlights scenes/knot.toml -o knot.json --frames 0:47 --fps 24
  offing highlights scenes/knot.toml -o knot.glb)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
