#include "host/cli/terrain/terrain_fly_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/pictures/terrain_render.h"
#include "host/cli/terrain/flight_comparison.h"
#include "host/cli/terrain/flight_path.h"
#include "host/cli/terrain/flight_recorder.h"
#include "host/cli/terrain/height_map_flags.h"
#include "host/cli/terrain/store_field.h"
#include "host/cli/terrain/terrain_camera.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"

namespace offing::cli {

namespace {

constexpr double radians = std::numbers::pi / 180.0;
constexpr double usual_latitude_deg = 46.0;

struct TerrainFlyArguments {
  std::string store, output, compared, size = "1280x720";
  std::string frames = "600", every = "12", speed = "300", rate = "30", height = "150";
  CacheFlags cache;
  HeightMapFlags map_flags;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

struct FlightSettings {
  int frames, every;
  double speed_mps, height_m, frames_a_second;
};

FlightSettings read_settings(const TerrainFlyArguments& arguments) {
  return {.frames = static_cast<int>(read_whole("--frames", arguments.frames, 1, 1'000'000, "600")),
          .every = static_cast<int>(read_whole("--every", arguments.every, 1, 1'000'000, "12")),
          .speed_mps = read_number("--speed-mps", arguments.speed, "m/s", 0.1, 1e5, "300"),
          .height_m = read_number("--height-m", arguments.height, "m", 1.0, 1e5, "150"),
          .frames_a_second = read_number("--fps", arguments.rate, "frames a second", 1.0, 1000.0, "30")};
}

std::vector<Camera> path_over(const terrain::TiledField& field, const FlightSettings& settings,
                              const std::string& size) {
  std::vector<Camera> cameras =
      flight_path({.width_m = field.map().width_m(),
                   .depth_m = field.map().depth_m(),
                   .step_m = settings.speed_mps / settings.frames_a_second,
                   .height_m = settings.height_m,
                   .frames = settings.frames,
                   .bound_m = [&](double x_m, double z_m) { return field.coarse_height_m(x_m, z_m); }});
  for (Camera& camera : cameras) {
    camera.vertical_field_of_view_rad = 60.0 * radians;
    read_image_size(size, camera);
  }
  return cameras;
}

/// What a flight came to.
struct FlightReport {
  FrameTimes times;
  double mean_tiles = 0.0, mean_stood_in = 0.0;
  int frames_stood_in = 0;  ///< in which coarser tiles stood in for some
  terrain::TiledField::Statistics tiles;
  std::size_t peak_bytes = 0;
  std::optional<FlightComparison::Result> comparison;
};

class Flying {
 public:
  Flying(const TerrainFlyArguments& arguments, const GlobalOptions& options)
      : arguments_(arguments),
        options_(options),
        settings_(read_settings(arguments)),
        store_(arguments.store, arguments.trust),
        device_(ocl::Device::open(choose_one_device(options.device))),
        field_(make_field(store_, device_, arguments.cache)),
        cameras_(path_over(field_, settings_, arguments.size)) {
    if (!arguments_.output.empty()) make_folder();
    if (!arguments_.compared.empty()) {
      HeightMapOptions reading = arguments_.map_flags.read();
      reading.trust.trust = arguments_.trust;
      const HeightMapFile file = read_height_map(arguments_.compared, reading);
      require_map_of_store(file.map);
      map_.emplace(make_field(file.map, device_));
      comparison_.emplace(*map_);
    }
  }

  FlightReport run() {
    FlightRecorder recorder(device_, cameras_.front(),
                            store_.header().centre_latitude_deg.value_or(usual_latitude_deg));
    // Kernels are compiled, and the flight begins with what it needs.
    field_.look_and_wait(cameras_.front());
    recorder.draw(field_, cameras_.front(), 0.0);
    FlightReport report;
    std::vector<double> seconds;
    Progress progress(settings_.frames, "frames", options_.verbosity);
    for (int frame = 0; frame < settings_.frames; ++frame) {
      options_.cancel.throw_if_cancelled();
      const Camera& camera = cameras_[static_cast<std::size_t>(frame)];
      seconds.push_back(recorder.draw(field_, camera, settings_.speed_mps));
      const terrain::TiledField::Statistics& tiles = field_.statistics();
      report.mean_tiles += static_cast<double>(tiles.tiles) / settings_.frames;
      report.mean_stood_in += static_cast<double>(tiles.stood_in) / settings_.frames;
      report.frames_stood_in += tiles.stood_in > 0 ? 1 : 0;
      if (frame % settings_.every == 0) keep(frame, camera, recorder);
      progress.advance();
    }
    report.times = frame_times(seconds);
    if (comparison_) compare(recorder);
    report.tiles = field_.statistics();
    report.peak_bytes = peak_resident_bytes();
    if (comparison_) report.comparison = comparison_->result();
    return report;
  }

