#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/common/parameter_options.h"
#include "host/cli/ocean/bake.h"
#include "host/cli/ocean/bake_description.h"
#include "host/cli/ocean/cascade_text.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/cli/ocean/query_settings.h"
#include "host/cli/ocean/water_left_out.h"
#include "host/command_line/frame_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/io/spectra/write_ww3_spectra.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/sampled_spectrum.h"

namespace offing::cli {

namespace {

struct BakeArguments {
  ParameterOptions parameters;
  FrameFlags frames;
  std::string folder;
  std::string chunk = "1/1";
  std::string channels;  // empty: usual_channels()
  std::string export_file;
  bool json = false;
  BakeSettings settings;  ///< of flags without a value
  bool has_wakes = false;
  SettingOptions<BakeSettings> values;
};

std::vector<scene::Row<BakeSettings>> velocity_rows() {
  return {{&BakeSettings::velocity_depth_m,
           velocity_depth_facts(
               "write the particle velocity at this depth below the moving surface, down to the bed")}};
}

std::vector<scene::Row<BakeSettings>> layout_rows() {
  return {{scene::choice(&BakeSettings::layout, {"channels", "combined", "rgb"}),
           {.key = "layout",
            .help = "channels: a file per cascade; combined: a file per frame, with layers; "
                    "rgb: a plain RGB or Y file per map, which all programs load"}},
          {scene::choice(&BakeSettings::axes, {"y-up", "z-up"}),
           {.key = "axes", .help = "axes of the files: x east, y up, z south; or x east, y north, z up"}}};
}

std::vector<scene::Row<BakeSettings>> file_rows() {
  return {{scene::choice(&BakeSettings::compression, {"none", "zips", "zip", "piz"}),
           {.key = "compression", .help = "compression of the EXR files"}},
          {scene::choice(&BakeSettings::mesh, {"none", "obj", "ply"}),
           {.key = "mesh",
            .help = "also write a mesh of the displaced surface: all cascades, over the longest patch",
            .example = "ply"}}};
}

BakeSettings read_settings(const BakeArguments& arguments, const scene::Scene& scene, double water_depth_m) {
  const NarrowedRange water{.flag = "--velocity-depth-m", .high = water_depth_m};
  BakeSettings settings = arguments.values.read(arguments.settings, water);
  require_file_name(arguments.folder);
  settings.folder = arguments.folder;
  settings.frames_per_second = scene.time.frames_per_second;
  settings.frames = arguments.frames.frames(scene);
  settings.share = read_share("--chunk", arguments.chunk);
  settings.channels |= arguments.channels.empty() ? usual_channels(settings.layout)
                                                  : read_channels("--channels", arguments.channels);
  if (arguments.values.is_given("--velocity-depth-m")) {
    settings.channels.set(static_cast<std::size_t>(ChannelGroup::velocity));
  }
  require_maps(settings);
  if (arguments.has_wakes) {
    if (scene.ocean.wakes.empty()) {
      throw Error(ErrorKind::bad_usage, "--wakes: expected a scene with [[ocean.wake]], found none",
                  "name a scene file that has one, such as scenes/afloat.toml, or leave --wakes out");
    }
    for (const scene::WakeScene& wake : scene.ocean.wakes)
      settings.wake_cells.push_back(wake.parameters.cells);
  }
  return settings;
}

void warn_of_broken_loop(const scene::Sea& sea, double frames_per_second) {
  if (!sea.parameters.loop_period_s) {
    return;
  }
  const double frames = *sea.parameters.loop_period_s * frames_per_second;
  if (std::abs(frames - std::round(frames)) > 1e-6 * frames) {
    spdlog::warn("the loop of {:g} s is {:g} frames at {:g} frames per second: no frame repeats the first",
                 *sea.parameters.loop_period_s, frames, frames_per_second);
  }
}

/// Writes the sheet once the pictures of all frames are there: the last process to end finds them complete.
void write_contact_sheet(const BakeSettings& settings, const FrameFiles& files, const ContactSheet& sheet) {
  for (int frame = settings.frames.first; frame <= settings.frames.last; ++frame) {
    if (!files.has_preview(frame)) return;
  }
  write_png(files.contact_sheet(), sheet.draw(), Existing::replace, PngCompression::fast);
}

nlohmann::json summary_json(const BakeSettings& settings, const scene::Sea& sea,
                            const scene::EnergyShares& energy, const BakeSummary& summary,
                            const FrameWriter& writer, const std::string& hash) {
  nlohmann::json json = {{"folder", settings.folder.string()},
                         {"frames_written", summary.written},
                         {"frames_kept", summary.kept},
                         {"scene_hash", hash},
                         {"m0_m2", energy.m0_m2},
                         {"out_of_band_m2", energy.out_of_band_m2}};
  json["cascades"] = nlohmann::json::array();
  for (std::size_t i = 0; i < sea.parameters.cascades.size(); ++i) {
    json["cascades"].push_back(
        {{"patch_m", sea.parameters.cascades[i].patch_length_m}, {"m0_m2", energy.cascade_m0_m2[i]}});
  }
  for (const auto& [name, error] : writer.half_errors()) {
    json["half_errors"][std::string(name)] = {{"largest_error", error.largest_error},
                                              {"bound", error.bound()}};
  }
  return json;
}

/// How far 16-bit floats are off, a line a map.
std::string half_error_text(const FrameWriter& writer) {
  std::string text;
  for (const auto& [name, error] : writer.half_errors()) {
    text += fmt::format("16-bit {}: at most {:.2g}{}{} off (bound {:.2g})\n", name, error.largest_error,
                        error.unit.empty() ? "" : " ", error.unit, error.bound());
  }
  return text;
}

/// What is asked for and cannot be done, and what is in the scene and not in the frames.
void warn_of_waves_beside(const scene::Sea& sea, const scene::EnergyShares& energy, GerstnerUse use) {
  if (use == GerstnerUse::included && !sea.has_gerstner_waves()) {
    spdlog::warn("--include-gerstner: not used: there are no Gerstner waves, swells or raindrops");
  }
  if (use == GerstnerUse::included && sea.parameters.loop_period_s && !sea.raindrops.empty()) {
    spdlog::warn("raindrops fall once: frames with raindrops do not loop");
  }
  if (use != GerstnerUse::included && !sea.raindrops.empty()) {
    spdlog::warn("the frames leave out the raindrops of the scene: --include-gerstner adds them");
  }
  const double left_out_m2 = energy_m2(sea.parameters.gerstner_waves.waves);
  if (use != GerstnerUse::included && left_out_m2 > 0.0) {
    const double all_m2 = energy.m0_m2 + energy_m2(sea.swells);
    spdlog::warn(
        "the maps leave out the {} Gerstner waves, {:.0f} % of the sea's energy: --include-gerstner adds "
        "them, "
        "ocean.json lists them",
        sea.parameters.gerstner_waves.waves.size(), 100.0 * left_out_m2 / all_m2);
  }
}

/// Whether a regular file holds this text and nothing else.
bool holds(const std::string& file, const std::string& text) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored) ||
      std::filesystem::file_size(file, ignored) != text.size())
    return false;
  std::ifstream found(file, std::ios::binary);
  return found && std::string(std::istreambuf_iterator<char>(found), {}) == text;
}

