#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "host/ocean/surface/water_optics.h"

namespace offing::scene {

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