 private:
  struct Kept {
    const Camera* camera;
    std::vector<bool> is_sky;  ///< [pixels]
  };

  void require_map_of_store(const HeightMap& map) const {
    const TileStoreHeader& of = store_.header();
    const auto is_near = [](double a, double b) { return std::abs(a - b) <= 1e-6 * b; };
    if (map.columns == of.shape.columns && map.rows == of.shape.rows &&
        is_near(map.spacing_x_m, of.spacing_x_m) && is_near(map.spacing_z_m, of.spacing_z_m)) {
      return;
    }
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected the map that the store was made of, {} x {} posts, {:.6g} x {:.6g} m "
                    "apart, found {} x {}, {:.6g} x {:.6g} m apart",
                    one_line(arguments_.compared), of.shape.columns, of.shape.rows, of.spacing_x_m,
                    of.spacing_z_m, map.columns, map.rows, map.spacing_x_m, map.spacing_z_m),
        "name that map, and say how to read it as it was said to `offing terrain tile`");
  }

  /// Of every picture that is written.
  FrameName image_name() const { return FrameName("-o", "frame.%06d.png", "frames").in(arguments_.output); }

  void make_folder() const {
    std::error_code status;
    std::filesystem::create_directories(arguments_.output, status);
    if (status) {
      throw Error(
          ErrorKind::file,
          fmt::format("{}: cannot be made a folder: {}", one_line(arguments_.output), status.message()),
          "name a folder where you may write with -o");
    }
    const GivenInputs inputs{{arguments_.store, arguments_.compared}, arguments_.trust};
    require_new_frames(image_name(), {0, settings_.frames - 1}, arguments_.existing, inputs, settings_.every);
  }

  void keep(int frame, const Camera& camera, FlightRecorder& recorder) {
    if (!arguments_.output.empty()) {
      const TerrainScenery scenery{
          .lines = world::cover_lines(store_.header().centre_latitude_deg.value_or(usual_latitude_deg))};
      write_png(image_name().of(frame),
                draw_terrain(device_, field_, camera, scenery, TerrainShow::light).image,
                arguments_.existing);
    }
    if (comparison_) kept_.push_back({&camera, sky_of(recorder.read_hits())});
  }

  static std::vector<bool> sky_of(const std::vector<TerrainHit>& hits) {
    std::vector<bool> is_sky(hits.size());
    std::transform(hits.begin(), hits.end(), is_sky.begin(),
                   [](const TerrainHit& hit) { return hit.kind == TERRAIN_MISS; });
    return is_sky;
  }

  /// After the flight, which would find in the cache what this waits for.
  void compare(FlightRecorder& recorder) {
    for (const Kept& kept : kept_) {
      options_.cancel.throw_if_cancelled();
      field_.look_and_wait(*kept.camera);
      recorder.draw(field_, *kept.camera, 0.0);
      comparison_->add(device_, *kept.camera, kept.is_sky, recorder.read_hits());
    }
  }

