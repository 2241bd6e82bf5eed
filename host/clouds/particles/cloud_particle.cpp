#include "host/clouds/particles/cloud_particle.h"

#include <numbers>

#include <fmt/format.h>

#include "host/base/parameter_check.h"
#include "kernels/shared/random.h"

namespace offing::clouds {

void require_valid(const CloudParticle& particle, std::size_t number) {
  const auto require = [&](const char* name, float value, double low, double high) {
    require_within(fmt::format("cloud particle {}: {}", number, name), static_cast<double>(value), low, high);
  };
  require("x", particle.x, -1e7, 1e7);
  require("y", particle.y, -1e7, 1e7);
  require("z", particle.z, -1e7, 1e7);
  require("radius", particle.radius, 1e-6, 1e7);
  require("optical_mass", particle.optical_mass, 0.0, 1e30);
}

CloudParticle cloud_particle(const glm::dvec3& place_m, double radius_m, double optical_mass_m2,
                             const CloudLook& look, const ParticleKey& key) {
  const PhiloxBlock block =
      philox_block(static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32),
                   OFFING_STREAM_CLOUD_PARTICLES, 0, 0, key.id);
  const std::uint32_t first = look.billboards == BillboardSet::crisp ? 0 : CLOUD_TEXTURES;
  return {.x = static_cast<float>(place_m.x),
          .y = static_cast<float>(place_m.y),
          .z = static_cast<float>(place_m.z),
          .radius = static_cast<float>(radius_m),
          .optical_mass = static_cast<float>(optical_mass_m2),
          .red = static_cast<float>(look.albedo.x),
          .green = static_cast<float>(look.albedo.y),
          .blue = static_cast<float>(look.albedo.z),
          .texture = first + block.v[0] % CLOUD_TEXTURES,
          .cloud = 0,
          .id = key.id,
          .turn = 2.0f * std::numbers::pi_v<float> * uniform_open01(block.v[1])};
}

}  // namespace offing::clouds
