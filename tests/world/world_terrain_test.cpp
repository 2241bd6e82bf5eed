// What a world with ground shows of it.
#include "host/world/world_terrain.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/mesh_shapes/shape.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/terrain/lakes/lake.h"
#include "host/world/world.h"
#include "tests/terrain/example_tiles.h"

namespace offing::world {
namespace {

/// A ridge along z, 100 m high in the middle, of 65 x 33 posts; or a valley, with another change of height
/// from post to post.
TerrainParameters ridge(double step_m = -3.0) {
  auto map = std::make_shared<HeightMap>();
  map->columns = 65;
  map->rows = 33;
  map->spacing_x_m = 10.0;
  map->spacing_z_m = 20.0;
  for (int row = 0; row < map->rows; ++row) {
    for (int column = 0; column < map->columns; ++column) {
      map->heights_m.push_back(static_cast<float>(100.0 + step_m * std::abs(column - 32)));
    }
  }
  return {.map = map, .origin_x_m = -320.0, .origin_z_m = -320.0, .latitude_deg = {}, .lines = {}};
}

/// Red and green side by side.
std::shared_ptr<const ColourMap> striped() {
  return std::make_shared<const ColourMap>(ColourMap{.columns = 2,
                                                     .rows = 1,
                                                     .rgba = {200, 0, 0, 255, 0, 200, 0, 255},
                                                     .left = 0.0,
                                                     .top = 0.0,
                                                     .right = 64.0,
                                                     .bottom = 32.0});
}

class WorldTerrainTest : public testing::Test {
 protected:
  WorldParameters parameters() const {
    WorldParameters dry;
    dry.has_sea = false;
    dry.terrain = ridge();
    return dry;
  }
  Camera camera() const {
    return {
        .eye_m = {-500.0, 150.0, 3.0}, .yaw_rad = 1.5, .pitch_rad = -0.2, .width_px = 61, .height_px = 35};
  }
  ocl::Device device_ = ocl::Device::open();
};

// A ball on the ridge's slope and one high above it. Fails if the first floats or sinks
// because relief is drawn below it, or the second keeps relief away, or if that is forgotten when it moves.
TEST_F(WorldTerrainTest, MeshesStandOnLevelGround) {
  WorldParameters dry = parameters();
  const auto ball_at = [](double above_m, double speed_mps) {
    MeshParameters ball;
    ball.name = "ball";
    ball.mesh = std::make_shared<TriangleMesh>(mesh_shapes::make_sphere(2.0, 1).mesh);
    ball.has_highlights = false;
    ball.motion = [=](double time_s) {
      return highlights::RigidMotion{.translation_m = {100.0 + speed_mps * time_s, 72.0 + above_m, 3.0}};
    };
    return ball;
  };
  dry.meshes = {ball_at(0.0, 0.0), ball_at(50.0, 0.0)};
  World world(device_, dry);
  EXPECT_EQ(world.terrain()->relief_m(100.0, 3.0), 0.0);
  EXPECT_NE(world.terrain()->relief_m(110.0, 3.0), 0.0);
  EXPECT_EQ(world.terrain()->relief_settings().discs.size(), 1u);
  world.set_meshes({ball_at(0.0, 2.0)});
  world.at(5.0, 100.0);
  EXPECT_NE(world.terrain()->relief_m(100.0, 3.0), 0.0);
  world.set_meshes({});
  EXPECT_TRUE(world.terrain()->relief_settings().discs.empty());
}

// Relief ends at the shore: where all ground within its reach, some 150 m, is below, there is none to lay.
// Fails if it is laid there, or is missing where ground rises at that distance.
TEST_F(WorldTerrainTest, LaysReliefWhereGroundRisesAboveTheShore) {
  WorldParameters dry = parameters();
  Camera at_foot = camera();
  at_foot.eye_m = {300.0, 14.0, 3.0};
  const auto is_laid = [&](double beach_line_m, double x_m) {
    dry.terrain->lines.beach_line_m = beach_line_m;
    World world(device_, dry);
    at_foot.eye_m.x = x_m;
    world.at(0.0, at_foot.eye_m.y);
    world.see_terrain(at_foot);
    return world.terrain()->relief().is_laid();
  };
  EXPECT_TRUE(is_laid(0.0, 300.0));
  EXPECT_TRUE(is_laid(50.0, 300.0));
  EXPECT_FALSE(is_laid(65.0, 300.0));
  EXPECT_TRUE(is_laid(65.0, 200.0));
  EXPECT_FALSE(is_laid(110.0, 0.0));
}

// Fails if relief that lies there is kept for another view, strength or mesh.
TEST_F(WorldTerrainTest, LaysReliefAnewWhereTheViewChanges) {
  WorldParameters dry = parameters();
  Camera standing = camera();
  standing.eye_m = {100.0, 74.0, 3.0};
  const auto heights_m = [&](World& world, const Camera& seen) {
    world.at(0.0, seen.eye_m.y);
    world.see_terrain(seen);
    return world.terrain()->relief().heights_m().read();
  };
  World world(device_, dry);
  const auto first = heights_m(world, standing);
  Camera turned = standing;
  turned.yaw_rad += 1.0;
  EXPECT_NE(heights_m(world, turned), first);
  EXPECT_EQ(heights_m(world, standing), first);
  dry.terrain->relief = 0.5;
  world.set_terrain(dry.terrain);
  EXPECT_NE(heights_m(world, standing), first);
  dry.terrain->relief = 1.0;
  world.set_terrain(dry.terrain);
  EXPECT_EQ(heights_m(world, standing), first);
}

// Fails if the detail of the ground that is asked for does not come to pictures.
TEST_F(WorldTerrainTest, DrawsTheDetailThatIsAskedFor) {
  WorldParameters dry = parameters();
  World world(device_, dry);
  const auto light = [&] {
    world.at(0.0, camera().eye_m.y);
    world.see_terrain(camera());
    return world.terrain()->image().image.read();
  };
  const auto fine = light();
  dry.terrain->finest_detail_m = 120.0;
  world.set_terrain(dry.terrain);
  EXPECT_NE(light(), fine);
  dry.terrain->finest_detail_m = 0.0;
  world.set_terrain(dry.terrain);
  EXPECT_EQ(light(), fine);
}

// Fails if planes or image are not of the hits, pixel by pixel. At edges, rays that miss the ground have
// distances of the ground beside them.
TEST_F(WorldTerrainTest, HasPlanesAndImageOfItsHits) {
  World world(device_, parameters());
  world.at(0.0, camera().eye_m.y);
  world.see_terrain(camera());
  const WorldTerrain& terrain = *world.terrain();
  ASSERT_TRUE(terrain.is_in_reach());
  const auto hits = terrain.image().hits.read();
  const auto planes = terrain.image().planes.read();
  const auto image = terrain.image().image.read();
  ASSERT_EQ(hits.size(), 61u * 35u);
  ASSERT_EQ(planes.size(), 2 * hits.size());
  ASSERT_EQ(image.size(), hits.size());
  std::size_t seen = 0, edges = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool is_edge = image[i][3] > 0.0f && image[i][3] < 1.0f && hits[i].kind == TERRAIN_MISS;
    if (is_edge) {
      ++edges;
      EXPECT_TRUE(std::isfinite(planes[i])) << i;
    } else {
      EXPECT_EQ(planes[i], hits[i].distance_m);
    }
    EXPECT_EQ(planes[hits.size() + i], static_cast<float>(hits[i].steps));
    if (hits[i].kind == TERRAIN_MISS) continue;
    ++seen;
    EXPECT_GT(image[i][1], 0.0f) << "dark at noon";
  }
  EXPECT_GT(seen, hits.size() / 10);
  EXPECT_LT(seen, hits.size());
  EXPECT_GT(edges, 5u);
}

// Fails if what the sea mirrors, or what is under water, has no planes of its own, or a camera's later
// picture takes them away. One ray a pixel leaves no edges.
TEST_F(WorldTerrainTest, HasPlanesOfMirroredGroundAndOfBeds) {
  WorldParameters wet = parameters();
  wet.has_sea = true;
  wet.spectrum = ocean::make_sea_spectrum(ocean::SpectrumParameters{});
  wet.ocean.size = 64;
  wet.ocean.cascades = ocean::cascades_from_patches(std::array{400.0, 50.0}, wet.ocean.size);
  World world(device_, wet);
  world.at(0.0, camera().eye_m.y);
  world.see_terrain(camera());
  const std::vector<float> first = world.terrain()->image().planes.read();
  world.see_terrain_beneath(camera());
  Camera from_below = mirrored(camera(), 0.0);
  from_below.width_px = 40;
  world.see_mirrored_terrain(from_below);
  const WorldTerrain& terrain = *world.terrain();
  ASSERT_NE(terrain.beneath(), nullptr);
  ASSERT_NE(terrain.mirrored(), nullptr);
  for (const TerrainImage* picture : {terrain.beneath(), terrain.mirrored()}) {
    const std::vector<TerrainHit> hits = picture->hits.read();
    const std::vector<float> planes = picture->planes.read();
    std::size_t seen = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(planes[i], hits[i].distance_m) << i;
      if (hits[i].kind != TERRAIN_MISS) ++seen;
    }
    EXPECT_GT(seen, 50u);
  }
  EXPECT_EQ(terrain.image().planes.read(), first);
}

