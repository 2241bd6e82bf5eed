#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "tests/sky/sky_reference.h"

namespace offing::sky {

/// Light scattered twice and more with the true phase functions and the true ground, by following random
/// paths from the eye; at one wavelength. What no isotropic approximation has a part in.
class SkyPaths {
 public:
  using Vector = std::array<double, 3>;

  SkyPaths(const Atmosphere& atmosphere, std::size_t wavelength, std::uint32_t seed)
      : air_(atmosphere), wavelength_(wavelength), random_(seed) {}

  struct Estimate {
    double mean = 0.0, standard_error = 0.0;
  };

  /// Radiance toward an eye from along a ray that misses the ground, 1/sr for sunlight of illuminance 1; y
  /// up.
  Estimate scattered_more(double eye_altitude_m, const Vector& view, const Vector& sun, int paths);

 private:
  double one_path(Vector position, Vector direction, const Vector& sun);
  double uniform() { return std::uniform_real_distribution<double>()(random_); }
  Vector turned(const Vector& direction, double cosine);
  double scattering_cosine(bool is_aerosol);
  double altitude_of(const Vector& position) const;

  SkyReference air_;
  std::size_t wavelength_;
  std::mt19937 random_;
};

}  // namespace offing::sky
