#include "host/clouds/image/cloud_image.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"

namespace offing::clouds {
namespace {

// How much brighter the lit side of a texture's lumps is than their mean.
constexpr float relief = 0.45f;
constexpr std::size_t first_list_entries = 1 << 16;
// 1 GiB.
constexpr std::size_t most_list_entries = std::size_t{1} << 28;

int tiles_along(int pixels) {
  return (pixels + CLOUD_TILE_PX - 1) / CLOUD_TILE_PX;
}

CloudImageParams device_params(const DrawnParticles& drawn, const Camera& camera, int box_pitch) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  const glm::vec3 eye(camera.eye_m - drawn.origin_m), forward(axes.forward), right(axes.right), up(axes.up);
  const glm::vec3 sun(drawn.sun_direction);
  return {.eye_x_m = eye.x,
          .eye_y_m = eye.y,
          .eye_z_m = eye.z,
          .forward_x = forward.x,
          .forward_y = forward.y,
          .forward_z = forward.z,
          .right_x = right.x,
          .right_y = right.y,
          .right_z = right.z,
          .up_x = up.x,
          .up_y = up.y,
          .up_z = up.z,
          .half_width = static_cast<float>(extent.x),
          .half_height = static_cast<float>(extent.y),
          .width_px = camera.width_px,
          .height_px = camera.height_px,
          .tile_columns = tiles_along(camera.width_px),
          .tile_rows = tiles_along(camera.height_px),
          .count = static_cast<int>(drawn.count),
          .box_pitch = box_pitch,
          .sun_x = sun.x,
          .sun_y = sun.y,
          .sun_z = sun.z,
          .near_m = static_cast<float>(drawn.near_m),
          .relief = relief};
}

// In simd shape a work-item draws a tile. Otherwise it draws a pixel, and a group a tile or a part of one.
ocl::LaunchShape composite_shape(const CloudImageParams& params, const ocl::KernelTuning& tuning) {
  const auto columns = static_cast<std::size_t>(params.tile_columns),
             rows = static_cast<std::size_t>(params.tile_rows);
  if (tuning.shape == ocl::KernelShape::simd) return {{columns * rows}, {tuning.group}};
  const std::size_t width = std::min<std::size_t>(tuning.group, CLOUD_TILE_PX);
  return {{columns * CLOUD_TILE_PX, rows * CLOUD_TILE_PX}, {width, tuning.group / width}};
}

}  // namespace

CloudImage::CloudImage(const ocl::Device& device, const BillboardTextures& textures)
    : device_(device),
      tiles_tuning_(ocl::tuning_for(device.info(), "billboard_tiles")),
      composite_tuning_(ocl::tuning_for(device.info(), "billboard_composite")),
      project_kernel_(ocl::Program::build(device, "clouds/billboard_project.cl").kernel("billboard_project")),
      tiles_kernel_(ocl::Program::build(device, "clouds/billboard_tiles.cl",
                                        ocl::Defines().set("LANES", tiles_tuning_.lanes))
                        .kernel("billboard_tiles")),
      composite_kernel_(ocl::Program::build(device, "clouds/billboard_composite.cl",
                                            ocl::Defines().set("LANES", composite_tuning_.lanes))
                            .kernel("billboard_composite")),
      textures_(device, textures.texels, "billboard textures"),
      used_(device, 1, "cloud tiles"),
      list_(device, first_list_entries, "cloud tiles"),
      no_shares_(device, 1, "shares of clouds") {}

void CloudImage::set_textures(const BillboardTextures& textures) {
  textures_.write(textures.texels);
}

