#include "host/clouds/shape/noise_octaves.h"

#include <cmath>

#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

struct FixedPoint {
  std::int32_t whole;
  std::uint32_t fraction;  // 2^-32
};

FixedPoint fixed_point(double place) {
  const double whole = std::floor(place);
  // The product may round up to 2^32.
  const double fraction = std::fmin((place - whole) * 0x1p32, 0x1p32 - 1.0);
  return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>(fraction)};
}

}  // namespace

std::vector<CloudOctave> noise_octaves(const Turbulence& turbulence, std::uint64_t seed,
                                       const glm::dvec3& origin_m, double cell_m, double time_s) {
  std::vector<CloudOctave> octaves;
  double variance = 0.0, amplitude = 1.0, wavelength_m = turbulence.wavelength_m;
  double layer = time_s * turbulence.change_per_s;
  for (int j = 0; j < turbulence.octaves; ++j) {
    variance += amplitude * amplitude * noise_variance;
    const double step = cell_m / wavelength_m;
    if (step <= 0.5) {
      const PhiloxBlock shift =
          philox_block(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                       OFFING_STREAM_CLOUD_OCTAVES, j, 0, 0);
      const auto shifted = [&](double place_m, int axis) {
        return fixed_point(place_m / wavelength_m + static_cast<double>(uniform_open01(shift.v[axis])));
      };
      const FixedPoint x = shifted(origin_m.x, 0), y = shifted(origin_m.y, 1), z = shifted(origin_m.z, 2);
      const double place = layer + static_cast<double>(uniform_open01(shift.v[3]));
      const double whole = std::floor(place);
      octaves.push_back({.origin_x = x.whole,
                         .origin_y = y.whole,
                         .origin_z = z.whole,
                         .fraction_x = x.fraction,
                         .fraction_y = y.fraction,
                         .fraction_z = z.fraction,
                         .step = static_cast<std::uint32_t>(step * 0x1p32),
                         .layer = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole) & 0xffffff),
                         .layer_fraction = static_cast<float>(place - whole),
                         .amplitude = static_cast<float>(amplitude)});
    }
    amplitude *= turbulence.gain;
    wavelength_m /= turbulence.lacunarity;
    layer *= std::cbrt(turbulence.lacunarity * turbulence.lacunarity);
  }
  for (CloudOctave& octave : octaves) octave.amplitude /= static_cast<float>(std::sqrt(variance));
  return octaves;
}

}  // namespace offing::clouds
