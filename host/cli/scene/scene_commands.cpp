#include "host/cli/scene/scene_commands.h"

namespace offing::cli {

void add_scene_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* command = app.add_subcommand("scene", "create and check scene files; list their keys");
  command->require_subcommand(1);
  add_new_command(*command, options);
  add_import_command(*command, options);
  add_check_command(*command, options);
  add_keys_command(*command, options);
  add_schema_command(*command, options);
}

}  // namespace offing::cli
