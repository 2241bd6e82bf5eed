#include "host/cli/common/global_options.h"

#include <CLI/Option.hpp>

#include "host/command_line/general_flags.h"

namespace offing::cli {

void add_global_options(CLI::App& command, GlobalOptions& options, DeviceUse device_use) {
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
        ->group(general_group);
  }
  add_verbosity_flags(command, options.verbosity);
}

}  // namespace offing::cli
