#include "host/command_line/trust_flag.h"

#include <CLI/Option.hpp>

#include "host/command_line/verbosity_flags.h"

namespace offing {

void add_trust_flag(CLI::App& command, Trust& trust) {
  command
      .add_flag_callback(
          "--untrusted", [&trust] { trust = Trust::untrusted; },
          "for files by other people: read what they name only from their folder and below")
      ->group(general_group);
}

}  // namespace offing
