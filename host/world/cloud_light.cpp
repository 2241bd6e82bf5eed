#include "host/world/cloud_light.h"

#include <algorithm>
#include <numbers>

namespace offing::world {

namespace {

constexpr double lowest_m = 1.0, highest_m = 50e3;  // of clouds, within the air

glm::dvec3 vector_of(const sky::Rgb& light) {
  return {light[0], light[1], light[2]};
}

/// Of red, green and blue: the wavelengths of the sky that lie there.
glm::dvec3 albedo_of(const sky::Atmosphere& atmosphere) {
  const sky::Spectrum& albedo = atmosphere.ground_albedo;
  return {albedo[0], 0.5 * (albedo[1] + albedo[2]), albedo[3]};
}

sky::Illuminance light_at(sky::ClearSky& sky, const CloudSunlight& sun, double altitude_m) {
  sky.at({.sun_direction = sun.direction, .sun_distance_au = sun.distance_au, .eye_altitude_m = altitude_m});
  return sky.read_illuminance();
}

}  // namespace

clouds::CloudIllumination cloud_illumination(sky::ClearSky& sky, const sky::Atmosphere& atmosphere,
                                             const CloudSunlight& sun, double altitude_m) {
  const sky::Illuminance above = light_at(sky, sun, std::clamp(altitude_m, lowest_m, highest_m));
  const sky::Illuminance below = light_at(sky, sun, lowest_m);
  clouds::CloudIllumination light;
  const auto& [x, y, z] = sun.direction;
  const glm::dvec3 sun_klx = vector_of(above.sun_klx);
  if (sky::luminance(above.sun_klx) > 0.0)
    light.suns.push_back({.direction = {x, y, z}, .illuminance_klx = sun_klx});
  // A surface under light of one radiance from everywhere above has pi times it.
  light.sky_kcdpm2 = vector_of(above.sky_klx) / std::numbers::pi;
  const glm::dvec3 on_ground_klx = vector_of(below.sun_klx) * std::max(y, 0.0) + vector_of(below.sky_klx);
  light.ground_kcdpm2 = albedo_of(atmosphere) * on_ground_klx / std::numbers::pi;
  return light;
}

}  // namespace offing::world
