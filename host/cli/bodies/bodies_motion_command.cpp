#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/base/utc_time.h"
#include "host/bodies/body_forces.h"
#include "host/cli/bodies/bodies_commands.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/ocean/query_settings.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/module.h"
#include "host/io/spectra/netcdf_module.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/file/version.h"
#include "host/scene/prepare/world_scene.h"

namespace offing::cli {
namespace {

using bodies::BodyPose;

constexpr double degree = std::numbers::pi / 180.0;
/// Half of what accelerations are taken over: a few sub-steps, a twentieth of the shortest motions of hulls.
constexpr double half_step_s = 4.0 / bodies::FloatingBodies::steps_per_s;

struct MotionArguments {
  std::string scene, times = "0:10:0.1", output;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

/// A body at one time.
struct MotionSample {
  const bodies::FloatingBody* body;
  BodyPose pose, before, after;  ///< half_step_s apart
  BodyReport report;

  glm::dvec3 origin_m() const { return bodies::FloatingBodies::world_point(*body, pose, glm::dvec3(0.0)); }
  glm::dvec3 acceleration_mps2() const {
    return (after.velocity_mps - before.velocity_mps) / (2.0 * half_step_s);
  }
  glm::dvec3 spin_rate_radps2() const { return (after.spin_radps - before.spin_radps) / (2.0 * half_step_s); }
  glm::dvec3 forward() const { return pose.turn * glm::dvec3(1.0, 0.0, 0.0); }
  /// Of its starboard side, below the level.
  double roll_rad() const {
    const glm::dvec3 up = pose.turn * glm::dvec3(0.0, 1.0, 0.0),
                     starboard = pose.turn * glm::dvec3(0.0, 0.0, 1.0);
    return std::atan2(-starboard.y, up.y);
  }
  double pitch_rad() const { return std::asin(std::clamp(forward().y, -1.0, 1.0)); }
};

struct MotionColumn {
  std::string name, unit, meaning;
  std::function<double(const MotionSample&)> value;
};

std::vector<MotionColumn> motion_columns() {
  return {{"x_m", "m", "mass centre, east", [](const MotionSample& s) { return s.pose.mass_centre_m.x; }},
          {"y_m", "m", "mass centre, up from the still water",
           [](const MotionSample& s) { return s.pose.mass_centre_m.y; }},
          {"z_m", "m", "mass centre, south", [](const MotionSample& s) { return s.pose.mass_centre_m.z; }},
          {"origin_x_m", "m", "origin of the hull's axes, east",
           [](const MotionSample& s) { return s.origin_m().x; }},
          {"origin_y_m", "m", "origin of the hull's axes, up",
           [](const MotionSample& s) { return s.origin_m().y; }},
          {"origin_z_m", "m", "origin of the hull's axes, south",
           [](const MotionSample& s) { return s.origin_m().z; }},
          {"turn_w", "1", "unit quaternion from the hull's axes to the world's, real part",
           [](const MotionSample& s) { return s.pose.turn.w; }},
          {"turn_x", "1", "the same, about x", [](const MotionSample& s) { return s.pose.turn.x; }},
          {"turn_y", "1", "the same, about y", [](const MotionSample& s) { return s.pose.turn.y; }},
          {"turn_z", "1", "the same, about z", [](const MotionSample& s) { return s.pose.turn.z; }},
          {"heading_deg", "degree", "direction of the bow, from east toward south",
           [](const MotionSample& s) { return bodies::heading_of(s.pose) / degree; }},
          {"pitch_deg", "degree", "of the bow, above the level",
           [](const MotionSample& s) { return s.pitch_rad() / degree; }},
          {"roll_deg", "degree", "of the starboard side, below the level",
           [](const MotionSample& s) { return s.roll_rad() / degree; }},
          {"velocity_x_mps", "m s-1", "of the mass centre, east",
           [](const MotionSample& s) { return s.pose.velocity_mps.x; }},
          {"velocity_y_mps", "m s-1", "of the mass centre, up",
           [](const MotionSample& s) { return s.pose.velocity_mps.y; }},
          {"velocity_z_mps", "m s-1", "of the mass centre, south",
           [](const MotionSample& s) { return s.pose.velocity_mps.z; }},
          {"spin_x_radps", "rad s-1", "about the hull's x, forward",
           [](const MotionSample& s) { return s.pose.spin_radps.x; }},
          {"spin_y_radps", "rad s-1", "about the hull's y, up",
           [](const MotionSample& s) { return s.pose.spin_radps.y; }},
          {"spin_z_radps", "rad s-1", "about the hull's z, to starboard",
           [](const MotionSample& s) { return s.pose.spin_radps.z; }},
          {"acceleration_x_mps2", "m s-2", "of the mass centre, east",
           [](const MotionSample& s) { return s.acceleration_mps2().x; }},
          {"acceleration_y_mps2", "m s-2", "of the mass centre, up",
           [](const MotionSample& s) { return s.acceleration_mps2().y; }},
          {"acceleration_z_mps2", "m s-2", "of the mass centre, south",
           [](const MotionSample& s) { return s.acceleration_mps2().z; }},
          {"spin_rate_x_radps2", "rad s-2", "about the hull's x",
           [](const MotionSample& s) { return s.spin_rate_radps2().x; }},
          {"spin_rate_y_radps2", "rad s-2", "about the hull's y",
           [](const MotionSample& s) { return s.spin_rate_radps2().y; }},
          {"spin_rate_z_radps2", "rad s-2", "about the hull's z",
           [](const MotionSample& s) { return s.spin_rate_radps2().z; }},
          {"displaced_m3", "m3", "of water", [](const MotionSample& s) { return s.pose.displaced_m3; }}};
}

/// Of each kind of forces, three of its force and three of its moment.
std::vector<MotionColumn> force_columns() {
  std::vector<MotionColumn> made;
  for (std::size_t kind = 0; kind < bodies::force_kinds.size(); ++kind) {
    for (std::size_t motion = 0; motion < BODY_MOTIONS; ++motion) {
      const bool is_force = motion < 3;
      const bodies::ForceKind& of = bodies::force_kinds[kind];
      const char axis = "xyz"[motion % 3];
      made.push_back(
          {is_force ? fmt::format("{}_{}_n", of.name, axis) : fmt::format("{}_moment_{}_nm", of.name, axis),
           is_force ? "N" : "N m",
           is_force ? fmt::format("force along {}: {}", axis, of.meaning)
                    : fmt::format("moment about {} at the mass centre: {}", axis, of.meaning),
           [at = BODY_MOTIONS * kind + motion](const MotionSample& s) {
             return static_cast<double>(s.report.forces[at]);
           }});
    }
  }
  return made;
}

const std::vector<MotionColumn>& columns() {
  static const std::vector<MotionColumn> all = [] {
    std::vector<MotionColumn> made = motion_columns();
    for (MotionColumn& column : force_columns()) made.push_back(std::move(column));
    return made;
  }();
  return all;
}

/// Where motions go: CSV in a file or on standard output, or NetCDF (time, body).
class MotionSink {
 public:
  MotionSink(const MotionArguments& arguments, const scene::Scene& scene,
             const std::vector<std::string>& names)
      : names_(names) {
    if (!arguments.output.empty() && !is_standard_output(arguments.output)) {
      file_.emplace(arguments.output, arguments.existing);
      if (lower_extension(arguments.output) == ".nc") {
        output_ = module_functions<spectra::NetcdfModule>("netcdf", "write NetCDF series")
                      .create(file_->temporary(), layout(scene), arguments.output);
        return;
      }
    }
    std::string header = "time_s,body";
    for (const MotionColumn& column : columns()) header += fmt::format(",{}", column.name);
    write(header + "\n");
  }

