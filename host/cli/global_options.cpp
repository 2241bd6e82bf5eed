#include "host/cli/global_options.h"

#include <CLI/Option.hpp>

namespace offing::cli {

void add_global_options(CLI::App& command, GlobalOptions& options, DeviceUse device_use) {
  constexpr const char* group = "General";
  if (device_use != DeviceUse::none) {
    const std::string all =
        device_use == DeviceUse::any_number
            ? ", or all to share the frames among all of them: those of different drivers then agree within "
              "1e-4 of the significant height, not bit for bit"
            : "";
    command
        .add_option(
            "--device", options.device,
            "OpenCL device: an index, cpu, gpu, or part of a name" + all +
                " (`offing devices` lists them; default $OFFING_DEVICE, then the first GPU, then the CPU)")
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
