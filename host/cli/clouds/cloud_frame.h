#pragma once

#include <optional>

#include "host/base/work.h"
#include "host/io/clouds/cloud_particles.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/ocl/device.h"
#include "host/world/world_clouds.h"

namespace offing::cli {

/// Makes what files hold of clouds at any time.
class CloudFrames {
 public:
  /// The token outlives it.
  CloudFrames(const ocl::Device& device, world::CloudSkyParameters sky, const CancelToken& cancel);

  /// All particles at a time. Throws what CloudGrower and WorldClouds throw.
  ParticleCloud particles_at(double time_s);
  /// The density of all clouds together: of a single sampled one that only drifts that of its field, of
  /// others that of their particles. Albedos are told where they differ, or are no grey. Throws what
  /// density_volume() and rasterised() throw.
  VdbCloud volume_at(double time_s, double cell_m);

 private:
  VdbCloud rasterised_at(double time_s, double cell_m);
  world::WorldClouds& view();

  ocl::Device device_;
  const CancelToken& cancel_;
  world::CloudSkyParameters sky_;
  std::optional<world::WorldClouds> view_;  // once particles are asked for: fields need none
};

/// What cells of a volume may be, m.
inline constexpr double least_cell_m = 1e-3, largest_cell_m = 1e5;

/// A round length such that the box around particles has about 128 cells along its longest edge.
double usual_cell_m(const ParticleCloud& cloud);

}  // namespace offing::cli
