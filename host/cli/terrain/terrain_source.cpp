#include "host/cli/terrain/terrain_source.h"

#include "host/base/error.h"
#include "host/scene/prepare/stored_terrain.h"
#include "host/terrain/tiles/tile_posts.h"

namespace offing::cli {
TerrainSource::TerrainSource(const TerrainInput& input, const CacheFlags& cache) : use_(cache.read()) {
  require_flags_of(input, cache);
  if (is_tile_store(input.file())) {
    store_.emplace(input.file(), input.trust());
    posts_ = terrain::posts_of(scene::tiled_map(store_->header()), scene::tile_reader(*store_),
                               terrain::Unreadable::refused);
    frame_ = frame_of(input.file(), scene::place_of(store_->header()));
  } else {
    map_ = input.read().map;
    frame_ = frame_of(input.file(), *map_);
    posts_ = terrain::posts_of(*map_);
  }
}

terrain::PostGrid TerrainSource::grid() const {
  return {.columns = posts_.columns,
          .rows = posts_.rows,
          .spacing_x_m = posts_.spacing_x_m,
          .spacing_z_m = posts_.spacing_z_m};
}

void TerrainSource::open(const ocl::Device& device) {
  if (map_) {
    field_.emplace(make_field(*map_, device));
  } else {
    tiles_.emplace(make_field(*store_, device, use_));
  }
}

std::vector<terrain::RayHit> TerrainSource::cast(std::span<const terrain::Ray> rays,
                                                 const terrain::EarthCurve& curve,
                                                 terrain::HitNormals normals) {
  if (!field_ && !tiles_)
    throw Error(ErrorKind::bad_usage, "terrain ground: expected a device first", "call open()");
  if (field_) {
    // Rays over flat ground need a kernel that is there already.
    return curve.bend_perm() == 0.0 ? field_->cast(rays, terrain::CastMethod::parity, normals)
                                    : field_->cast(rays, curve, normals);
  }
  std::vector<terrain::RayHit> hits = tiles_->cast_fully(rays, curve);
  if (normals == terrain::HitNormals::patch) return hits;
  for (terrain::RayHit& hit : hits) {
    if (hit.kind != TERRAIN_SURFACE && hit.kind != TERRAIN_INSIDE) continue;
    const auto normal =
        terrain::smooth_normal_at(posts_, (hit.cell_x + static_cast<double>(hit.u)) * posts_.spacing_x_m,
                                  (hit.cell_z + static_cast<double>(hit.v)) * posts_.spacing_z_m);
    if (!normal) continue;
    hit.normal_x = static_cast<float>(normal->x);
    hit.normal_y = static_cast<float>(normal->y);
    hit.normal_z = static_cast<float>(normal->z);
  }
  return hits;
}

}  // namespace offing::cli
