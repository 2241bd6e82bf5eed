// cloud_light_dump FILE: what an eye sees of lit clouds, by both models of light, on the device that the
// environment names, and texels of their shadow map. FILE: red, green, blue and depth of each sprite, light
// over a white one's of 10 kcd/m2; share of the light that texels let through.
#include <cmath>
#include <fstream>
#include <vector>

#include "host/clouds/cloud_shadow_map.h"
#include "host/clouds/particle_light.h"
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
  CloudLook look;
  look.albedo = glm::dvec3(0.99, 0.95, 0.9);
  ParticleLight lit(device);
  CloudShadowMap shadow(device);
  // A heap, and a flat one whose grid has other sides; one at a time, as the compiler of rusticl
  // (Mesa 22.3.6) crashes at clouds/light_entry.cl, which several need.
  for (const clouds::test::Heap& heap :
       {clouds::test::Heap{.count = 30},
        clouds::test::Heap{.seed = 5, .count = 40, .half_axes_m = {1500.0, 120.0, 900.0}, .base_m = -60.0}}) {
    const std::vector<CloudParticle> particles = clouds::test::heap(heap);
    const auto count = static_cast<std::uint32_t>(particles.size());
    const ocl::Buffer<CloudParticle> buffer(device, particles, "particles");
    ocl::Buffer<CloudSprite> sprites(device, count, "sprites");
    for (const LightModel model : {LightModel::calibrated, LightModel::harris}) {
      lit.relight(buffer, count, light, std::span(&look, 1), model);
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
    for (std::size_t i = 0; i < texels.size(); i += 97) add(std::exp(-texels[i][0]));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
