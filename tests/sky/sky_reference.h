#pragma once

#include <array>
#include <functional>

#include "host/sky/atmosphere.h"

namespace offing::sky {

/// The air once more, in double precision and written apart from the kernels: densities by their formulas,
/// radii by Pythagoras, integrals in small steps without tables.
class SkyReference {
 public:
  explicit SkyReference(const Atmosphere& atmosphere) : a_(atmosphere) {}

  const Atmosphere& atmosphere() const { return a_; }

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

  double altitude_after(double altitude_m, double cosine, double distance_m) const;

  /// Share of light that passes along a ray that misses the ground, from its beginning to the end of the air.
  Spectrum transmittance(double altitude_m, double cosine) const;

  /// Share of the sun's disc above the horizon (as the kernels smooth it), times transmittance.
  Spectrum sunlight(double altitude_m, double sun_cosine) const;

  /// A ray by the cosines of its zenith angle, the sun's at its beginning, and the angle between the two.
  struct Ray {
    double altitude_m = 0.0;
    double cosine = 1.0, sun_cosine = 1.0, between = 1.0;
  };

  /// Isotropic radiance at an altitude and a sun's zenith cosine.
  using Isotropic = std::function<Spectrum(double altitude_m, double sun_cosine)>;

  /// What the air along a ray sends to its beginning, 1/sr for sunlight of illuminance 1: the sun's light
  /// scattered once, and `others` scattered on. Without the ground.
  Spectrum scattered(const Ray& ray, const Isotropic& others) const;

  /// Mean over all directions of light scattered twice and more, after Hillaire 2020.
  Spectrum scattered_more(double altitude_m, double sun_cosine) const;

 private:
  Atmosphere a_;
};

double rayleigh_phase(double cosine);
double aerosol_phase(double asymmetry, double cosine);

}  // namespace offing::sky
