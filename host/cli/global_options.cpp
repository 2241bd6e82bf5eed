#include "host/cli/global_options.h"

#include <CLI/Option.hpp>

namespace offing::cli {

void add_global_options(CLI::App& command, GlobalOptions& options, DeviceUse device_use) {
  constexpr const char* group = "General";
  if (device_use != DeviceUse::none) {
    const std::string all =
        device_use == DeviceUse::any_number
            ? "\nall: shares the frames among all; those of different drivers agree within 1e-4 of the "
              "significant height"
            : "";
    command
        .add_option("--device", options.device,
                    "OpenCL device, of `offing devices`: an index, cpu, gpu, or part of a name" + all +
                        "\ndefault $OFFING_DEVICE, then the first GPU, then the CPU")
        ->type_name("DEVICE")
        ->group(group);
  }
  CLI::Option* quiet = command.add_flag_callback(
      "--quiet", [&options] { options.verbosity = Verbosity::quiet; }, "errors only, no progress");
  CLI::Option* verbose = command.add_flag_callback(
      "--verbose", [&options] { options.verbosity = Verbosity::verbose; }, "more about what is done");
  command.parse_complete_callback([&options] { configure_log(options.verbosity); });
  quiet->group(group);
  verbose->group(group)->excludes(quiet);
}

}  // namespace offing::cli
