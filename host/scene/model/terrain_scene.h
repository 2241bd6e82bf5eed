#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/io/height_maps/height_map_options.h"
#include "host/ocean/surface/water_optics.h"
#include "host/terrain/generate/fractal_terrain.h"
#include "host/terrain/shading/canopy.h"
#include "host/terrain/shading/materials.h"

namespace offing::scene {

/// Whether ground around a place hides the sky's light from it.
enum class SkyVisibility { off, on };

/// [terrain.canopy]: woods over the ground.
struct CanopyScene {
  std::string map;       ///< picture of the cover; empty: where the rules say
  terrain::Canopy wood;  ///< without its map
};

/// The terrain of a scene: a file of heights or, without one, generated terrain.
struct TerrainScene {
  bool is_given = false;  ///< the scene has a [terrain] section
  std::string file;       ///< height map or tile store; empty: generated terrain
  HeightMapOptions reading;
  int cache_mb = 256;  ///< for the tiles of a store, MiB
  terrain::FractalParameters fractal;
  std::optional<double> origin_x_m, origin_z_m;  ///< of the first post; absent: the map's middle is at 0
  double water_line_m = 0.0;                     ///< ground at or below is water, where there is no sea
  std::optional<double> tree_line_m, snow_line_m;
  std::string colour;  ///< picture of the ground from above; empty: cover by height
  SkyVisibility sky_visibility = SkyVisibility::off;
  terrain::Landscape landscape = terrain::Landscape::plain;
  std::vector<terrain::Material> materials;  ///< [[terrain.material]]: over those of the landscape
  CanopyScene canopy;
  double relief = 1.0;           ///< strength of relief between posts, near the eye; 0: none
  double finest_detail_m = 0.0;  ///< patterns of the ground that are finer show as their mean
};

/// [[lake]]: still water in a basin of the terrain.
struct LakeScene {
  std::string name;
  double x_m = 0.0, z_m = 0.0;    ///< a place in it
  std::optional<double> level_m;  ///< absent: as full as its basin holds
  double wind_speed_mps = 2.0;
  double wind_direction_rad = 0.0;  ///< of travel, from +x toward +z
  ocean::WaterType water = ocean::WaterType::oceanic_3;
};

}  // namespace offing::scene
