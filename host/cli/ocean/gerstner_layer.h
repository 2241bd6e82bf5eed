#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "host/cli/ocean/baked_frame.h"
#include "host/ocean/surface/foam.h"
#include "host/ocean/surface/gerstner_surface.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// The first cascade of a baked frame with the Gerstner waves of the sea, on one device.
class GerstnerLayer {
 public:
  GerstnerLayer(const ocl::Device& device, const scene::Sea& sea);

  const ocean::GerstnerSea& gerstner_waves() const { return gerstner_waves_; }

  /// The cascade's fields and the waves added up; Jacobian, eigenvalue and foam are those of all cascades and
  /// waves together, at the labels of this one. Foam and velocity where `spectral` has them. `sea` is at
  /// time_s, before and after.
  BakedFrame::CascadeFields with_waves(const BakedFrame::CascadeFields& spectral, ocean::Ocean& sea,
                                       double time_s, double velocity_depth_m);

 private:
  std::vector<float> foam_at(ocean::Ocean& sea, double time_s);
  const std::vector<float>& coverage_at(ocean::Ocean& sea, std::int64_t instant);
  void add_velocity(ocean::VelocityFields& velocity, double time_s, double depth_m) const;

  ocean::GerstnerSea gerstner_waves_;
  ocean::FoamParameters foam_;
  ocean::FoamInstants instants_;
  ocean::SampleGrid labels_;  // those of the cascade
  ocean::GerstnerSurface surface_;
  std::map<std::int64_t, std::vector<float>>
      coverages_;  // by key of the instant, as the next frame needs them
};

}  // namespace offing::cli
