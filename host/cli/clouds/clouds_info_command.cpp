#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/cli/clouds/cloud_frame.h"
#include "host/cli/clouds/clouds_commands.h"
#include "host/cli/common/device_choice.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/clouds/shape/genera.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/print_results.h"
#include "host/io/file_extension.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_clouds.h"

namespace offing::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  std::string file, grid = "density";
  bool json = false;
  Trust trust = Trust::trusted;
};

struct Box {
  glm::dvec3 low_m{std::numeric_limits<double>::infinity()}, high_m{-std::numeric_limits<double>::infinity()};

  void take(const glm::dvec3& middle_m, double radius_m) {
    low_m = glm::min(low_m, middle_m - radius_m);
    high_m = glm::max(high_m, middle_m + radius_m);
  }
};

Json json_of(const glm::dvec3& place_m) {
  return {place_m.x, place_m.y, place_m.z};
}

Json volume_facts(const InfoArguments& arguments) {
  const VdbCloud cloud = read_vdb(arguments.file, arguments.grid);
  const CloudVolume& volume = cloud.volume;
  const glm::dvec3 size_m = glm::dvec3(volume.bricks[0], volume.bricks[1], volume.bricks[2]) *
                            (CloudVolume::brick_cells * volume.cell_m);
  const auto has_density = [](float value) { return value > 0.0f; };
  return {{"kind", "volume"},
          {"grid", arguments.grid},
          {"low_m", json_of(volume.origin_m)},
          {"high_m", json_of(volume.origin_m + size_m)},
          {"cell_m", volume.cell_m},
          {"bricks", volume.density.size() / CloudVolume::cells_of_brick},
          {"cells", std::count_if(volume.density.begin(), volume.density.end(), has_density)},
          {"density_sum", std::accumulate(volume.density.begin(), volume.density.end(), 0.0)},
          {"density_max", *std::max_element(volume.density.begin(), volume.density.end())},
          {"extinction_per_m", volume.extinction_per_m},
          {"tells_extinction", cloud.tells_extinction},
          {"optical_mass_m2", clouds::optical_mass(volume)},
          {"has_colour", !cloud.albedo.empty()}};
}

Json particle_facts(const InfoArguments& arguments) {
  const ParticleCloud cloud = read_cloud_particles(arguments.file);
  Box box;
  std::set<std::uint32_t> clouds;
  double optical_mass_m2 = 0.0;
  float least_m = std::numeric_limits<float>::infinity(), most_m = 0.0f;
  for (const CloudParticle& particle : cloud.particles) {
    box.take(cloud.origin_m + glm::dvec3(particle.x, particle.y, particle.z), particle.radius);
    clouds.insert(particle.cloud);
    optical_mass_m2 += particle.optical_mass;
    least_m = std::min(least_m, particle.radius);
    most_m = std::max(most_m, particle.radius);
  }
  return {{"kind", "particles"},     {"low_m", json_of(box.low_m)},         {"high_m", json_of(box.high_m)},
          {"clouds", clouds.size()}, {"particles", cloud.particles.size()}, {"radius_min_m", least_m},
          {"radius_max_m", most_m},  {"optical_mass_m2", optical_mass_m2}};
}

Json scene_facts(const InfoArguments& arguments, const GlobalOptions& options) {
  const scene::Scene scene = scene::load_scene(arguments.file, arguments.trust);
  const std::optional<world::CloudSkyParameters> sky = scene::prepare_clouds(scene);
  Json list = Json::array();
  std::size_t particles = 0;
  if (sky) {
    const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
    CloudFrames frames(device, *sky, options.cancel);
    const ParticleCloud all = frames.particles_at(scene.time.start_s);
    std::vector<std::size_t> counts(sky->clouds.size());
    std::vector<Box> boxes(sky->clouds.size());
    for (const CloudParticle& particle : all.particles) {
      ++counts[particle.cloud];
      boxes[particle.cloud].take(all.origin_m + glm::dvec3(particle.x, particle.y, particle.z),
                                 particle.radius);
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      // Those of layers come after the scene's own, and have no names.
      Json cloud = {{"name", i < scene.clouds.size() ? scene.clouds[i].name : ""},
                    {"genus", clouds::range_of(sky->clouds[i].genus).name},
                    {"particles", counts[i]}};
      if (counts[i] > 0) {
        cloud["low_m"] = json_of(boxes[i].low_m);
        cloud["high_m"] = json_of(boxes[i].high_m);
      }
      list.push_back(std::move(cloud));
    }
    particles = all.particles.size();
  }
  return {{"kind", "scene"}, {"particles", particles}, {"clouds", list}};
}

void tell(const InfoArguments& arguments, const Json& facts) {
  if (arguments.json) {
    print_json(facts);
    return;
  }
  fmt::print("{}\n", one_line(arguments.file));
  for (const auto& [name, value] : facts.items()) {
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      fmt::print("  {:<18} {}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
      continue;
    }
    for (const Json& cloud : value) {
      const std::string given = one_line(cloud["name"].get<std::string>());
      fmt::print("  {:<18} {} particles{}\n", cloud["genus"].get<std::string>(),
                 cloud["particles"].get<std::size_t>(), given.empty() ? "" : fmt::format(", \"{}\"", given));
    }
  }
}

void run(const InfoArguments& arguments, const GlobalOptions& options) {
  require_extension(arguments.file, {".toml", ".vdb", ".ply"});
  if (arguments.file.ends_with(".vdb")) {
    tell(arguments, volume_facts(arguments));
  } else if (arguments.file.ends_with(".ply")) {
    tell(arguments, particle_facts(arguments));
  } else {
    tell(arguments, scene_facts(arguments, options));
  }
}

}  // namespace

void add_clouds_info_command(CLI::App& parent, GlobalOptions& options) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command =
      parent.add_subcommand("info", "print facts about a volume, particles or the clouds of a scene");
  command->add_option("FILE", arguments->file, "volume (.vdb), particles (.ply) or scene (.toml)")
      ->transform(find_scene)
      ->required();
  command->add_option("--grid", arguments->grid, "grid of the .vdb to read (default: density)")
      ->type_name("NAME");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
Examples:
  offing clouds info cumulus.vdb --json
  offing clouds info scenes/sky.toml)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