// A basin with a lake 20 m deep, seen from above. Fails if its water is not as far away as its level, or its
// shore as the ground. Floats and the bed's patches: gate 1e-4 of the distance, but at the shore, where a
// pixel may show either.
TEST_F(WorldTerrainTest, DrawsLakesAtTheirLevel) {
  constexpr double level_m = 80.0;
  auto map = std::make_shared<HeightMap>();
  map->columns = map->rows = 65;
  map->spacing_x_m = map->spacing_z_m = 10.0;
  for (int row = 0; row < 65; ++row) {
    for (int column = 0; column < 65; ++column)
      map->heights_m.push_back(
          static_cast<float>(60.0 + 2.0 * std::max(std::abs(column - 32), std::abs(row - 32))));
  }
  WorldParameters dry = parameters();
  dry.terrain = TerrainParameters{
      .map = map, .origin_x_m = -320.0, .origin_z_m = -320.0, .latitude_deg = {}, .lines = {}};
  dry.terrain->relief = 0.0;
  dry.terrain->lakes = {{.lake = std::make_shared<const terrain::Lake>(
                             terrain::fill_lake(dry.terrain->posts(), 320.0, 320.0, level_m))}};
  World world(device_, dry);
  Camera above = camera();
  above.eye_m = {0.0, 200.0, 0.0};
  above.pitch_rad = -1.2;
  world.at(0.0, above.eye_m.y);
  world.see_terrain(above);
  const std::vector<TerrainHit> hits = world.terrain()->image().hits.read();
  const std::vector<float> planes = world.terrain()->image().planes.read();
  std::size_t water = 0, land = 0;
  for (int row = 0; row < above.height_px; ++row) {
    for (int column = 0; column < above.width_px; ++column) {
      const auto i = static_cast<std::size_t>(row * above.width_px + column);
      const glm::dvec2 clip(2.0 * (column + 0.5) / above.width_px - 1.0,
                            1.0 - 2.0 * (row + 0.5) / above.height_px);
      const double rise = glm::normalize(ray_direction(above, clip)).y,
                   ground_m = static_cast<double>(hits[i].distance_m);
      const double over_m = above.eye_m.y + ground_m * rise - level_m;
      if (hits[i].kind == TERRAIN_MISS || std::abs(over_m) < 1.0) continue;
      ++(over_m < 0.0 ? water : land);
      const double expected_m = over_m < 0.0 ? (level_m - above.eye_m.y) / rise : ground_m;
      EXPECT_NEAR(static_cast<double>(planes[i]), expected_m, 1e-4 * expected_m) << column << ", " << row;
    }
  }
  EXPECT_GT(water, 200u);
  EXPECT_GT(land, 200u);
}

