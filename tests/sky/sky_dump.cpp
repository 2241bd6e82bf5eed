// sky_dump FILE: a clear sky through every kernel of the sky, on the device that the environment names. FILE:
// for each sun, a map in units of its mean light and the illuminances in klx, as floats.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "host/base/error.h"
#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"

namespace {

using namespace offing;
using namespace offing::sky;

void dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  std::printf("%s, %s\n", device.info().name.c_str(), device.info().platform.c_str());
  ClearSky sky(device, Atmosphere{});
  std::ofstream file(path, std::ios::binary);
  const auto write = [&file](const auto& values) {
    for (const double value : values) {
      const auto single = static_cast<float>(value);
      file.write(reinterpret_cast<const char*>(&single), sizeof(single));
    }
  };
  for (const double sun_rad : {1.0, 0.05, -0.1}) {
    sky.at({.sun_direction = direction_of(0.3, sun_rad)}, 20.0);
    ocl::Buffer<Texel> map(device, 24 * 13, "map");
    sky.fill_map(24, 13, map);
    double mean = 0.0;
    std::vector<double> light;
    for (const Texel& texel : map.read()) {
      for (std::size_t c = 0; c < 3; ++c) light.push_back(texel[c]);
    }
    for (const double value : light) mean += value / static_cast<double>(light.size());
    for (double& value : light) value /= mean;
    write(light);
    const Illuminance illuminance = sky.read_illuminance();
    write(illuminance.sun_klx);
    write(illuminance.sky_klx);
    write(sky.read_light(std::vector{sky::direction_of(0.3, sun_rad)}).sky_kcdpm2.front());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: sky_dump FILE\n", stderr);
    return EXIT_FAILURE;
  }
  try {
    dump(argv[1]);
  } catch (const offing::Error& error) {
    std::fprintf(stderr, "error: %s\nhint: %s\n", error.what(), error.hint().c_str());
    return offing::exit_code(error.kind());
  }
}
