#pragma once

#include <array>

#include "host/sky/atmosphere.h"

namespace offing::sky {

/// The air once more, in double precision and written apart from the kernels: densities and optical depths by
/// their formulas, integrals by Simpson's rule over the altitude, the sun a point except at the horizon.
class SkyReference {
 public:
  explicit SkyReference(const Atmosphere& atmosphere) : a_(atmosphere) {}

  struct Coefficients {
    Spectrum rayleigh_perm{};
    double aerosol_perm = 0.0;
    Spectrum extinction_perm{};
  };
  Coefficients at_altitude(double altitude_m) const;

  /// Where a ray of this zenith angle ends, and whether on the ground.
  struct End {
    double distance_m = 0.0;
    bool on_ground = false;
  };
  End end_of(double altitude_m, double cosine) const;

  double altitude_m(double altitude_m, double cosine, double distance_m) const;

  /// Share of light that passes along a ray that misses the ground, from its beginning to the end of the air.
  Spectrum transmittance(double altitude_m, double cosine) const;

  /// Light scattered once toward an eye, without the ground: radiance for sunlight of illuminance 1, 1/sr.
  Spectrum scattered_once(double eye_altitude_m, double cosine, double sun_cosine, double between) const;

  /// Share of the sun's disc above the horizon (as the kernels smooth it), times transmittance.
  Spectrum sunlight(double altitude_m, double sun_cosine) const;

 private:
  Atmosphere a_;
};

double rayleigh_phase(double cosine);
double aerosol_phase(double asymmetry, double cosine);

}  // namespace offing::sky
