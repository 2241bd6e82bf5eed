#include "host/world/terrain_light.h"

#include <algorithm>
#include <cmath>

namespace offing::world {

CoverLines cover_lines(double latitude_deg) {
  constexpr double highest_m = 5000.0, tropics_deg = 25.0, at_the_sea_deg = 75.0, below_snow_m = 800.0;
  const double share =
      std::clamp((at_the_sea_deg - std::abs(latitude_deg)) / (at_the_sea_deg - tropics_deg), 0.0, 1.0);
  return {.tree_line_m = highest_m * share - below_snow_m, .snow_line_m = highest_m * share};
}

terrain::LandscapeLines landscape_lines(const CoverLines& lines) {
  return {.shore_m = std::max(lines.sea_level_m, lines.beach_line_m), .tree_line_m = lines.tree_line_m};
}

terrain::ReliefSettings relief_of(const CoverLines& lines, double strength) {
  return {.strength = strength,
          .shore_m = std::max(lines.sea_level_m, lines.beach_line_m),
          .tree_line_m = lines.tree_line_m,
          .snow_line_m = lines.snow_line_m};
}

TerrainLight terrain_light(const sky::Illuminance& light, const sky::Atmosphere& atmosphere,
                           const CoverLines& lines, double sea_level_m) {
  const auto narrow = [](double value) { return static_cast<float>(value); };
  // Of red, green and blue: the wavelengths of the sky that lie there.
  const sky::Spectrum& depth = atmosphere.rayleigh_optical_depth;
  const double rayleigh_m = atmosphere.rayleigh_scale_height_m, aerosol_m = atmosphere.aerosol_scale_height_m;
  // Kernels count heights from 0: there the air of a higher sea would be denser by so much.
  const double rayleigh = std::exp(sea_level_m / rayleigh_m) / rayleigh_m;
  return {.sun_red_klx = narrow(light.sun_klx[0]),
          .sun_green_klx = narrow(light.sun_klx[1]),
          .sun_blue_klx = narrow(light.sun_klx[2]),
          .sky_red_klx = narrow(light.sky_klx[0]),
          .sky_green_klx = narrow(light.sky_klx[1]),
          .sky_blue_klx = narrow(light.sky_klx[2]),
          .rayleigh_red_perm = narrow(depth[0] * rayleigh),
          .rayleigh_green_perm = narrow(0.5 * (depth[1] + depth[2]) * rayleigh),
          .rayleigh_blue_perm = narrow(depth[3] * rayleigh),
          .aerosol_perm =
              narrow(atmosphere.aerosol_optical_depth * std::exp(sea_level_m / aerosol_m) / aerosol_m),
          .rayleigh_scale_height_m = narrow(rayleigh_m),
          .aerosol_scale_height_m = narrow(aerosol_m),
          .sea_level_m = narrow(lines.sea_level_m),
          .beach_line_m = narrow(lines.beach_line_m),
          .tree_line_m = narrow(lines.tree_line_m),
          .snow_line_m = narrow(lines.snow_line_m),
          // Of a light breeze, 4 m/s: half the mean square slope of Cox & Munk 1954.
          .water_slopes = 0.012f,
          .swash = {},
          .still_water_m = 0.0f};
}

}  // namespace offing::world