// Fails if the place of the map is lost: height under a point of the world.
TEST_F(WorldTerrainTest, AnswersInPlacesOfTheWorld) {
  const WorldTerrain terrain(device_, ridge());
  EXPECT_NEAR(terrain.terrain_at(0.0, 0.0)->height_m, 100.0, 1e-9);
  EXPECT_NEAR(terrain.terrain_at(-100.0, 250.0)->height_m, 70.0, 1e-9);
  EXPECT_FALSE(terrain.terrain_at(321.0, 0.0));
}

// Fails if an eye too far for rays ends the frame instead of seeing nothing.
TEST_F(WorldTerrainTest, SeesNothingFromTooFar) {
  World world(device_, parameters());
  Camera far = camera();
  world.at(0.0, far.eye_m.y);
  for (const double x_m : {-1e8, 1e8}) {
    far.eye_m.x = x_m;
    EXPECT_NO_THROW(world.see_terrain(far));
    EXPECT_FALSE(world.terrain()->is_in_reach());
  }
  // As far east of the map as rays reach, which is farther from its first post.
  const auto& [map, terrain] = std::pair(*parameters().terrain->map, *parameters().terrain);
  const double edge_m = terrain.origin_x_m + map.spacing_x_m * (map.columns - 1);
  for (const double beyond : {terrain::farthest_origin_cells - 0.5, terrain::farthest_origin_cells + 0.5}) {
    far.eye_m.x = edge_m + beyond * map.spacing_x_m;
    EXPECT_NO_THROW(world.see_terrain(far));
    EXPECT_EQ(world.terrain()->is_in_reach(), beyond < terrain::farthest_origin_cells);
  }
  world.see_terrain(camera());
  EXPECT_TRUE(world.terrain()->is_in_reach());
}

