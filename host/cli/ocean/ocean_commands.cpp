#include "host/cli/ocean/ocean_commands.h"

namespace offing::cli {

void add_ocean_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* ocean = app.add_subcommand("ocean", "bake, check and query a sea; inspect measured spectra");
  ocean->require_subcommand(1);
  add_bake_command(*ocean, options);
  add_stats_command(*ocean, options);
  add_query_command(*ocean, options);
  add_modes_command(*ocean, options);
  add_spectrum_command(*ocean, options);
}

}  // namespace offing::cli
