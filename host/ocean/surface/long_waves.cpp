#include "host/ocean/surface/long_waves.h"

#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocl/program.h"

namespace offing::ocean {

LongWaves::LongWaves(const ocl::Device& device, const WaveModes& modes, double choppiness,
                     double water_depth_m)
    : device_(device),
      water_depth_m_(water_depth_m),
      filter_(ocl::Program::build(device, "ocean/mode_filter.cl").kernel("mode_filter")),
      amplitude_(device, modes.amplitude().size(), "long waves' amplitudes"),
      surface_(device, modes, choppiness) {}

void LongWaves::at(const WaveModes& modes, double min_wavelength_m, double time_s) {
  if (min_wavelength_m_ != min_wavelength_m) {
    reset();
    filter_.launch({{static_cast<std::size_t>(modes.columns()), static_cast<std::size_t>(modes.size()),
                     static_cast<std::size_t>(modes.cascade_count())}},
                   modes.amplitude(), modes.wavenumber_step(), modes.columns(), modes.size(),
                   static_cast<float>(largest_wavenumber_radpm(min_wavelength_m)), amplitude_);
    min_wavelength_m_ = min_wavelength_m;
  }
  if (time_s_ == time_s) return;
  time_s_.reset();
  surface_.at(modes, amplitude_, time_s);
  time_s_ = time_s;
}

void LongWaves::velocity_at(const WaveModes& modes, double depth_below_surface_m) {
  if (!velocity_) velocity_.emplace(device_, modes, water_depth_m_);
  velocity_->at(modes, amplitude_, *time_s_, depth_below_surface_m);
}

void LongWaves::reset() {
  min_wavelength_m_.reset();
  time_s_.reset();
  if (velocity_) velocity_->reset();
}

}  // namespace offing::ocean
