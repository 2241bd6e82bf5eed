#include "host/world/lake_look.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "host/base/numbers/normal_deviations.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/spectrum/slope_covariance.h"

namespace offing::world {
namespace {

constexpr double gravity_mps2 = ocean::Dispersion{}.gravity_mps2;
constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr int wave_count = 28;
constexpr double shortest_wave_radpm = turn_rad / 0.15;
constexpr double shortest_ripple_radpm = 3700.0;
constexpr double spread_rad = 0.6;  // of the directions of waves
// Of the light below the surface, what leaves upward.
constexpr double water_leaving_share = 0.54;

/// Below it the skin of water stays smooth.
constexpr double ruffling_wind_mps = 1.5;
/// Below it waves are no longer told from a mirror, and the laws of their growth leave the range of numbers.
constexpr double least_wind_mps = 1e-3;

/// The longest waves of a sea that has grown over so long a way (Hasselmann et al. 1973, JONSWAP).
double peak_radpm(double wind_mps, double fetch_m) {
  const double growth = gravity_mps2 * fetch_m / (wind_mps * wind_mps);
  const double omega_radps =
      turn_rad * 3.5 * gravity_mps2 / wind_mps * std::pow(std::max(growth, 1.0), -0.33);
  return omega_radps * omega_radps / gravity_mps2;
}

/// Evenly spread over 0 ... 1, and without order from one number to the next.
double spread_number(int i, double step) {
  const double value = (i + 1) * step;
  return value - std::floor(value);
}

}  // namespace

terrain::LakeLook look_of_lake(const LakeSettings& settings, const glm::dvec3& eye_m, double time_s,
                               const sky::Illuminance& light, double sun_rise) {
  const auto narrow = [](double value) { return static_cast<float>(value); };
  terrain::LakeLook look;
  const ocean::WaterOptics optics = ocean::water_optics(settings.water);
  const auto deep = [&](const sky::Rgb& klx, std::size_t c) {
    return narrow(water_leaving_share * optics.reflectance[c] / std::numbers::pi * klx[c]);
  };
  LakeWater& water = look.water;
  water.attenuation_red_perm = narrow(optics.attenuation_perm[0]);
  water.attenuation_green_perm = narrow(optics.attenuation_perm[1]);
  water.attenuation_blue_perm = narrow(optics.attenuation_perm[2]);
  water.of_sky_red_kcdpm2 = deep(light.sky_klx, 0);
  water.of_sky_green_kcdpm2 = deep(light.sky_klx, 1);
  water.of_sky_blue_kcdpm2 = deep(light.sky_klx, 2);
  const float rise = narrow(std::max(sun_rise, 0.0));
  water.of_sun_red_kcdpm2 = rise * deep(light.sun_klx, 0);
  water.of_sun_green_kcdpm2 = rise * deep(light.sun_klx, 1);
  water.of_sun_blue_kcdpm2 = rise * deep(light.sun_klx, 2);

  const double wind_mps = settings.wind.wind_speed_mps;
  if (wind_mps < least_wind_mps) return look;
  const ocean::SlopeCovariance all = ocean::measured_slopes(settings.wind);
  const double ruffled = std::min(wind_mps / ruffling_wind_mps, 1.0);
  const double longest_radpm =
      std::min(peak_radpm(wind_mps, std::sqrt(settings.lake->area_m2)), 0.5 * shortest_wave_radpm);
  const double of_waves =
      std::log(shortest_wave_radpm / longest_radpm) / std::log(shortest_ripple_radpm / longest_radpm);
  water.ripples_xx = narrow(ruffled * (1.0 - of_waves) * all.xx);
  water.ripples_xz = narrow(ruffled * (1.0 - of_waves) * all.xz);
  water.ripples_zz = narrow(ruffled * (1.0 - of_waves) * all.zz);
  const double slope = std::sqrt(2.0 * ruffled * of_waves * all.mean_square() / wave_count);
  for (int i = 0; i < wave_count; ++i) {
    const double share = (i + spread_number(i, 0.7548776662466927)) / wave_count;
    const double k_radpm = longest_radpm * std::pow(shortest_wave_radpm / longest_radpm, share);
    const double direction_rad =
        settings.wind.wind_direction_rad +
        spread_rad * deviations_below(std::clamp(spread_number(i, 0.5698402909980532), 0.02, 0.98));
    const double kx_radpm = k_radpm * std::cos(direction_rad), kz_radpm = k_radpm * std::sin(direction_rad);
    const double phase_rad = kx_radpm * eye_m.x + kz_radpm * eye_m.z -
                             std::sqrt(gravity_mps2 * k_radpm) * time_s +
                             turn_rad * spread_number(i, 0.6180339887498949);
    look.waves.push_back(
        {narrow(kx_radpm), narrow(kz_radpm), narrow(slope), narrow(std::remainder(phase_rad, turn_rad))});
  }
  return look;
}

std::vector<terrain::LakeLook> looks_of_lakes(std::span<const LakeSettings> lakes, const glm::dvec3& eye_m,
                                              double time_s, const sky::Illuminance& light, double sun_rise) {
  std::vector<terrain::LakeLook> looks;
  for (const LakeSettings& each : lakes) looks.push_back(look_of_lake(each, eye_m, time_s, light, sun_rise));
  return looks;
}

}  // namespace offing::world
