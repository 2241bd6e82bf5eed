#pragma once

#include "host/cli/pictures/preview_surface.h"
#include "host/cli/pictures/vector3.h"

namespace offing::cli {

/// Sun, a plain clear sky and what the sea makes of them. Radiances are linear and relative: the sky over the
/// horizon is about 1. A picture to judge waves by, not a measurement of light.
class PreviewLight {
 public:
  /// `ripple_variance` is added to the slope variance that a SurfaceSample brings.
  PreviewLight(double sun_azimuth_rad, double sun_elevation_rad, double ripple_variance);

  /// Radiance from a unit direction; below the horizon that of the horizon. Without the sun's disc.
  Vec3 sky(Vec3 direction) const;
  /// The disc of the sun itself, where this direction meets it.
  Vec3 sun_disc(Vec3 direction) const;

  /// Radiance of the sea toward `to_eye` (unit). `foam_opacity` is what hides the water, 0 ... 1.
  Vec3 sea(const SurfaceSample& surface, Vec3 to_eye, float foam_opacity) const;

  /// `radiance` seen through `distance_m` of air along `direction` (unit).
  Vec3 through_air(Vec3 radiance, Vec3 direction, float distance_m) const;

 private:
  Vec3 reflected(const SurfaceSample& surface, Vec3 to_eye, float& reflectance, float& visible_area) const;
  Vec3 glitter(const SurfaceSample& surface, Vec3 to_eye, float visible_area) const;

  float ripple_variance_;
  Vec3 to_sun_;
  Vec3 sun_irradiance_;
};

/// Display value 0 ... 1 of a radiance: a film-like curve (Narkowicz 2015, "ACES filmic tone mapping curve"),
/// still linear light.
Vec3 tone_mapped(Vec3 radiance);

}  // namespace offing::cli
