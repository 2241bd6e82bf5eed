#include "host/terrain/cast/relief_surface.h"

#include <algorithm>
#include <cmath>

#include "host/terrain/cast/image_rays.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::terrain {
namespace {

// Steps of the first level are at most so long.
constexpr double longest_step_m = 0.25;
constexpr int most_steps_log2 = 30;  // along a map, so that their numbers are ints
constexpr std::size_t most_discs = 64;
constexpr std::size_t posts_a_level = std::size_t{TERRAIN_RELIEF_POSTS} * TERRAIN_RELIEF_POSTS;

int in_steps(int cell, float fraction, int steps_log2) {
  return (cell << steps_log2) +
         static_cast<int>(std::floor(std::ldexp(static_cast<double>(fraction), steps_log2)));
}

}  // namespace

ReliefLevels relief_levels(int cells_x, int cells_z, double spacing_x_m, double spacing_z_m) {
  const auto wanted =
      static_cast<int>(std::ceil(std::log2(std::max(spacing_x_m, spacing_z_m) / longest_step_m)));
  const int most = most_steps_log2 - static_cast<int>(std::ceil(std::log2(std::max(cells_x, cells_z))));
  ReliefLevels levels{.finest_log2 = std::min(wanted, most)};
  levels.count = std::clamp((levels.finest_log2 + 1) / TERRAIN_RELIEF_RATIO_LOG2, 0, TERRAIN_RELIEF_LEVELS);
  if (levels.count == 0) return levels;
  const int coarsest_log2 = levels.finest_log2 - (levels.count - 1) * TERRAIN_RELIEF_RATIO_LOG2;
  // The eye is anywhere within the four steps between posts of the next level.
  levels.reach_m =
      std::ldexp((TERRAIN_RELIEF_CELLS / 2 - 8) * std::min(spacing_x_m, spacing_z_m), -coarsest_log2);
  return levels;
}

ReliefSurface::ReliefSurface(const ocl::Device& device)
    : device_(device),
      rays_(ray_tuning(device)),
      base_(ocl::Program::build(device, "terrain/pyramid_base.cl").kernel("pyramid_base")),
      reduce_(ocl::Program::build(device, "terrain/pyramid_reduce.cl").kernel("pyramid_reduce")),
      heights_m_(device, TERRAIN_RELIEF_LEVELS * posts_a_level, "relief"),
      maxima_m_(device, std::size_t{TERRAIN_RELIEF_LEVELS} * TERRAIN_RELIEF_NODES, "relief maxima"),
      discs_(device, most_discs, "relief discs"),
      no_lakes_(device, 1, "no lakes"),
      no_cells_(device, 1, "no cells of lakes"),
      materials_(device, std::vector<Material>(1)) {}

bool ReliefSurface::choose_levels(const TerrainField& field, const TerrainView& eye, double above_m,
                                  const ReliefSettings& settings) {
  params_ = {};
  const bool is_over_map =
      eye.cell_x >= 0 && eye.cell_x < field.cells_x && eye.cell_z >= 0 && eye.cell_z < field.cells_z;
  if (!is_over_map || !(settings.strength > 0.0)) return false;
  const auto spacing_m = [](float cells_per_m) { return 1.0 / static_cast<double>(cells_per_m); };
  const ReliefLevels levels = relief_levels(field.cells_x, field.cells_z, spacing_m(field.cells_per_m_x),
                                            spacing_m(field.cells_per_m_z));
  if (levels.count == 0 || above_m >= levels.reach_m) return false;
  const auto narrow = [](double value) { return static_cast<float>(value); };
  params_.levels = levels.count;
  params_.finest_log2 = levels.finest_log2;
  params_.middle_x = in_steps(eye.cell_x, eye.fraction_x, levels.finest_log2);
  params_.middle_z = in_steps(eye.cell_z, eye.fraction_z, levels.finest_log2);
  params_.eye_cell_x = eye.cell_x;
  params_.eye_cell_z = eye.cell_z;
  params_.eye_fraction_x = eye.fraction_x;
  params_.eye_fraction_z = eye.fraction_z;
  params_.eye_height_m = eye.height_m;
  params_.strength = narrow(settings.strength);
  params_.reach_m = narrow(levels.reach_m);
  params_.shore_m = narrow(settings.shore_m);
  params_.tree_line_m = narrow(settings.tree_line_m);
  params_.snow_line_m = narrow(settings.snow_line_m);
  std::vector<TerrainReliefDisc> discs;
  const auto away_m = [](const TerrainReliefDisc& disc) { return std::hypot(disc.east_m, disc.south_m); };
  for (const LevelDisc& disc : settings.discs) {
    const double east_m =
        disc.x_m - (eye.cell_x + static_cast<double>(eye.fraction_x)) * spacing_m(field.cells_per_m_x);
    const double south_m =
        disc.z_m - (eye.cell_z + static_cast<double>(eye.fraction_z)) * spacing_m(field.cells_per_m_z);
    if (std::hypot(east_m, south_m) >= levels.reach_m + disc.radius_m + disc.ramp_m()) continue;
    discs.push_back(
        {narrow(east_m), narrow(south_m), narrow(disc.radius_m), narrow(disc.ramp_m()), narrow(disc.share)});
  }
  if (discs.size() > most_discs) {
    std::ranges::nth_element(discs, discs.begin() + most_discs, {}, away_m);
    discs.resize(most_discs);
  }
  if (!discs.empty()) discs_.write(discs);
  params_.discs = static_cast<int>(discs.size());
  if (laid_materials_ != settings.materials) {
    if (!settings.materials.empty()) materials_ = MaterialLayer(device_, settings.materials);
    laid_materials_ = settings.materials;
  }
  return true;
}

