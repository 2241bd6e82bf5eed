// cloud_model_dump FILE: density, sums and motion of a small cloud on the device that the environment names.
// FILE: cells of a frayed cloud and of the same as a shape, of rasterised particles, and places and masses of
// particles that move in every way.
#include <fstream>

#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/cloud_density.h"
#include "tests/ocl/dump_program.h"

namespace {

using namespace offing;
using namespace offing::clouds;

void write_dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  std::ofstream file(path, std::ios::binary);
  const auto add = [&](float value) { file.write(reinterpret_cast<const char*>(&value), sizeof(value)); };
  const auto add_cells = [&](const CloudVolume& volume) {
    for (std::size_t i = 0; i < volume.density.size(); i += 5) add(volume.density[i]);
  };

  CloudParameters cloud;
  cloud.seed = 99;
  cloud.balls = {{{0.0, 0.0, 0.0}, 30.0}, {{25.0, 8.0, -12.0}, 18.0}};
  cloud.turbulence.wavelength_m = 40.0;
  cloud.turbulence.wisp = 1.3;
  cloud.turbulence.change_per_s = 0.01;
  const CloudVolume volume = field_volume(device, cloud, 4.0, 33.0);
  add_cells(volume);
  CloudParameters shaped = cloud;
  shaped.shape = std::make_shared<const CloudVolume>(volume);
  add_cells(field_volume(device, shaped, 5.0, 33.0));

  cloud.levels = {{.ratio = 0.5}};
  cloud.motion = {.wind_mps = {3.0, 0.0, 1.0}, .shear_per_s = 0.01, .drag = 2.0, .sway_m = 5.0};
  cloud.motion.heat = CloudHeat{.condensation_m = 20.0};
  cloud.motion.obstacle = CloudObstacle{{300.0, 0.0, 100.0}, 40.0};
  CloudModel model(device, cloud);
  model.at(90.0);
  const std::vector<CloudParticle> particles = model.particles().read();
  for (const CloudParticle& particle : particles) {
    add(particle.x);
    add(particle.y);
    add(particle.z);
    add(particle.optical_mass);
  }
  add_cells(rasterised(device, particles, 6.0, 0.02));
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
