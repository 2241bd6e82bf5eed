#include "tests/clouds/reference_density.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

double fade(double t) {
  return 6.0 * std::pow(t, 5) - 15.0 * std::pow(t, 4) + 10.0 * std::pow(t, 3);
}

std::array<double, 4> gradient(std::uint64_t seed, int octave, const std::array<std::int64_t, 4>& point) {
  const PhiloxBlock words = philox_block(
      static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
      OFFING_STREAM_CLOUD_NOISE + (static_cast<std::uint32_t>(octave) << 24) +
          static_cast<std::uint32_t>(point[3] & 0xffffff),
      static_cast<int>(point[0]), static_cast<int>(point[1]), static_cast<std::uint32_t>(point[2]));
  const double share = static_cast<double>(uniform_open01(words.v[0]));
  const double first = 2.0 * std::numbers::pi * static_cast<double>(uniform_open01(words.v[1]));
  const double second = 2.0 * std::numbers::pi * static_cast<double>(uniform_open01(words.v[2]));
  return {std::sqrt(1.0 - share) * std::cos(first), std::sqrt(1.0 - share) * std::sin(first),
          std::sqrt(share) * std::cos(second), std::sqrt(share) * std::sin(second)};
}

}  // namespace

double reference_noise(std::uint64_t seed, int octave, const std::array<double, 4>& place) {
  double sum = 0.0;
  for (int corner = 0; corner < 16; ++corner) {
    std::array<std::int64_t, 4> point;
    std::array<double, 4> offset;
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      point[axis] = static_cast<std::int64_t>(std::floor(place[axis])) + ((corner >> axis) & 1);
      offset[axis] = place[axis] - static_cast<double>(point[axis]);
      weight *= 1.0 - fade(std::abs(offset[axis]));
    }
    const std::array<double, 4> direction = gradient(seed, octave, point);
    for (std::size_t axis = 0; axis < 4; ++axis) sum += weight * direction[axis] * offset[axis];
  }
  return sum;
}

double reference_turbulence(const Turbulence& turbulence, std::uint64_t seed, const glm::dvec3& place_m,
                            double time_s, double shortest_m) {
  // Mean square of one octave over the unit cell, by its definition: the sum over corners of the square of
  // their weight and offset, a quarter of it along each gradient; by Simpson's rule.
  double square = 0.0, square_offset = 0.0;
  constexpr int steps = 2000;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, weight = 1.0 - fade(t);
    const double simpson = (i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) / (3.0 * steps);
    square += simpson * weight * weight;
    square_offset += simpson * weight * weight * t * t;
  }
  const double variance = 16.0 * square_offset * square * square * square;
  double sum = 0.0, sum_variance = 0.0;
  for (int octave = 0; octave < turbulence.octaves; ++octave) {
    const double amplitude = std::pow(turbulence.gain, octave);
    const double wavelength_m = turbulence.wavelength_m / std::pow(turbulence.lacunarity, octave);
    sum_variance += amplitude * amplitude * variance;
    if (wavelength_m < shortest_m) continue;
    const PhiloxBlock shift =
        philox_block(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                     OFFING_STREAM_CLOUD_OCTAVES, octave, 0, 0);
    std::array<double, 4> place{
        place_m.x / wavelength_m, place_m.y / wavelength_m, place_m.z / wavelength_m,
        time_s * turbulence.change_per_s * std::pow(turbulence.lacunarity, octave * 2.0 / 3.0)};
    for (std::size_t axis = 0; axis < 4; ++axis) {
      place[axis] += static_cast<double>(uniform_open01(shift.v[axis]));
    }
    sum += amplitude * reference_noise(seed, octave, place);
  }
  return 1.0 / (1.0 + std::exp(-1.702 * sum / std::sqrt(sum_variance)));
}

double reference_density(const CloudParameters& parameters, const glm::dvec3& place_m, double time_s,
                         double shortest_m) {
  double implicit = 0.0;
  for (const Metaball& ball : parameters.balls) {
    const double r = glm::distance(place_m, ball.centre_m) / ball.radius_m;
    if (r >= 1.0) continue;
    implicit +=
        ball.weight * (1.0 - 4.0 / 9.0 * std::pow(r, 6) + 17.0 / 9.0 * std::pow(r, 4) - 22.0 / 9.0 * r * r);
  }
  if (implicit <= 0.0) return 0.0;
  const Turbulence& turbulence = parameters.turbulence;
  const double share = turbulence.blend * std::fmin(1.0, implicit / turbulence.edge);
  const double noise = reference_turbulence(turbulence, parameters.seed, place_m, time_s, shortest_m);
  return std::pow(std::fmax(0.0, (1.0 - share) * implicit + share * turbulence.strength * noise),
                  turbulence.wisp);
}

}  // namespace offing::clouds
