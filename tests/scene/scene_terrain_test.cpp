// The ground of scenes: what [terrain] says, with its faults, and what an edit makes anew.
#include "host/scene/prepare/scene_terrain.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/png_image.h"
#include "host/io/tile_store/tile_store.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/prepare/world_scene.h"
#include "host/terrain/tiles/tile_builder.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/log_capture.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::scene {
namespace {

using testing::HasSubstr;

Scene scene_of(const std::string& text, const std::filesystem::path& folder = {}) {
  return parse_scene("version = 1\n" + text, "valley.toml", folder);
}

/// Of what asking for the ground of a scene throws; "" if it does not.
std::string fault_of(const std::string& text, const std::filesystem::path& folder = {}) {
  try {
    prepare_terrain(scene_of(text, folder));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty()) << error.what();
    return error.what();
  }
  return "";
}

class SceneTerrainTest : public testing::Test {
 protected:
  /// A raw map of 3 x 2 posts: 0, 10, 20 / 30, 40, 50.
  void SetUp() override {
    const std::vector<float> heights_m{0.0f, 10.0f, 20.0f, 30.0f, 40.0f, 50.0f};
    std::ofstream(folder_.path() / "small.r32", std::ios::binary)
        .write(reinterpret_cast<const char*>(heights_m.data()), 24);
  }
  world::TerrainParameters small(const std::string& more) {
    return *prepare_terrain(
        scene_of("[terrain]\nfile = \"small.r32\"\nraw_columns = 3\nraw_rows = 2\n" + more, folder_.path()));
  }
  TemporaryFolder folder_;
};

// Fails if large generated terrain is not kept for the next scene, is made again, or is taken for other
// terrain.
TEST_F(SceneTerrainTest, GeneratedTerrainIsKept) {
  const test::ScopedEnvironment cache("OFFING_CACHE_DIR", (folder_.path() / "kept").string());
  const auto heights_of = [](int posts, int seed) {
    return prepare_terrain(scene_of("[terrain]\nerosion = 0.5\nposts = " + std::to_string(posts) +
                                    "\nseed = " + std::to_string(seed) + "\n"))
        ->map->heights_m;
  };
  const auto kept = [this] {
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(folder_.path() / "kept")) {
      if (file.path().extension() == ".heights") files.push_back(file.path());
    }
    return files;
  };
  heights_of(65, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "kept")) << "small terrain is not worth a file";
  const std::vector<float> heights_m = heights_of(513, 1);
  ASSERT_EQ(kept().size(), 1u);
  std::filesystem::create_hard_link(kept().front(), folder_.path() / "link");
  EXPECT_EQ(heights_of(513, 1), heights_m);
  EXPECT_EQ(std::filesystem::hard_link_count(folder_.path() / "link"), 2u) << "the file was written again";
  EXPECT_NE(heights_of(513, 2), heights_m);
  EXPECT_EQ(kept().size(), 2u);
}

// Fails if a scene with ground alone gets a sea, or one with a sea loses it.
TEST_F(SceneTerrainTest, StandsAloneWithoutAnOceanSection) {
  EXPECT_TRUE(scene_of("").has_sea());
  EXPECT_FALSE(prepare_terrain(scene_of("")));
  EXPECT_FALSE(scene_of("[terrain]\n").has_sea());
  EXPECT_TRUE(scene_of("[terrain]\n[ocean]\n").has_sea());
  EXPECT_TRUE(scene_of("[terrain]\n[[ocean.swell]]\n").has_sea());
  EXPECT_THROW(prepare_sea(scene_of("[terrain]\n")), Error);
}

