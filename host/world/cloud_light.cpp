#include "host/world/cloud_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::world {

namespace {

constexpr double lowest_m = 1.0, highest_m = 50e3;  // of clouds, within the air
constexpr double step_m = 500.0;

glm::dvec3 vector_of(const sky::Rgb& light) {
  return {light[0], light[1], light[2]};
}

/// Of red, green and blue: the wavelengths of the sky that lie there.
glm::dvec3 albedo_of(const sky::Atmosphere& atmosphere) {
  const sky::Spectrum& albedo = atmosphere.ground_albedo;
  return {albedo[0], 0.5 * (albedo[1] + albedo[2]), albedo[3]};
}

sky::Illuminance light_at(sky::ClearSky& sky, const sky::Sun& sun, double altitude_m) {
  sky.at(sun, altitude_m);
  return sky.read_illuminance();
}

}  // namespace

std::vector<clouds::CloudIllumination> cloud_illumination(sky::ClearSky& sky,
                                                          const sky::Atmosphere& atmosphere,
                                                          const sky::Sun& sun,
                                                          std::span<const double> altitudes_m) {
  // Between two steps the light is mixed.
  const auto steps_up = [](double altitude_m) {
    return std::clamp(altitude_m, lowest_m, highest_m) / step_m;
  };
  std::map<double, sky::Illuminance> above;
  for (const double altitude_m : altitudes_m) {
    above.try_emplace(std::floor(steps_up(altitude_m)));
    above.try_emplace(std::ceil(steps_up(altitude_m)));
  }
  for (auto& [step, light] : above) light = light_at(sky, sun, std::max(step * step_m, lowest_m));
  const sky::Illuminance below = light_at(sky, sun, lowest_m);
  const auto& [x, y, z] = sun.sun_direction;
  const glm::dvec3 on_ground_klx = vector_of(below.sun_klx) * std::max(y, 0.0) + vector_of(below.sky_klx);
  std::vector<clouds::CloudIllumination> lights;
  for (const double altitude_m : altitudes_m) {
    const double steps = steps_up(altitude_m);
    const sky::Illuminance &lower = above.at(std::floor(steps)), &upper = above.at(std::ceil(steps));
    const auto between = [&](const sky::Rgb& a, const sky::Rgb& b) {
      return glm::mix(vector_of(a), vector_of(b), steps - std::floor(steps));
    };
    clouds::CloudIllumination& light = lights.emplace_back();
    const glm::dvec3 sun_klx = between(lower.sun_klx, upper.sun_klx);
    if (std::max({sun_klx.x, sun_klx.y, sun_klx.z}) > 0.0)
      light.suns.push_back({.direction = {x, y, z}, .illuminance_klx = sun_klx});
    // A surface under light of one radiance from everywhere above has pi times it.
    light.sky_kcdpm2 = between(lower.sky_klx, upper.sky_klx) / std::numbers::pi;
    light.ground_kcdpm2 = albedo_of(atmosphere) * on_ground_klx / std::numbers::pi;
  }
  return lights;
}

std::vector<clouds::CloudIllumination> with_lights(std::vector<clouds::CloudIllumination> illumination,
                                                   std::span<const Light> lights,
                                                   std::span<const glm::dvec3> places_m) {
  for (const Light& light : lights.first(std::min(lights.size(), most_lights_on_clouds))) {
    const glm::dvec3 klx = light.illuminance_klx * light.colour;
    if (klx == glm::dvec3(0.0)) continue;
    for (std::size_t cloud = 0; cloud < illumination.size(); ++cloud) {
      const bool is_place = light.source.kind == highlights::Source::Kind::place;
      const glm::dvec3 way = is_place ? light.source.vector - places_m[cloud] : light.source.vector;
      const double length = glm::length(way);
      std::vector<clouds::CloudLight>& suns = illumination[cloud].suns;
      if (suns.empty()) suns.emplace_back();
      // One in a cloud's very middle stands above it.
      suns.push_back(
          {.direction = length > 0.0 ? way / length : glm::dvec3(0.0, 1.0, 0.0), .illuminance_klx = klx});
    }
  }
  return illumination;
}

}  // namespace offing::world
