// `offing terrain fly`: the path of a flight, its frames and what they cost, and the same frames over the
// whole map.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "host/base/argument.h"
#include "host/base/camera.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/pictures/terrain_render.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_camera.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/frame_name.h"
#include "host/ocl/device.h"
#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"
#include "host/world/terrain_light.h"

namespace offing::cli {
namespace {

/// A flight over a map whose first post is at x = z = 0.
struct Flight {
  double width_m = 0.0, depth_m = 0.0;
  double step_m = 10.0;     ///< from frame to frame
  double height_m = 150.0;  ///< above the ground
  int frames = 600;
  /// Upper bound of the ground around a place of the plan.
  std::function<double(double x_m, double z_m)> bound_m;
};

constexpr double pitch_rad = -10.0 * std::numbers::pi / 180.0;
// The height is the highest bound within so many steps before and behind, and then their mean.
constexpr int smoothed_steps = 60;

glm::dvec2 figure(const Flight& flight, double phase) {
  return {flight.width_m * (0.5 + 0.4 * std::sin(phase)),
          flight.depth_m * (0.5 + 0.4 * std::sin(2.0 * phase))};
}

/// Eye and direction of each frame: along a figure of eight that keeps a tenth of the map from its edges and
/// begins a little past the middle, following the bound of the ground smoothly, looking ahead and 10 degrees
/// down.
std::vector<Camera> flight_path(const Flight& flight) {
  const int points = flight.frames + 4 * smoothed_steps;
  std::vector<glm::dvec2> places;
  std::vector<double> bounds_m;
  double phase = 0.0;
  for (int i = 0; i < points; ++i) {
    const glm::dvec2 place = figure(flight, phase);
    places.push_back(place);
    bounds_m.push_back(flight.bound_m(place.x, place.y));
    constexpr double probe = 1e-6;
    phase += flight.step_m * probe / glm::length(figure(flight, phase + probe) - place);
  }
  std::vector<Camera> cameras;
  std::vector<double> highest_m;
  for (int i = 0; i < points; ++i) {
    const auto from = bounds_m.begin() + std::max(0, i - smoothed_steps);
    const auto to = bounds_m.begin() + std::min(points, i + smoothed_steps + 1);
    highest_m.push_back(*std::max_element(from, to));
  }
  for (int frame = 0; frame < flight.frames; ++frame) {
    const int at = frame + smoothed_steps;
    double sum_m = 0.0;
    for (int i = at - smoothed_steps; i <= at + smoothed_steps; ++i)
      sum_m += highest_m[static_cast<std::size_t>(i)];
    const glm::dvec2 here = places[static_cast<std::size_t>(at)],
                     way = places[static_cast<std::size_t>(at + 1)] - here;
    Camera camera;
    camera.eye_m = {here.x, sum_m / (2 * smoothed_steps + 1) + flight.height_m, here.y};
    camera.yaw_rad = std::atan2(way.x, -way.y);
    camera.pitch_rad = pitch_rad;
    cameras.push_back(camera);
  }
  return cameras;
}

/// Draws the frames of a flight on a device and times them: rays and light, under one sky.
class FlightRecorder {
 public:
  FlightRecorder(const ocl::Device& device, const Camera& first, double latitude_deg);

  /// Draws the frame; returns the seconds that it took, the choice of tiles included.
  double draw(terrain::TiledField& field, const Camera& camera, double ahead_m);

  /// What the last frame's rays hit.
  std::vector<TerrainHit> read_hits() const { return hits_.read(); }

