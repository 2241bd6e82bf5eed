#include <memory>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/progress.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/common/parameter_options.h"
#include "host/cli/ocean/certificate_text.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/command_line/setting_options.h"

namespace offing::cli {

namespace {

struct StatsSettings {
  int seeds = 8;
};

struct StatsArguments {
  ParameterOptions parameters;
  SettingOptions<StatsSettings> settings;
  bool json = false;
};

void run(const StatsArguments& arguments, const GlobalOptions& options) {
  const int seeds = arguments.settings.read().seeds;
  const scene::Sea sea = scene::prepare_sea(arguments.parameters.read());
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  const scene::Certificate certificate = [&] {
    Progress progress(seeds, "seeds", options.verbosity);
    return scene::certify(device, sea, seeds, Work(options.cancel, [&](double) { progress.advance(); }));
  }();
  if (arguments.json) {
    fmt::print("{}\n", certificate_json(certificate, sea, arguments.parameters.directions()).dump(2));
  } else {
    fmt::print("{}", certificate_text(certificate, sea, arguments.parameters.directions()));
  }
}

}  // namespace

void add_stats_command(CLI::App& ocean, GlobalOptions& options) {
  using enum scene::ParameterGroup;
  const auto arguments = std::make_shared<StatsArguments>();
  CLI::App* command =
      ocean.add_subcommand("stats", "compare the sea state you asked for with the generated surface");
  arguments->parameters.add_to(*command, {world, sea, grid, foam});
  arguments->settings.add_to(*command, {{&StatsSettings::seeds,
                                         {.key = "seeds",
                                          .low = 1.0,
                                          .high = 1e5,
                                          .help = "number of seas, each with its own seed, to average over",
                                          .example = "20"}}});
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
The columns are: asked, the whole spectrum; resolved, the part of it that the grids can hold; measured, the
surface, averaged over the seeds. In JSON, peak_period_s is 1 / f where the energy density E(f) is largest:
the period that --tp-s sets. tp_s is the integral of E^4 over that of f E^4. tz_s is Tm02. spread_deg is the
standard deviation of directions.

Examples:
  offing ocean stats --hs-m 2.5 --tp-s 8 --swell hs_m=1,tp_s=14,direction_deg=60
  offing ocean stats --spectrum pm --wind-speed-mps 10 --seeds 20
  offing ocean stats --spectrum-file 41010.data_spec --record 0 --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
