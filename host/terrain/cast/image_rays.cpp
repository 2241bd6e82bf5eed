#include "host/terrain/cast/image_rays.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/cast/ray.h"

namespace offing::terrain {

ocl::KernelTuning ray_tuning(const ocl::Device& device) {
  return ocl::tuning_for(device.info(), "terrain_rays");
}

TerrainView device_view(const Camera& camera, const PostGrid& grid) {
  require_valid(camera);
  const Ray ray{.origin_m = camera.eye_m};
  require_valid(ray, grid);
  const TerrainRay eye = device_ray(ray, grid);
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  const glm::vec3 forward(axes.forward), right(extent.x * axes.right), up(extent.y * axes.up);
  return {.cell_x = eye.cell_x,
          .cell_z = eye.cell_z,
          .fraction_x = eye.fraction_x,
          .fraction_z = eye.fraction_z,
          .height_m = eye.height_m,
          .height_rest_m = eye.height_rest_m,
          .forward_x = forward.x,
          .forward_y = forward.y,
          .forward_z = forward.z,
          .right_x = right.x,
          .right_y = right.y,
          .right_z = right.z,
          .up_x = up.x,
          .up_y = up.y,
          .up_z = up.z,
          .width_px = camera.width_px,
          .height_px = camera.height_px};
}

ocl::LaunchShape image_shape(const Camera& camera, const ocl::KernelTuning& rays) {
  const auto width = static_cast<std::size_t>(camera.width_px),
             height = static_cast<std::size_t>(camera.height_px);
  if (rays.shape == ocl::KernelShape::workgroup) return {{width, height}};
  const auto tile_px = static_cast<std::size_t>(rays.lanes);
  return {{(width + tile_px - 1) / tile_px, (height + tile_px - 1) / tile_px}, {rays.group}};
}

std::size_t pixel_count(const Camera& camera) {
  return static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
}

void require_room(const char* name, std::size_t needed, std::size_t found) {
  if (found >= needed) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("terrain {}: expected a buffer of {}, found {}", name, needed, found),
              "make the buffer as large as what is cast");
}

}  // namespace offing::terrain
