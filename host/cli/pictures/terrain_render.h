#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "host/base/camera.h"
#include "host/base/colour_map.h"
#include "host/io/png_image.h"
#include "host/sky/clear_sky.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"
#include "host/world/lake_look.h"
#include "host/world/terrain_light.h"

namespace offing::cli {

/// What a picture of the ground is lit by.
struct TerrainScenery {
  double sun_azimuth_rad = 225.0 * std::numbers::pi / 180.0;  ///< clockwise from north
  double sun_elevation_rad = 30.0 * std::numbers::pi / 180.0;
  world::CoverLines lines = {};
  double exposure_ev = 0.0;  ///< stops above what the light asks for
  terrain::Sampling sampling = {};
  std::optional<ColourMap> colours = {};  ///< none: cover by height and slope
  bool sea_goes_on = false;               ///< whether a sea lies beyond the map, at the level of its water
  bool sees_horizons = true;              ///< whether ground hides the sky from ground
  std::vector<world::LakeSettings> lakes = {};
  terrain::Landscape landscape = terrain::Landscape::plain;
  std::optional<terrain::Canopy> canopy = {};  ///< woods; none: there are none
  double relief = 1.0;                         ///< strength of relief between posts, near the eye
  double finest_detail_m = 0.0;                ///< patterns of the ground that are finer show as their mean

  terrain::ReliefSettings relief_settings() const;
};

/// What a picture shows.
enum class TerrainShow { light, steps };

struct TerrainRender {
  RgbImage image;
  std::vector<float> distances_m;  ///< [height][width] along each pixel's unit ray, +inf where it misses
  std::size_t terrain_pixels = 0;
  double mean_steps = 0.0;
  double refined_share = 0.0;  ///< of the pixels, those that got rays of their own
};

/// The ground before a clear sky, as a camera sees it; or the steps that its rays took (T11), from blue
/// (none) through green (16) and yellow to red (80 and more).
TerrainRender draw_terrain(const ocl::Device& device, terrain::HeightField& field, const Camera& camera,
                           const TerrainScenery& scenery, TerrainShow show);
/// The same of the tiles of the field's last look().
TerrainRender draw_terrain(const ocl::Device& device, terrain::TiledField& field, const Camera& camera,
                           const TerrainScenery& scenery, TerrainShow show);

}  // namespace offing::cli
