#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/ocean/spectrum/wind.h"
#include "host/ocean/surface/water_optics.h"
#include "host/sky/clear_sky.h"
#include "host/terrain/lakes/lake_layer.h"

namespace offing::world {

/// A lake of a world: its water, the wind over it, and how clear it is.
struct LakeSettings {
  std::shared_ptr<const terrain::Lake> lake;
  ocean::Wind wind{.wind_speed_mps = 2.0};
  ocean::WaterType water = ocean::WaterType::oceanic_3;

  bool operator==(const LakeSettings&) const = default;
};

/// What a lake looks like in this light from an eye (x, y, z) m, in fixed axes. The longest waves are those
/// that the wind raises over a fetch as long as the lake is wide. The octaves from them down to 15 cm have
/// equal shares of the slope variance measured in such a wind (Cox & Munk 1954), and ripples have the rest.
/// Without wind the water is a mirror.
terrain::LakeLook look_of_lake(const LakeSettings& settings, const glm::dvec3& eye_m, double time_s,
                               const sky::Illuminance& light, double sun_rise);
/// look_of_lake() of each lake, in the same order.
std::vector<terrain::LakeLook> looks_of_lakes(std::span<const LakeSettings> lakes, const glm::dvec3& eye_m,
                                              double time_s, const sky::Illuminance& light, double sun_rise);

}  // namespace offing::world