// Fails if a picture of the ground is not on it, or not in its place: red west of the ridge, green east of
// it.
TEST_F(WorldTerrainTest, WearsItsColours) {
  WorldParameters painted = parameters();
  painted.terrain->colours = striped();
  World world(device_, painted);
  Camera above = camera();
  above.eye_m = {0.0, 900.0, 0.0};
  above.yaw_rad = 0.0;
  above.pitch_rad = -1.5;
  world.at(0.0, above.eye_m.y);
  world.see_terrain(above, {.rays = 1});
  const auto hits = world.terrain()->image().hits.read();
  const auto image = world.terrain()->image().image.read();
  std::array<int, 2> seen{};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    // Colours are mixed across the border between the texels' middles; half a texel aside they are pure.
    if (hits[i].kind != TERRAIN_SURFACE || (hits[i].cell_x >= 15 && hits[i].cell_x < 49)) continue;
    const bool is_west = hits[i].cell_x < 32;
    ++seen[is_west ? 0 : 1];
    EXPECT_GT(image[i][is_west ? 0 : 1], 4.0f * image[i][is_west ? 1 : 0]) << i;
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 20);
}

/// The tiles of hills, as a map and as a store, with the first post away from the origin.
class TiledWorldTerrainTest : public testing::Test {
 protected:
  TerrainParameters in_tiles(const terrain::TileReader& read) const {
    return {.map = nullptr,
            .tiles = std::make_shared<const TerrainTiles>(TerrainTiles{
                .map = example_.tiled_map(), .read = read, .cache_bytes = std::size_t{64} << 20}),
            .origin_x_m = -1000.0,
            .origin_z_m = 500.0,
            .latitude_deg = {},
            .lines = {}};
  }
  TerrainParameters whole() const {
    TerrainParameters parameters = in_tiles(example_.reader());
    parameters.tiles.reset();
    auto map = std::make_shared<HeightMap>();
    const test::HeightMap& from = example_.map();
    map->columns = from.grid.columns;
    map->rows = from.grid.rows;
    map->spacing_x_m = from.grid.spacing_x_m;
    map->spacing_z_m = from.grid.spacing_z_m;
    map->heights_m = from.heights_m;
    parameters.map = map;
    return parameters;
  }
  /// So fine that all tiles are wanted at level 0.
  static Camera fine_camera() {
    return {.eye_m = {1500.0, 400.0, 4000.0},
            .pitch_rad = -0.3,
            .vertical_field_of_view_rad = 0.05,
            .width_px = 96,
            .height_px = 64};
  }
  static World world_of(const ocl::Device& device, const TerrainParameters& terrain) {
    WorldParameters parameters;
    parameters.has_sea = false;
    parameters.terrain = terrain;
    return {device, parameters};
  }
  ocl::Device device_ = ocl::Device::open();
  test::ExampleTiles example_ = test::hilly_tiles();
};

// Fails if ground in tiles is seen elsewhere than its map, or answers otherwise.
TEST_F(TiledWorldTerrainTest, IsTheGroundOfItsMap) {
  World of_tiles = world_of(device_, in_tiles(example_.reader())), of_map = world_of(device_, whole());
  for (World* world : {&of_tiles, &of_map}) {
    world->at(0.0, 400.0);
    world->see_terrain(fine_camera());
  }
  EXPECT_EQ(of_tiles.terrain()->tiles()->statistics().stood_in, 0u);
  const auto found = of_tiles.terrain()->image().hits.read(),
             expected = of_map.terrain()->image().hits.read();
  std::size_t seen = 0, differ = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    seen += expected[i].kind == TERRAIN_MISS ? 0 : 1;
    const bool is_same = found[i].kind == expected[i].kind && found[i].cell_x == expected[i].cell_x &&
                         found[i].cell_z == expected[i].cell_z;
    // At the border of two cells a ray's cell may be either's.
    differ += is_same ? 0 : 1;
  }
  EXPECT_GT(seen, 1000u);
  EXPECT_LE(differ, found.size() / 500);
  for (const auto& [x_m, z_m] : {std::pair(0.0, 700.0), {-1000.0, 500.0}, {5999.0, 6000.0}}) {
    const auto point = of_tiles.terrain()->terrain_at(x_m, z_m);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->height_m, of_map.terrain()->terrain_at(x_m, z_m)->height_m);
  }
  EXPECT_FALSE(of_tiles.terrain()->terrain_at(-1001.0, 700.0));
  const terrain::Ray down{.origin_m = {1234.0, 5000.0, 2345.0}};
  EXPECT_NEAR(of_tiles.terrain()->cast(down).distance_m, of_map.terrain()->cast(down).distance_m, 0.01);
}

