// Scenes are large: what only reads one does not copy it.
#include <gtest/gtest.h>

#include "host/scene/file/scene_files.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/world_scene.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/scene/section_text.h"

namespace offing::scene {
namespace {

// Fails if showing, comparing, preparing, hashing or saving a scene copies it. A frame does no more with it.
TEST(SceneCopies, ReadingMakesNone) {
  const Scene scene = test::scene_of(
      "[ocean]\nsize = 16\n[[ocean.cascade]]\npatch_m = 100\n[[ocean.swell]]\n[[mesh]]\nname = \"a\"\n"
      "[[mesh.highlight]]\nopacity = 0.5\n[[light]]\n[camera]\nx_m.keys = [{ t = 0, value = 3 }]\n");
  const Scene other = scene;
  const std::size_t before = CopyCount::copies();
  for (const Parameter& row : parameter_table()) {
    value_text(scene, row, Digits::exact);
    default_text(row);
  }
  EXPECT_FALSE(differ_in(Affects::spectrum | Affects::meshes | Affects::clouds, scene, other));
  const Sea sea = prepare_sea(scene, Warnings::left_out);
  unused_parameters(scene, sea);
  scene_hash(scene, sea, "");
  scene_text(scene, "");
  files_of(scene);
  view_at(scene, 1.0);
  mesh_materials_at(scene, 1.0);
  mesh_rules_at(scene, 1.0);
  lights_at(scene, 1.0);
  prepare_world(scene, Warnings::left_out);
  EXPECT_EQ(CopyCount::copies(), before);
}

// Fails if an edit leaves a difference, elements that have gone, or takes clouds that are not to be shown
// yet.
TEST(SceneCopies, DifferencesAreTaken) {
  const Scene edited = test::scene_of(
      "[wind]\nspeed_mps = 3\n[[ocean.swell]]\namplitude_m = 2\n[terrain]\nfile = \"map.tif\"\n[[cloud]]\n"
      "scale = 2\n[[mesh]]\n[[mesh.highlight]]\nopacity = { keys = [{ t = 0, value = 0.5 }] }\n");
  Scene scene = test::scene_of(
      "[ocean]\n[[ocean.swell]]\n[[ocean.swell]]\nperiod_s = 5\n[[cloud]]\n[[cloud]]\n[[mesh]]\n[[mesh]]\n"
      "[camera]\nx_m = { keys = [{ t = 0, value = 1 }] }\n");
  const std::size_t before = CopyCount::copies();
  take_values(all_but_clouds, edited, scene);
  EXPECT_FALSE(differ_in(all_but_clouds, edited, scene));
  EXPECT_EQ(scene.clouds.size(), 2u);
  EXPECT_TRUE(scene.terrain.is_given);
  EXPECT_EQ(scene.tracks, edited.tracks);
  take_values(everything, edited, scene);
  EXPECT_EQ(scene_text(scene, ""), scene_text(edited, ""));
  EXPECT_EQ(CopyCount::copies(), before);
}

// Fails if copies are not counted, or moves are.
TEST(SceneCopies, AreCounted) {
  Scene scene;
  const std::size_t before = CopyCount::copies();
  Scene copy = scene;
  copy = scene;
  EXPECT_EQ(CopyCount::copies(), before + 2);
  const Scene moved = std::move(copy);
  EXPECT_EQ(CopyCount::copies(), before + 2);
}

}  // namespace
}  // namespace offing::scene
