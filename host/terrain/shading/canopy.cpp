#include "host/terrain/shading/canopy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/terrain/shading/materials.h"
#include "kernels/shared/terrain_noise.h"

namespace offing::terrain {

std::shared_ptr<const ColourMap> cover_map(ColourMap picture) {
  for (std::size_t texel = 0; texel + 3 < picture.rgba.size(); texel += 4) {
    std::uint8_t* rgba = picture.rgba.data() + texel;
    const int grey = (rgba[0] + rgba[1] + rgba[2] + 1) / 3;
    rgba[3] = static_cast<std::uint8_t>((grey * rgba[3] + 127) / 255);
    rgba[0] = rgba[1] = rgba[2] = 0;
  }
  return std::make_shared<const ColourMap>(std::move(picture));
}

std::optional<Canopy> wood_of(Canopy rules, std::shared_ptr<const ColourMap> map, double tree_line_m) {
  if (!map && !(rules.share > 0.0)) return std::nullopt;
  if (!rules.highest_m) rules.highest_m = tree_line_m;
  rules.map = std::move(map);
  return rules;
}

CanopyLayer::CanopyLayer(const ocl::Device& device, const Canopy& canopy) : no_map_(device, 1, "no woods") {
  constexpr auto step_m = static_cast<double>(TERRAIN_STEP_M);
  const auto narrow = [](double value) { return static_cast<float>(value); };
  params_.height_m = narrow(canopy.height_m);
  params_.red = narrow(canopy.colour.r);
  params_.green = narrow(canopy.colour.g);
  params_.blue = narrow(canopy.colour.b);
  params_.lowest_m = canopy.lowest_m ? narrow(*canopy.lowest_m) : -TERRAIN_NO_LIMIT_M;
  params_.highest_m = canopy.highest_m ? narrow(*canopy.highest_m) : TERRAIN_NO_LIMIT_M;
  params_.edge_m = narrow(canopy.edge_m);
  params_.steepest_rad = narrow(canopy.steepest_rad);
  params_.patch_log2 = static_cast<int>(std::lround(std::log2(canopy.patch_m / step_m)));
  params_.patches = narrow(patch_threshold(canopy.share));
  if (!canopy.map) return;
  map_.emplace(device, *canopy.map);
  TerrainLook look{};
  map_->describe(look);
  params_.map_columns = look.colour_columns;
  params_.map_rows = look.colour_rows;
  params_.map_levels = look.colour_levels;
  params_.map_left = look.colour_left;
  params_.map_top = look.colour_top;
  params_.map_a_cell_x = look.colours_a_cell_x;
  params_.map_a_cell_z = look.colours_a_cell_z;
}

}  // namespace offing::terrain
