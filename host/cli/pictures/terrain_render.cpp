#include "host/cli/pictures/terrain_render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

#include <glm/geometric.hpp>

#include "host/base/parallel_for.h"
#include "host/sky/sun_position.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/cast/step_colours.h"

namespace offing::cli {
namespace {

// Of a level surface of mean ground, what it comes out at before the tone curve, where 1 is white.
constexpr double key = 0.3;
constexpr double mean_albedo = 0.18;
constexpr double least_klx = 1e-4;

/// Display value of a radiance, still linear light.
glm::vec3 tone_mapped(glm::vec3 radiance) {
  constexpr float exposure = 0.6f;  // the horizon sky lands at about 0.8 of display white
  radiance *= exposure;
  return {filmic(radiance.x), filmic(radiance.y), filmic(radiance.z)};
}

void store(RgbImage& image, std::size_t pixel, glm::vec3 linear, float noise) {
  image.rgb[3 * pixel] = dithered_srgb(linear.x, noise);
  image.rgb[3 * pixel + 1] = dithered_srgb(linear.y, noise);
  image.rgb[3 * pixel + 2] = dithered_srgb(linear.z, noise);
}

/// Directions of the pixels that the ground does not cover.
std::vector<std::array<double, 3>> open_directions(const Camera& camera,
                                                   const std::vector<terrain::Texel>& terrain) {
  std::vector<std::array<double, 3>> directions;
  for (std::size_t pixel = 0; pixel < terrain.size(); ++pixel) {
    if (terrain[pixel][3] >= 1.0f) continue;
    const auto width = static_cast<std::size_t>(camera.width_px);
    const glm::dvec2 clip(2.0 * (static_cast<double>(pixel % width) + 0.5) / camera.width_px - 1.0,
                          1.0 - 2.0 * (static_cast<double>(pixel / width) + 0.5) / camera.height_px);
    // Beyond a map on land there is haze, as at the horizon.
    constexpr double horizon = 0.002;
    glm::dvec3 ray = glm::normalize(ray_direction(camera, clip));
    ray.y = std::max(ray.y, horizon);
    ray = glm::normalize(ray);
    directions.push_back({ray.x, ray.y, ray.z});
  }
  return directions;
}

/// How far the ground is below the eye; infinite where there is none.
template <class Field>
double above_ground_m(Field& field, const Camera& camera) {
  return field.cast(std::vector<terrain::Ray>{{.origin_m = camera.eye_m}}).front().distance_m;
}

template <class Field>
void draw_light(const ocl::Device& device, const Field& field, const Camera& camera,
                const TerrainScenery& scenery, const terrain::ReliefSurface& relief,
                ocl::Buffer<TerrainHit>& hits, terrain::LakeLayer* lakes, TerrainRender& picture) {
  const sky::Atmosphere atmosphere;
  sky::ClearSky sky(device, atmosphere);
  sky.at({.sun_direction = sky::direction_of(scenery.sun_azimuth_rad, scenery.sun_elevation_rad)},
         std::max(0.0, camera.eye_m.y - scenery.lines.sea_level_m));
  const sky::Illuminance at_eye = sky.read_illuminance();
  // Heights of maps are measured from the sea level, 0.
  const TerrainLight light = world::terrain_light(at_eye, atmosphere, scenery.lines, 0.0);
  ocl::Buffer<terrain::Texel> terrain(device, hits.size(), "terrain image");
  std::optional<terrain::ColourLayer> colours;
  std::optional<terrain::OpenSky> open_sky;
  terrain::TerrainAppearance look{.sampling = scenery.sampling,
                                  .sea_goes_on = scenery.sea_goes_on,
                                  .relief = &relief,
                                  .finest_detail_m = scenery.finest_detail_m};
  if (scenery.colours) look.colours = &colours.emplace(device, *scenery.colours);
  if constexpr (std::is_same_v<Field, terrain::HeightField>) {
    if (scenery.sees_horizons) look.open_sky = &open_sky.emplace(device, field);
  }
  const std::vector<terrain::Material> laid =
      terrain::materials_of(scenery.landscape, world::landscape_lines(scenery.lines));
  std::optional<terrain::MaterialLayer> materials;
  if (!laid.empty()) look.materials = &materials.emplace(device, laid);
  std::optional<terrain::CanopyLayer> canopy;
  if (scenery.canopy) look.canopy = &canopy.emplace(device, *scenery.canopy);
  if (lakes != nullptr) {
    lakes->set_looks(
        world::looks_of_lakes(scenery.lakes, camera.eye_m, 0.0, at_eye, std::sin(scenery.sun_elevation_rad)));
    look.lakes = lakes;
    for (const TerrainHit& hit : hits.read()) picture.distances_m.push_back(hit.distance_m);
    ocl::Buffer<float> distances(device, picture.distances_m, "distances");
    lakes->stand_before(field, camera, hits, distances);
    picture.distances_m = distances.read();
  }
  terrain::TerrainShade shade(device);
  shade.at(field, camera, hits, {light, sky.params(), sky.view_table()}, terrain, look);
  picture.refined_share = shade.refined_share();
  std::vector<terrain::Texel> texels = terrain.read();
  const sky::SkyLight seen = sky.read_light(open_directions(camera, texels));
  std::size_t next_open = 0;
  for (terrain::Texel& texel : texels) {
    const float open = 1.0f - texel[3];
    if (open <= 0.0f) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      texel[i] += open * static_cast<float>(seen.sky_kcdpm2[next_open][i] + seen.sun_kcdpm2[next_open][i]);
    }
    ++next_open;
  }

