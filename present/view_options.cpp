#include "present/view_options.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/frame_flags.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/help_format.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/new_output.h"
#include "host/command_line/parse_arguments.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/file/version.h"
#include "host/scene/prepare/scene_renderer.h"
#include "present/output/image_file.h"
#include "present/output/video_pipe.h"
#include "present/window/scene_sources.h"

namespace offing::present {
namespace {

constexpr const char *kernel_folder = "kernels", *shader_folder = "present/passes";

constexpr const char* footer = R"(
Examples:
  offing-view scenes/storm.toml --headless --size 1920x1080 --time 12.5 -o storm.png
  offing-view scenes/storm.toml --record out_%04d.png --frames 0:47 --fps 24
  offing-view scenes/flight.toml --video flight.webm
  offing-view scenes/knot.toml --headless --highlights only -o glints.exr
  offing-view --terrain S33W071.tif
  offing-view scenes/cumulus.toml --compare-reference -o compared

Exit codes: 0 done, 1 failed, 2 wrong usage or input, 3 no usable device or display, 130 interrupted.)";

// The command line as it was written.
struct Written {
  std::string scene, terrain, size, output, record, video, device, sources;
  SettingOptions<ViewOptions> view;
  SettingOptions<ReferenceComparison> reference;
  FrameFlags frames;
  bool compares_reference = false;
  bool is_headless = false;
  bool is_window = false;
  bool is_paused = false;
  bool prints_json = false;
  Existing existing = Existing::keep;
  Verbosity verbosity = Verbosity::normal;
  Trust trust = Trust::trusted;
};

std::vector<scene::Row<ViewOptions>> picture_rows() {
  return {{scene::choice_or("auto", &ViewOptions::detail, {"low", "high"}),
           {.key = "detail", .help = "level of detail; auto: high, but low for windows that the CPU draws"}},
          {&ViewOptions::kept_hz,
           {.key = "keep_fps",
            .unit = "1/s",
            .high = 1000.0,
            .help = "frame rate that a window keeps by lowering quality; 0: never lower it",
            .example = "20",
            .absent = "20 if the CPU draws, else 0"}},
          {&ViewOptions::render_scale,
           {.key = "render_scale",
            .low = 0.1,
            .high = 1.0,
            .help = "scale of the picture that a window draws and shows enlarged; less is faster",
            .example = "0.5"}},
          {&ViewOptions::ui_scale,
           {.key = "ui_scale",
            .low = 1.0,
            .high = 3.0,
            .help = "scale of a window's panels and letters",
            .example = "2",
            .absent = "the display's scale"}},
          {&ViewOptions::time_s, time_facts("time to show", "the scene's start")},
          {scene::choice(&ViewOptions::highlights, {"shown", "hidden", "only", "unobstructed"}),
           {.key = "highlights",
            .help = "highlights of meshes in pictures; only: nothing else, with alpha, to lay over hidden\n"
                    "unobstructed: the same, hidden by their own mesh alone"}}};
}

std::vector<scene::Row<ReferenceComparison>> reference_rows() {
  return {{&ReferenceComparison::samples,
           {.key = "samples", .low = 1.0, .high = 1e6, .help = "paths per pixel"}}};
}

std::vector<scene::Row<ViewOptions>> transfer_rows() {
  std::vector<std::string_view> names;
  for (const TransferPath path : all_transfer_paths) names.push_back(to_string(path));
  return {{scene::choice_or("best", &ViewOptions::transfer, std::move(names)),
           {.key = "transfer",
            .help = "how to transfer maps from OpenCL to OpenGL; best: the first way that works"}}};
}

void add_options(CLI::App& app, Written& written) {
  app.name("offing-view");
  format_help(app);
  app.description(
      "offing-view: show a scene's sea, terrain, meshes and clouds in a window, or write pictures");
  app.set_version_flag("--version", "offing-view " + std::string(scene::version()), "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.add_option("SCENE", written.scene,
                 "scene file (.toml); default: an island, a ship and clouds, or --terrain alone")
      ->transform(find_scene)
      ->type_name("");
  app.add_option("--terrain", written.terrain,
                 "height map or tile store to show: GeoTIFF, .hgt, USGS DEM, ASCII grid, PNG, EXR\n"
                 "it replaces the file of the scene's [terrain]; the other keys there say how to read it")
      ->type_name("FILE");
  const char* pictures = "Pictures";
  app.add_flag("--headless", written.is_headless, "write pictures without opening a window")->group(pictures);
  app.add_flag("--window", written.is_window, "open a window also when recording (--record, --video)")
      ->group(pictures);
  app.add_option("--size", written.size,
                 "size of the picture or window (default 1280x720, or the last size of a window)\nby "
                 "default, a window that the CPU draws "
                 "shows a smaller picture, enlarged")
      ->type_name("WxH")
      ->group(pictures);
  written.view.add_to(app, picture_rows(), pictures);
  app.add_flag("--paused", written.is_paused, "open the window paused at the start time; press Space to run")
      ->group(pictures);
  app.add_option("-o,--output", written.output,
                 "picture to write: .png as on a screen, .exr scene-linear in kcd/m2")
      ->type_name("FILE")
      ->group(pictures);
  app.add_option("--record", written.record,
                 "write one picture per frame, such as out_%04d.png; a video name acts like --video")
      ->type_name("NAMES")
      ->group(pictures);
  app.add_option("--video", written.video,
                 "write the frames as a video, out.webm or out.mp4; needs the program ffmpeg")
      ->type_name("FILE")
      ->group(pictures);
  written.frames.add_frames_to(app, pictures);
  written.frames.add_fps_to(app, pictures);
  add_force_flag(app, written.existing)->group(pictures);
  const char* reference = "Clouds compared with a reference";
  app.add_flag("--compare-reference", written.compares_reference,
               "compare the drawn clouds with a reference path-traced in double precision; write both and "
               "their difference\n"
               "-o names the folder to write to; --size is 160x90 by default")
      ->group(reference);
  written.reference.add_to(app, reference_rows(), reference);
  app.add_flag("--json", written.prints_json,
               "print the light of both, their differences, the camera and the light on the clouds, as JSON")
      ->group(reference);
  add_device_flag(app, written.device);
  written.view.add_to(app, transfer_rows(), general_group);
  app.add_option(
         "--sources", written.sources,
         "checkout of Offing whose kernels and shaders to use; F5 reloads them\n(default: those built in)")
      ->type_name("FOLDER")
      ->group(general_group);
  add_trust_flag(app, written.trust);
  add_verbosity_flags(app, written.verbosity);
  app.footer(footer);
}

Recording read_recording(const Written& written, const scene::Scene& scene) {
  Recording recording{.video = written.video,
                      .frames = written.frames.frames(scene),
                      .frames_per_second = written.frames.times(scene).frames_per_second,
                      .existing = written.existing};
  if (is_video_name(written.record)) {
    if (!written.video.empty()) {
      throw Error(
          ErrorKind::bad_usage,
          fmt::format("--record: expected picture names when --video is given, got {}", written.record),
          "only one video is written: leave out --record or --video");
    }
    recording.video = written.record;
  } else if (!written.record.empty()) {
    recording.name.emplace("--record", written.record, "out_%04d.png");
    require_image_name(written.record);
  }
  return recording;
}

void require_sources(const std::filesystem::path& folder) {
  if (std::filesystem::is_directory(folder / kernel_folder) &&
      std::filesystem::is_directory(folder / shader_folder)) {
    return;
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("--sources: expected a folder with {} and {}, got {}", kernel_folder, shader_folder,
                          folder.string()),
              "name a checkout of Offing");
}

/// Throws, before any work is done, for files that may not be written.
ReferenceComparison read_comparison(const Written& written, const GivenInputs& inputs) {
  if (written.output.empty()) {
    throw Error(ErrorKind::bad_usage, "--compare-reference: expected a folder for its pictures, found none",
                "add -o compared");
  }
  if (!written.record.empty() || !written.video.empty() || written.is_window) {
    throw Error(ErrorKind::bad_usage,
                "--compare-reference: expected no --record, --video or --window, found one of them",
                "leave them out");
  }
  require_file_name(written.output);
  ReferenceComparison comparison = written.reference.read(
      {.folder = written.output, .prints_json = written.prints_json, .existing = written.existing});
  std::error_code failed;
  comparison.is_new_folder = std::filesystem::create_directories(comparison.folder, failed);
  if (failed || !std::filesystem::is_directory(comparison.folder)) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot create the folder", written.output),
                "name another folder");
  }
  for (const char* name : {"drawn.png", "reference.png", "error.png", "compared.exr"})
    require_new(comparison.file(name).string(), written.existing, inputs);
  return comparison;
}

