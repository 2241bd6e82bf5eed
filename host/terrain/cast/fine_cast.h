#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/base/height_tile.h"
#include "host/terrain/cast/ray.h"

namespace offing::terrain {

/// Ground of which only parts are there, the rest being stood in for by coarser ground that is nowhere lower.
struct CoarseTerrain {
  std::size_t most_tiles;                                           ///< that can be laid at once
  std::function<void(const std::vector<TileKey>&)> lay;             ///< these, and nothing else that is fine
  std::function<std::optional<TileKey>(const RayHit&)> finer_tile;  ///< nothing for a hit of fine ground
  std::function<std::vector<RayHit>(std::span<const Ray>)> cast;
};

/// What rays hit first of the fine ground: ever more of the tiles are laid that rays hit coarsely, until none
/// does. A ray that misses coarse ground misses the fine too, so that few tiles are asked for. All that a ray
/// has asked for stays until it is done; where that is too much for all rays, they are taken in smaller
/// groups. Throws Error(bad_input) where it is too much for one.
std::vector<RayHit> cast_until_fine(std::span<const Ray> rays, const CoarseTerrain& terrain);

}  // namespace offing::terrain
