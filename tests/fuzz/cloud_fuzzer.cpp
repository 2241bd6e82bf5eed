#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/io/clouds/cloud_particles.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("cloud.ply");
  file.hold({data, size});
  return offing::fuzz::check_reading([] {
    const offing::ParticleCloud cloud = offing::read_cloud_particles(file.path());
    expect(!cloud.particles.empty());
    for (const CloudParticle& particle : cloud.particles) {
      for (const float place_m : {particle.x, particle.y, particle.z}) expect(std::isfinite(place_m));
      expect(std::isfinite(particle.radius) && particle.radius > 0.0f);
      expect(std::isfinite(particle.optical_mass) && particle.optical_mass >= 0.0f);
      for (const float share : {particle.red, particle.green, particle.blue})
        expect(share >= 0.0f && share <= 1.0f);
      expect(std::isfinite(particle.turn) && particle.texture < 2 * CLOUD_TEXTURES);
    }
  });
}
