#include "host/cli/terrain/terrain_commands.h"

namespace offing::cli {

void add_terrain_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* terrain = app.add_subcommand("terrain", "inspect, generate, render and query height maps");
  terrain->require_subcommand(1);
  add_terrain_info_command(*terrain, options);
  add_terrain_generate_command(*terrain, options);
  add_terrain_render_command(*terrain, options);
  add_terrain_tile_command(*terrain, options);
  add_terrain_fly_command(*terrain, options);
  add_terrain_height_command(*terrain, options);
  add_terrain_profile_command(*terrain, options);
  add_terrain_lake_command(*terrain, options);
  add_terrain_ray_command(*terrain, options);
  add_terrain_los_command(*terrain, options);
  add_terrain_viewshed_command(*terrain, options);
  add_terrain_sky_command(*terrain, options);
  add_terrain_sun_command(*terrain, options);
}

}  // namespace offing::cli