// Fails if what a file is told about is lost on its way: spacing, scale, offset, place.
TEST_F(SceneTerrainTest, ReadsFilesAsItIsTold) {
  const world::TerrainParameters plain = small("");
  EXPECT_EQ(plain.map->columns, 3);
  EXPECT_EQ(plain.map->heights_m.back(), 50.0f);
  EXPECT_EQ(plain.origin_x_m, -1.0) << "the middle is not at the origin";
  EXPECT_EQ(plain.origin_z_m, -0.5);
  const world::TerrainParameters told =
      small("spacing_x_m = 4\nspacing_z_m = 8\nvertical_scale = 0.5\noffset_m = -5\norigin_x_m = 100\n");
  EXPECT_EQ(told.map->spacing_x_m, 4.0);
  EXPECT_EQ(told.map->spacing_z_m, 8.0);
  EXPECT_THAT(told.map->heights_m, testing::ElementsAre(-5.0f, 0.0f, 5.0f, 10.0f, 15.0f, 20.0f));
  EXPECT_EQ(told.origin_x_m, 100.0);
  EXPECT_EQ(told.origin_z_m, -4.0);
}

// Fails if a fault of the ground does not name the scene's line and column, the value and the fix.
TEST_F(SceneTerrainTest, TellsFaultsWithTheirPlace) {
  const std::filesystem::path& folder = folder_.path();
  EXPECT_THAT(
      fault_of("[terrain]\nfile = \"none.tif\"\n", folder),
      testing::AllOf(HasSubstr("valley.toml:3:8: terrain.file: expected a height map, got no such file"),
                     HasSubstr("none.tif")));
  EXPECT_THAT(fault_of("[terrain]\nfile = \"small.r32\"\n", folder),
              HasSubstr("valley.toml:3:8: terrain.file: "))
      << "a file without a size";
  EXPECT_THAT(fault_of("[terrain]\nfile = \".\"\n", folder), HasSubstr("valley.toml:3:8: terrain.file: "));
  EXPECT_THAT(fault_of("[terrain]\nside_m = 1e6\nlongest_m = 10\n"), HasSubstr("longest_m"));
  const auto refusal = [](const std::string& text) {
    try {
      scene_of(text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("[terrain]\nrelief_m = -1\n"),
            "valley.toml:3:12: terrain.relief_m: expected a number in m within [0, 20000], got -1");
  EXPECT_EQ(refusal("[terrain]\nspacing_x_m = 0\n"),
            "valley.toml:3:15: terrain.spacing_x_m: expected a number in m within [0.001, 100000], got 0");
  EXPECT_EQ(refusal("[terrain]\nencoding = \"jpeg\"\n"),
            "valley.toml:3:12: terrain.encoding: expected one of plain, mapbox, terrarium, got \"jpeg\"");
  EXPECT_EQ(refusal("[terrain]\nreleif_m = 3\n"),
            "valley.toml:3:1: terrain.releif_m: expected a known key, got \"releif_m\"");
  EXPECT_EQ(refusal("[terrain]\nfile = 3\n"), "valley.toml:3:8: terrain.file: expected a file name, got 3");
  EXPECT_EQ(refusal("[[terrain]]\n"), "valley.toml:2:3: terrain: expected a section [terrain], got an array");
}

// Fails if a key that says nothing about this ground is passed over in silence.
TEST_F(SceneTerrainTest, TellsWhatIsNotUsed) {
  const auto logged = [](const std::string& text) {
    const test::LogCapture log;
    const world::WorldParameters parameters = prepare_world(scene_of(text));
    EXPECT_FALSE(parameters.has_sea);
    return log.text();
  };
  const std::string small_terrain = "[terrain]\nposts = 9\n";
  EXPECT_THAT(logged(small_terrain + "encoding = \"mapbox\"\n"),
              HasSubstr("valley.toml:4:12: terrain.encoding: not used: terrain.file is not given"));
  EXPECT_THAT(logged(small_terrain + "[wind]\nspeed_mps = 3\n"),
              HasSubstr("valley.toml:5:13: wind.speed_mps: not used: the scene has no [ocean]"));
  EXPECT_THAT(logged(small_terrain + "water_line_m = 3\n"), testing::Not(HasSubstr("not used")));
}

// Fails if a picture of the ground is not read, not where the map is, or its faults do not name their place.
TEST_F(SceneTerrainTest, ReadsPicturesOfTheGround) {
  write_png(folder_.path() / "green.png", {2, 1, {0, 200, 0, 10, 20, 30}});
  EXPECT_EQ(small("").colours, nullptr);
  const world::TerrainParameters painted = small("colour = \"green.png\"\n");
  ASSERT_NE(painted.colours, nullptr);
  EXPECT_THAT(painted.colours->rgba, testing::ElementsAre(0, 200, 0, 255, 10, 20, 30, 255));
  // From the first posts of 3 x 2 to the last ones.
  EXPECT_EQ(painted.colours->right, 2.0);
  EXPECT_EQ(painted.colours->bottom, 1.0);
  const std::string made = "[terrain]\nposts = 9\ncolour = ";
  EXPECT_NE(prepare_terrain(scene_of(made + "\"green.png\"\n", folder_.path()))->colours, nullptr);
  EXPECT_THAT(
      fault_of(made + "\"none.png\"\n", folder_.path()),
      HasSubstr("valley.toml:4:10: terrain.colour: expected a picture of the ground, got no such file"));
  EXPECT_THAT(fault_of(made + "\"small.r32\"\n", folder_.path()),
              testing::AllOf(HasSubstr("valley.toml:4:10: terrain.colour: "), HasSubstr("small.r32")));
}

// Fails if a tile store is not read as one, or keys that say how to read a map are passed over for it.
TEST_F(SceneTerrainTest, TakesTileStores) {
  const TileSetShape shape = TileSetShape::of(300, 200);
  const TileStoreWriter writer(folder_.path() / "hills.tiles", Existing::keep);
  terrain::TileBuilder builder(shape, [&](const HeightTile& tile) { writer.write(tile); });
  std::vector<float> heights_m(300);
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 300; ++column)
      heights_m[static_cast<std::size_t>(column)] = static_cast<float>(column + 2 * row);
    builder.add_row(heights_m);
  }
  TileStoreHeader header;
  header.shape = shape;
  header.spacing_x_m = 4.0;
  header.spacing_z_m = 5.0;
  header.highest_m = 697.0f;
  writer.finish(header);
  const std::string text = "[terrain]\nfile = \"hills.tiles\"\ncache_mb = 40\n";
  const auto terrain = prepare_terrain(scene_of(text, folder_.path()));
  ASSERT_TRUE(terrain);
  EXPECT_EQ(terrain->map, nullptr);
  ASSERT_NE(terrain->tiles, nullptr);
  EXPECT_EQ(terrain->tiles->cache_bytes, std::size_t{40} << 20);
  EXPECT_EQ(terrain->origin_x_m, -0.5 * 4.0 * 299);
  EXPECT_EQ(terrain::terrain_at(terrain->posts(), 4.0 * 280, 5.0 * 150)->height_m, 280.0 + 300.0);
  Scene scene = scene_of(text, folder_.path());
  place_camera(scene, terrain);
  EXPECT_EQ(scene.view.camera.eye_m.y, 997.0);
  const test::LogCapture log;
  prepare_world(scene_of(text + "offset_m = 3\nsky_visibility = \"on\"\n", folder_.path()));
  EXPECT_THAT(log.text(),
              HasSubstr("valley.toml:5:12: terrain.offset_m: not used: the terrain comes from a tile store"));
  EXPECT_THAT(log.text(), HasSubstr("terrain.sky_visibility: not used"));
  prepare_world(scene_of("[terrain]\nposts = 9\ncache_mb = 40\n"));
  EXPECT_THAT(log.text(), HasSubstr("terrain.cache_mb: not used: terrain.file is not a tile store"));
}

