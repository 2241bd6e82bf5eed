#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/bodies/hull.h"
#include "host/cli/bodies/bodies_commands.h"
#include "host/cli/bodies/linear_body.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/scene_file.h"

namespace offing::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  std::string scene;
  bool json = false;
  Trust trust = Trust::trusted;
};

Json json_of(const glm::dvec3& place_m) {
  return {place_m.x, place_m.y, place_m.z};
}

Json period_of(double period_s) {
  return period_s > 0.0 ? Json(period_s) : Json(nullptr);
}

/// The box of what is below the water.
bodies::Extent wetted_extent(const LinearBody& body) {
  bodies::Extent extent = bodies::extent_of(body.body.hull);
  extent.high_m.y = body.level_m;
  return extent;
}

Json facts_of(const LinearBody& linear) {
  const bodies::FloatingBody& body = linear.body;
  const bodies::Submerged& below = linear.below;
  const HydrodynamicData& data = *linear.data;
  const bodies::Extent extent = wetted_extent(linear);
  const double metacentre_above_m = below.centre_m.y - body.mass_centre_m.y;
  const bodies::NaturalPeriods periods = bodies::natural_periods(data, linear.mass, linear.restoring);
  Json infinite = Json::object();
  for (std::size_t i = 0; i < hull_motions; ++i)
    infinite[motion_names[i]] = data.added_mass_at_infinity[7 * motion_places[i]];
  constexpr double turn = 2.0 * std::numbers::pi, degree = turn / 360.0;
  return {{"name", body.name},
          {"mass_kg", body.mass_kg},
          {"displaced_m3", below.volume_m3},
          {"length_m", extent.high_m.x - extent.low_m.x},
          {"breadth_m", extent.high_m.z - extent.low_m.z},
          {"draught_m", extent.high_m.y - extent.low_m.y},
          {"water_level_m", linear.level_m},
          {"mass_centre_m", json_of(body.mass_centre_m)},
          {"buoyancy_centre_m", json_of(below.centre_m)},
          {"water_plane_m2", below.plane_m2},
          {"gm_roll_m", below.plane_zz_m4 / below.volume_m3 + metacentre_above_m},
          {"gm_pitch_m", below.plane_xx_m4 / below.volume_m3 + metacentre_above_m},
          {"heave_period_s", period_of(periods.heave_s)},
          {"roll_period_s", period_of(periods.roll_s)},
          {"pitch_period_s", period_of(periods.pitch_s)},
          {"hydrodynamics",
           {{"source", data.source},
            {"about_m", json_of(data.about_m)},
            {"frequencies", data.frequencies_radps.size()},
            {"longest_period_s", turn / data.frequencies_radps.front()},
            {"shortest_period_s", turn / data.frequencies_radps.back()},
            {"directions", data.directions_rad.size()},
            {"first_direction_deg", data.directions_rad.front() / degree},
            {"last_direction_deg", data.directions_rad.back() / degree},
            {"added_mass_at_infinity", infinite}}}};
}

std::string seconds(const Json& period) {
  return period.is_null() ? "none" : fmt::format("{:.2f} s", period.get<double>());
}

void print_facts(const Json& facts) {
  const auto number = [&](const char* key) { return facts[key].get<double>(); };
  const Json& data = facts["hydrodynamics"];
  fmt::print("{}\n", one_line(facts["name"].get<std::string>()));
  fmt::print("  mass                {:.6g} kg, displaces {:.6g} m3\n", number("mass_kg"),
             number("displaced_m3"));
  fmt::print("  below the water     {:.4g} m long, {:.4g} m wide, {:.4g} m deep\n", number("length_m"),
             number("breadth_m"), number("draught_m"));
  fmt::print("  metacentric height  {:.3f} m in roll, {:.3f} m in pitch\n", number("gm_roll_m"),
             number("gm_pitch_m"));
  fmt::print("  natural periods     heave {}, roll {}, pitch {}\n", seconds(facts["heave_period_s"]),
             seconds(facts["roll_period_s"]), seconds(facts["pitch_period_s"]));
  fmt::print("  hydrodynamics       {}: {} periods from {:.3g} to {:.3g} s, {} directions\n",
             one_line(data["source"].get<std::string>()), data["frequencies"].get<std::size_t>(),
             data["shortest_period_s"].get<double>(), data["longest_period_s"].get<double>(),
             data["directions"].get<std::size_t>());
}

void run(const InfoArguments& arguments) {
  Json list = Json::array();
  for (const LinearBody& body : linear_bodies(scene::load_scene(arguments.scene, arguments.trust)))
    list.push_back(facts_of(body));
  if (arguments.json) {
    print_json({{"bodies", list}});
    return;
  }
  for (const Json& facts : list) print_facts(facts);
}

}  // namespace

void add_bodies_info_command(CLI::App& parent, GlobalOptions& options) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command =
      parent.add_subcommand("info", "print displacement, stability, natural periods and hydrodynamic data");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[body]]")
      ->transform(find_scene)
      ->required();
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
Places are in the axes of the hull: forward, up, to starboard. Natural periods are without damping.
Hydrodynamic data come from body.hydrodynamics, else from a panel method. A body with a negative metacentric
height capsizes.

Example:
  offing bodies info scenes/afloat.toml --json)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
