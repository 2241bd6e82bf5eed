#include "host/cli/commands.h"

#include <string>

#include "host/cli/bodies/bodies_commands.h"
#include "host/cli/clouds/clouds_commands.h"
#include "host/cli/common/devices_command.h"
#include "host/cli/highlights/highlights_command.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/cli/scene/scene_commands.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/command_line/help_format.h"
#include "host/scene/file/version.h"

namespace offing::cli {

void add_commands(CLI::App& app, GlobalOptions& options) {
  app.name("offing");
  format_help(app);
  app.description("Offing: oceans calibrated in metres, computed on any OpenCL device");
  app.set_version_flag("--version", "offing " + std::string(scene::version()), "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  add_ocean_command(app, options);
  add_terrain_command(app, options);
  add_highlights_command(app, options);
  add_bodies_command(app, options);
  add_clouds_command(app, options);
  add_scene_command(app, options);
  add_devices_command(app, options);
  app.footer(R"(
Examples:
  offing devices
  offing ocean bake --wind-speed-mps 15 --size 512 --frames 0:47 --fps 24 --preview -o out
  offing ocean bake --spectrum-file 41010.data_spec --record 0 --frames 0:9 --combined -o out
  offing ocean stats scenes/storm.toml --seeds 20
  offing ocean query scenes/storm.toml --at 120,-35 --time 12.5
  offing terrain info N42E001.hgt.zip
  offing terrain render S33W071.tif -o andes.png
  offing highlights scenes/knot.toml -o knot.glb
  offing bodies rao scenes/afloat.toml -o rao.csv
  offing clouds build scenes/cumulus.toml -o cumulus.vdb
  offing scene new harbour.toml

Exit codes: 0 done, 1 failed, 2 wrong usage or input, 3 no usable device, 130 interrupted.)");
}

}  // namespace offing::cli
