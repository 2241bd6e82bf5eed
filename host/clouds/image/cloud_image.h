#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/image/billboard_textures.h"
#include "host/clouds/light/resolved_clouds.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/cloud_image_params.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Particles on a device, as pictures are made of them. Valid while the buffers live.
struct DrawnParticles {
  const ocl::Buffer<CloudParticle>& particles;  ///< [count]
  const ocl::Buffer<CloudSprite>& sprites;      ///< [count], seen from the camera's eye
  const ocl::Buffer<std::uint32_t>& order;      ///< [count], indices of both, the farthest from the eye first
  std::uint32_t count = 0;
  glm::dvec3 origin_m{0.0};                 ///< of their places, in the world
  glm::dvec3 sun_direction{0.0, 1.0, 0.0};  ///< unit, toward it: from where the relief of textures is lit
  double near_m = 0.05;                     ///< of CloudImage::scene_depth()
  ResolvedClouds* resolved = nullptr;       ///< for this camera; nullptr: all are shown as billboards
};

/// What a camera sees of the particles of clouds, made on a device: billboards that face the eye (C9), with
/// the density along each ray between the eye and the scene, so that clouds may be flown through and things
/// stand in them. Particles that pass each other fade (kernels/clouds/billboard_composite.cl): nothing pops.
class CloudImage {
 public:
  /// Throws what programs and buffers throw.
  CloudImage(const ocl::Device& device, const BillboardTextures& textures);

  void set_textures(const BillboardTextures& textures);

  /// Makes room for pictures of this size; scene_depth() holds 0 then.
  void fit(int width_px, int height_px);

  /// [height][width] of reversed depth: near_m over the distance along the line of sight to what hides the
  /// clouds behind it, 0 where nothing does. Row 0 is at the bottom. For callers to fill.
  ocl::Buffer<float>& scene_depth() { return scene_depth_; }

  /// Enqueues the picture for a camera of the size of fit(). Waits for how many particles there are a tile.
  /// Throws Error(bad_usage) for another size or without room for `count` in the buffers, and
  /// Error(out_of_memory) where lists of the particles before each 16 x 16 pixels are more than 1 GiB.
  void draw(const DrawnParticles& drawn, const Camera& camera);

  // Of the last draw(), [height][width], row 0 at the bottom.

  /// RGBA, kcd/m2, premultiplied.
  const ocl::Buffer<std::array<float, 4>>& image() const { return image_; }
  /// Mean distance from the eye of the light of a pixel, m; 0 where there is none.
  const ocl::Buffer<float>& distance_m() const { return distance_; }
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

 private:
  void fit_particles(std::uint32_t count);

  ocl::Device device_;
  ocl::KernelTuning tiles_tuning_, composite_tuning_;
  ocl::Kernel project_kernel_, tiles_kernel_, composite_kernel_;
  ocl::Buffer<std::uint32_t> textures_;
  int width_px_ = 0, height_px_ = 0;
  ocl::Buffer<CloudBillboard> billboards_;
  ocl::Buffer<float> boxes_;  // [4][padded count] px
  ocl::Buffer<std::int32_t> first_, seen_, used_;
  ocl::Buffer<std::uint32_t> list_;
  ocl::Buffer<float> scene_depth_, distance_, marched_distance_, no_shares_;
  ocl::Buffer<std::array<float, 4>> image_, marched_;
};

}  // namespace offing::clouds