 private:
  ocl::Device device_;
  sky::Atmosphere atmosphere_;
  sky::ClearSky sky_;
  TerrainLight light_;
  terrain::TerrainShade shade_;
  ocl::Buffer<TerrainHit> hits_;
  ocl::Buffer<terrain::Texel> image_;
};

/// Frame times by rank.
struct FrameTimes {
  double median_s = 0.0, slowest_hundredth_s = 0.0, worst_s = 0.0;
};

FlightRecorder::FlightRecorder(const ocl::Device& device, const Camera& first, double latitude_deg)
    : device_(device),
      sky_(device, atmosphere_),
      shade_(device),
      hits_(device, terrain::pixel_count(first), "terrain hits"),
      image_(device, terrain::pixel_count(first), "terrain image") {
  const TerrainScenery scenery;
  sky_.at({.sun_direction = sky::direction_of(scenery.sun_azimuth_rad, scenery.sun_elevation_rad)},
          std::max(0.0, first.eye_m.y));
  // Heights of maps are measured from the sea level, 0.
  light_ = world::terrain_light(sky_.read_illuminance(), atmosphere_, world::cover_lines(latitude_deg), 0.0);
}

double FlightRecorder::draw(terrain::TiledField& field, const Camera& camera, double ahead_m) {
  const auto start = std::chrono::steady_clock::now();
  field.look(camera, ahead_m);
  field.cast(camera, hits_);
  shade_.at(field, camera, hits_, {light_, sky_.params(), sky_.view_table()}, image_);
  device_.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

FrameTimes frame_times(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(std::ceil(share * static_cast<double>(seconds.size()))) - 1];
  };
  return {at(0.5), at(0.99), seconds.back()};
}

/// Largest memory that the process has had, bytes.
std::size_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Frames of a flight over tiles against those over the whole map.
class FlightComparison {
 public:
  /// field must outlive this.
  explicit FlightComparison(terrain::HeightField& field) : field_(field) {}

  /// What tiles showed of a frame: where there was sky while some were still missing ([pixels]), and all once
  /// they were there.
  void add(const ocl::Device& device, const Camera& camera, const std::vector<bool>& sky_flown,
           const std::vector<TerrainHit>& loaded);

  struct Result {
    std::size_t frames = 0, pixels = 0;
    std::size_t holes_flown = 0, holes_loaded = 0;  ///< pixels of sky where the map has ground
    std::size_t raised = 0;  ///< pixels of ground where the map has sky, once all tiles were there
    /// Distance to the ground, off by so much of itself: of pixels that both show ground.
    double median_error = 0.0, worst_hundredth_error = 0.0;
  };
  Result result() const;

 private:
  terrain::HeightField& field_;
  Result result_;
  std::vector<float> errors_;
};

void FlightComparison::add(const ocl::Device& device, const Camera& camera,
                           const std::vector<bool>& sky_flown, const std::vector<TerrainHit>& loaded) {
  ocl::Buffer<float> distances(device, terrain::pixel_count(camera), "distances");
  field_.cast(camera, distances);
  const std::vector<float> map_m = distances.read();
  ++result_.frames;
  result_.pixels += map_m.size();
  for (std::size_t i = 0; i < map_m.size(); ++i) {
    const bool is_ground = std::isfinite(map_m[i]);
    if (is_ground) {
      result_.holes_flown += sky_flown[i] ? 1 : 0;
      result_.holes_loaded += loaded[i].kind == TERRAIN_MISS ? 1 : 0;
      if (loaded[i].kind != TERRAIN_MISS) {
        errors_.push_back(std::abs(loaded[i].distance_m - map_m[i]) / std::max(map_m[i], 1e-3f));
      }
    } else {
      result_.raised += loaded[i].kind == TERRAIN_MISS ? 0 : 1;
    }
  }
}

FlightComparison::Result FlightComparison::result() const {
  Result result = result_;
  if (errors_.empty()) return result;
  std::vector<float> errors = errors_;
  const auto at = [&](double share) {
    const auto place =
        errors.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), place, errors.end());
    return static_cast<double>(*place);
  };
  result.median_error = at(0.5);
  result.worst_hundredth_error = at(0.99);
  return result;
}

constexpr double usual_latitude_deg = 46.0;

struct FlightSettings {
  int frames = 600, every = 12;
  double speed_mps = 300.0, height_m = 150.0, frames_a_second = 30.0;
};

struct TerrainFlyArguments {
  std::string store, output, compared, size = "1280x720";
  SettingOptions<FlightSettings> flight;
  CacheFlags cache;
  HeightMapFlags map_flags;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

std::vector<scene::Row<FlightSettings>> flight_rows() {
  constexpr double most_frames = 1e6;
  return {
      {&FlightSettings::frames, {.key = "frames", .low = 1.0, .high = most_frames, .help = "frames to draw"}},
      {&FlightSettings::speed_mps,
       {.key = "speed_mps", .unit = "m/s", .low = 0.1, .high = 1e5, .help = "speed over ground"}},
      {&FlightSettings::frames_a_second, like_scene("time.fps", "--fps", "frames per second of flight")},
      {&FlightSettings::height_m,
       {.key = "height_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e5,
        .help = "height above the highest ground nearby"}},
      {&FlightSettings::every,
       {.key = "every",
        .low = 1.0,
        .high = most_frames,
        .help = "write and compare one frame out of this many"}}};
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
    camera.vertical_field_of_view_rad = 60.0 * radians_per_degree;
    read_image_size(size, camera);
  }
  return cameras;
}

