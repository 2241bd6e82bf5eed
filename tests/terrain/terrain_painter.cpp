#include "tests/terrain/terrain_painter.h"

#include <algorithm>
#include <cmath>

#include "host/terrain/cast/image_rays.h"
#include "host/terrain/cast/mirrored_cast.h"

namespace offing::test {
namespace {

using terrain::Texel;

SkyParams sky_of(const PaintedTerrain& scene) {
  SkyParams sky{};
  sky.sun_direction_x = static_cast<float>(std::cos(scene.sun_elevation_rad));
  sky.sun_direction_y = static_cast<float>(std::sin(scene.sun_elevation_rad));
  sky.sun_angular_radius_rad = static_cast<float>(scene.sun_radius_rad);
  sky.ground_radius_m = 6.36e6f;
  sky.eye_altitude_m = 2.0f;
  return sky;
}

std::vector<Texel> sky_table(float haze) {
  std::vector<Texel> table(SKY_VIEW_COLUMNS * SKY_VIEW_ROWS * SKY_VIEW_LAYERS, Texel{});
  std::fill_n(table.begin(), SKY_VIEW_COLUMNS * SKY_VIEW_ROWS, Texel{haze, haze, haze, 0.0f});
  return table;
}

}  // namespace

TerrainLight PaintedTerrain::clear_light() {
  TerrainLight light{};
  light.sun_red_klx = 100.0f;
  light.sky_red_klx = 10.0f;
  light.rayleigh_scale_height_m = 8000.0f;
  light.aerosol_scale_height_m = 1200.0f;
  light.sea_level_m = 1000.0f;
  return light;
}

PaintedTerrain PaintedTerrain::covered(const HeightMap& map) {
  PaintedTerrain scene;
  const auto [lowest, highest] = std::minmax_element(map.heights_m.begin(), map.heights_m.end());
  TerrainLight& light = scene.light;
  light.sun_red_klx = light.sun_green_klx = light.sun_blue_klx = 90.0f;
  light.sky_red_klx = light.sky_green_klx = light.sky_blue_klx = 12.0f;
  light.aerosol_perm = 1e-4f;
  light.sea_level_m = 0.9f * *lowest + 0.1f * *highest;
  light.tree_line_m = 0.6f * *lowest + 0.4f * *highest;
  light.snow_line_m = 0.3f * *lowest + 0.7f * *highest;
  return scene;
}

TerrainPainter::TerrainPainter(const HeightMap& map, const PaintedTerrain& scene)
    : device_(ocl::Device::open()),
      field_(device_, map.grid, map.heights_m),
      shade_(device_),
      relief_(device_),
      light_(scene.light),
      sky_(sky_of(scene)),
      view_table_(device_, sky_table(scene.haze_kcdpm2), "sky") {}

std::vector<Texel> TerrainPainter::draw(const Camera& camera, terrain::TerrainAppearance look) {
  const std::size_t pixels = terrain::pixel_count(camera);
  ocl::Buffer<TerrainHit>& hits = hits_.emplace(device_, pixels, "hits");
  ocl::Buffer<Texel> image(device_, pixels, "image");
  const std::vector<terrain::Ray> down{{.origin_m = camera.eye_m}};
  if (relief_settings_.strength > 0.0)
    relief_.at(field_, camera, field_.cast(down).front().distance_m, relief_settings_);
  look.relief = &relief_;
  field_.cast(camera, relief_, hits);
  shade_.at(field_, camera, hits, {light_, sky_, view_table_}, image, look);
  return image.read();
}

std::vector<Texel> TerrainPainter::draw_mirrored(const Camera& mirrored, double plane_m) {
  const std::size_t pixels = terrain::pixel_count(mirrored);
  ocl::Buffer<TerrainHit>& hits = hits_.emplace(device_, pixels, "hits");
  ocl::Buffer<Texel> image(device_, pixels, "image");
  terrain::MirroredCast(device_).at(field_, mirrored, plane_m, hits);
  shade_.at(field_, mirrored, hits, {light_, sky_, view_table_}, image, {.sampling = {.rays = 1}});
  return image.read();
}

}  // namespace offing::test