/// Throws where a scene has no highlights that could stand alone.
void require_highlights(const scene::Scene& scene) {
  for (const scene::MeshScene& mesh : scene.meshes) {
    if (mesh.shown == scene::MeshHighlights::on) return;
  }
  throw Error(ErrorKind::bad_input,
              "--highlights: expected a scene with a [[mesh]] that has highlights, found none",
              "add a [[mesh]] to the scene, such as that of scenes/knot.toml");
}

/// Throws at the first flag that the others leave without effect.
void refuse_unused(const Written& written, const ViewOptions& options) {
  const auto refuse = [](const char* what, const char* hint) {
    throw Error(ErrorKind::bad_usage, what, hint);
  };
  if (written.frames.has_frames() && !options.recording) {
    refuse("--frames: expected --record or --video, found neither",
           "add --record out_%04d.png or --video out.webm");
  }
  if (written.frames.has_fps() && !options.recording) {
    refuse("--fps: expected --record or --video, found neither",
           "add --record out_%04d.png or --video out.webm");
  }
  if (written.view.is_given("--time") && options.recording && options.output.empty()) {
    refuse("--time: expected no --record or --video, which set the time of each frame",
           "choose the frames with --frames A:B, or make one picture with -o");
  }
  if (!options.comparison && (written.reference.are_given() || written.prints_json)) {
    refuse("--samples, --json: expected --compare-reference, found none",
           "add --compare-reference, or leave them out");
  }
  if (written.existing == Existing::replace && options.output.empty() && !options.recording) {
    refuse("--force: expected -o, --record or --video, found none", "leave --force out");
  }
  if (written.view.is_given("--highlights") && (options.opens_window || options.comparison)) {
    refuse("--highlights: expected pictures in files, found a window or --compare-reference",
           "use --headless -o out.png, or --record out_%04d.png");
  }
  if (is_alone(options.highlights) && options.recording && !options.recording->video.empty()) {
    refuse("--highlights: expected pictures, found a video, which has no alpha", "add --record out_%04d.png");
  }
  if (options.opens_window && !options.recording) return;
  if (options.kept_hz) {
    throw bad_argument("--keep-fps", "a window without a recording", "pictures in files",
                       "only with a window: pictures in files have full detail");
  }
  if (written.view.is_given("--render-scale")) {
    throw bad_argument("--render-scale", "a window without a recording", "pictures in files",
                       "--size sets their size");
  }
  if (options.ui_scale) {
    throw bad_argument("--ui-scale", "a window without a recording", "pictures in files",
                       "only windows have panels");
  }
  if (written.is_paused) {
    refuse("--paused: expected a window without a recording, found none",
           "leave --paused out, or open a window");
  }
}

