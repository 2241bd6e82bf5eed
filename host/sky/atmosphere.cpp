#include "host/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "host/base/parameter_check.h"

namespace offing::sky {
namespace {

void require_each_within(std::string_view name, const Spectrum& values, double low, double high) {
  for (const double value : values) require_within(name, value, low, high);
}

// Altitudes that an exponential layer counts for: its depth over its value at the ground.
double exponential_depth_m(double scale_height_m, double thickness_m) {
  return -scale_height_m * std::expm1(-thickness_m / scale_height_m);
}

// The same for a tent of height 1, cut off by the ground and the end of the air.
double tent_depth_m(double peak_m, double half_width_m, double thickness_m) {
  const auto from_peak_m = [half_width_m](double distance_m) {
    const double within_m = std::clamp(distance_m, -half_width_m, half_width_m);
    return within_m - 0.5 * within_m * std::abs(within_m) / half_width_m;
  };
  return from_peak_m(thickness_m - peak_m) - from_peak_m(-peak_m);
}

}  // namespace

void require_valid(const Atmosphere& atmosphere) {
  const Atmosphere& a = atmosphere;
  // Single precision and the step counts of the kernels hold for air as thin, beside its planet, as the
  // Earth's.
  require_within("sky.ground_radius_m", a.ground_radius_m, 1e6, 1e8);
  require_within("sky.thickness_m", a.thickness_m, 10e3, 200e3);
  require_each_within("sky.rayleigh_optical_depth", a.rayleigh_optical_depth, 0.0, 2.0);
  require_within("sky.rayleigh_scale_height_m", a.rayleigh_scale_height_m, 1000.0, 50e3);
  require_within("sky.aerosol_optical_depth", a.aerosol_optical_depth, 0.0, 2.0);
  require_within("sky.aerosol_scale_height_m", a.aerosol_scale_height_m, 500.0, 50e3);
  require_within("sky.aerosol_albedo", a.aerosol_albedo, 0.0, 1.0);
  require_within("sky.aerosol_asymmetry", a.aerosol_asymmetry, -0.95, 0.95);
  require_each_within("sky.ozone_optical_depth", a.ozone_optical_depth, 0.0, 2.0);
  require_within("sky.ozone_half_width_m", a.ozone_half_width_m, 1000.0, 100e3);
  require_within("sky.ozone_peak_m", a.ozone_peak_m, 0.0, a.thickness_m);
  require_each_within("sky.ground_albedo", a.ground_albedo, 0.0, 1.0);
  require_within("sky.sun_angular_radius_rad", a.sun_angular_radius_rad, 1e-3, 0.1);
}

AtmosphereParams atmosphere_params(const Atmosphere& atmosphere) {
  const Atmosphere& a = atmosphere;
  const auto single = [](double value) { return static_cast<float>(value); };
  const Spectrum& rayleigh = a.rayleigh_optical_depth;
  const double rayleigh_depth_m = exponential_depth_m(a.rayleigh_scale_height_m, a.thickness_m);
  const Spectrum& ozone = a.ozone_optical_depth;
  const double ozone_depth_m = tent_depth_m(a.ozone_peak_m, a.ozone_half_width_m, a.thickness_m);
  const double aerosol_extinction_perm =
      a.aerosol_optical_depth / exponential_depth_m(a.aerosol_scale_height_m, a.thickness_m);
  return {.ground_radius_m = single(a.ground_radius_m),
          .thickness_m = single(a.thickness_m),
          .rayleigh_scale_height_m = single(a.rayleigh_scale_height_m),
          .aerosol_scale_height_m = single(a.aerosol_scale_height_m),
          .rayleigh_scattering_0_perm = single(rayleigh[0] / rayleigh_depth_m),
          .rayleigh_scattering_1_perm = single(rayleigh[1] / rayleigh_depth_m),
          .rayleigh_scattering_2_perm = single(rayleigh[2] / rayleigh_depth_m),
          .rayleigh_scattering_3_perm = single(rayleigh[3] / rayleigh_depth_m),
          .ozone_absorption_0_perm = single(ozone[0] / ozone_depth_m),
          .ozone_absorption_1_perm = single(ozone[1] / ozone_depth_m),
          .ozone_absorption_2_perm = single(ozone[2] / ozone_depth_m),
          .ozone_absorption_3_perm = single(ozone[3] / ozone_depth_m),
          .ozone_peak_m = single(a.ozone_peak_m),
          .ozone_half_width_m = single(a.ozone_half_width_m),
          .aerosol_scattering_perm = single(a.aerosol_albedo * aerosol_extinction_perm),
          .aerosol_extinction_perm = single(aerosol_extinction_perm),
          .sun_angular_radius_rad = single(a.sun_angular_radius_rad),
          .padding = 0.0f,
          .ground_albedo_0 = single(a.ground_albedo[0]),
          .ground_albedo_1 = single(a.ground_albedo[1]),
          .ground_albedo_2 = single(a.ground_albedo[2]),
          .ground_albedo_3 = single(a.ground_albedo[3])};
}

Rgb rgb_of_sunlight(const Spectrum& share) {
  const SunlightColour colour;
  const auto sum = [&share](const Spectrum& channel_klx) {
    return std::inner_product(share.begin(), share.end(), channel_klx.begin(), 0.0);
  };
  return {sum(colour.red_klx), sum(colour.green_klx), sum(colour.blue_klx)};
}

double luminance(const Rgb& light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

}  // namespace offing::sky
