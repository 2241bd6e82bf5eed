#include "host/cli/pictures/foam_texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace offing::cli {
namespace {

/// 0 ... 1, the same for the same lattice point everywhere (finaliser of MurmurHash3, Appleby 2011).
float lattice_value(std::int32_t column, std::int32_t row) {
  std::uint32_t h =
      static_cast<std::uint32_t>(column) * 0x9E3779B1u ^ static_cast<std::uint32_t>(row) * 0x85EBCA77u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return static_cast<float>((h ^ (h >> 16)) >> 8) * 0x1p-24f;
}

/// Smooth noise, 0 ... 1, one bump a lattice cell.
float value_noise(double x, double z) {
  const double cell_x = std::floor(x), cell_z = std::floor(z);
  const auto smooth = [](float t) { return t * t * (3.0f - 2.0f * t); };
  const float right = smooth(static_cast<float>(x - cell_x)), down = smooth(static_cast<float>(z - cell_z));
  const std::int32_t c = static_cast<std::int32_t>(cell_x), r = static_cast<std::int32_t>(cell_z);
  const float top = std::lerp(lattice_value(c, r), lattice_value(c + 1, r), right);
  const float bottom = std::lerp(lattice_value(c, r + 1), lattice_value(c + 1, r + 1), right);
  return std::lerp(top, bottom, down);
}

// Mean and deviation of |2 v - 1| for this noise, measured over 10^6 points.
constexpr float ridge_mean = 0.357f;
constexpr float ridge_deviation = 0.237f;

}  // namespace

float foam_opacity(double x_m, double z_m, float coverage, float footprint_m) {
  if (coverage <= 0.0f || coverage >= 1.0f) return coverage <= 0.0f ? 0.0f : 1.0f;
  // Octaves of ridges from 1.9 m down, bent by slow noise so that foam draws threads instead of round blobs.
  const float bend = value_noise(0.31 * x_m + 17.0, 0.31 * z_m + 5.0) - 0.5f;
  float noise = 0.0f, amplitude = 1.0f, power = 0.0f, seen_power = 0.0f;
  double wavelength_m = 1.9;
  for (int octave = 0; octave < 5; ++octave) {
    const float visible =
        std::clamp(2.0f - 4.0f * footprint_m / static_cast<float>(wavelength_m), 0.0f, 1.0f);
    if (visible > 0.0f) {
      const double x = (x_m + 1.5 * bend) / wavelength_m + 31.7 * octave;
      const double z = (z_m - 1.5 * bend) / wavelength_m - 11.3 * octave;
      noise += visible * amplitude * (ridge_mean - std::abs(2.0f * value_noise(x, z) - 1.0f));
    }
    power += amplitude * amplitude;
    seen_power += visible * amplitude * amplitude;
    amplitude *= 0.62f;
    wavelength_m *= 0.47;
  }
  // Threshold that a share `coverage` of the noise exceeds: a logistic stands for the normal distribution.
  const float deviation = ridge_deviation * std::sqrt(power);
  const float threshold = deviation * std::log((1.0f - coverage) / coverage) / 1.702f;
  const float textured = std::clamp(0.5f + (noise - threshold) / (1.2f * deviation), 0.0f, 1.0f);
  return std::lerp(coverage, textured, seen_power / power);
}

}  // namespace offing::cli
