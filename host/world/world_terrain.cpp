#include "host/world/world_terrain.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "host/terrain/cast/image_rays.h"
#include "host/terrain/tiles/tile_posts.h"
#include "host/terrain/walk/relief_height.h"

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
      edge_distances_(device),
      mirrored_cast_(device),
      relief_(device) {
  if (parameters.map) {
    field_.emplace(device, grid_of(parameters), parameters.map->heights_m);
  } else {
    tiles_.emplace(device, placed_map(parameters), parameters.tiles->read, parameters.tiles->cache_bytes);
  }
  if (parameters.colours) colours_.emplace(device, *parameters.colours);
  if (parameters.sees_horizons && field_) open_sky_.emplace(device, *field_);
  make_lakes(parameters);
  make_materials(parameters);
  make_canopy(parameters);
}

void WorldTerrain::make_canopy(const TerrainParameters& parameters) {
  std::optional<terrain::CanopyLayer> canopy;
  if (parameters.canopy) canopy.emplace(device_, *parameters.canopy);
  canopy_ = std::move(canopy);
}

void WorldTerrain::make_materials(const TerrainParameters& parameters) {
  materials_.reset();
  if (!parameters.materials.empty()) materials_.emplace(device_, parameters.materials);
}

void WorldTerrain::make_lakes(const TerrainParameters& parameters) {
  std::vector<std::shared_ptr<const terrain::Lake>> lakes;
  for (const LakeSettings& each : parameters.lakes) lakes.push_back(each.lake);
  lakes_.reset();
  if (!lakes.empty()) lakes_.emplace(device_, lakes);
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
  if (parameters.canopy != parameters_.canopy) make_canopy(parameters);
  parameters_.canopy = parameters.canopy;
  if (are_other_colours) colours_ = std::move(colours);
  if (parameters.lakes != parameters_.lakes) make_lakes(parameters);
  parameters_.lakes = parameters.lakes;
  if (parameters.materials != parameters_.materials) make_materials(parameters);
  parameters_.materials = parameters.materials;
  parameters_.lines = parameters.lines;
  parameters_.relief = parameters.relief;
  parameters_.finest_detail_m = parameters.finest_detail_m;
  parameters_.colours = parameters.colours;
  parameters_.sees_horizons = parameters.sees_horizons;
}

std::optional<terrain::TerrainPoint> WorldTerrain::terrain_at(double x_m, double z_m) const {
  return terrain::terrain_at(posts_, x_m - parameters_.origin_x_m, z_m - parameters_.origin_z_m);
}

std::optional<double> WorldTerrain::surface_m(double x_m, double z_m) const {
  const std::optional<terrain::TerrainPoint> ground = terrain_at(x_m, z_m);
  if (!ground) return std::nullopt;
  double height_m = ground->height_m;
  for (const LakeSettings& each : parameters_.lakes) {
    height_m += terrain::depth_of_lake(*each.lake, posts_, x_m - parameters_.origin_x_m,
                                       z_m - parameters_.origin_z_m);
  }
  return height_m;
}

std::optional<glm::dvec3> WorldTerrain::water_before(const terrain::Ray& ray, double distance_m) const {
  const glm::dvec3 bed_m = ray.origin_m + distance_m * ray.direction;
  for (const LakeSettings& each : parameters_.lakes) {
    const double level_m = each.lake->level_m;
    const double depth_m = terrain::depth_of_lake(*each.lake, posts_, bed_m.x - parameters_.origin_x_m,
                                                  bed_m.z - parameters_.origin_z_m);
    if (depth_m <= 0.0 || ray.origin_m.y <= level_m) continue;
    return ray.origin_m + (level_m - ray.origin_m.y) / ray.direction.y * ray.direction;
  }
  return std::nullopt;
}

void WorldTerrain::look_at_lakes(const Camera& camera, const terrain::TerrainIllumination& light) {
  if (!lakes_) return;
  const TerrainLight& klx = light.light;
  sky::Illuminance illuminance;
  illuminance.sun_klx = {klx.sun_red_klx, klx.sun_green_klx, klx.sun_blue_klx};
  illuminance.sky_klx = {klx.sky_red_klx, klx.sky_green_klx, klx.sky_blue_klx};
  lakes_->set_looks(
      looks_of_lakes(parameters_.lakes, camera.eye_m, time_s_, illuminance, light.sky.sun_direction_y));
}

void WorldTerrain::set_level_discs(std::vector<terrain::LevelDisc> discs) {
  level_discs_ = std::move(discs);
  for (terrain::LevelDisc& disc : level_discs_) {
    disc.x_m -= parameters_.origin_x_m;
    disc.z_m -= parameters_.origin_z_m;
  }
}

terrain::ReliefSettings WorldTerrain::relief_settings() const {
  const bool goes_on = tiles_ && tiles_->map().edge != terrain::MapEdge::ends;
  terrain::ReliefSettings settings = relief_of(parameters_.lines, goes_on ? 0.0 : parameters_.relief);
  settings.discs = level_discs_;
  settings.materials = parameters_.materials;
  for (const LakeSettings& each : parameters_.lakes) settings.lakes.push_back(each.lake);
  return settings;
}

