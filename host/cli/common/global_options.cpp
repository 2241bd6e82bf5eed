#include "host/cli/common/global_options.h"

#include "host/command_line/general_flags.h"

namespace offing::cli {

void add_global_options(CLI::App& command, GlobalOptions& options, DeviceUse device_use) {
  if (device_use != DeviceUse::none) {
    const bool takes_all = device_use == DeviceUse::any_number;
    add_device_flag(command, options.device,
                    takes_all ? "all: share the frames among all devices; frames of different drivers agree "
                                "within 1e-4 of the significant wave height"
                              : "");
  }
  add_verbosity_flags(command, options.verbosity);
}

}  // namespace offing::cli
