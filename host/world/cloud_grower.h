#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "host/base/work.h"
#include "host/ocl/device.h"
#include "host/world/world.h"
#include "host/world/world_clouds.h"

namespace offing::world {

/// How many of the clouds of a sky have their particles.
struct CloudProgress {
  std::size_t done = 0, all = 0;
  double share = 0.0;  ///< of the next one, 0 ... 1
};

/// What is done with clouds that take longer to make than a first picture may (host/base/time_estimate.h).
enum class LongWork {
  refused,  ///< as clouds::require_short_sampling() does
  done,     ///< where somebody sees the progress and can stop it, as in a window
};

/// Gives clouds their particles ahead of a WorldClouds, which takes most of the time that clouds take: on
/// another thread with a device of its own, or with what is known from the last sky. Particles are those that
/// WorldClouds makes of the same parameters.
class CloudGrower {
 public:
  explicit CloudGrower(const ocl::Device& device) : device_(device) {}

  /// The sky with `particles` for each of its clouds. Those whose form the last sky had, wherever it was, are
  /// the same object. `progress` is told before each cloud, while it is made, and at the end. Throws what
  /// clouds::particles_at_rest() throws, with the number of the cloud, from 1; Error(cancelled); where long
  /// work is refused what clouds::require_short_sampling() throws.
  CloudSkyParameters grown(CloudSkyParameters sky, const CancelToken& cancel,
                           const std::function<void(CloudProgress)>& progress = {},
                           LongWork long_work = LongWork::refused);

 private:
  struct Form {
    clouds::CloudParameters parameters;  // without place, motion and edits
    std::shared_ptr<const std::vector<CloudParticle>> particles;
  };

  ocl::Device device_;
  std::vector<Form> known_;
};

/// Gives the clouds of a world their particles ahead of it, if it has any: making them takes longest, and
/// making a world cannot be stopped. As CloudGrower::grown().
void grow_clouds(const ocl::Device& device, WorldParameters& parameters, const CancelToken& cancel,
                 const std::function<void(CloudProgress)>& progress = {});

}  // namespace offing::world