/// The file of --export-spectrum; none for an empty name. A bake that resumes finds what it has exported: an
/// equal file is left alone, and another is refused at once.
class SpectrumExport {
 public:
  SpectrumExport(std::string file, const scene::Sea& sea, Existing existing, const GivenInputs& inputs)
      : file_(std::move(file)), existing_(existing) {
    if (file_.empty()) return;
    const WaveSpectrum sampled = scene::sampled_spectrum(sea);
    text_ = ww3_text(file_, std::span(&sampled, 1));
    if (std::filesystem::exists(file_) && !holds(file_, text_)) require_new(file_, existing, inputs);
  }

  void write(const GivenInputs& inputs) const {
    if (file_.empty() || holds(file_, text_)) return;
    require_new(file_, existing_, inputs);
    write_file_atomically(file_, text_, existing_);
  }

 private:
  std::string file_, text_;
  Existing existing_;
};

void run(const BakeArguments& arguments, const GlobalOptions& options) {
  const scene::Scene scene = arguments.parameters.read();
  const scene::Sea sea = scene::prepare_sea(scene);
  const BakeSettings settings = read_settings(arguments, scene, sea.spectrum.dispersion.depth_m);
  const std::vector<ocl::DeviceInfo> devices = choose_devices(options.device);
  const scene::EnergyShares energy = scene::energy_shares(sea.spectrum, sea.parameters.cascades);
  const GivenInputs inputs = arguments.parameters.inputs(scene);
  const SpectrumExport exported(arguments.export_file, sea, settings.existing, inputs);
  if (!arguments.json) {
    print_summary("{}", cascade_text(sea, energy));
    std::fflush(stdout);
  }
  warn_of_broken_loop(sea, settings.frames_per_second);
  warn_of_waves_beside(sea, energy, settings.gerstner);
  const bool has_wakes = !settings.wake_cells.empty();
  warn_of_water_left_out(scene, "frames", has_wakes ? WakeUse::included : WakeUse::left_out);

  const std::string hash = scene::scene_hash(scene, sea, canonical_text(settings),
                                             has_wakes ? scene::shapes_sea_and_wakes : scene::shapes_sea);
  const FrameFiles files(settings, static_cast<int>(sea.parameters.cascades.size()), hash);
  if (const std::filesystem::path file = arguments.export_file; files.will_write(file)) {
    require_distinct({{"-o", settings.folder / file.filename()}, {"--export-spectrum", file}});
  }
  files.prepare_folder(inputs);
  exported.write(inputs);  // after the folder: it may lie there
  const std::string description = bake_description(scene, sea, settings, energy, hash).dump(2) + "\n";
  if (const std::string file = files.description(); !holds(file, description)) {
    write_file_atomically(file, description);  // prepare_folder() has looked at what is there
  }
  FrameWriter writer(sea, settings, files, hash, scene::spectrum_name(scene, sea));
  const BakeSummary summary = [&] {
    const std::size_t count = frames_in_share(settings.frames, settings.share).size();
    Progress progress(static_cast<int>(count), "frames", options.verbosity);
    return bake(devices, sea, settings, files, writer, progress, options.cancel, scene);
  }();
  if (settings.preview == PreviewUse::pictures) {
    write_contact_sheet(settings, files, writer.contact_sheet());
  }
  if (arguments.json) {
    fmt::print("{}\n", summary_json(settings, sea, energy, summary, writer, hash).dump(2));
  } else {
    print_summary("{}", half_error_text(writer));
    print_summary("{} frame{} written, {} there already: {}\n", summary.written,
                  summary.written == 1 ? "" : "s", summary.kept, settings.folder.string());
  }
}

