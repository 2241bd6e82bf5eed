#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/clouds/cloud_frame.h"
#include "host/cli/clouds/clouds_commands.h"
#include "host/cli/common/device_choice.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/command_line/frame_flags.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/io/frame_name.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/schema/unused_parameters.h"

namespace offing::cli {
namespace {

struct BuildSettings {
  std::optional<double> cell_m;  ///< none: usual_cell_m()
  std::optional<double> time_s;  ///< none: the scene's start
};

struct BuildArguments {
  std::string scene, output;
  SettingOptions<BuildSettings> settings;
  FrameFlags frames;
  bool half = false;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

/// A file to write and the time that it shows.
struct TimedFile {
  std::string name;
  double time_s = 0.0;
};

bool is_sequence(const BuildArguments& arguments) {
  return arguments.output.find('%') != std::string::npos;
}

std::vector<scene::Row<BuildSettings>> cell_rows() {
  return {{&BuildSettings::cell_m,
           {.key = "cell_m",
            .unit = "m",
            .low = least_cell_m,
            .high = largest_cell_m,
            .help = "edge length of the volume's cells",
            .example = "20",
            .absent = "128 cells along the longest side"}}};
}

FrameName frame_name(const BuildArguments& arguments) {
  return {"-o", arguments.output, "cloud.%04d.vdb"};
}

std::vector<TimedFile> files_of(const BuildArguments& arguments, const scene::Scene& scene) {
  if (!is_sequence(arguments)) {
    if (arguments.frames.has_frames() || arguments.frames.has_fps()) {
      throw Error(ErrorKind::bad_usage,
                  "--frames: expected a name with a place for the frame's number, found none",
                  "write -o cloud.%04d.vdb");
    }
    return {{arguments.output, arguments.settings.read().time_s.value_or(scene.time.start_s)}};
  }
  if (arguments.settings.is_given("--time")) {
    throw Error(ErrorKind::bad_usage, "--time: expected one file, found a name for many", "use --frames");
  }
  const FrameName name = frame_name(arguments);
  const FrameRange frames = arguments.frames.frames(scene);
  std::vector<TimedFile> files;
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    files.push_back({name.of(frame).string(), frame / scene.time.frames_per_second});
  }
  return files;
}

void require_outputs(const BuildArguments& arguments, const scene::Scene& scene) {
  GivenInputs inputs{scene::files_of(scene), arguments.trust};
  inputs.names.push_back(arguments.scene);
  if (is_sequence(arguments)) {
    require_new_frames(frame_name(arguments), arguments.frames.frames(scene), arguments.existing, inputs);
  } else {
    require_new(arguments.output, arguments.existing, inputs);
  }
}

bool is_volume(const BuildArguments& arguments) {
  return arguments.output.ends_with(".vdb");
}

/// What is told of the last file.
nlohmann::ordered_json facts_of(const VdbCloud& cloud) {
  const std::vector<float>& density = cloud.volume.density;
  return {{"cell_m", cloud.volume.cell_m},
          {"bricks", density.size() / CloudVolume::cells_of_brick},
          {"density_sum", std::accumulate(density.begin(), density.end(), 0.0)},
          {"extinction_per_m", cloud.volume.extinction_per_m},
          {"optical_mass_m2", clouds::optical_mass(cloud.volume)}};
}

nlohmann::ordered_json facts_of(const ParticleCloud& cloud) {
  double optical_mass_m2 = 0.0;
  for (const CloudParticle& particle : cloud.particles) optical_mass_m2 += particle.optical_mass;
  return {{"particles", cloud.particles.size()}, {"optical_mass_m2", optical_mass_m2}};
}

/// Files of nothing cannot be read.
void require_some(std::size_t count, const TimedFile& file) {
  if (count > 0) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected density at {:g} s, found none", one_line(file.name), file.time_s),
              "give balls a weight and a size, or choose a time at which there is cloud");
}

nlohmann::ordered_json write_frame(const BuildArguments& arguments, CloudFrames& frames,
                                   const TimedFile& file, std::optional<double>& cell_m) {
  if (!is_volume(arguments)) {
    const ParticleCloud cloud = frames.particles_at(file.time_s);
    require_some(cloud.particles.size(), file);
    write_cloud_particles(file.name, cloud, arguments.existing);
    return facts_of(cloud);
  }
  if (!cell_m) cell_m = usual_cell_m(frames.particles_at(file.time_s));
  const VdbCloud cloud = frames.volume_at(file.time_s, *cell_m);
  require_some(cloud.volume.density.size(), file);
  write_vdb(file.name, cloud, arguments.half ? VdbPrecision::half : VdbPrecision::single, arguments.existing);
  return facts_of(cloud);
}

void tell(const BuildArguments& arguments, const std::vector<TimedFile>& files, std::size_t clouds,
          const nlohmann::ordered_json& facts) {
  std::uintmax_t bytes = 0;
  for (const TimedFile& file : files) bytes += std::filesystem::file_size(file.name);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"file", arguments.output}, {"frames", files.size()}, {"clouds", clouds}};
    json.update(facts);
    json["bytes"] = bytes;
    print_json(json);
    return;
  }
  const std::string content =
      is_volume(arguments) ? fmt::format("{} bricks of cells of {:g} m", facts["bricks"].get<std::size_t>(),
                                         facts["cell_m"].get<double>())
                           : fmt::format("{} particles", facts["particles"].get<std::size_t>());
  print_summary("{}: {} file{}, {} cloud{}, {}, {} bytes\n", one_line(arguments.output), files.size(),
                files.size() == 1 ? "" : "s", clouds, clouds == 1 ? "" : "s", content, bytes);
}

