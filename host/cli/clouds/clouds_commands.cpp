#include "host/cli/clouds/clouds_commands.h"

namespace offing::cli {

void add_clouds_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* command = app.add_subcommand("clouds", "export and inspect clouds as volumes or particles");
  command->require_subcommand(1);
  add_clouds_build_command(*command, options);
  add_clouds_info_command(*command, options);
}

}  // namespace offing::cli
