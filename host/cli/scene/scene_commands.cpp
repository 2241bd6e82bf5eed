#include "host/cli/scene/scene_commands.h"

namespace offing::cli {

void add_scene_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* command = app.add_subcommand("scene", "help to write scene files: keys, JSON Schema");
  command->require_subcommand(1);
  add_keys_command(*command, options);
  add_schema_command(*command, options);
}

}  // namespace offing::cli