// Fails if the sky is hidden by ground without being asked for, or is not where it is.
TEST_F(SceneTerrainTest, KnowsWhetherGroundHidesTheSky) {
  EXPECT_FALSE(small("").sees_horizons);
  EXPECT_TRUE(small("sky_visibility = \"on\"\n").sees_horizons);
  EXPECT_FALSE(small("sky_visibility = \"off\"\n").sees_horizons);
}

// Fails if a saved scene is another one: without its sea, its ground, or a file that moved with the folder.
TEST_F(SceneTerrainTest, IsSavedWhole) {
  for (const char* text :
       {"[terrain]\n", "[terrain]\n[ocean]\n", "[terrain]\nseed = 4\n[ocean]\nsize = 64\n"}) {
    const Scene scene = scene_of(text);
    const Scene again = parse_scene(scene_text(scene, ""), "again.toml", "");
    EXPECT_EQ(again.has_sea(), scene.has_sea()) << text;
    EXPECT_EQ(again.terrain.is_given, scene.terrain.is_given) << text;
    EXPECT_EQ(again.terrain.fractal.seed, scene.terrain.fractal.seed) << text;
  }
  const Scene scene = scene_of("[terrain]\nfile = \"small.r32\"\n", folder_.path());
  EXPECT_THAT(scene_text(scene, folder_.path()), HasSubstr("file = \"small.r32\""));
  const Scene painted =
      scene_of("[terrain]\ncolour = \"photo.png\"\nsky_visibility = \"on\"\n", folder_.path());
  EXPECT_THAT(scene_text(painted, folder_.path()),
              testing::AllOf(HasSubstr("colour = \"photo.png\""), HasSubstr("sky_visibility = \"on\"")));
}

