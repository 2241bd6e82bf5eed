#include "present/passes/water/ring_waves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

using Ring = ocean::GerstnerInstant::Ring;

double apparent_height(const Ring& ring, glm::dvec2 eye_m) {
  const glm::dvec2 centre_m(ring.centre_x_m, ring.centre_z_m);
  const double distance_m = std::max(glm::distance(centre_m, eye_m) - ring.radius_m, ring.wavelength_m);
  return std::abs(ring.amplitude_m) / distance_m;
}

}  // namespace

RingWaves::RingWaves() : rings_("Rings", rings_binding) {}

void RingWaves::prepare(const ocean::GerstnerInstant& gerstner_waves, glm::dvec2 eye_m) {
  std::vector<Ring> rings = gerstner_waves.rings();
  if (rings.size() > glsl::most_rings) {
    std::nth_element(
        rings.begin(), rings.begin() + glsl::most_rings, rings.end(),
        [&](const Ring& a, const Ring& b) { return apparent_height(a, eye_m) > apparent_height(b, eye_m); });
    rings.resize(glsl::most_rings);
  }
  glsl::RingUniforms uniforms{};
  for (const Ring& ring : rings) {
    glm::vec4* values = uniforms.values + static_cast<std::ptrdiff_t>(2 * uniforms.count++);
    values[0] = {ring.centre_x_m - eye_m.x, ring.centre_z_m - eye_m.y, ring.wavelength_m, ring.radius_m};
    values[1] = {ring.amplitude_m, std::remainder(ring.phase_rad, 2.0 * std::numbers::pi), 0.0, 0.0};
  }
  count_ = uniforms.count;
  rings_.fill(uniforms);
}

}  // namespace offing::present
