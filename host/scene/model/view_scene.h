#pragma once

#include <numbers>
#include <optional>

#include "host/base/camera.h"
#include "host/base/utc_time.h"
#include "host/sky/atmosphere.h"
#include "host/sky/sun_position.h"
#include "host/terrain/walk/walker.h"

namespace offing::scene {

/// How the camera of a window moves.
enum class CameraMode { fly, walk };

/// What a scene says about its pictures: eye, sun, air and exposure. At one time: view_at() (moving_view.h).
struct ViewScene {
  Camera camera{.eye_m = {0.0, 5.0, 0.0},
                .pitch_rad = -std::numbers::pi / 90.0,
                .vertical_field_of_view_rad = std::numbers::pi / 4.0};
  CameraMode mode = CameraMode::fly;
  terrain::WalkerParameters walker;
  double walking_mps = 1.5;
  sky::SunAngles sun_direction{.azimuth_rad = std::numbers::pi / 4.0,
                               .elevation_rad = std::numbers::pi / 6.0};
  double sun_distance_au = 1.0;
  std::optional<UtcTime> sun_time_utc;  ///< the sun stands where it does at this time, seen from the origin
  double sun_time_scale = 0.0;          ///< seconds that pass for the sun in one of the scene
  sky::Atmosphere atmosphere;           ///< its aerosols; what follows is for atmosphere_of() to take in
  double ozone_du = 300.0;
  double pressure_pa = 101'325.0;
  std::optional<double> ground_albedo;  ///< absent: that of clear sea water
  double exposure_ev = 0.0;             ///< stops above the exposure that the light at the eye asks for
};

/// The sun of a view.
sky::Sun sun_of(const ViewScene& view);

/// The air of a view. Throws nothing; require_valid() holds for values of the parameter table.
sky::Atmosphere atmosphere_of(const ViewScene& view);

}  // namespace offing::scene