void add_output_options(CLI::App& command, const std::shared_ptr<BakeArguments>& arguments) {
  constexpr const char* group = "Output";
  BakeSettings& settings = arguments->settings;
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command.add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  const auto add_switch = [&](const char* name, const char* help, auto set) {
    return command.add_flag_callback(name, set, help)->group(group);
  };
  add("-o,--output", arguments->folder, "DIR", "folder for the frames; created if missing")->required();
  arguments->frames.add_frames_to(command, group);
  add("--channels", arguments->channels, "LIST",
      "channels to write, separated by commas: displacement, slope, gradient, jacobian, foam, velocity, "
      "normal\n(default: all but the last two; with --layout rgb displacement, foam, normal)");
  add_switch("--velocity", "also write the particle velocity at the surface",
             [&settings] { settings.channels.set(static_cast<std::size_t>(ChannelGroup::velocity)); });
  arguments->values.add_to(command, velocity_rows(), group);
  arguments->values.add_to(command, layout_rows(), group);
  add_switch("--combined", "the same as --layout combined", [&settings] {
    settings.layout = FileLayout::combined;
  })->excludes(command.get_option("--layout"));
  add_switch("--half", "write 16-bit floats, each within 1/2048 of the value or 3e-8 (default: 32-bit)",
             [&settings] { settings.pixel_type = PixelType::half_16; });
  arguments->values.add_to(command, file_rows(), group);
  add_switch("--preview", "also write a shaded picture of each frame from above, and a contact sheet of all",
             [&settings] { settings.preview = PreviewUse::pictures; });
  add_switch("--include-gerstner",
             "add Gerstner waves, swells and raindrops to cascade c0 and its mesh\nc0 then no longer tiles, "
             "and holds the Jacobian and foam of the whole sea\n(default: list Gerstner waves and swells in "
             "the header, leave raindrops out)",
             [&settings] { settings.gerstner = GerstnerUse::included; });
  add_switch("--wakes",
             "also write each [[ocean.wake]] as maps of its own (ocean.w0...), with its place in the header\n"
             "channels: height, slope, foam, and rise (its rate) if velocity is asked for",
             [arguments = arguments.get()] { arguments->has_wakes = true; });
  add("--export-spectrum", arguments->export_file, "FILE",
      "also write the spectrum as WAVEWATCH III text (.spec)");
  add("--chunk", arguments->chunk, "i/n",
      "make every n-th frame, beginning with the i-th: n processes can share a folder (default: 1/1)");
  add_force_flag(command, settings.existing)
      ->description("replace existing files, including frames of another scene and all files made from them")
      ->group(group);
  command.add_flag("--json", arguments->json, "print the summary as JSON")->group(group);
}

}  // namespace

void add_bake_command(CLI::App& ocean, GlobalOptions& options) {
  using enum scene::ParameterGroup;
  const auto arguments = std::make_shared<BakeArguments>();
  CLI::App* command =
      ocean.add_subcommand("bake", "write the sea's maps as OpenEXR frames; resumes an interrupted bake");
  add_output_options(*command, arguments);
  arguments->parameters.add_to(*command, {world, time, sea, grid, foam});
  add_global_options(*command, options, DeviceUse::any_number);
  command->footer(R"(
ocean.json in the folder describes the files. Cascades show the open sea, without wakes, bodies and shores;
--wakes adds what hulls and rain do to the water of wake windows.

Examples:
  offing ocean bake --wind-speed-mps 15 --size 512 --frames 0:47 --fps 24 --preview -o out
  offing ocean bake --spectrum-file 41010.data_spec --record 0 --frames 0:9 --combined -o out
  offing ocean bake scenes/storm.toml --chunk 2/8 -o out     (for the second of eight processes))");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