/// What the scene is made of: no picture takes its place.
GivenInputs inputs_of(const Written& written, const scene::Scene& scene) {
  GivenInputs inputs{scene::files_of(scene), written.trust};
  inputs.names.push_back(written.scene);
  return inputs;
}

/// The picture of a recording that may have this name, if there is one. Of recordings with a folder a frame
/// none is looked for: there may be billions.
std::filesystem::path recorded_as(const Recording& recording, const std::filesystem::path& output) {
  if (!recording.name || output.empty() || !recording.name->is_one_folder()) return {};
  const std::optional<int> frame = recording.name->frame_of(output.filename().string());
  if (!frame || *frame < recording.frames.first || *frame > recording.frames.last) return {};
  return recording.name->of(*frame);
}

/// Throws for what may not or cannot be written, before any work is done.
void require_outputs(const Written& written, const ViewOptions& options) {
  const GivenInputs inputs = inputs_of(written, options.scene);
  if (!options.comparison) require_new(options.output.string(), written.existing, inputs);
  if (!options.recording) return;
  const Recording& recording = *options.recording;
  require_distinct({{"-o", options.output}, {"--record", recorded_as(recording, options.output)}});
  require_recording(recording, inputs);
  if (recording.video.empty()) return;
  // A window has as many pixels as its display gives it; its pictures are made to fit.
  const ImageSize size = options.size.value_or(ImageSize{});
  if (!options.opens_window) require_video_size(recording.video, size.width, size.height);
}

