#include "host/ocean/surface/surface_maps.h"

#include "host/ocean/surface/mode_self_test.h"

namespace offing::ocean {

ModeTransform::Request surface_request() {
  return {.first_source = "ocean/spectrum_advance.cl",
          .first_kernel = "spectrum_advance",
          .second_source = "ocean/surface_assemble.cl",
          .second_kernel = "surface_assemble",
          .half_fields = 5,
          .pair_fields = 4,
          .self_test = surface_self_test};
}

SurfaceMaps::SurfaceMaps(const ocl::Device& device, const WaveModes& modes, double choppiness)
    : transform_(device, modes, surface_request()), choppiness_(choppiness) {
  const auto n = static_cast<std::size_t>(modes.size());
  const std::size_t floats = 4 * n * n * static_cast<std::size_t>(modes.cascade_count());
  displacement_ = ocl::Buffer<float>(device, floats, "displacement map");
  gradient_ = ocl::Buffer<float>(device, floats, "gradient map");
}

void SurfaceMaps::at(const WaveModes& modes, const ocl::Buffer<float>& amplitude, double choppiness,
                     double time_s) {
  const WaveTime time = modes.clock().at(time_s);
  transform_.advance(amplitude, modes.rate(), modes.wavenumber_step(), time.ticks, time.tick_fraction,
                     static_cast<float>(choppiness));
  transform_.assemble(modes.wavenumber_step(), displacement_, gradient_);
}

}  // namespace offing::ocean