// Fails if an edit of lines or place makes the heights anew, or one of heights does not.
TEST_F(SceneTerrainTest, MakesAnewOnlyWhatAnEditChanges) {
  const Scene before = scene_of("[terrain]\nposts = 33\n");
  const std::optional<world::TerrainParameters> now = prepare_terrain(before);
  Scene after = before;
  after.terrain.snow_line_m = 900.0;
  after.terrain.origin_x_m = 7.0;
  const auto moved = edited_terrain(now, before, after);
  EXPECT_EQ(moved->map, now->map);
  EXPECT_EQ(moved->lines.snow_line_m, 900.0);
  EXPECT_EQ(moved->origin_x_m, 7.0);
  write_png(folder_.path() / "grey.png", {1, 1, {9, 9, 9}});
  Scene painted = after;
  painted.terrain.colour = (folder_.path() / "grey.png").string();
  const auto with_colours = edited_terrain(moved, after, painted);
  EXPECT_EQ(with_colours->map, now->map);
  ASSERT_NE(with_colours->colours, nullptr);
  Scene higher_snow = painted;
  higher_snow.terrain.snow_line_m = 901.0;
  EXPECT_EQ(edited_terrain(with_colours, painted, higher_snow)->colours, with_colours->colours);
  EXPECT_EQ(edited_terrain(with_colours, painted, after)->colours, nullptr);
  after.terrain.fractal.relief_m *= 2.0;
  const auto higher = edited_terrain(now, before, after);
  EXPECT_NE(higher->map, now->map);
  EXPECT_NE(higher->map->heights_m, now->map->heights_m);
  after.terrain.is_given = false;
  EXPECT_FALSE(edited_terrain(now, before, after));
}

// Fails if the sea's bed is painted as water, or lines that the scene names are not its own.
TEST_F(SceneTerrainTest, HasTheLinesOfTheScene) {
  const auto lines = [](const std::string& text) { return prepare_terrain(scene_of(text))->lines; };
  EXPECT_EQ(lines("[terrain]\nposts = 5\nwater_line_m = 12\n").sea_level_m, 12.0);
  EXPECT_LT(lines("[terrain]\nposts = 5\nwater_line_m = 12\n[ocean]\n").sea_level_m, -1e5);
  const std::string with_sea = "[ocean]\n[terrain]\nposts = 5\n";
  EXPECT_EQ(lines(with_sea + "[world]\nsea_level_m = 300\n").beach_line_m,
            lines(with_sea).beach_line_m + 300.0);
  EXPECT_EQ(lines("[terrain]\nposts = 5\ntree_line_m = 7\n").tree_line_m, 7.0);
  EXPECT_EQ(lines("[terrain]\nposts = 5\n").snow_line_m, world::CoverLines{}.snow_line_m);
}

