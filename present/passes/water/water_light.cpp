#include "present/passes/water/water_light.h"

#include <algorithm>
#include <numbers>

#include "host/ocean/surface/water_optics.h"

namespace offing::present {

WaterLight water_light(const world::World& world) {
  const sky::Illuminance& light = world.illuminance();
  const float rise = std::max(0.0f, world.sky().params().sun_direction_y);
  const ocean::WaterOptics optics = ocean::water_optics(world.parameters().water);
  WaterLight water{};
  for (int channel = 0; channel < 3; ++channel) {
    const auto c = static_cast<std::size_t>(channel);
    const float returned =
        water_leaving_share * static_cast<float>(optics.reflectance[c]) / std::numbers::pi_v<float>;
    water.attenuation_perm[channel] = static_cast<float>(optics.attenuation_perm[c]);
    water.of_sky_kcdpm2[channel] = returned * static_cast<float>(light.sky_klx[c]);
    water.of_sun_kcdpm2[channel] = returned * static_cast<float>(light.sun_klx[c]) * rise;
  }
  return water;
}

}  // namespace offing::present
