#include "host/cli/bodies/bodies_commands.h"

namespace offing::cli {

void add_bodies_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* command = app.add_subcommand("bodies", "measure and simulate the floating bodies of a scene");
  command->require_subcommand(1);
  add_bodies_motion_command(*command, options);
  add_bodies_rao_command(*command, options);
  add_bodies_info_command(*command, options);
}

}  // namespace offing::cli