void CloudImage::fit(int width_px, int height_px) {
  if (width_px == width_px_ && height_px == height_px_) return;
  const std::size_t pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  const auto tiles =
      static_cast<std::size_t>(tiles_along(width_px)) * static_cast<std::size_t>(tiles_along(height_px));
  scene_depth_ = ocl::Buffer<float>(device_, pixels, "depth before clouds");
  scene_depth_.fill(0.0f);
  image_ = ocl::Buffer<std::array<float, 4>>(device_, pixels, "picture of clouds");
  distance_ = ocl::Buffer<float>(device_, pixels, "distances of clouds");
  marched_ = ocl::Buffer<std::array<float, 4>>(device_, pixels, "picture of marched clouds");
  marched_distance_ = ocl::Buffer<float>(device_, pixels, "distances of marched clouds");
  first_ = ocl::Buffer<std::int32_t>(device_, tiles, "cloud tiles");
  seen_ = ocl::Buffer<std::int32_t>(device_, tiles, "cloud tiles");
  width_px_ = width_px;
  height_px_ = height_px;
}

void CloudImage::fit_particles(std::uint32_t count) {
  if (count <= billboards_.size()) return;
  const std::size_t room = (std::size_t{count} + CLOUD_BOX_PAD - 1) / CLOUD_BOX_PAD * CLOUD_BOX_PAD;
  billboards_ = ocl::Buffer<CloudBillboard>(device_, room, "billboards of clouds");
  boxes_ = ocl::Buffer<float>(device_, 4 * room, "boxes of clouds");
}

void CloudImage::draw(const DrawnParticles& drawn, const Camera& camera) {
  require_valid(camera);
  if (camera.width_px != width_px_ || camera.height_px != height_px_) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("picture of clouds: expected a camera of {} x {} pixels, found {} x {}",
                            width_px_, height_px_, camera.width_px, camera.height_px));
  }
  const std::size_t room = std::min({drawn.particles.size(), drawn.sprites.size(), drawn.order.size()});
  if (room < drawn.count) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("picture of clouds: expected buffers of {} particles, found {}", drawn.count, room));
  }
  fit_particles(std::max(drawn.count, 1u));
  const int box_pitch = static_cast<int>((drawn.count + CLOUD_BOX_PAD - 1) / CLOUD_BOX_PAD * CLOUD_BOX_PAD);
  const CloudImageParams params = device_params(drawn, camera, box_pitch);
  const ocl::LaunchShape picture = composite_shape(params, composite_tuning_);
  const bool has_marched = drawn.resolved != nullptr && drawn.resolved->has_any();
  if (has_marched)
    drawn.resolved->march(picture, params, camera.eye_m, scene_depth_, marched_, marched_distance_);
  if (drawn.count > 0) {
    project_kernel_.launch({{static_cast<std::size_t>(box_pitch)}}, drawn.particles, drawn.sprites,
                           drawn.order, static_cast<int>(has_marched),
                           has_marched ? drawn.resolved->billboard_shares() : no_shares_, params, billboards_,
                           boxes_);
  }
  const std::size_t group = tiles_tuning_.group;
  const ocl::LaunchShape tiles{{(first_.size() + group - 1) / group * group}, {group}};
  while (true) {
    used_.fill(0);
    tiles_kernel_.launch(tiles, boxes_, params, static_cast<int>(list_.size()), first_, seen_, list_, used_);
    const auto used = static_cast<std::size_t>(used_.map()[0]);
    if (used <= list_.size()) break;
    if (used > most_list_entries) {
      throw Error(ErrorKind::out_of_memory,
                  fmt::format("picture of clouds: {} particles cover so many of the {} x {} pixels that "
                              "their tiles need more than {} places",
                              drawn.count, width_px_, height_px_, most_list_entries),
                  "take a smaller picture, fewer particles (clouds.quality), or an eye that is further away");
    }
    list_ = ocl::Buffer<std::uint32_t>(device_, std::min(2 * used, most_list_entries), "cloud tiles");
  }
  composite_kernel_.launch(picture, billboards_, first_, seen_, list_, textures_, scene_depth_,
                           static_cast<int>(has_marched), marched_, marched_distance_, params, image_,
                           distance_);
}

}  // namespace offing::clouds