  void add(std::int64_t index, double time_s, const std::vector<MotionSample>& samples) {
    if (output_) {
      const auto at = static_cast<std::size_t>(index);
      const std::size_t one = 1, zero = 0;
      output_->put(0, {&at, 1}, {&one, 1}, {&time_s, 1});
      const std::array<std::size_t, 2> start{at, zero}, count{one, samples.size()};
      for (std::size_t column = 0; column < columns().size(); ++column) {
        std::vector<double> values;
        for (const MotionSample& sample : samples) values.push_back(columns()[column].value(sample));
        output_->put(column + 1, start, count, values);
      }
      return;
    }
    std::string text;
    for (std::size_t body = 0; body < samples.size(); ++body) {
      text += fmt::format("{:.10g},{}", time_s, names_[body]);
      for (const MotionColumn& column : columns())
        text += fmt::format(",{:.9g}", column.value(samples[body]));
      text += '\n';
    }
    write(text);
  }

  void finish() {
    if (output_) output_->close();
    if (file_) file_->commit();
  }

 private:
  void write(const std::string& text) {
    if (file_) {
      file_->write(text);
    } else {
      fmt::print("{}", text);
    }
  }

  spectra::NetcdfLayout layout(const scene::Scene& scene) const {
    using Layout = spectra::NetcdfLayout;
    Layout layout;
    layout.attributes = {{"Conventions", "CF-1.8"},
                         {"title", "Motions of floating bodies"},
                         {"source", fmt::format("Offing {}", scene::version())},
                         {"bodies", fmt::format("{}", fmt::join(names_, ","))},
                         {"comment",
                          "x points east, y up from the still water and z south; axes of hulls point "
                          "forward, up and to starboard"}};
    layout.dimensions = {{"time", 0}, {"body", names_.size()}};
    layout.variables.push_back(
        {"time",
         Layout::Type::float64,
         {0},
         {{"units",
           "seconds since " + iso_time(scene.view.sun_time_utc.value_or(from_unix_seconds(0))).value_or("")},
          {"calendar", "proleptic_gregorian"},
          {"standard_name", "time"},
          {"axis", "T"},
          {"long_name", "time of the scene"}}});
    for (const MotionColumn& column : columns()) {
      layout.variables.push_back({column.name,
                                  Layout::Type::float64,
                                  {0, 1},
                                  {{"units", column.unit}, {"long_name", column.meaning}}});
    }
    return layout;
  }

