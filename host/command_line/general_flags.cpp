#include "host/command_line/general_flags.h"

#include <CLI/Option.hpp>
#include <fmt/format.h>

namespace offing {

void add_device_flag(CLI::App& command, std::string& device, std::string_view also) {
  command
      .add_option(
          "--device", device,
          fmt::format(
              "OpenCL device, as `offing devices` lists them: an index, cpu, gpu, or part of a name{}{}\n"
              "default: $OFFING_DEVICE, then the first GPU, then the CPU",
              also.empty() ? "" : "\n", also))
      ->type_name("DEVICE")
      ->group(general_group);
}

void add_verbosity_flags(CLI::App& command, Verbosity& verbosity) {
  CLI::Option* quiet = command.add_flag_callback(
      "--quiet", [&verbosity] { verbosity = Verbosity::quiet; },
      "results and errors only: no progress, warnings or summaries");
  CLI::Option* verbose = command.add_flag_callback(
      "--verbose", [&verbosity] { verbosity = Verbosity::verbose; }, "more about what is done");
  command.parse_complete_callback([&verbosity] { configure_log(verbosity); });
  quiet->group(general_group);
  verbose->group(general_group)->excludes(quiet);
}

void add_trust_flag(CLI::App& command, Trust& trust) {
  command
      .add_flag_callback(
          "--untrusted", [&trust] { trust = Trust::untrusted; },
          "for other people's files: they may read only files in their own folder and below")
      ->group(general_group);
}

}  // namespace offing