// Fails if materials of a scene do not lie over those of its landscape, values are mixed up, or a new colour
// makes the heights anew.
TEST_F(SceneTerrainTest, HasTheMaterialsOfTheScene) {
  const std::string text =
      "[terrain]\nposts = 5\nlandscape = \"desert\"\ntree_line_m = 900\n"
      "[[terrain.material]]\nname = \"moss\"\nlike = \"grass\"\ncolour = [0.1, 0.2, 0.3]\nlowest_m = 7\n"
      "[[terrain.material]]\ngentlest_deg = 90\nsteepest_deg = 45\nshare = 0.5\n";
  const Scene before = scene_of(text);
  const auto now = prepare_terrain(before);
  const std::size_t own = terrain::materials_of(terrain::Landscape::desert, {}).size();
  ASSERT_EQ(now->materials.size(), own + 2);
  const terrain::Material &moss = now->materials[own], &last = now->materials[own + 1];
  EXPECT_EQ(moss.name, "moss");
  EXPECT_EQ(moss.like, terrain::MaterialLike::grass);
  EXPECT_EQ(moss.colour.b, 0.3);
  EXPECT_EQ(moss.lowest_m, 7.0);
  EXPECT_FALSE(moss.highest_m);
  EXPECT_DOUBLE_EQ(last.gentlest_rad, 2.0 * *last.steepest_rad);
  EXPECT_EQ(last.share, 0.5);
  Scene after = before;
  after.terrain.materials[0].colour.r = 0.9;
  const auto edited = edited_terrain(now, before, after);
  EXPECT_EQ(edited->map, now->map);
  EXPECT_EQ(edited->materials[own].colour.r, 0.9);
  EXPECT_TRUE(prepare_terrain(scene_of("[terrain]\nposts = 5\n"))->materials.empty());
}

// Fails if woods of a scene do not end at its tree line, values are mixed up, or a new height of theirs makes
// the heights of the ground anew.
TEST_F(SceneTerrainTest, HasTheWoodsOfTheScene) {
  const std::string ground = "[terrain]\nposts = 5\ntree_line_m = 900\n";
  EXPECT_FALSE(prepare_terrain(scene_of(ground))->canopy);
  EXPECT_FALSE(prepare_terrain(scene_of(ground + "[terrain.canopy]\nheight_m = 9\n"))->canopy);
  const Scene before = scene_of(ground +
                                "[terrain.canopy]\nshare = 0.5\nlowest_m = 7\nedge_m = 3\npatch_m = 100\n"
                                "steepest_deg = 90\nheight_m = 9\ncolour = [0.1, 0.2, 0.3]\n");
  const auto now = prepare_terrain(before);
  ASSERT_TRUE(now->canopy);
  const terrain::Canopy& wood = *now->canopy;
  EXPECT_EQ(wood.share, 0.5);
  EXPECT_EQ(wood.lowest_m, 7.0);
  EXPECT_EQ(wood.highest_m, 900.0);
  EXPECT_EQ(wood.edge_m, 3.0);
  EXPECT_EQ(wood.patch_m, 100.0);
  EXPECT_NEAR(wood.steepest_rad, 1.5708, 1e-4);
  EXPECT_EQ(wood.height_m, 9.0);
  EXPECT_EQ(wood.colour.g, 0.2);
  Scene after = before;
  after.terrain.canopy.wood.height_m = 20.0;
  const auto edited = edited_terrain(now, before, after);
  EXPECT_EQ(edited->map, now->map);
  EXPECT_EQ(edited->canopy->height_m, 20.0);
  EXPECT_EQ(
      prepare_terrain(scene_of(ground + "[terrain.canopy]\nshare = 1\nhighest_m = 80\n"))->canopy->highest_m,
      80.0);
}

// Fails if the picture of a scene's woods is not read as their cover, is read again for another colour, or
// its faults do not name their place.
TEST_F(SceneTerrainTest, ReadsPicturesOfWoods) {
  write_png(folder_.path() / "woods.png", {2, 1, {255, 255, 255, 0, 60, 30}});
  const std::string made = "[terrain]\nposts = 9\n[terrain.canopy]\nmap = ";
  const Scene before = scene_of(made + "\"woods.png\"\n", folder_.path());
  const auto now = prepare_terrain(before);
  ASSERT_TRUE(now->canopy);
  EXPECT_THAT(now->canopy->map->rgba, testing::ElementsAre(0, 0, 0, 255, 0, 0, 0, 30));
  Scene after = before;
  after.terrain.canopy.wood.colour.r = 0.5;
  EXPECT_EQ(edited_terrain(now, before, after)->canopy->map, now->canopy->map);
  after.terrain.canopy.map.clear();
  EXPECT_FALSE(edited_terrain(now, before, after)->canopy);
  EXPECT_THAT(
      fault_of(made + "\"none.png\"\n", folder_.path()),
      HasSubstr("valley.toml:5:7: terrain.canopy.map: expected a picture of the woods, got no such file"));
}