// Fails if what is seen beneath a sea, by a coarser picture, takes away the tiles of the picture itself.
TEST_F(TiledWorldTerrainTest, ThePictureBeneathLeavesTheTilesOfThePicture) {
  World world = world_of(device_, in_tiles(example_.reader()));
  world.at(0.0, 400.0);
  world.see_terrain(fine_camera());
  WorldTerrain& terrain = *world.terrain();
  const std::size_t tiles = terrain.tiles()->statistics().tiles;
  Camera coarse = fine_camera();
  coarse.vertical_field_of_view_rad = 1.0;
  coarse.width_px = 12;
  coarse.height_px = 8;
  terrain.beneath_at(coarse, world.sky(), {}, {});
  EXPECT_EQ(terrain.tiles()->statistics().tiles, tiles);
  ASSERT_NE(terrain.beneath(), nullptr);
  EXPECT_EQ(terrain.beneath()->width_px, 12);
}

// Fails if a window waits for tiles, shows a hole until they are there, or coarse ones for ever.
TEST_F(TiledWorldTerrainTest, CoarseTilesStandInUntilFineOnesAreThere) {
  std::promise<void> gate;
  const std::shared_future<void> opened = gate.get_future().share();
  World world = world_of(device_, in_tiles([&](const TileKey& key) {
                           if (key.level < example_.shape().coarsest()) opened.wait();
                           return example_.reader()(key);
                         }));
  World of_map = world_of(device_, whole());
  world.at(0.0, 400.0);
  of_map.at(0.0, 400.0);
  of_map.see_terrain(fine_camera());
  world.see_terrain(fine_camera(), {}, TileWait::none);
  EXPECT_GT(world.terrain()->tiles()->statistics().stood_in, 0u);
  const auto coarse = world.terrain()->image().hits.read(), expected = of_map.terrain()->image().hits.read();
  std::size_t holes = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    holes += expected[i].kind != TERRAIN_MISS && coarse[i].kind == TERRAIN_MISS ? 1 : 0;
  }
  EXPECT_EQ(holes, 0u);
  gate.set_value();
  const auto start = std::chrono::steady_clock::now();
  do {
    world.see_terrain(fine_camera(), {}, TileWait::none);
  } while (world.terrain()->tiles()->statistics().stood_in > 0 &&
           std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
  EXPECT_EQ(world.terrain()->tiles()->statistics().stood_in, 0u);
}

// Fails if a world without a sea has water, or its ground changes otherwise than a fresh world's would.
TEST_F(WorldTerrainTest, ChangesAsAFreshWorldHasIt) {
  World world(device_, parameters());
  EXPECT_FALSE(world.has_sea());
  EXPECT_THROW(world.ocean(), Error);
  EXPECT_EQ(world.reach().vertical_m, 0.0);
  Camera above = camera();
  above.eye_m.y = 700.0;
  above.pitch_rad = -0.8;
  // A ridge hides no sky.
  std::vector<TerrainParameters> changes(5, ridge(6.0));
  for (TerrainParameters& changed : changes) changed.lines.snow_line_m = 40.0;
  changes[1].origin_z_m = -300.0;
  changes[2].colours = striped();
  changes[3] = changes[2];
  changes[3].sees_horizons = true;
  changes[4].sees_horizons = true;
  std::vector<terrain::Texel> before;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    TerrainParameters& changed = changes[i];
    changed.map = changes[0].map;
    world.set_terrain(changed);
    WorldParameters fresh_parameters = parameters();
    fresh_parameters.terrain = changed;
    World fresh(device_, fresh_parameters);
    for (World* one : {&world, &fresh}) {
      one->at(0.0, above.eye_m.y);
      one->see_terrain(above);
    }
    const std::vector<terrain::Texel> image = world.terrain()->image().image.read();
    EXPECT_TRUE(image == fresh.terrain()->image().image.read()) << "change " << i;
    EXPECT_TRUE(image != before) << "change " << i << " shows nothing";
    before = image;
  }
  world.set_terrain(std::nullopt);
  EXPECT_EQ(world.terrain(), nullptr);
  EXPECT_NO_THROW(world.see_terrain(above));
}

}  // namespace
}  // namespace offing::world
