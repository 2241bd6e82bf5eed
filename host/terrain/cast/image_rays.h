#pragma once

#include <cstddef>

#include "host/base/camera.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "host/terrain/field/post_grid.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// How rays are cast on this device.
ocl::KernelTuning ray_tuning(const ocl::Device& device);

/// A camera as kernels take it (shared/terrain.h). Throws what require_valid(camera) throws, and
/// Error(bad_input) for an eye that require_valid(Ray) refuses.
TerrainView device_view(const Camera& camera, const PostGrid& grid);

/// Work-items for the pixels of a camera, as kernels/terrain/image_rays.clh shares them out.
ocl::LaunchShape image_shape(const Camera& camera, const ocl::KernelTuning& rays);

std::size_t pixel_count(const Camera& camera);

/// Throws Error(bad_usage) that names the buffer, unless it holds what is needed.
void require_room(const char* name, std::size_t needed, std::size_t found);

}  // namespace offing::terrain
