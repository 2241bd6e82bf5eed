#include "present/light_meter.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

constexpr int meter_columns = 9, meter_rows = 7;
// What the mean of the sky comes out at before the tone curve, where 1 is white.
constexpr double key = 0.36;
// Below this light, deep dusk, pictures grow dark as the eye's do.
constexpr double least_kcdpm2 = 1e-4;

std::vector<std::array<double, 3>> metered_directions(const Camera& camera) {
  std::vector<std::array<double, 3>> directions;
  for (int row = 0; row < meter_rows; ++row) {
    for (int column = 0; column < meter_columns; ++column) {
      const glm::dvec2 clip((2.0 * column + 1.0) / meter_columns - 1.0, (2.0 * row + 1.0) / meter_rows - 1.0);
      const glm::dvec3 ray = glm::normalize(ray_direction(camera, clip));
      // Water mirrors the sky above it; grazing rays see it higher up, where waves turn toward the eye.
      const glm::dvec3 seen = glm::normalize(glm::dvec3(ray.x, std::abs(ray.y) + 0.02, ray.z));
      directions.push_back({seen.x, seen.y, seen.z});
    }
  }
  return directions;
}

}  // namespace

double LightMeter::exposure(const sky::ClearSky& sky, const Camera& camera, double ev) {
  std::vector<std::array<double, 3>> directions = metered_directions(camera);
  if (sky.revision() != revision_ || directions != directions_) {
    double log_sum = 0.0;
    for (const sky::Rgb& light : sky.read_light(directions).sky_kcdpm2) {
      log_sum += std::log(sky::luminance(light) + least_kcdpm2);
    }
    mean_stops_ = log_sum / std::log(2.0) / static_cast<double>(directions.size());
    revision_ = sky.revision();
    directions_ = std::move(directions);
  }
  return key * std::exp2(ev - mean_stops_);
}

}  // namespace offing::present
