#include "host/bodies/radiation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/bodies/panel_method.h"

namespace offing::bodies {
namespace {

using std::numbers::pi;

// Both in units of sqrt(length / gravity). After 15 of them the waves of a hull have left it.
constexpr double memory_span = 30.0, finest_sample = 0.05;
constexpr int most_steps_a_sample = 8;
constexpr std::size_t most_samples = 2048;
// Of the span: from here on a half cosine leads the function to 0, so that its end does not ring.
constexpr double taper_begin = 0.5;

bool is_finite(const HullMatrix& matrix) {
  return std::all_of(matrix.begin(), matrix.end(), [](double value) { return std::isfinite(value); });
}

void require_fitting(const HydrodynamicData& data) {
  const std::size_t frequencies = data.frequencies_radps.size();
  double before_radps = 0.0;
  bool is_fitting =
      frequencies > 0 && data.damping.size() == frequencies && is_finite(data.added_mass_at_infinity);
  for (const double frequency_radps : data.frequencies_radps) {
    is_fitting = is_fitting && std::isfinite(frequency_radps) && frequency_radps > before_radps;
    before_radps = frequency_radps;
  }
  is_fitting = is_fitting && std::all_of(data.damping.begin(), data.damping.end(), is_finite);
  if (!is_fitting) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected rising frequencies above 0, each with a damping matrix of numbers",
                            data.source),
                "compute the hydrodynamic data again");
  }
}

/// Adds to the first samples what keeps each motion's own damping from being below 0 at any frequency, so
/// that the memory, once sampled and cut, gives no energy to a hull.
void keep_passive(std::vector<HullMatrix>& memory) {
  for (std::size_t motion = 0; motion < hull_motions; ++motion) {
    const std::size_t entry = motion * hull_motions + motion;
    double least = 0.0;
    const std::size_t frequencies = 2 * memory.size();
    for (std::size_t i = 0; i <= frequencies; ++i) {
      // Chebyshev's recurrence for cos(n angle).
      const double twice = 2.0 * std::cos(pi * static_cast<double>(i) / static_cast<double>(frequencies));
      double last = 1.0, now = 0.5 * twice, sum = memory[0][entry];
      for (std::size_t n = 1; n < memory.size(); ++n) {
        sum += memory[n][entry] * now;
        last = std::exchange(now, twice * now - last);
      }
      least = std::min(least, sum);
    }
    memory[0][entry] -= least;
  }
}

}  // namespace

HullMatrix about_another_point(const HullMatrix& matrix, const glm::dvec3& arm_m) {
  // v_old = v_new - spin x arm: the columns of `moved`; forces follow by its transpose.
  HullMatrix moved{};
  for (std::size_t i = 0; i < hull_motions; ++i) moved[i * hull_motions + i] = 1.0;
  moved[0 * 6 + 4] = -arm_m.z;
  moved[0 * 6 + 5] = arm_m.y;
  moved[1 * 6 + 3] = arm_m.z;
  moved[1 * 6 + 5] = -arm_m.x;
  moved[2 * 6 + 3] = -arm_m.y;
  moved[2 * 6 + 4] = arm_m.x;
  HullMatrix half{}, whole{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t k = 0; k < 6; ++k) half[i * 6 + j] += matrix[i * 6 + k] * moved[k * 6 + j];
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t k = 0; k < 6; ++k) whole[i * 6 + j] += moved[k * 6 + i] * half[k * 6 + j];
    }
  }
  return whole;
}

HullMemory memory_of_hull(const HydrodynamicData& data, const glm::dvec3& mass_centre_m, double length_m,
                          double steps_per_s) {
  require_fitting(data);
  const glm::dvec3 arm_m = mass_centre_m - data.about_m;
  const double unit_s = std::sqrt(length_m / data.gravity_mps2);
  HullMemory made;
  made.added_mass = about_another_point(data.added_mass_at_infinity, arm_m);
  made.steps_a_sample =
      std::clamp(static_cast<int>(finest_sample * unit_s * steps_per_s), 1, most_steps_a_sample);
  const double sample_s = made.steps_a_sample / steps_per_s;
  const auto samples =
      std::clamp(static_cast<std::size_t>(memory_span * unit_s / sample_s), std::size_t{2}, most_samples);
  made.memory = retardation(data, sample_s, samples);
  for (std::size_t n = 0; n < samples; ++n) {
    const double place = static_cast<double>(n) / static_cast<double>(samples);
    const double taper =
        place < taper_begin ? 1.0 : 0.5 + 0.5 * std::cos(pi * (place - taper_begin) / (1.0 - taper_begin));
    const double weight = taper * sample_s * (n == 0 ? 0.5 : 1.0);
    made.memory[n] = about_another_point(made.memory[n], arm_m);
    for (double& value : made.memory[n]) value *= weight;
  }
  keep_passive(made.memory);
  return made;
}

}  // namespace offing::bodies
