#include "host/command_line/verbosity_flags.h"

#include <CLI/Option.hpp>

namespace offing {

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

}  // namespace offing
