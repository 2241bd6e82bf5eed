#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing terrain`: what can be done with height maps.
void add_terrain_command(CLI::App& app, GlobalOptions& options);

/// `offing terrain info FILE`: size, spacing, range, voids and place of a height map.
void add_terrain_info_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain generate -o FILE.r32`: generated terrain of any size, row by row.
void add_terrain_generate_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain render FILE -o PNG`: a picture of a height map, and its depth.
void add_terrain_render_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain tile`: a height map of any size as a store of tiles.
void add_terrain_tile_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain fly`: a flight over a tile store or a height map, and what its frames cost.
void add_terrain_fly_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain height FILE --at X,Z`: height, normal and slope of the ground at a point.
void add_terrain_height_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain lake FILE --at X,Z`: water in a basin.
void add_terrain_lake_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain profile FILE --from X,Z --to X,Z`: heights along a line.
void add_terrain_profile_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain ray FILE --from X,Y,Z --to X,Y,Z`: what a ray hits first.
void add_terrain_ray_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain los FILE --from X,Z,H --to X,Z,H`: whether two points see each other.
void add_terrain_los_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain viewshed FILE --observer X,Z -o out.tif`: which ground is seen from a point.
void add_terrain_viewshed_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain sky FILE -o out.tif`: how much of the sky the ground sees, and its horizons.
void add_terrain_sky_command(CLI::App& terrain, GlobalOptions& options);

/// `offing terrain sun FILE --from DATE --to DATE -o out.tif`: hours of sun, sunlight, and shadows by time.
void add_terrain_sun_command(CLI::App& terrain, GlobalOptions& options);

}  // namespace offing::cli
