#include "host/command_line/trust_flag.h"

#include <CLI/Option.hpp>

#include "host/command_line/verbosity_flags.h"

namespace offing {

void add_trust_flag(CLI::App& command, Trust& trust) {
  command
      .add_flag_callback(
          "--untrusted", [&trust] { trust = Trust::untrusted; },
          "for other people's files: they may read only files in their own folder and below")
      ->group(general_group);
}

}  // namespace offing
