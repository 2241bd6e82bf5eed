#include "host/terrain/cast/fine_cast.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

using Places = std::vector<std::size_t>;

[[noreturn]] void throw_too_many(std::size_t needed, std::size_t most) {
  throw Error(
      ErrorKind::bad_input,
      fmt::format("tiles: expected rays that need at most {} tiles each, found one that needs {} or more",
                  most, needed),
      "make the cache larger, or the ray shorter");
}

/// Fills in the hits of a group of rays. Returns those for which there was no room.
Places cast_group(std::span<const Ray> rays, Places group, const CoarseTerrain& terrain,
                  std::vector<RayHit>& hits) {
  const bool is_alone = group.size() == 1;
  std::set<TileKey> tiles;
  while (!group.empty() && tiles.size() <= terrain.most_tiles) {
    terrain.lay({tiles.begin(), tiles.end()});
    std::vector<Ray> some;
    for (const std::size_t i : group) some.push_back(rays[i]);
    const std::vector<RayHit> found = terrain.cast(some);
    Places open;
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (const std::optional<TileKey> finer = terrain.finer_tile(found[i])) {
        tiles.insert(*finer);
        open.push_back(group[i]);
      } else {
        hits[group[i]] = found[i];
      }
    }
    group = std::move(open);
  }
  if (is_alone && !group.empty()) throw_too_many(tiles.size(), terrain.most_tiles);
  return group;
}

}  // namespace

std::vector<RayHit> cast_until_fine(std::span<const Ray> rays, const CoarseTerrain& terrain) {
  std::vector<RayHit> hits(rays.size());
  Places waiting(rays.size());
  std::iota(waiting.rbegin(), waiting.rend(), std::size_t{0});
  std::size_t group_size = rays.size();
  while (!waiting.empty()) {
    const auto first = waiting.end() - static_cast<std::ptrdiff_t>(std::min(group_size, waiting.size()));
    const Places open = cast_group(rays, {first, waiting.end()}, terrain, hits);
    waiting.erase(first, waiting.end());
    waiting.insert(waiting.end(), open.begin(), open.end());
    // Half of those that were too many, however many have been done with them.
    if (!open.empty()) group_size = std::max<std::size_t>(1, open.size() / 2);
  }
  return hits;
}

}  // namespace offing::terrain