  const TerrainFlyArguments& arguments_;
  const GlobalOptions& options_;
  FlightSettings settings_;
  TileStore store_;
  ocl::Device device_;
  terrain::TiledField field_;
  std::vector<Camera> cameras_;
  std::optional<terrain::HeightField> map_;
  std::optional<FlightComparison> comparison_;
  std::vector<Kept> kept_;
};

constexpr double mebibyte = 1 << 20;

nlohmann::ordered_json to_json(const TerrainFlyArguments& arguments, const FlightReport& report) {
  nlohmann::ordered_json json = {{"store", arguments.store},
                                 {"frames", std::stoi(arguments.frames)},
                                 {"frame_ms",
                                  {{"median", 1e3 * report.times.median_s},
                                   {"slowest_hundredth", 1e3 * report.times.slowest_hundredth_s},
                                   {"worst", 1e3 * report.times.worst_s}}},
                                 {"tiles",
                                  {{"mean", report.mean_tiles},
                                   {"mean_stood_in", report.mean_stood_in},
                                   {"frames_with_stand_ins", report.frames_stood_in},
                                   {"loaded", report.tiles.loaded},
                                   {"failed", report.tiles.failed},
                                   {"slots", report.tiles.slots}}},
                                 {"cache_mb", static_cast<double>(report.tiles.bytes) / mebibyte},
                                 {"peak_memory_mb", static_cast<double>(report.peak_bytes) / mebibyte}};
  if (report.comparison) {
    const FlightComparison::Result& of = *report.comparison;
    json["comparison"] = {{"frames", of.frames},
                          {"pixels", of.pixels},
                          {"holes_flown", of.holes_flown},
                          {"holes_loaded", of.holes_loaded},
                          {"raised", of.raised},
                          {"distance_error_median", of.median_error},
                          {"distance_error_worst_hundredth", of.worst_hundredth_error}};
  }
  return json;
}

void print_text(const TerrainFlyArguments& arguments, const FlightReport& report) {
  fmt::print("{}: {} frames, median {:.1f} ms, slowest hundredth {:.1f} ms, worst {:.1f} ms\n",
             one_line(arguments.store), arguments.frames, 1e3 * report.times.median_s,
             1e3 * report.times.slowest_hundredth_s, 1e3 * report.times.worst_s);
  fmt::print("  tiles      {:.0f} a frame, {:.1f} of them stood in for, {} loaded, {} failed, {} slots\n",
             report.mean_tiles, report.mean_stood_in, report.tiles.loaded, report.tiles.failed,
             report.tiles.slots);
  fmt::print("  memory     {:.0f} MiB for tiles, {:.0f} MiB at most in all\n",
             static_cast<double>(report.tiles.bytes) / mebibyte,
             static_cast<double>(report.peak_bytes) / mebibyte);
  if (!report.comparison) return;
  const FlightComparison::Result& of = *report.comparison;
  fmt::print(
      "  compared   {} frames of {} pixels in all: {} holes in flight, {} once loaded, {} pixels of ground "
      "where "
      "the map has sky; distance off by {:.2g} of itself in the median, {:.2g} in the worst hundredth\n",
      of.frames, of.pixels, of.holes_flown, of.holes_loaded, of.raised, of.median_error,
      of.worst_hundredth_error);
}

void run(const TerrainFlyArguments& arguments, const GlobalOptions& options) {
  require_file_name(arguments.output);
  const FlightReport report = Flying(arguments, options).run();
  if (arguments.json) {
    print_json(to_json(arguments, report));
  } else {
    print_text(arguments, report);
  }
}

}  // namespace

void add_terrain_fly_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainFlyArguments>();
  CLI::App* command = terrain.add_subcommand("fly", "a flight over a tile store, and what its frames cost");
  command->add_option("STORE", arguments->store, "tile store of `offing terrain tile`")
      ->required()
      ->type_name("");
  arguments->cache.add_to(*command);
  arguments->cache.add_edge_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group("Flight");
  };
  add("--frames", arguments->frames, "N", "frames to draw (default 600)");
  add("--size", arguments->size, "WxH", "pixels (default 1280x720)");
  add("--speed-mps", arguments->speed, "V", "speed over the ground, m/s (default 300)");
  add("--fps", arguments->rate, "F", "frames a second of flight (default 30)");
  add("--height-m", arguments->height, "H", "above the highest ground around, m (default 150)");
  add("-o,--output", arguments->output, "FOLDER", "writes pictures there, frame.000000.png and so on");
  add("--every", arguments->every, "K", "of every K-th frame (default 12)");
  add("--compare", arguments->compared, "FILE",
      "height map that the store was made of: compares every K-th frame with that of the whole map in "
      "memory");
  arguments->map_flags.add_to(*command);
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "results for scripts");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
The way is a figure of eight over the middle of the map. Frames are drawn as fast as they can be, one step of V / F
metres after the other; times include the choice of tiles, rays, shadows and light. The other flags say how to read
the map of --compare.

Examples:
  offing terrain fly ground.tiles --cache-mb 256
  offing terrain fly ground.tiles --frames 100 --every 10 -o frames --speed-mps 1000
  offing terrain fly ground.tiles --compare ground.r32 --raw-size 32768x32768 --spacing-m 2 --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
