#pragma once

namespace offing::ocean {

/// Wind over a sea.
struct Wind {
  double wind_speed_mps = 10.0;
  double wind_direction_rad = 0.0;  ///< of travel, from +x toward +z

  bool operator==(const Wind&) const = default;
};

}  // namespace offing::ocean