ViewOptions checked(const Written& written) {
  ViewOptions options;
  options.verbosity = written.verbosity;
  const bool shows_default = written.scene.empty() && written.terrain.empty();
  const EmbeddedFile& shipped = shipped_source(first_scene);
  if (!written.scene.empty()) options.scene = scene::load_scene(written.scene, written.trust);
  if (shows_default) options.scene = scene::parse_scene(shipped.text, shipped.name, "");
  if (!written.terrain.empty()) {
    options.scene.terrain.is_given = true;
    options.scene.terrain.file = written.terrain;
    options.scene.set_at.insert_or_assign("terrain.file", "--terrain");
    options.scene.named_files.erase(written.terrain);
  }
  options.trust = options.scene.trust = written.trust;
  // The window saves an installed scene under another name, as it does those of its list.
  if (std::filesystem::path(written.scene).parent_path() != installed_scenes()) {
    options.scene_file = written.scene;
  }
  options.scene_name =
      std::filesystem::path(shows_default ? shipped.name : std::string_view(written.scene)).stem().string();
  if (!written.size.empty()) options.size = read_size("--size", written.size);
  options.time_s = options.scene.time.start_s;
  options = written.view.read(std::move(options));
  options.starts_paused = written.is_paused;
  options.output = written.output;
  options.existing = written.existing;
  if (written.compares_reference) {
    options.comparison = read_comparison(written, inputs_of(written, options.scene));
  }
  if (!written.output.empty() && !options.comparison) require_image_name(options.output);
  if (!written.record.empty() || !written.video.empty()) {
    options.recording = read_recording(written, options.scene);
  }
  options.device = written.device;
  options.sources = written.sources;
  if (!written.sources.empty()) require_sources(options.sources);
  const bool makes_images = options.recording || !options.output.empty();
  if (written.is_window && written.is_headless) {
    throw Error(ErrorKind::bad_usage, "offing-view: expected --headless or --window, found both",
                "leave one of them out");
  }
  if (written.is_window && !options.output.empty()) {
    throw Error(ErrorKind::bad_usage, "--window: expected no -o, found one",
                "leave --window out, write a recording with --record or --video, or press F12 in the window");
  }
  options.opens_window = written.is_window || (!written.is_headless && !makes_images);
  if (!options.opens_window && !makes_images) {
    throw Error(ErrorKind::bad_usage,
                "--headless: expected a picture to make, found neither -o nor --record nor --video",
                "add -o out.png");
  }
  if (is_alone(options.highlights)) require_highlights(options.scene);
  refuse_unused(written, options);
  require_outputs(written, options);
  return options;
}

}  // namespace

void use_sources(const std::filesystem::path& checkout) {
  setenv("OFFING_KERNEL_PATH", (checkout / kernel_folder).c_str(), 1);
  setenv("OFFING_SHADER_PATH", (checkout / shader_folder).c_str(), 1);
}

ImageSize read_size(std::string_view flag, std::string_view text) {
  constexpr int largest = scene::longest_picture_px;
  ImageSize size;
  const char* end = text.data() + text.size();
  const auto [cross, width_error] = std::from_chars(text.data(), end, size.width);
  if (width_error == std::errc{} && cross != end && *cross == 'x') {
    const auto [rest, height_error] = std::from_chars(cross + 1, end, size.height);
    const auto fits = [](int side) { return side >= 1 && side <= largest; };
    if (height_error == std::errc{} && rest == end && fits(size.width) && fits(size.height)) return size;
  }
  throw bad_argument(flag, fmt::format("WxH, each within [1, {}]", largest), text, "1280x720");
}

FrameSettings frame_settings(Detail detail, std::optional<TransferPath> transfer) {
  if (detail == Detail::low) {
    return {.water = {.cells = {128, 128}, .taps = 1},
            .transfer = transfer,
            .terrain = {.rays = 1},
            .sky_step_px = 2};
  }
  return {.water = {.cells = {384, 384}, .taps = 4, .views_px = 1024},
          .transfer = transfer,
          .terrain = {.rays = 16}};
}

void visit_command_line(const std::function<void(const CLI::App&)>& visit) {
  Written written;
  CLI::App app;
  add_options(app, written);
  visit(app);
}

std::optional<ViewOptions> read_view_options(int argc, const char* const* argv) {
  Written written;
  CLI::App app;
  add_options(app, written);
  if (!parse_arguments(app, argc, argv)) return std::nullopt;
  return checked(written);
}

}  // namespace offing::present