void ReliefSurface::lay(const ocl::Kernel& posts, const ocl::Buffer<float>& heights_m,
                        const ocl::Buffer<float>& maxima_m, const TerrainField& field,
                        const TerrainView& view, const LakeLayer* lakes) {
  const ocl::LaunchShape shape = ocl::launch_shape(rays_, TERRAIN_RELIEF_POSTS, TERRAIN_RELIEF_POSTS);
  const auto level_begin = [](int level) { return level * static_cast<int>(posts_a_level); };
  for (int level = params_.levels - 1; level >= 0; --level) {
    posts.launch(shape, heights_m, maxima_m, field, view, params_, discs_,
                 lakes ? lakes->waters() : no_lakes_, lakes ? lakes->cells() : no_cells_,
                 lakes ? lakes->count() : 0, materials_.materials(), static_cast<int>(laid_materials_.size()),
                 level, heights_m_);
    std::size_t nodes = TERRAIN_RELIEF_CELLS / 2;
    int begin = level * TERRAIN_RELIEF_NODES;
    base_.launch({{nodes, nodes}}, heights_m_, level_begin(level), TERRAIN_RELIEF_POSTS, TERRAIN_RELIEF_POSTS,
                 static_cast<int>(nodes), maxima_m_, begin);
    while (nodes > 1) {
      const int next = begin + static_cast<int>(nodes * nodes);
      nodes /= 2;
      reduce_.launch({{nodes, nodes}}, maxima_m_, begin, static_cast<int>(nodes), next);
      begin = next;
    }
  }
}

void ReliefSurface::at(const HeightField& field, const Camera& camera, double above_m,
                       const ReliefSettings& settings, const LakeLayer* lakes) {
  const TerrainField of_map = field.device_field(CastMethod::parity);
  const TerrainView view = device_view(camera, field.grid());
  if (!choose_levels(of_map, view, above_m, settings)) return;
  if (!map_posts_) {
    const ocl::Defines defines =
        ocl::Defines().set("LANES", rays_.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT);
    map_posts_ = ocl::Program::build(device_, "terrain/relief_posts.cl", defines).kernel("relief_posts");
  }
  lay(*map_posts_, field.heights_m(), field.pyramid().maxima_m(), of_map, view, lakes);
}

void ReliefSurface::at(const TiledField& field, const Camera& camera, double above_m,
                       const ReliefSettings& settings, const LakeLayer* lakes) {
  params_ = {};
  if (field.map().edge != MapEdge::ends) return;
  const TerrainField of_map = field.device_field();
  const TerrainView view = field.device_view(camera);
  if (!choose_levels(of_map, view, above_m, settings)) return;
  if (!tile_posts_) {
    tile_posts_ =
        ocl::Program::build(device_, "terrain/relief_posts.cl", tiles_defines(rays_.lanes, MapEdge::ends))
            .kernel("relief_posts");
  }
  lay(*tile_posts_, field.pool(), field.pages(), of_map, view, lakes);
}

}  // namespace offing::terrain
