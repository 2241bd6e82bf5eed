#include "host/world/ground_view.h"

#include <algorithm>
#include <span>
#include <utility>

#include "host/terrain/picture.h"
#include "host/terrain/tile_posts.h"

namespace offing::world {
namespace {

terrain::PostGrid grid_of(const GroundParameters& parameters) {
  terrain::PostGrid grid = terrain::post_grid(*parameters.map);
  grid.origin_x_m = parameters.origin_x_m;
  grid.origin_z_m = parameters.origin_z_m;
  return grid;
}

terrain::TiledMap placed_map(const GroundParameters& parameters) {
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

terrain::GroundPosts GroundParameters::posts() const {
  if (map) return terrain::posts_of(map);
  return terrain::posts_of(tiles->map, tiles->read, terrain::Unreadable::stood_in_for);
}

terrain::GroundExtent GroundParameters::extent() const {
  if (map) return terrain::extent_of(*map);
  const terrain::TiledMap& of = tiles->map;
  return {.width_m = of.width_m(), .depth_m = of.depth_m(), .highest_m = of.highest_m};
}

GroundView::GroundView(const ocl::Device& device, const GroundParameters& parameters)
    : device_(device),
      parameters_(parameters),
      posts_(parameters.posts()),
      shade_(device),
      hit_planes_(device) {
  if (parameters.map) {
    field_.emplace(device, grid_of(parameters), parameters.map->heights_m);
  } else {
    tiles_.emplace(device, placed_map(parameters), parameters.tiles->read, parameters.tiles->cache_bytes);
  }
  if (parameters.colours) colours_.emplace(device, *parameters.colours);
  if (parameters.sees_horizons && field_) open_sky_.emplace(device, *field_);
}

void GroundView::set_cover(const GroundParameters& parameters) {
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

std::optional<terrain::GroundPoint> GroundView::ground_at(double x_m, double z_m) const {
  return terrain::ground_at(posts_, x_m - parameters_.origin_x_m, z_m - parameters_.origin_z_m);
}

TerrainHit GroundView::cast(const terrain::Ray& ray) {
  const std::span<const terrain::Ray> one(&ray, 1);
  return (field_ ? field_->cast(one) : tiles_->cast(one)).front();
}

void GroundView::fit(const Camera& camera) {
  if (width_px_ == camera.width_px && height_px_ == camera.height_px) return;
  const std::size_t pixels = terrain::pixel_count(camera);
  hits_ = ocl::Buffer<TerrainHit>(device_, pixels, "ground's hits");
  image_ = ocl::Buffer<terrain::Texel>(device_, pixels, "ground's image");
  planes_ = ocl::Buffer<float>(device_, terrain::HitPlanes::plane_count * pixels, "ground's planes");
  width_px_ = camera.width_px;
  height_px_ = camera.height_px;
}

void GroundView::at(const Camera& camera, const sky::ClearSky& sky, const LightOnGround& light,
                    const terrain::Sampling& sampling, TileWait wait, const terrain::SeaOverGround& sea) {
  is_in_reach_ = rays_reach(field_ ? field_->grid() : tiles_->grid(), camera.eye_m);
  if (!is_in_reach_) return;
  fit(camera);
  sea_ = sea;
  const terrain::GroundLook look{.sampling = sampling,
                                 .colours = colours_ ? &*colours_ : nullptr,
                                 .open_sky = open_sky_ ? &*open_sky_ : nullptr,
                                 .sea = sea};
  const terrain::GroundLight ground_light{light.light, sky.params(), sky.view_table(), light.clouds};
  if (field_) {
    field_->cast(camera, hits_);
    shade_.at(*field_, camera, hits_, ground_light, image_, look);
  } else {
    if (wait == TileWait::all) {
      tiles_->look_and_wait(camera);
    } else {
      tiles_->look(camera, tiles_ahead_m);
    }
    tiles_->cast(camera, hits_);
    shade_.at(*tiles_, camera, hits_, ground_light, image_, look);
  }
  hit_planes_.at(hits_, terrain::pixel_count(camera), planes_);
}

}  // namespace offing::world
