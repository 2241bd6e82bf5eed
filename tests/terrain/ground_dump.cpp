// ground_dump FILE: rays and pictures of a small map through every kernel of the terrain, on the device that
// the environment names. FILE: distances in metres by all methods (1e6 where rays miss), then the pictures'
// light: plain, and with a colour map over half of the ground, shares of the sky and automatic sampling;
// then a viewshed, a lake and materials, ground with relief, woods, and rays and pictures of a map in tiles.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/lakes/lake.h"
#include "host/terrain/shading/canopy.h"
#include "host/terrain/shading/terrain_shade.h"
#include "tests/ocl/dump_program.h"
#include "tests/terrain/example_tiles.h"

namespace {

using namespace offing;
using terrain::Texel;

class Dump {
 public:
  explicit Dump(const char* path) : file_(path, std::ios::binary) {}
  void add(float value) { file_.write(reinterpret_cast<const char*>(&value), sizeof(value)); }
  /// Throws Error(file) unless all was written.
  void finish() {
    file_.close();
    if (!file_) throw Error(ErrorKind::file, "the dump cannot be written", "make room");
  }
  void add_distance(double distance_m) {
    add(std::isinf(distance_m) ? 1e6f : static_cast<float>(distance_m));
  }

 private:
  std::ofstream file_;
};

/// 5 x 7 texels, every third not covered, over the west of the map.
ColourMap coloured_squares() {
  ColourMap map{.columns = 5, .rows = 7, .rgba = {}, .left = 0.0, .top = 1.0, .right = 25.0, .bottom = 37.0};
  for (int i = 0; i < 35; ++i) {
    for (const int value : {7 * i, 255 - 6 * i, 90, i % 3 == 0 ? 0 : 255}) {
      map.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return map;
}

/// What lies on the ground of a picture; nullptr: nothing.
struct Layers {
  const terrain::ReliefSurface* relief = nullptr;
  const terrain::LakeLayer* lakes = nullptr;
  const terrain::CanopyLayer* canopy = nullptr;
};

template <class Field>
void dump_image(const ocl::Device& device, Field& field, const Camera& camera, Dump& dump,
                const Layers& layers = {}) {
  const auto pixels = static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  ocl::Buffer<TerrainHit> hits(device, pixels, "hits");
  ocl::Buffer<float> distances_m(device, pixels, "distances");
  // Light of woods turns hits of the ground into hits of crowns.
  const auto cast = [&] {
    layers.relief == nullptr ? field.cast(camera, hits) : field.cast(camera, *layers.relief, hits);
  };
  cast();
  if (layers.relief == nullptr) {
    field.cast(camera, distances_m);
    for (const float distance_m : distances_m.read()) dump.add_distance(static_cast<double>(distance_m));
  } else {
    for (const TerrainHit& hit : hits.read()) dump.add_distance(static_cast<double>(hit.distance_m));
  }
  TerrainLight light{};
  light.sun_red_klx = light.sun_green_klx = light.sun_blue_klx = 90.0f;
  light.sky_red_klx = light.sky_green_klx = light.sky_blue_klx = 12.0f;
  light.rayleigh_scale_height_m = 8000.0f;
  light.aerosol_scale_height_m = 1200.0f;
  light.aerosol_perm = 1e-4f;
  light.sea_level_m = -20.0f;
  light.tree_line_m = 20.0f;
  light.snow_line_m = 50.0f;
  SkyParams sky{};
  sky.sun_direction_x = 0.8f;
  sky.sun_direction_y = 0.6f;
  sky.sun_angular_radius_rad = 0.05f;
  sky.ground_radius_m = 6.36e6f;
  sky.eye_altitude_m = 2.0f;
  const std::vector<Texel> table(SKY_VIEW_COLUMNS * SKY_VIEW_ROWS * SKY_VIEW_LAYERS,
                                 Texel{1.0f, 2.0f, 3.0f, 0.0f});
  const ocl::Buffer<Texel> view_table(device, table, "sky");
  ocl::Buffer<Texel> image(device, pixels, "image");
  terrain::TerrainShade shade(device);
  const terrain::ColourLayer colours(device, coloured_squares());
  std::optional<terrain::OpenSky> open_sky;
  terrain::TerrainAppearance rich{
      .sampling = {}, .colours = &colours, .canopy = layers.canopy, .relief = layers.relief};
  const terrain::MaterialLayer materials(
      device, std::vector<terrain::Material>{
                  {.like = terrain::MaterialLike::scree, .colour = {0.3, 0.2, 0.1}, .share = 0.5},
                  {.highest_m = 20.0, .edge_m = 5.0, .gentlest_rad = 0.4}});
  if (layers.lakes != nullptr) {
    rich.lakes = layers.lakes;
    rich.materials = &materials;
  }
  if constexpr (std::is_same_v<Field, terrain::HeightField>) rich.open_sky = &open_sky.emplace(device, field);
  for (const terrain::TerrainAppearance& look :
       {terrain::TerrainAppearance{.sampling = {.rays = 1}, .canopy = layers.canopy, .relief = layers.relief},
        rich}) {
    cast();
    shade.at(field, camera, hits, {light, sky, view_table}, image, look);
    for (const Texel& texel : image.read()) {
      std::for_each(texel.begin(), texel.end(), [&](float v) { dump.add(v); });
    }
  }
}

/// Light of a lake with two waves in the map's deepest basin, on ground with materials.
void dump_lake(const ocl::Device& device, terrain::HeightField& field, const test::HeightMap& map,
               Dump& dump) {
  const terrain::TerrainPosts posts{
      .columns = map.grid.columns,
      .rows = map.grid.rows,
      .spacing_x_m = map.grid.spacing_x_m,
      .spacing_z_m = map.grid.spacing_z_m,
      .height_m =
          [&](int column, int row) {
            return map.heights_m[static_cast<std::size_t>(row * map.grid.columns + column)];
          },
      .is_void = [](int, int) { return false; }};
  std::optional<terrain::Lake> deepest;
  for (int row = 2; row + 2 < map.grid.rows; ++row) {
    for (int column = 2; column + 2 < map.grid.columns; ++column) {
      const double x_m = map.grid.spacing_x_m * column, z_m = map.grid.spacing_z_m * row;
      const auto is_higher = [&](int across, int down) {
        return posts.height_m(column + across, row + down) > posts.height_m(column, row);
      };
      if (!is_higher(1, 0) || !is_higher(-1, 0) || !is_higher(0, 1) || !is_higher(0, -1)) continue;
      try {
        terrain::Lake lake = terrain::fill_lake(posts, x_m, z_m, {});
        if (!deepest || lake.volume_m3 > deepest->volume_m3) deepest = std::move(lake);
      } catch (const Error&) {
        // Water runs off the map from there.
      }
    }
  }
  if (!deepest) throw Error(ErrorKind::bad_usage, "the dump has no lake", "take another map");
  const glm::dvec3 middle_m(map.grid.spacing_x_m * (deepest->first_column + 0.5 * deepest->columns),
                            deepest->level_m,
                            map.grid.spacing_z_m * (deepest->first_row + 0.5 * deepest->rows));
  terrain::LakeLayer lakes(device, {std::make_shared<const terrain::Lake>(*deepest)});
  terrain::LakeLook look;
  look.water.ripples_xx = look.water.ripples_zz = 1e-3f;
  look.water.attenuation_red_perm = look.water.attenuation_green_perm = look.water.attenuation_blue_perm =
      0.2f;
  look.waves = {{0.3f, 0.1f, 0.05f, 1.0f}, {1.0f, -0.4f, 0.03f, 2.0f}};
  lakes.set_looks({&look, 1});
  dump_image(
      device, field,
      {.eye_m = middle_m + glm::dvec3(0.0, 40.0, 60.0), .pitch_rad = -0.5, .width_px = 21, .height_px = 11},
      dump, {.lakes = &lakes});
}

/// Distances and light of ground with relief, on a map so fine that it has one level of few posts.
void dump_relief(const ocl::Device& device, Dump& dump) {
  const test::HeightMap map =
      test::valleys({.columns = 60, .rows = 52, .spacing_x_m = 0.3, .spacing_z_m = 0.3});
  terrain::HeightField field(device, map.grid, map.heights_m);
  const Camera camera{
      .eye_m = {9.0, field.highest_m() + 1.0, 12.0}, .pitch_rad = -0.6, .width_px = 18, .height_px = 7};
  terrain::ReliefSurface relief(device);
  relief.at(field, camera, 2.0, {.strength = 2.0, .tree_line_m = -100.0, .snow_line_m = 1000.0});
  if (!relief.is_laid()) throw Error(ErrorKind::bad_usage, "the dump has no relief", "take a coarser map");
  dump_image(device, field, camera, dump, {.relief = &relief});
}

/// Light of woods, with crowns near and far: by rules, and by a map of their cover.
void dump_woods(const ocl::Device& device, terrain::HeightField& field, Dump& dump) {
  const terrain::Canopy by_rules{.lowest_m = -30.0,
                                 .highest_m = 60.0,
                                 .edge_m = 10.0,
                                 .steepest_rad = 1.2,
                                 .share = 0.6,
                                 .patch_m = 100.0};
  terrain::Canopy by_map{.height_m = 25.0};
  by_map.map = terrain::cover_map(coloured_squares());
  for (const terrain::Canopy& wood : {by_rules, by_map}) {
    const terrain::CanopyLayer canopy(device, wood);
    dump_image(device, field,
               {.eye_m = {200.0, 130.0, 440.0}, .pitch_rad = -0.4, .width_px = 21, .height_px = 11}, dump,
               {.canopy = &canopy});
  }
}

void dump_viewshed(const ocl::Device& device, const terrain::HeightField& field, Dump& dump) {
  const terrain::PostGrid& grid = field.grid();
  ocl::Buffer<std::uint8_t> seen(
      device, static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), "seen");
  terrain::Viewshed(device).at(field,
                               {.observer_x_m = 201.0,
                                .observer_z_m = 130.0,
                                .observer_height_m = 3.0,
                                .target_height_m = 1.0,
                                .radius_m = 300.0,
                                .curve = {.radius_m = 1e5, .refraction = 0.13}},
                               seen);
  for (const std::uint8_t post : seen.read()) dump.add(post);
}

/// Tiles of two levels, of which a coarse picture wants both, and beyond the map its mirror.
void dump_tiles(const ocl::Device& device, Dump& dump) {
  constexpr std::size_t cache_bytes = std::size_t{34} << 20;
  const test::ExampleTiles example(test::valleys({.columns = 290, .rows = 270}));
  for (const terrain::MapEdge edge : {terrain::MapEdge::ends, terrain::MapEdge::mirrors}) {
    terrain::TiledField field(device, example.tiled_map(edge), example.reader(), cache_bytes);
    const Camera camera{
        .eye_m = {250.0, 90.0, 250.0}, .yaw_rad = 0.5, .pitch_rad = -0.3, .width_px = 18, .height_px = 7};
    field.look_and_wait(camera);
    dump_image(device, field, camera, dump);
    for (const terrain::RayHit& hit : field.cast(test::example_rays(example.map(), 40, 52))) {
      dump.add_distance(hit.distance_m);
    }
  }
}

void write_dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map =
      test::valleys({.columns = 45, .rows = 38, .spacing_x_m = 10.0, .spacing_z_m = 12.5});
  terrain::HeightField field(device, map.grid, map.heights_m);
  Dump dump(path);
  using terrain::CastMethod;
  const std::vector<terrain::Ray> rays = test::example_rays(map, 90, 51);
  for (const CastMethod method :
       {CastMethod::parity, CastMethod::paper, CastMethod::pdm, CastMethod::linear}) {
    for (const terrain::RayHit& hit : field.cast(rays, method)) dump.add_distance(hit.distance_m);
  }
  // From above, whose rays go one way in part of the blocks, and from within.
  dump_image(device, field,
             {.eye_m = {200.0, 130.0, 440.0}, .pitch_rad = -0.4, .width_px = 21, .height_px = 11}, dump);
  dump_image(device, field, {.eye_m = {100.0, 40.0, 300.0}, .yaw_rad = 0.8, .width_px = 18, .height_px = 6},
             dump);
  dump_viewshed(device, field, dump);
  dump_lake(device, field, map, dump);
  dump_relief(device, dump);
  dump_woods(device, field, dump);
  dump_tiles(device, dump);
  dump.finish();
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