  const double level_sun = std::max(0.0, std::sin(scenery.sun_elevation_rad));
  const double level_klx =
      sky::luminance(at_eye.sun_klx) * level_sun + sky::luminance(at_eye.sky_klx) + least_klx;
  const auto exposure =
      static_cast<float>(key * std::exp2(scenery.exposure_ev) / (mean_albedo / 3.14159265358979 * level_klx));
  parallel_rows(camera.height_px, [&](int row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width_px) +
                                static_cast<std::size_t>(column);
      const terrain::Texel& light_there = texels[pixel];
      const glm::vec3 exposed = exposure * glm::vec3(light_there[0], light_there[1], light_there[2]);
      store(picture.image, pixel, tone_mapped(exposed), dither_noise(column, row));
    }
  });
}

template <class Field>
TerrainRender draw(const ocl::Device& device, Field& field, const Camera& camera,
                   const TerrainScenery& scenery, TerrainShow show) {
  const auto width = static_cast<std::size_t>(camera.width_px),
             height = static_cast<std::size_t>(camera.height_px);
  ocl::Buffer<TerrainHit> hits_on_device(device, width * height, "terrain hits");
  terrain::ReliefSurface relief(device);
  const terrain::ReliefSettings settings = scenery.relief_settings();
  std::optional<terrain::LakeLayer> lakes;
  if (!settings.lakes.empty()) lakes.emplace(device, settings.lakes);
  relief.at(field, camera, above_ground_m(field, camera), settings, lakes ? &*lakes : nullptr);
  field.cast(camera, relief, hits_on_device);
  TerrainRender picture;
  picture.image = {camera.width_px, camera.height_px, std::vector<std::uint8_t>(3 * width * height)};
  if (show == TerrainShow::light) {
    draw_light(device, field, camera, scenery, relief, hits_on_device, lakes ? &*lakes : nullptr, picture);
  }
  // With crowns of woods, which light has found.
  const std::vector<TerrainHit> hits = hits_on_device.read();
  picture.distances_m.resize(hits.size(), std::numeric_limits<float>::infinity());
  for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
    const TerrainHit& hit = hits[pixel];
    picture.distances_m[pixel] = std::min(picture.distances_m[pixel], hit.distance_m);
    if (show == TerrainShow::steps) {
      const auto [red, green, blue] = terrain::step_colour(static_cast<float>(hit.steps));
      store(picture.image, pixel, {red, green, blue}, 0.0f);
    }
    picture.terrain_pixels += hit.kind == TERRAIN_MISS ? 0 : 1;
    picture.mean_steps += hit.steps / static_cast<double>(hits.size());
  }
  return picture;
}

}  // namespace

terrain::ReliefSettings TerrainScenery::relief_settings() const {
  terrain::ReliefSettings settings = world::relief_of(lines, relief);
  for (const world::LakeSettings& each : lakes) settings.lakes.push_back(each.lake);
  settings.materials = terrain::materials_of(landscape, world::landscape_lines(lines));
  return settings;
}

TerrainRender draw_terrain(const ocl::Device& device, terrain::HeightField& field, const Camera& camera,
                           const TerrainScenery& scenery, TerrainShow show) {
  return draw(device, field, camera, scenery, show);
}

TerrainRender draw_terrain(const ocl::Device& device, terrain::TiledField& field, const Camera& camera,
                           const TerrainScenery& scenery, TerrainShow show) {
  return draw(device, field, camera, scenery, show);
}

}  // namespace offing::cli