  std::vector<std::string> names_;
  std::optional<AtomicFile> file_;
  std::unique_ptr<spectra::NetcdfOutput> output_;
};

/// A world without what neither floats nor carries.
world::WorldParameters with_bodies_alone(world::WorldParameters parameters) {
  parameters.clouds.reset();
  parameters.wakes.clear();
  if (parameters.bodies.empty()) {
    throw Error(ErrorKind::bad_input, "bodies: expected a scene with a [[body]], found none",
                "add a [[body]] to the scene, such as that of scenes/afloat.toml");
  }
  return parameters;
}

void run(const MotionArguments& arguments, const GlobalOptions& options) {
  const TimeRange times = read_time_range("--times", arguments.times);
  scene::Scene scene = scene::load_scene(arguments.scene, arguments.trust);
  GivenInputs inputs{scene::files_of(scene), arguments.trust};
  inputs.names.push_back(arguments.scene);
  const std::string file = is_standard_output(arguments.output) ? "" : arguments.output;
  if (!file.empty()) require_extension(file, {".csv", ".nc"});
  require_new(file, arguments.existing, inputs);
  const world::WorldParameters parameters = with_bodies_alone(scene::prepare_shown_world(scene));
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  world::World world(device, parameters);
  world.keep_forces_on_bodies();
  world.set_sea_samples(16);  // bodies feel the whole sea still, and nobody looks at it
  std::vector<std::string> names;
  for (const world::BodySettings& settings : parameters.bodies) {
    names.push_back(one_line(settings.body.name));
    std::ranges::replace(names.back(), ',', ' ');
  }
  MotionSink sink(arguments, scene, names);
  Progress progress(static_cast<int>(times.count), "times",
                    file.empty() ? Verbosity::quiet : options.verbosity);
  for (std::int64_t i = 0; i < times.count; ++i) {
    options.cancel.throw_if_cancelled();
    const double time_s = times.time_s(i);
    scene::show_at(world, scene, time_s + half_step_s);
    std::vector<MotionSample> samples;
    for (std::size_t body = 0; body < names.size(); ++body) {
      samples.push_back({&parameters.bodies[body].body, world.bodies()->pose(body, time_s),
                         world.bodies()->pose(body, time_s - half_step_s),
                         world.bodies()->pose(body, time_s + half_step_s),
                         world.bodies()->forces(body, time_s)});
    }
    sink.add(i, time_s, samples);
    progress.advance();
  }
  sink.finish();
  if (file.empty()) return;
  if (arguments.json) {
    print_json({{"file", file}, {"times", times.count}, {"bodies", names}});
  } else {
    print_summary("{}: {} times of {} bod{}\n", one_line(file), times.count, names.size(),
                  names.size() == 1 ? "y" : "ies");
  }
}

}  // namespace

void add_bodies_motion_command(CLI::App& parent, GlobalOptions& options) {
  const auto arguments = std::make_shared<MotionArguments>();
  CLI::App* command = parent.add_subcommand(
      "motion", "simulate bodies and write their poses, velocities, accelerations and forces");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[body]]")
      ->transform(find_scene)
      ->required();
  command
      ->add_option("--times", arguments->times, "times from A to B in steps of DT, in s (default: 0:10:0.1)")
      ->type_name("A:B:DT")
      ->group("Output");
  command
      ->add_option("-o,--output", arguments->output,
                   "file to write, .csv or .nc (NetCDF); default: -, CSV to standard output")
      ->type_name("FILE")
      ->group("Output");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the summary of a file as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
x points east, y up and z south. To place a vertex of the hull, turn it by the unit quaternion turn_w, turn_x,
turn_y, turn_z, then add origin_x_m, origin_y_m, origin_z_m. Velocities and accelerations are of the mass
centre; spins are about the axes of the hull. heading_deg is from east toward south, pitch_deg lifts the bow,
roll_deg lowers the starboard side.
Forces, and moments about the mass centre, are along and about x, y and z. Each kind has its columns:
pressure, drag, radiation, excitation, propeller, rudder, gravity, wind and mooring.

Examples:
  offing bodies motion scenes/afloat.toml --times 0:60:0.1 -o motion.nc
  offing bodies motion ship.toml --times 0:4:0.5)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