/// Two pits in 9 x 5 posts 10 m apart: 3 m at (-20, 0), 4 m at (20, 0); a saddle of 7 m between them, 9 m
/// around.
std::string pits(const std::filesystem::path& folder) {
  std::vector<float> heights_m(9 * 5, 9.0f);
  heights_m[2 * 9 + 2] = 3.0f;
  heights_m[2 * 9 + 3] = 6.0f;
  heights_m[2 * 9 + 4] = 7.0f;
  heights_m[2 * 9 + 5] = 6.5f;
  heights_m[2 * 9 + 6] = 4.0f;
  std::ofstream(folder / "pits.r32", std::ios::binary)
      .write(reinterpret_cast<const char*>(heights_m.data()),
             static_cast<std::streamsize>(sizeof(float) * heights_m.size()));
  return "[terrain]\nfile = \"pits.r32\"\nraw_columns = 9\nraw_rows = 5\nspacing_x_m = 10\nspacing_z_m = "
         "10\n";
}

// Fails if lakes of a scene are not where it says, have other levels, or are filled anew by an edit of
// something else.
TEST_F(SceneTerrainTest, FillsLakes) {
  const std::string text =
      pits(folder_.path()) +
      "[[lake]]\nx_m = -20\nlevel_m = 6.5\nwind_speed_mps = 0\n[[lake]]\nx_m = 21\nlevel_m = 5\n";
  const Scene before = scene_of(text, folder_.path());
  const auto now = prepare_terrain(before);
  ASSERT_EQ(now->lakes.size(), 2u);
  EXPECT_EQ(now->lakes[0].lake->level_m, 6.5);
  EXPECT_EQ(now->lakes[0].wind.wind_speed_mps, 0.0);
  EXPECT_TRUE(now->lakes[0].lake->is_wet_at(2, 2));
  EXPECT_FALSE(now->lakes[0].lake->is_wet_at(6, 2));
  EXPECT_TRUE(now->lakes[1].lake->is_wet_at(6, 2));
  const auto full = prepare_terrain(scene_of(pits(folder_.path()) + "[[lake]]\nx_m = -20\n", folder_.path()));
  EXPECT_EQ(full->lakes[0].lake->level_m, 9.0);
  Scene after = before;
  after.lakes[0].wind_speed_mps = 4.0;
  after.lakes[1].level_m = 6.0;
  const auto edited = edited_terrain(now, before, after);
  EXPECT_EQ(edited->lakes[0].lake, now->lakes[0].lake);
  EXPECT_EQ(edited->lakes[0].wind.wind_speed_mps, 4.0);
  EXPECT_EQ(edited->lakes[1].lake->level_m, 6.0);
}

// Fails if a lake that cannot be is taken, or refused without its place in the scene.
TEST_F(SceneTerrainTest, RefusesLakesThatCannotBe) {
  const auto fault = [&](const std::string& lakes) {
    return fault_of(pits(folder_.path()) + lakes, folder_.path());
  };
  EXPECT_THAT(
      fault("[[lake]]\nx_m = -20\nlevel_m = 9.5\n"),
      HasSubstr("valley.toml:10:11: lake.level_m: expected a level up to its spill level, 9 m, found 9.5 m"));
  EXPECT_THAT(fault("[[lake]]\nx_m = -20\nlevel_m = 2\n"), HasSubstr("expected a level above the ground"));
  EXPECT_THAT(fault("[[lake]]\nx_m = 900\n"), HasSubstr("lake.x_m: expected a place on the map"));
  EXPECT_THAT(fault("[[lake]]\nx_m = -35\nz_m = 15\n"), HasSubstr("from where water runs off the map"));
  EXPECT_THAT(fault("[[lake]]\nx_m = -20\n[[lake]]\nx_m = 20\n"), HasSubstr("found lake 1"));
  EXPECT_THAT(fault("[[lake]]\nx_m = -20\nlevel_m = 5\n[ocean]\n[world]\nsea_level_m = 5.5\n"),
              HasSubstr("lake.level_m: expected a level above the sea, 5.5 m, found 5 m"));
}

