// `offing ocean modes`: all single waves of a sea, for other programs.
#include <cmath>
#include <memory>
#include <string>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/cli/common/device_choice.h"
#include "host/cli/common/parameter_options.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/cli/ocean/water_left_out.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/file_extension.h"
#include "host/io/modes/mode_file.h"
#include "host/ocean/surface/ocean.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {
namespace {

struct ModesArguments {
  ParameterOptions parameters;
  std::string output_file;
  bool json = false;
  Existing existing = Existing::keep;
};

/// What the waves come to: 4 sqrt(m0), m0 the sum of A^2 / 2.
double hs_m(const ModalSea& sea) {
  double m0_m2 = 0.0;
  for (const SeaMode& mode : sea.modes) m0_m2 += 0.5 * mode.amplitude_m * mode.amplitude_m;
  return 4.0 * std::sqrt(m0_m2);
}

void run(const ModesArguments& arguments, const GlobalOptions& options) {
  const bool is_text = is_standard_output(arguments.output_file);
  if (!is_text) require_extension(arguments.output_file, {".nc", ".csv"});
  const scene::Scene scene = arguments.parameters.read();
  const scene::Sea sea = scene::prepare_sea(scene);
  warn_of_water_left_out(scene, "modes", WakeUse::left_out);
  if (!sea.raindrops.empty()) spdlog::warn("modes leave out the rings of {} raindrops", sea.raindrops.size());
  if (!is_text) require_new(arguments.output_file, arguments.existing, arguments.parameters.inputs(scene));
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  const ModalSea modes = ocean::Ocean(device, sea.spectrum, sea.parameters).modes();
  if (is_text) {
    fmt::print("{}", modes_csv(modes));
    return;
  }
  write_modes(arguments.output_file, modes, arguments.existing);
  if (arguments.json) {
    const nlohmann::ordered_json json = {{"file", arguments.output_file},
                                         {"modes", modes.modes.size()},
                                         {"hs_m", hs_m(modes)},
                                         {"patch_lengths_m", modes.patch_lengths_m},
                                         {"size", modes.size},
                                         {"scene_hash", scene::scene_hash(scene, sea, "modes")}};
    fmt::print("{}\n", json.dump(2));
  } else {
    print_summary("{} waves written, Hs {:.3f} m: {}\n", modes.modes.size(), hs_m(modes),
                  arguments.output_file);
  }
}

}  // namespace

void add_modes_command(CLI::App& ocean, GlobalOptions& options) {
  using enum scene::ParameterGroup;
  const auto arguments = std::make_shared<ModesArguments>();
  CLI::App* command = ocean.add_subcommand("modes", "write all single waves of a sea, for other programs");
  command
      ->add_option("-o,--output", arguments->output_file,
                   "file to write: NetCDF (.nc) or CSV (.csv); -: CSV to standard output")
      ->required()
      ->type_name("FILE");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print a summary as JSON");
  arguments->parameters.add_to(*command, {world, sea, grid});
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
With p = kx_radpm x + kz_radpm z - omega_radps t + phase_rad, water that is at (x, z) at rest rises by the sum
of amplitude_m cos p. It moves sideways by the sum of -choppiness (kx, kz)/k amplitude_m sin p. Waves on no
patch (patch -1) are Gerstner waves: their choppiness is at most 1 over the sum of their k amplitude_m.

Other commands make this sea by --modes-file, scenes by the key ocean.modes_file. The file has no wind: add
--wind-speed-mps for the foam. It leaves out wakes, shores and raindrops.

Examples:
  offing ocean modes scenes/storm.toml -o storm.nc
  offing ocean modes --wind-speed-mps 12 --size 64 --cascades 1 -o sea.csv)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
