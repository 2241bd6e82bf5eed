// A program of somebody who has Offing installed: it includes by the installed paths and uses every layer,
// from the scene's defaults to maps that an OpenCL device computes.
#include <cmath>
#include <cstdio>

#include "host/base/error.h"
#include "host/io/spectra/read_spectra.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/prepare/sea.h"

namespace {

/// Significant wave height, 4 sqrt(variance), of the first cascade's surface.
double measured_hs_m(const offing::scene::Sea& sea) {
  offing::ocean::Ocean ocean(offing::ocl::Device::open(), sea.spectrum, sea.parameters);
  ocean.at(0.0);
  double sum = 0.0;
  const offing::ocean::SurfaceFields surface = ocean.read_surface(0);
  for (const float height_m : surface.displacement_y) {
    sum += static_cast<double>(height_m) * height_m;
  }
  return 4.0 * std::sqrt(sum / static_cast<double>(surface.displacement_y.size()));
}

}  // namespace

int main() try {
  offing::scene::Scene scene;
  scene.ocean.parameters.size = 64;
  const offing::scene::Sea sea = offing::scene::prepare_sea(scene);
  const double asked_m = offing::ocean::integrate_sea_state(sea.spectrum).hs_m;
  const double measured_m = measured_hs_m(sea);
  std::printf("Hs: %.2f m asked, %.2f m in the first cascade\n", asked_m, measured_m);
  // The first cascade holds most of the energy; one realisation of it scatters by some percent.
  const bool is_right = measured_m > 0.7 * asked_m && measured_m < 1.3 * asked_m;

  try {
    offing::read_spectra("no such file");
    return 1;
  } catch (const offing::Error& error) {
    std::printf("%s\n%s\n", error.what(), error.hint().c_str());
  }
  return is_right ? 0 : 1;
} catch (const offing::Error& error) {
  std::printf("error: %s\nhint: %s\n", error.what(), error.hint().c_str());
  return offing::exit_code(error.kind());
}
