#include "present/passes/sky/light_meter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

constexpr int meter_columns = 9, meter_rows = 7;
// What the mean of the sky comes out at before the tone curve, where 1 is white.
constexpr double key = 0.36;
// What white in all the light on meshes comes out at: colours in half of it are half as bright.
constexpr double mesh_key = 1.8;
// Below this light, deep dusk, pictures grow dark as the eye's do.
constexpr double least_kcdpm2 = 1e-4;

// Of ground between woods and scree.
constexpr double mean_albedo = 0.2;

double level_ground_kcdpm2(const world::World& world) {
  const sky::Illuminance& light = world.illuminance();
  const double level_sun = std::max(0.0, static_cast<double>(world.sky().params().sun_direction_y));
  return mean_albedo / std::numbers::pi *
         (level_sun * sky::luminance(light.sun_klx) + sky::luminance(light.sky_klx));
}

/// Light of a white surface that faces all light there is.
double white_kcdpm2(const world::World& world) {
  double sum_klx = sky::luminance(world.illuminance().sky_klx) + sky::luminance(world.illuminance().sun_klx);
  for (const world::Light& light : world.parameters().lights) {
    const glm::dvec3 klx = light.illuminance_klx * light.colour;
    sum_klx += sky::luminance({klx.r, klx.g, klx.b});
  }
  return sum_klx / std::numbers::pi;
}

std::vector<std::array<double, 3>> metered_directions(const Camera& camera, bool has_water) {
  std::vector<std::array<double, 3>> directions;
  for (int row = 0; row < meter_rows; ++row) {
    for (int column = 0; column < meter_columns; ++column) {
      const glm::dvec2 clip((2.0 * column + 1.0) / meter_columns - 1.0, (2.0 * row + 1.0) / meter_rows - 1.0);
      const glm::dvec3 ray = glm::normalize(ray_direction(camera, clip));
      // Water mirrors the sky above it; grazing rays see it higher up, where waves turn toward the eye.
      const glm::dvec3 mirrored = glm::normalize(glm::dvec3(ray.x, std::abs(ray.y) + 0.02, ray.z));
      const glm::dvec3 seen = has_water || ray.y >= 0.0 ? mirrored : ray;
      directions.push_back({seen.x, seen.y, seen.z});
    }
  }
  return directions;
}

}  // namespace

double LightMeter::exposure(const world::World& world, const Camera& camera, double ev) {
  if (!world.meshes().empty() && !world.has_sea() && !world.terrain()) {
    return mesh_key * std::exp2(ev) / (white_kcdpm2(world) + least_kcdpm2);
  }
  const sky::ClearSky& sky = world.sky();
  const bool has_water = world.has_sea() || !world.terrain();
  std::vector<std::array<double, 3>> directions = metered_directions(camera, has_water);
  if (sky.revision() != revision_ || directions != directions_ || has_water != has_water_) {
    const double ground_kcdpm2 = level_ground_kcdpm2(world);
    const sky::SkyLight light = sky.read_light(directions);
    double log_sum = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const bool is_ground = !has_water && directions[i][1] < 0.0;
      const double seen_kcdpm2 = is_ground ? ground_kcdpm2 : sky::luminance(light.sky_kcdpm2[i]);
      log_sum += std::log(seen_kcdpm2 + least_kcdpm2);
    }
    mean_stops_ = log_sum / std::log(2.0) / static_cast<double>(directions.size());
    revision_ = sky.revision();
    has_water_ = has_water;
    directions_ = std::move(directions);
  }
  return key * std::exp2(ev - mean_stops_);
}

}  // namespace offing::present