void run(const BuildArguments& arguments, const GlobalOptions& options) {
  require_extension(arguments.output, {".vdb", ".ply"});
  if (!is_volume(arguments) && (arguments.half || arguments.settings.is_given("--cell-m"))) {
    throw Error(ErrorKind::bad_usage, "--half, --cell-m: expected a .vdb, found particles", "leave them out");
  }
  std::optional<double> cell_m = arguments.settings.read().cell_m;
  scene::Scene scene = scene::load_scene(arguments.scene, arguments.trust);
  scene.time = arguments.frames.times(scene);
  const std::vector<TimedFile> files = files_of(arguments, scene);
  require_outputs(arguments, scene);
  for (const std::string& line : scene::unused_cloud_parameters(scene)) spdlog::warn("{}", line);
  const std::optional<world::CloudSkyParameters> sky = scene::prepare_clouds(scene);
  if (!sky) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected clouds, found none", one_line(arguments.scene)),
                "add a [[cloud]] section to the scene");
  }
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  CloudFrames frames(device, *sky, options.cancel);
  nlohmann::ordered_json facts;
  {
    Progress progress(static_cast<int>(files.size()), "frames", options.verbosity);
    for (const TimedFile& file : files) {
      options.cancel.throw_if_cancelled(
          "run the same command again with --force, which replaces the files that are done");
      facts = write_frame(arguments, frames, file, cell_m);
      progress.advance();
    }
  }
  tell(arguments, files, sky->clouds.size(), facts);
}

}  // namespace

void add_clouds_build_command(CLI::App& parent, GlobalOptions& options) {
  const auto arguments = std::make_shared<BuildArguments>();
  CLI::App* command =
      parent.add_subcommand("build", "export the clouds of a scene as a volume or as particles");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[cloud]] or [[cloud_layer]]")
      ->transform(find_scene)
      ->required();
  constexpr const char* group = "Output";
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  add("-o,--output", arguments->output, "FILE",
      "file to write. .vdb: density as a fog volume, in world metres, +y up; .ply: particles; "
      "cloud.%04d.vdb: one file per frame")
      ->required();
  arguments->settings.add_to(*command, cell_rows(), group);
  command->add_flag("--half", arguments->half, "write 16-bit values (default: 32-bit)")->group(group);
  arguments->settings.add_to(
      *command, {{&BuildSettings::time_s, time_facts("time of the clouds", "the scene's start")}}, group);
  arguments->frames.add_frames_to(*command, group);
  arguments->frames.add_fps_to(*command, group);
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the summary as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
Examples:
  offing clouds build scenes/cumulus.toml -o cumulus.vdb --cell-m 10 --half
  offing clouds build scenes/cumulus.toml -o cumulus.ply
  offing clouds build scenes/sky.toml -o sky.%04d.vdb --frames 0:47 --fps 24)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
