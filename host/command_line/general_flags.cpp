#include "host/command_line/general_flags.h"

#include <CLI/Option.hpp>
#include <fmt/format.h>

namespace offing {

void add_device_flag(CLI::App& command, std::string& device, std::string_view also) {
  command
      .add_option(
          "--device", device,
          fmt::format(
              "OpenCL device: cpu, gpu, or an index or part of a name that `offing devices` lists{}{}\n"
              "default: $OFFING_DEVICE, then the first GPU, then the CPU",
              also.empty() ? "" : "\n", also))
      ->type_name("DEVICE")
      ->group(general_group);
}

void add_verbosity_flags(CLI::App& command, Verbosity& verbosity) {
  CLI::Option* quiet = command.add_flag_callback(
      "--quiet", [&verbosity] { verbosity = Verbosity::quiet; },
      "print only results and errors: no progress, warnings or summaries");
  CLI::Option* verbose = command.add_flag_callback(
      "--verbose", [&verbosity] { verbosity = Verbosity::verbose; },
      "print details such as the devices and drivers in use");
  command.parse_complete_callback([&verbosity] { configure_log(verbosity); });
  quiet->group(general_group);
  verbose->group(general_group)->excludes(quiet);
}

void add_trust_flag(CLI::App& command, Trust& trust) {
  command
      .add_flag_callback(
          "--untrusted", [&trust] { trust = Trust::untrusted; },
          "use for files that you do not trust: they may read only files in their own folder and below it")
      ->group(general_group);
}

}  // namespace offing