double WorldTerrain::relief_m(double x_m, double z_m) const {
  const std::optional<terrain::TerrainPoint> below = terrain_at(x_m, z_m);
  if (!below) return 0.0;
  const glm::dvec3 feet_m(x_m - parameters_.origin_x_m, below->height_m, z_m - parameters_.origin_z_m);
  return terrain::relief_height_m(posts_, relief_settings(), feet_m.x, feet_m.z, feet_m);
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
          .sea = sea,
          .lakes = lakes_ ? &*lakes_ : nullptr,
          .materials = materials_ ? &*materials_ : nullptr,
          .canopy = canopy_ ? &*canopy_ : nullptr,
          .finest_detail_m = parameters_.finest_detail_m};
}

template <class Field>
void WorldTerrain::lay_planes(const Field& field, const Camera& camera, const terrain::SeaOverTerrain& sea,
                              const terrain::LakeLayer* lakes, TerrainImage& picture) {
  const std::size_t pixels = terrain::pixel_count(camera);
  if (distances_m_.size() < pixels) distances_m_ = ocl::Buffer<float>(device_, pixels, "ground's distances");
  hit_planes_.at(picture.hits, pixels, distances_m_, picture.planes);
  if (lakes != nullptr) lakes->stand_before(field, camera, picture.hits, distances_m_);
  edge_distances_.at(field, camera, sea, picture.image, distances_m_, picture.planes);
}

void WorldTerrain::paint(const Camera& camera, const terrain::TerrainIllumination& light,
                         const terrain::Sampling& sampling, const terrain::SeaOverTerrain& sea,
                         TerrainImage& picture) {
  picture.fit(device_, camera);
  look_at_lakes(camera, light);
  terrain::TerrainAppearance look = look_of(sampling, sea);
  look.relief = &relief_;
  if (field_) {
    field_->cast(camera, relief_, picture.hits);
    shade_.at(*field_, camera, picture.hits, light, picture.image, look);
    lay_planes(*field_, camera, sea, look.lakes, picture);
  } else {
    tiles_->cast(camera, relief_, picture.hits);
    shade_.at(*tiles_, camera, picture.hits, light, picture.image, look);
    lay_planes(*tiles_, camera, sea, look.lakes, picture);
  }
}

bool WorldTerrain::rises_near(const Camera& camera, double shore_m) {
  const glm::dvec2 spacing_m(posts_.spacing_x_m, posts_.spacing_z_m);
  const glm::dvec2 from_first_m(camera.eye_m.x - parameters_.origin_x_m,
                                camera.eye_m.z - parameters_.origin_z_m);
  const glm::ivec2 last(posts_.columns - 1, posts_.rows - 1);
  const glm::ivec2 post(glm::clamp(glm::floor(from_first_m / spacing_m), glm::dvec2(0.0), glm::dvec2(last)));
  if (post != near_.post) {
    const terrain::ReliefLevels levels = terrain::relief_levels(last.x, last.y, spacing_m.x, spacing_m.y);
    const glm::ivec2 reach = glm::ivec2(glm::ceil(levels.reach_m / spacing_m)) + 1;
    const glm::ivec2 begin = glm::max(post - reach, glm::ivec2(0)), end = glm::min(post + reach, last);
    near_ = {post, -std::numeric_limits<float>::infinity()};
    for (int row = begin.y; row <= end.y; ++row) {
      for (int column = begin.x; column <= end.x; ++column)
        near_.height_m = std::max(near_.height_m, posts_.height_m(column, row));
    }
  }
  return near_.height_m > shore_m;
}

void WorldTerrain::lay_relief(const Camera& camera) {
  terrain::ReliefSettings settings = relief_settings();
  if (tiles_) {
    // Of tiles, nothing is waited for: their coarsest level is nowhere below the ground.
    const double above_m = camera.eye_m.y - tiles_->coarse_height_m(camera.eye_m.x, camera.eye_m.z);
    relief_.at(*tiles_, camera, above_m, settings, lakes_ ? &*lakes_ : nullptr);
    return;
  }
  if (settings.strength > 0.0 && !rises_near(camera, settings.shore_m)) settings.strength = 0.0;
  const ReliefView view{camera, std::move(settings)};
  if (laid_ == view) return;
  laid_.reset();
  const std::optional<terrain::TerrainPoint> below = terrain_at(camera.eye_m.x, camera.eye_m.z);
  const double above_m = below ? camera.eye_m.y - below->height_m : std::numeric_limits<double>::infinity();
  relief_.at(*field_, camera, above_m, view.settings, lakes_ ? &*lakes_ : nullptr);
  laid_ = view;
}

void WorldTerrain::at(const Camera& camera, const sky::ClearSky& sky, const TerrainLighting& light,
                      const terrain::Sampling& sampling, TileWait wait, const terrain::SeaOverTerrain& sea) {
  is_in_reach_ = rays_reach(field_ ? field_->grid() : tiles_->grid(), camera.eye_m);
  if (!is_in_reach_) return;
  if (tiles_ && wait == TileWait::all) tiles_->look_and_wait(camera);
  if (tiles_ && wait == TileWait::none) tiles_->look(camera, tiles_ahead_m);
  lay_relief(camera);
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
  terrain::TerrainAppearance look = look_of({.rays = 1}, {});
  look.woods = terrain::WoodsShape::even;
  shade_.at(*field_, mirrored, mirrored_.hits, {light.light, sky.params(), sky.view_table(), light.clouds},
            mirrored_.image, look);
  lay_planes(*field_, mirrored, {}, nullptr, mirrored_);
}

}  // namespace offing::world
