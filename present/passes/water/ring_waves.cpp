#include "present/passes/water/ring_waves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

constexpr std::size_t max_rings = 64;
constexpr GLuint rings_binding = 2;

using Ring = ocean::GerstnerInstant::Ring;

double apparent_height(const Ring& ring, glm::dvec2 eye_m) {
  const glm::dvec2 centre_m(ring.centre_x_m, ring.centre_z_m);
  const double distance_m = std::max(glm::distance(centre_m, eye_m) - ring.radius_m, ring.wavelength_m);
  return std::abs(ring.amplitude_m) / distance_m;
}

}  // namespace

RingWaves::RingWaves() : rings_("Rings", rings_binding, 2 * max_rings) {}

void RingWaves::prepare(const ocean::GerstnerInstant& gerstner_waves, glm::dvec2 eye_m) {
  std::vector<Ring> rings = gerstner_waves.rings();
  if (rings.size() > max_rings) {
    std::nth_element(
        rings.begin(), rings.begin() + max_rings, rings.end(),
        [&](const Ring& a, const Ring& b) { return apparent_height(a, eye_m) > apparent_height(b, eye_m); });
    rings.resize(max_rings);
  }
  std::vector<glm::vec4> values;
  for (const Ring& ring : rings) {
    values.emplace_back(ring.centre_x_m - eye_m.x, ring.centre_z_m - eye_m.y, ring.wavelength_m,
                        ring.radius_m);
    values.emplace_back(ring.amplitude_m, std::remainder(ring.phase_rad, 2.0 * std::numbers::pi), 0.0, 0.0);
  }
  count_ = static_cast<int>(rings.size());
  rings_.fill(std::move(values));
}

void RingWaves::bind(const ShaderProgram& program) const {
  program.set("ring_count", count_);
  rings_.bind(program);
}

}  // namespace offing::present
