#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/search/lighting.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"

namespace offing::highlights {

/// A point of a surface where the normal is the half vector of a light: where Blinn's highlight is brightest.
struct HighlightPoint {
  std::uint32_t face = 0;
  int light = 0;  ///< index into Lighting::lights
  /// 1 where normals turn as the surface does (humps and hollows, K > 0), -1 on saddles. On a closed surface
  /// whose normals vanish nowhere their sum is 1 - genus for every light while H covers less than all
  /// directions.
  int orientation = 1;
  glm::dvec3 weights{1.0, 0.0, 0.0};  ///< of the face's corners, >= 0, their sum is 1
  glm::dvec3 position_m{0.0};
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit, interpolated
  glm::dvec3 e_max{1.0, 0.0, 0.0};   ///< unit, across the normal, of either sign
  double k_max_per_m = 0.0, k_min_per_m = 0.0;
  double n_dot_h = 1.0;
};

/// Where a face's corners with these weights are.
glm::dvec3 place_on(const HighlightSurface& surface, std::uint32_t face, const glm::dvec3& weights);

enum class SearchMethod {
  zeros,          ///< of a field that both faces of an edge share: none lost, none found twice
  least_squares,  ///< face by face as printed, duplicates merged
};

/// Finds highlight points on the device (H3 of docs/sources.md). Between vertices, normals are interpolated
/// and normalised; H is that of each vertex. Results are in the order of light, then face.
class HighlightFinder {
 public:
  explicit HighlightFinder(const ocl::Device& device);

  /// All points of a surface of the same device; eye and lights in the mesh's axes. Waits for the device.
  /// Throws Error(bad_input) for a source that is not finite or has no direction.
  std::vector<HighlightPoint> find(const HighlightSurface& surface, const Lighting& lighting,
                                   SearchMethod method = SearchMethod::zeros);

 private:
  void launch_zeros(const HighlightSurface& surface, int first_light, int light_count);
  void launch_least_squares(const HighlightSurface& surface, int first_light, int light_count);
  int search(const HighlightSurface& surface, const Lighting& lighting, SearchMethod method);

  ocl::Device device_;
  ocl::KernelTuning field_tuning_, points_tuning_;
  ocl::Kernel field_kernel_, points_kernel_, least_squares_kernel_;
  ocl::Buffer<HighlightLight> lights_;
  ocl::Buffer<float> field_;
  ocl::Buffer<std::uint32_t> masks_;
  ocl::Buffer<std::int32_t> count_;
  ocl::Buffer<HighlightRecord> records_;
};

}  // namespace offing::highlights
