#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "kernels/shared/terrain_materials.h"

namespace offing::terrain {

/// The ground whose relief and pattern a material has.
enum class MaterialLike { grass, scree, rock, sand };

/// A material over the ground's own cover, between heights and between slopes.
struct Material {
  std::string name = {};
  MaterialLike like = MaterialLike::rock;
  glm::dvec3 colour{0.2};                               ///< mean diffuse albedo, linear Rec.709
  double roughness = 1.0;                               ///< strength of its relief
  std::optional<double> lowest_m = {}, highest_m = {};  ///< heights between which it lies; absent: no limit
  double edge_m = 10.0;                                 ///< height difference over which it fades out there
  double gentlest_rad = 0.0;                            ///< slopes between which it lies, from level
  std::optional<double> steepest_rad = {};              ///< absent: no limit
  double share = 1.0;                                   ///< of that ground, in patches

  bool operator==(const Material&) const = default;
};

/// How many deviations noise exceeds on this share of the ground; beyond all noise for all of it.
double patch_threshold(double share);

/// Materials of a landscape. `plain` has none: the ground's own cover is all there is.
enum class Landscape { plain, alpine, desert, tropical, volcanic };

/// Heights at which the cover of ground changes, m.
struct LandscapeLines {
  double shore_m = 0.0;  ///< up to which sand or water is
  double tree_line_m = 2000.0;
};

/// The materials of a landscape, in the order in which they are laid.
std::vector<Material> materials_of(Landscape landscape, const LandscapeLines& lines);

/// Materials as kernels read them, in the same order.
std::vector<TerrainMaterial> device_materials(std::span<const Material> materials);

/// Materials on a device, in their order. Later ones lie over earlier ones.
class MaterialLayer {
 public:
  MaterialLayer(const ocl::Device& device, std::span<const Material> materials);

  int count() const { return static_cast<int>(materials_.size()); }
  const ocl::Buffer<TerrainMaterial>& materials() const { return materials_; }

 private:
  ocl::Buffer<TerrainMaterial> materials_;
};

}  // namespace offing::terrain
