#pragma once

#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "host/base/colour_map.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/shading/colour_layer.h"
#include "kernels/shared/terrain_canopy.h"

namespace offing::terrain {

/// A wood over ground of some heights and slopes, as pictures show it.
struct Canopy {
  double height_m = 16.0;                               ///< of its highest crowns
  glm::dvec3 colour{0.036, 0.050, 0.021};               ///< mean diffuse albedo of crowns, linear Rec.709
  std::optional<double> lowest_m = {}, highest_m = {};  ///< heights between which it grows; absent: no limit
  double edge_m = 80.0;                                 ///< difference of height in which it ends there
  double steepest_rad = 0.698131700797731831;  ///< 40 degrees: slopes up to which it grows, from level
  double share = 0.0;                          ///< of that ground, in patches; 0: no wood
  double patch_m = 400.0;                      ///< how large these are
  /// Its cover: the coverage of the picture's texels, whose colours say nothing. None: the rules above.
  std::shared_ptr<const ColourMap> map = {};

  bool operator==(const Canopy&) const = default;
};

/// A map of cover of a picture: white is a dense wood, black and what the picture does not cover is none.
std::shared_ptr<const ColourMap> cover_map(ColourMap picture);

/// The wood of these rules or of this map below the tree line; nothing where there is none.
std::optional<Canopy> wood_of(Canopy rules, std::shared_ptr<const ColourMap> map, double tree_line_m);

/// A wood on a device.
class CanopyLayer {
 public:
  /// Throws what ColourLayer throws.
  CanopyLayer(const ocl::Device& device, const Canopy& canopy);

  const TerrainCanopy& params() const { return params_; }
  /// Of its map, as those of a ColourLayer.
  const ocl::Buffer<std::uint32_t>& texels() const { return map_ ? map_->colours() : no_map_; }

 private:
  TerrainCanopy params_{};
  std::optional<ColourLayer> map_;
  ocl::Buffer<std::uint32_t> no_map_;
};

}  // namespace offing::terrain