/// What a flight came to.
struct FlightReport {
  int frames = 0;
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
        settings_(arguments.flight.read()),
        store_(arguments.store, arguments.trust),
        device_(ocl::Device::open(choose_one_device(options.device))),
        field_(make_field(store_, device_, arguments.cache.read())),
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
    report.frames = settings_.frames;
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
        "name that map, with the flags that you gave to `offing terrain tile`");
  }

  /// Of every picture that is written.
  FrameName image_name() const { return FrameName("-o", "frame.%06d.png", "frames").in(arguments_.output); }

  void make_folder() const {
    std::error_code status;
    std::filesystem::create_directories(arguments_.output, status);
    if (status) {
      throw Error(
          ErrorKind::file,
          fmt::format("{}: cannot create the folder: {}", one_line(arguments_.output), status.message()),
          "name a folder with -o in which you may write");
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

nlohmann::ordered_json flight_json(const TerrainFlyArguments& arguments, const FlightReport& report) {
  nlohmann::ordered_json json = {{"store", arguments.store},
                                 {"frames", report.frames},
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
             one_line(arguments.store), report.frames, 1e3 * report.times.median_s,
             1e3 * report.times.slowest_hundredth_s, 1e3 * report.times.worst_s);
  fmt::print(
      "  tiles      {:.0f} per frame, {:.1f} of them replaced by coarser ones, {} loaded, {} failed, {} "
      "slots\n",
      report.mean_tiles, report.mean_stood_in, report.tiles.loaded, report.tiles.failed, report.tiles.slots);
  fmt::print("  memory     {:.0f} MiB for tiles, {:.0f} MiB at most in all\n",
             static_cast<double>(report.tiles.bytes) / mebibyte,
             static_cast<double>(report.peak_bytes) / mebibyte);
  if (!report.comparison) return;
  const FlightComparison::Result& of = *report.comparison;
  fmt::print(
      "  compared   {} frames of {} pixels in all: {} holes in flight, {} once loaded, {} pixels of ground "
      "where the map has sky; relative distance error {:.2g} in the median, {:.2g} in the worst hundredth\n",
      of.frames, of.pixels, of.holes_flown, of.holes_loaded, of.raised, of.median_error,
      of.worst_hundredth_error);
}

void run(const TerrainFlyArguments& arguments, const GlobalOptions& options) {
  require_file_name(arguments.output);
  const FlightReport report = Flying(arguments, options).run();
  if (arguments.json) {
    print_json(flight_json(arguments, report));
  } else {
    print_text(arguments, report);
  }
}

}  // namespace

void add_terrain_fly_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainFlyArguments>();
  CLI::App* command = terrain.add_subcommand("fly", "fly over a tile store and measure frame times");
  command->add_option("STORE", arguments->store, "tile store made by `offing terrain tile`")
      ->required()
      ->type_name("");
  arguments->cache.add_to(*command);
  arguments->cache.add_edge_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group("Flight");
  };
  add("--size", arguments->size, "WxH", "size in pixels (default 1280x720)");
  arguments->flight.add_to(*command, flight_rows(), "Flight");
  add("-o,--output", arguments->output, "FOLDER", "folder to write pictures to: frame.000000.png and so on");
  add("--compare", arguments->compared, "FILE",
      "height map from which the store was made: compare the frames of --every with frames of the whole map "
      "in memory");
  arguments->map_flags.add_to(*command);
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
The flight is a figure of eight over the middle of the map. Frames are drawn as fast as possible; from one
to the next the eye moves by speed / fps metres. Times include the choice of tiles, rays, shadows and
light. The flags under Heights, Spacing and Files without a header say how to read the map of --compare.

Examples:
  offing terrain fly ground.tiles --cache-mb 256
  offing terrain fly ground.tiles --frames 100 --every 10 -o frames --speed-mps 1000
  offing terrain fly ground.tiles --compare ground.r32 --raw-size 32768x32768 --spacing-m 2 --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
