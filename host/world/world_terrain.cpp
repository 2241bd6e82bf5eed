#include "host/world/world_terrain.h"

#include <algorithm>
#include <span>
#include <utility>

#include "host/terrain/cast/image_rays.h"
#include "host/terrain/tiles/tile_posts.h"

namespace offing::world {
namespace {

terrain::PostGrid grid_of(const TerrainParameters& parameters) {
  terrain::PostGrid grid = terrain::post_grid(*parameters.map);
  grid.origin_x_m = parameters.origin_x_m;
  grid.origin_z_m = parameters.origin_z_m;
  return grid;
}

terrain::TiledMap placed_map(const TerrainParameters& parameters) {
  terrain::TiledMap map = parameters.tiles->map;
  map.origin_x_m = parameters.origin_x_m;
  map.origin_z_m = parameters.origin_z_m;
  return map;
}

// As far ahead of a moving camera tiles are loaded before it is there: a second of fast flight.
constexpr double tiles_ahead_m = 300.0;

bool rays_reach(const terrain::PostGrid& grid, const glm::dvec3& eye_m) {
  return terrain::cells_beyond(grid, eye_m.x, eye_m.z) <= terrain::farthest_origin_cells;
}

}  // namespace

void TerrainImage::fit(const ocl::Device& device, const Camera& camera) {
  if (width_px == camera.width_px && height_px == camera.height_px) return;
  const std::size_t pixels = terrain::pixel_count(camera);
  hits = ocl::Buffer<TerrainHit>(device, pixels, "ground's hits");
  image = ocl::Buffer<terrain::Texel>(device, pixels, "ground's image");
  planes = ocl::Buffer<float>(device, terrain::HitPlanes::plane_count * pixels, "ground's planes");
  width_px = camera.width_px;
  height_px = camera.height_px;
}

terrain::TerrainPosts TerrainParameters::posts() const {
  if (map) return terrain::posts_of(map);
  return terrain::posts_of(tiles->map, tiles->read, terrain::Unreadable::stood_in_for);
}

terrain::TerrainExtent TerrainParameters::extent() const {
  if (map) return terrain::extent_of(*map);
  const terrain::TiledMap& of = tiles->map;
  return {.width_m = of.width_m(), .depth_m = of.depth_m(), .highest_m = of.highest_m};
}

WorldTerrain::WorldTerrain(const ocl::Device& device, const TerrainParameters& parameters)
    : device_(device),
      parameters_(parameters),
      posts_(parameters.posts()),
      shade_(device),
      hit_planes_(device),
      mirrored_cast_(device) {
  if (parameters.map) {
    field_.emplace(device, grid_of(parameters), parameters.map->heights_m);
  } else {
    tiles_.emplace(device, placed_map(parameters), parameters.tiles->read, parameters.tiles->cache_bytes);
  }
  if (parameters.colours) colours_.emplace(device, *parameters.colours);
  if (parameters.sees_horizons && field_) open_sky_.emplace(device, *field_);
}

void WorldTerrain::set_cover(const TerrainParameters& parameters) {
  const bool are_other_colours = parameters.colours != parameters_.colours;
  std::optional<terrain::ColourLayer> colours;
  if (are_other_colours && parameters.colours) colours.emplace(device_, *parameters.colours);
  if (!parameters.sees_horizons) {
    open_sky_.reset();
  } else if (!open_sky_ && field_) {
    open_sky_.emplace(device_, *field_);
  }
  if (are_other_colours) colours_ = std::move(colours);
  parameters_.lines = parameters.lines;
  parameters_.colours = parameters.colours;
  parameters_.sees_horizons = parameters.sees_horizons;
}

std::optional<terrain::TerrainPoint> WorldTerrain::terrain_at(double x_m, double z_m) const {
  return terrain::terrain_at(posts_, x_m - parameters_.origin_x_m, z_m - parameters_.origin_z_m);
}

terrain::RayHit WorldTerrain::cast(const terrain::Ray& ray) {
  const std::span<const terrain::Ray> one(&ray, 1);
  return (field_ ? field_->cast(one) : tiles_->cast(one)).front();
}

terrain::TerrainAppearance WorldTerrain::look_of(const terrain::Sampling& sampling,
                                                 const terrain::SeaOverTerrain& sea) const {
  return {.sampling = sampling,
          .colours = colours_ ? &*colours_ : nullptr,
          .open_sky = open_sky_ ? &*open_sky_ : nullptr,
          .sea = sea};
}

void WorldTerrain::paint(const Camera& camera, const terrain::TerrainIllumination& light,
                         const terrain::Sampling& sampling, const terrain::SeaOverTerrain& sea,
                         TerrainImage& picture) {
  picture.fit(device_, camera);
  picture.sea = sea;
  const terrain::TerrainAppearance look = look_of(sampling, sea);
  if (field_) {
    field_->cast(camera, picture.hits);
    shade_.at(*field_, camera, picture.hits, light, picture.image, look);
  } else {
    tiles_->cast(camera, picture.hits);
    shade_.at(*tiles_, camera, picture.hits, light, picture.image, look);
  }
  hit_planes_.at(picture.hits, terrain::pixel_count(camera), picture.planes);
}

void WorldTerrain::at(const Camera& camera, const sky::ClearSky& sky, const TerrainLighting& light,
                      const terrain::Sampling& sampling, TileWait wait, const terrain::SeaOverTerrain& sea) {
  is_in_reach_ = rays_reach(field_ ? field_->grid() : tiles_->grid(), camera.eye_m);
  if (!is_in_reach_) return;
  if (tiles_ && wait == TileWait::all) tiles_->look_and_wait(camera);
  if (tiles_ && wait == TileWait::none) tiles_->look(camera, tiles_ahead_m);
  paint(camera, {light.light, sky.params(), sky.view_table(), light.clouds}, sampling, sea, image_);
}

void WorldTerrain::beneath_at(const Camera& camera, const sky::ClearSky& sky, const TerrainLighting& light,
                              const terrain::SeaOverTerrain& sea) {
  if (!is_in_reach_) return;
  paint(camera, {light.light, sky.params(), sky.view_table(), light.clouds}, {.rays = 1}, sea, beneath_);
}

void WorldTerrain::mirror_at(const Camera& mirrored, double plane_m, const sky::ClearSky& sky,
                             const TerrainLighting& light) {
  is_mirrored_ = field_ && rays_reach(field_->grid(), mirrored.eye_m);
  if (!is_mirrored_) return;
  mirrored_.fit(device_, mirrored);
  mirrored_cast_.at(*field_, mirrored, plane_m, mirrored_.hits);
  shade_.at(*field_, mirrored, mirrored_.hits, {light.light, sky.params(), sky.view_table(), light.clouds},
            mirrored_.image, look_of({.rays = 1}, {}));
  hit_planes_.at(mirrored_.hits, terrain::pixel_count(mirrored), mirrored_.planes);
}

}  // namespace offing::world
