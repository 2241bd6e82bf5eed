#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/light/particle_light.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/cloud_image_params.h"
#include "kernels/shared/cloud_march.h"

namespace offing::clouds {

/// The density of clouds that are large on the screen, and the sunlight in it, in cells of some 20 m: so that
/// pictures march along lines of sight and see the light between billows, where particles would show one
/// light each (kernels/clouds/march). A cloud is marched where its parts are large in the picture, and
/// shown as billboards where they are small; in between it is shown as both, each with a share of its
/// density.
///
/// A volume takes 2 MB of the device, and 2 MB more for each sun; all together as much again to make one.
class ResolvedClouds {
 public:
  /// lumps: how strong those smaller than particles are, 0 (left out) to 1.
  explicit ResolvedClouds(const ocl::Device& device, double lumps = 1.0);

  /// From now on these particles are resolved, in this light, by the calibrated model. Waits for the
  /// particles. Keeps references to both.
  void set(const ocl::Buffer<CloudParticle>& particles, const ParticleLight& light);
  /// From now on nothing is.
  void clear() {
    bounds_.clear();
    volumes_.clear();
  }

  /// Queues what a camera needs of them. origin_m: of the particles' places, in the world.
  void resolve(const Camera& camera, const glm::dvec3& origin_m);

  /// Queues the volume of a cloud, so that resolve() need not, if there is room for it.
  void make(int cloud);

  // Of the last resolve().

  /// The clouds that have a volume.
  std::vector<int> marched() const;

  bool has_any() const { return !volumes_.empty(); }
  /// [clouds]: of each cloud, the share that billboards show.
  const ocl::Buffer<float>& billboard_shares() const { return shares_; }
  /// Queues the picture of what is marched: image, RGBA premultiplied, kcd/m2, and mean distances, both of
  /// the size of `params`. `shape` is that of kernels of pictures (billboard_composite).
  void march(const ocl::LaunchShape& shape, CloudImageParams params, const glm::dvec3& eye_m,
             const ocl::Buffer<float>& scene_depth, ocl::Buffer<std::array<float, 4>>& image,
             ocl::Buffer<float>& distance_m);

 private:
  /// What depends on whether clouds have colours.
  struct Kernels {
    ocl::Kernel source, march;
  };

  Kernels& kernels();
  void reserve(std::size_t slots);
  void make(const CloudMarchVolume& volume);
  void pair(const ocl::Buffer<float>& values, std::size_t count, std::size_t first,
            ocl::Buffer<std::uint32_t>& pairs);

  ocl::Device device_;
  double lumps_;
  ocl::KernelTuning density_tuning_, cell_tuning_, group_tuning_, picture_tuning_;
  ocl::Kernel bounds_kernel_, density_kernel_, blocks_kernel_, descent_kernel_, beam_kernel_, pairs_kernel_;
  std::array<std::optional<Kernels>, 2> kernels_;  // of one channel and of three
  const ocl::Buffer<CloudParticle>* particles_ = nullptr;
  const ParticleLight* light_ = nullptr;
  std::vector<CloudMarchBounds> bounds_;        // one a cloud; empty: nothing is resolved
  CloudMarchVolume axes_{};                     // of all volumes
  std::vector<std::optional<int>> slots_;       // whose volume each holds
  std::vector<CloudMarchVolume> volumes_;       // in the order of their clouds
  std::vector<CloudMarchVolume> volumes_held_;  // as volumes_buffer_ has them
  std::vector<float> shares_held_;              // as shares_ has them
  glm::dvec3 origin_m_{0.0};
  ocl::Buffer<CloudMarchBounds> bounds_buffer_;
  ocl::Buffer<CloudMarchVolume> volumes_buffer_;
  ocl::Buffer<float> shares_;
  ocl::Buffer<float> density_, depths_;  // of the volume that is made
  ocl::Buffer<std::uint32_t> cells_, phases_, sources_, noise_;
  ocl::Buffer<std::int32_t> blocks_;
};

}  // namespace offing::clouds
