// cloud_light_dump FILE: what an eye sees of lit clouds, by both models of light, on the device that the
// environment names, and texels of their shadow map. FILE: red, green, blue and depth of each sprite, light
// over a white one's of 10 kcd/m2; share of the light that texels let through, with where their clouds are;
// shares at places below.
#include <cmath>
#include <fstream>
#include <vector>

#include "host/clouds/light/cloud_shadow_map.h"
#include "host/clouds/light/particle_light.h"
#include "tests/clouds/example_clouds.h"
#include "tests/ocl/dump_program.h"

namespace {

using namespace offing;
using namespace offing::clouds;

void write_dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  std::ofstream file(path, std::ios::binary);
  const auto add = [&](float value) { file.write(reinterpret_cast<const char*>(&value), sizeof(value)); };
  CloudIllumination light;
  light.suns.push_back({{0.48, 0.6, 0.64}, glm::dvec3(100.0, 80.0, 60.0)});
  light.sky_kcdpm2 = glm::dvec3(2.0, 3.0, 5.0);
  light.ground_kcdpm2 = glm::dvec3(1.0);
  CloudLook greyish, even;
  greyish.albedo = glm::dvec3(0.99, 0.95, 0.9);
  even.phase = PhaseKind::mie_droplet;
  const std::vector<CloudLook> looks{greyish, even};
  ParticleLight lit(device);
  CloudShadowMap shadow(device);
  // A heap alone, and with a flat one before its sun, whose grid has other sides.
  const std::vector<CloudParticle> heap = clouds::test::heap({.count = 30});
  std::vector<CloudParticle> both = heap;
  for (CloudParticle particle :
       clouds::test::heap({.seed = 5, .count = 40, .half_axes_m = {1400.0, 250.0, 600.0}, .cloud = 1})) {
    particle.x += 960.0f, particle.y += 1200.0f, particle.z += 1280.0f;
    both.push_back(particle);
  }
  for (const auto& particles : {heap, both}) {
    const auto count = static_cast<std::uint32_t>(particles.size());
    const ocl::Buffer<CloudParticle> buffer(device, particles, "particles");
    ocl::Buffer<CloudSprite> sprites(device, count, "sprites");
    for (const LightModel model : {LightModel::calibrated, LightModel::harris}) {
      lit.relight(buffer, count, light, std::span(looks).first(particles.back().cloud + 1), model);
      lit.see({100.0f, 200.0f, 3000.0f}, sprites);
      for (const CloudSprite& sprite : sprites.read()) {
        add(0.1f * sprite.red);
        add(0.1f * sprite.green);
        add(0.1f * sprite.blue);
        add(sprite.optical_depth);
      }
    }
    shadow.update(buffer, count, light.suns[0].direction, {0.0, 0.0, 0.0}, 2000.0);
    const std::vector<CloudShadowMap::Texel> texels = shadow.map().read();
    for (std::size_t i = 0; i < texels.size(); i += 97) {
      add(std::exp(-texels[i][0]));
      // Where the clouds of a texel are, weighted by them.
      add(std::fmin(texels[i][0], 1.0f) * texels[i][1]);
      add(std::fmin(texels[i][0], 1.0f) * texels[i][2]);
    }
    std::vector<glm::vec3> places_m;
    for (int i = 0; i < 40; ++i)
      places_m.emplace_back(40.0f * static_cast<float>(i) - 900.0f, -300.0f, 10.0f);
    for (const float share : shadow.transmittance(places_m)) add(share);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
