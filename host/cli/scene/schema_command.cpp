// `offing scene schema`: what editors need to check and complete scene files.
#include "host/cli/scene/json_schema.h"
#include "host/cli/scene/scene_commands.h"
#include "host/command_line/print_results.h"

namespace offing::cli {

void add_schema_command(CLI::App& scene, GlobalOptions& options) {
  CLI::App* command = scene.add_subcommand("schema", "print the JSON Schema of scene files, for editors");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
The schema follows JSON Schema draft-07. Taplo and Even Better TOML use it for a scene whose first line
names it:

  #:schema ./offing.schema.json

It cannot check everything; `offing scene check` can.

Example:
  offing scene schema > offing.schema.json)");
  command->callback([] { print_json(scene_json_schema()); });
}

}  // namespace offing::cli
