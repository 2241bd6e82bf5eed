#include "host/ocean/query/mode_fields.h"

#include <algorithm>
#include <numbers>

#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/velocity_map.h"
#include "host/ocl/program.h"
#include "kernels/shared/mode_layout.h"
#include "kernels/shared/query_params.h"

namespace offing::ocean {

ModeFields::ModeFields(const ocl::Device& device, const WaveModes& modes, double choppiness,
                       double water_depth_m)
    : tuning_(ocl::tuning_for(device.info(), "mode_sums")),
      kernel_(ocl::Program::build(device, "ocean/mode_fields.cl", ocl::Defines().set("LANES", tuning_.lanes))
                  .kernel("mode_fields")),
      choppiness_(static_cast<float>(choppiness)),
      water_depth_m_(finite_depth_m(water_depth_m)),
      fields_(device,
              static_cast<std::size_t>(modes.cascade_count()) * 2 * QUERY_FIELDS *
                  mode_plane_size(modes.columns(), modes.size()),
              "fields of the modes") {
  fields_.fill(0.0f);
}

void ModeFields::at(const WaveModes& modes, const Place& place) {
  if (held_ && held_->covers(place)) return;
  held_.reset();
  const WaveTime time = modes.clock().at(place.time_s);
  const std::size_t plane = mode_plane_size(modes.columns(), modes.size());
  kernel_.launch(
      {{plane / static_cast<std::size_t>(tuning_.lanes), static_cast<std::size_t>(modes.cascade_count())}},
      modes.amplitude(), modes.rate(), modes.wavenumber_step(), modes.columns(), modes.size(), time.ticks,
      time.tick_fraction, choppiness_, static_cast<float>(largest_wavenumber_radpm(place.min_wavelength_m)),
      place.depth_m ? 1 : 0, static_cast<float>(modes.clock().radps_per_rate()),
      static_cast<float>(place.depth_m.value_or(0.0)), water_depth_m_, fields_);
  held_ = place;
}

double mode_radius(const Cascade& cascade, double min_wavelength_m) {
  const double k_max_radpm = std::min(cascade.k_max_radpm, largest_wavenumber_radpm(min_wavelength_m));
  if (cascade.k_min_radpm > k_max_radpm) return 0.0;
  return k_max_radpm * cascade.patch_length_m / (2.0 * std::numbers::pi) + 1.0;
}

}  // namespace offing::ocean