// Fails if the eye of a scene that does not place it is under the ground, or one that is placed is moved.
TEST_F(SceneTerrainTest, PlacesTheEyeWhereNothingElseDoes) {
  Scene scene = scene_of("[terrain]\nposts = 33\norigin_x_m = 500\n[camera]\nfov_deg = 70\n");
  const auto terrain = prepare_terrain(scene);
  place_camera(scene, terrain);
  const auto& heights_m = terrain->map->heights_m;
  EXPECT_EQ(scene.view.camera.eye_m.y, *std::max_element(heights_m.begin(), heights_m.end()) + 300.0);
  EXPECT_EQ(scene.view.camera.eye_m.x, 500.0 + 10e3);
  EXPECT_NEAR(scene.view.camera.vertical_field_of_view_rad, 70.0 / 180.0 * 3.14159265, 1e-6);
  Scene placed = scene_of("[terrain]\nposts = 33\n[camera]\nx_m = 3\n");
  place_camera(placed, terrain);
  EXPECT_EQ(placed.view.camera.eye_m.x, 3.0);
  Scene moving = scene_of(
      "[terrain]\nposts = 33\n[camera]\ny_m = { keys = [{ t = 0, value = 9 }, { t = 1, value = 8 }] }\n");
  place_camera(moving, terrain);
  EXPECT_EQ(moving.view.camera.eye_m.y, 9.0);
}

// Fails if a walker's eye is not at its height above the ground as it is drawn.
TEST_F(SceneTerrainTest, StandsWalkersOnTheGround) {
  const Scene scene = scene_of(
      "[terrain]\nposts = 33\n[camera]\nx_m = 1234\nz_m = -77\nmode = \"walk\"\n[walk]\neye_height_m = 2\n");
  world::World world(ocl::Device::open(), prepare_world(scene));
  const ViewScene view = show_at(world, scene, 0.0);
  const double relief_m = world.terrain()->relief_m(1234.0, -77.0);
  EXPECT_NE(relief_m, 0.0);
  EXPECT_NEAR(view.camera.eye_m.y, world.terrain()->terrain_at(1234.0, -77.0)->height_m + relief_m + 2.0,
              1e-9);
}

// Fails if an eye in the ground stays there, if nobody is told how deep it was, or if one over the ground is
// moved. Off the map one is told of where there is no sea.
TEST_F(SceneTerrainTest, LiftsEyesOutOfTheGround) {
  const Scene scene = scene_of("[terrain]\nposts = 33\n[camera]\nx_m = 1234\nz_m = -77\n");
  world::World world(ocl::Device::open(), prepare_world(scene));
  const world::WorldTerrain& terrain = *world.terrain();
  const double terrain_m = terrain.terrain_at(1234.0, -77.0)->height_m;
  ViewScene view = view_at(scene, 0.0);
  view.camera.eye_m.y = terrain_m - 12.5;
  EXPECT_THAT(eye_warning(terrain, view, true).value_or(""),
              testing::HasSubstr("is 12.5 m below the ground"));
  stand_on_ground(terrain, view);
  EXPECT_NEAR(view.camera.eye_m.y, terrain_m + view.walker.eye_height_m, 1e-9);
  view.camera.eye_m.y = terrain_m + 0.5;
  EXPECT_EQ(eye_warning(terrain, view, false), std::nullopt);
  stand_on_ground(terrain, view);
  EXPECT_EQ(view.camera.eye_m.y, terrain_m + 0.5);
  view.camera.eye_m.x = -10'100.0;  // the ground is 20 km wide
  EXPECT_EQ(eye_warning(terrain, view, true), std::nullopt);
  EXPECT_THAT(eye_warning(terrain, view, false).value_or(""),
              testing::HasSubstr("is 100.0 m beyond the map"));
}

}  // namespace
}  // namespace offing::scene
