#include "host/ocean/surface/velocity_map.h"

#include <algorithm>

#include "host/ocean/surface/mode_self_test.h"

namespace offing::ocean {
namespace {
// Water deeper than this is deep for every wave that a patch can hold, and finite numbers suit every device.
constexpr double bottomless_m = 1e6;
}  // namespace

float finite_depth_m(double water_depth_m) {
  return static_cast<float>(std::min(water_depth_m, bottomless_m));
}

ModeTransform::Request velocity_request() {
  return {.first_source = "ocean/velocity_advance.cl",
          .first_kernel = "velocity_advance",
          .second_source = "ocean/velocity_assemble.cl",
          .second_kernel = "velocity_assemble",
          .half_fields = 4,
          .pair_fields = 2,
          .self_test = velocity_self_test};
}

VelocityMap::VelocityMap(const ocl::Device& device, const WaveModes& modes, double water_depth_m)
    : transform_(device, modes, velocity_request()), water_depth_m_(finite_depth_m(water_depth_m)) {
  const auto n = static_cast<std::size_t>(modes.size());
  velocity_ =
      ocl::Buffer<float>(device, 4 * n * n * static_cast<std::size_t>(modes.cascade_count()), "velocity map");
}

void VelocityMap::at(const WaveModes& modes, const ocl::Buffer<float>& amplitude, double time_s,
                     double depth_below_surface_m) {
  const Place wanted{time_s, depth_below_surface_m};
  if (held_ == wanted) return;
  held_.reset();
  const WaveTime time = modes.clock().at(time_s);
  transform_.advance(amplitude, modes.rate(), modes.wavenumber_step(), time.ticks, time.tick_fraction,
                     static_cast<float>(modes.clock().radps_per_rate()),
                     static_cast<float>(depth_below_surface_m), water_depth_m_);
  transform_.assemble(modes.wavenumber_step(), velocity_);
  held_ = wanted;
}

}  // namespace offing::ocean
