// Undo and redo of every kind of edit, by the pictures that they show.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/presets.h"
#include "present/editing/objects/object_edits.h"
#include "present/editing/objects/selection.h"
#include "present/editing/scene_editing.h"
#include "present/output/camera_path.h"
#include "present/view_options.h"
#include "present/window/bookmarks.h"
#include "present/window/dropped_files.h"
#include "tests/io/temporary_folder.h"
#include "tests/present/gl_test.h"
#include "tests/present/no_threads.h"

namespace offing::present {
namespace {

/// One of each kind of object, and of each section.
constexpr const char* scene_text = R"(version = 1
[camera]
x_m = 0
y_m = 5
z_m = 14
pitch_deg = -8
fov_deg = 60
[ocean]
size = 32
cascade_count = 1
[[ocean.swell]]
period_s = 4
amplitude_m = 0.2
[[ocean.raindrop]]
x_m = 1
amplitude_m = 0.005
time_s = -2
[[ocean.wake]]
centre = "place"
length_m = 24
cells = 32
history_s = 1
[[ocean.wake.hull]]
x_m = 3
length_m = 4
beam_m = 2
draught_m = 0.5
speed_mps = 2
[terrain]
posts = 65
side_m = 400
mean_m = -12
relief_m = 40
origin_z_m = -500
[[terrain.material]]
name = "moss"
[[mesh]]
name = "ball"
shape = "sphere"
size_m = 1.5
detail = 2
x_m = -4
y_m = 4
[[mesh.highlight]]
[[mesh]]
name = "hull"
shape = "ship"
size_m = 6
detail = 1
highlights = "off"
[[light]]
name = "lantern"
kind = "place"
x_m = -2
y_m = 7
z_m = 4
illuminance_klx = 200
[[body]]
name = "boat"
mesh = "hull"
draught_m = 0.4
x_m = 3
z_m = -4
[[body.mooring]]
anchor_m = [3, -5, -9]
[clouds]
quality = 0.1
[[cloud]]
name = "heap"
y_m = 300
z_m = -1200
[[cloud.ball]]
radius_m = 150
[[cloud.level]]
ratio = 0.5
[[cloud.particle_edit]]
fate = "kept"
[[cloud_layer]]
coverage = 0
extent_m = 500
y_m = 400
[[bookmark]]
y_m = 3
)";

/// A value of each group of the parameter table that a user can edit, and whether this scene shows it.
struct ValueEdit {
  const char* key;
  const char* text;
  bool is_seen = true;
};
constexpr std::array<ValueEdit, 31> value_edits{{{"wind.speed_mps", "16"},
                                                 {"ocean.hs_m", "2"},
                                                 {"ocean.choppiness", "0.2"},
                                                 {"ocean.gerstner.count", "4"},
                                                 {"ocean.swell.amplitude_m", "0.6"},
                                                 {"ocean.raindrop.amplitude_m", "0.01", false},
                                                 {"ocean.wake.length_m", "12"},
                                                 {"ocean.wake.hull.draught_m", "1"},
                                                 {"ocean.foam.fraction", "0.2", false},
                                                 {"terrain.relief_m", "90"},
                                                 {"terrain.vertical_scale", "2", false},
                                                 {"terrain.material.share", "0.1", false},
                                                 {"terrain.canopy.share", "0.7", false},
                                                 {"walk.eye_height_m", "3", false},
                                                 {"mesh.size_m", "9"},
                                                 {"mesh.highlight.opacity", "0.3", false},
                                                 {"light.y_m", "5"},
                                                 {"body.x_m", "1"},
                                                 {"body.mooring.length_m", "1", false},
                                                 {"clouds.quality", "0.2", false},
                                                 {"cloud_layer.x_m", "9", false},
                                                 {"cloud.scale", "1.5"},
                                                 {"cloud.ball.radius_m", "220"},
                                                 {"cloud.level.ratio", "0.7", false},
                                                 {"cloud.particle_edit.fate", "removed", false},
                                                 {"sun.elevation_deg", "12"},
                                                 {"sky.ozone_du", "600", false},
                                                 {"bookmark.x_m", "4", false},
                                                 {"render.exposure_ev", "1"},
                                                 {"world.seed", "9"},
                                                 {"time.fps", "30", false}}};

class UndoPicturesTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    state_.scene = first_scene();
    sea_ = std::make_unique<LiveSea>(
        *context_, LiveSeaSettings{.device = "", .frame = frame_settings(Detail::low)}, state_.scene);
    state_.camera = FreeCamera(state_.scene.view.camera);
    editing_ = std::make_unique<SceneEditing>(*sea_, state_);
    untouched_ = picture();
  }
  void TearDown() override {
    editing_.reset();
    sea_.reset();
    GlTest::TearDown();
  }

  virtual scene::Scene first_scene() { return scene::parse_scene(scene_text, "a.toml", ""); }
  Screen screen() const { return {state_.camera.camera(), {96.0, 64.0}}; }

  /// Once all clouds are made.
  std::vector<unsigned char> picture() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (sea_->is_making() && std::chrono::steady_clock::now() < end) {
      if (editing_) editing_->take_made();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (editing_) editing_->take_made();
    Camera camera = state_.camera.camera();
    camera.width_px = 96;
    camera.height_px = 64;
    // As a window does: a moving picture, then that of a view that stands, whose highlights have no history.
    sea_->draw({.time_s = 0.0, .camera = camera});
    sea_->draw({.time_s = 0.0,
                .camera = camera,
                .lighting_at = recorded_lighting(sea_->scene(), sea_->terrain(), camera.eye_m),
                .first_s = 0.0},
               PictureKind::still);
    return sea_->frame().screen().read_bytes();
  }
  std::string text() const { return scene::scene_text(state_.scene, ""); }

  /// Does it, takes it back, does it again and takes it back: the scene is then as it was.
  void expect_undone_and_redone(const std::string& name, bool is_seen, const std::function<void()>& edit) {
    const std::string before = text();
    edit();
    ASSERT_FALSE(state_.message.is_fault) << name << ": " << state_.message.text;
    const std::string after = text();
    EXPECT_NE(after, before) << name;
    const std::vector<unsigned char> edited = picture();
    EXPECT_TRUE(edited != untouched_ || !is_seen) << name << " is not seen";
    editing_->undo();
    EXPECT_EQ(text(), before) << name;
    EXPECT_TRUE(picture() == untouched_) << "undo of " << name;
    editing_->redo();
    EXPECT_EQ(text(), after) << name;
    EXPECT_TRUE(picture() == edited) << "redo of " << name;
    editing_->undo();
    EXPECT_EQ(text(), before) << name;
    deselect_objects(state_);
  }
  void change(const std::string& name, bool is_seen, const std::function<void(scene::Scene&)>& change) {
    expect_undone_and_redone(name, is_seen, [&] {
      editing_->make([&](scene::Scene& scene) {
        change(scene);
        return std::string();
      });
    });
  }

  ViewState state_{.scene = {}, .camera = FreeCamera(Camera{}), .clock = SceneClock(0.0)};
  std::unique_ptr<LiveSea> sea_;
  std::unique_ptr<SceneEditing> editing_;
  std::vector<unsigned char> untouched_;
};

// Fails if undo or redo of a value shows another picture or leaves another scene, or a group has no value
// here.
TEST_F(UndoPicturesTest, OfValues) {
  // The camera, which undo leaves to the user, and lakes, which need a basin: see below.
  std::set<scene::ParameterGroup> groups{scene::ParameterGroup::camera, scene::ParameterGroup::lake};
  for (const ValueEdit& edit : value_edits) {
    ASSERT_NE(scene::find_parameter(edit.key), nullptr) << edit.key;
    const scene::Parameter& row = *scene::find_parameter(edit.key);
    groups.insert(row.group);
    change(edit.key, edit.is_seen, [&](scene::Scene& scene) {
      scene::store(scene, row, scene::read_flag_value(row, edit.text), {.subject = edit.key},
                   scene::ElementIndex{});
    });
  }
  for (const GroupPanel& panel : group_panels()) EXPECT_TRUE(groups.contains(panel.group)) << panel.title;
}

// Fails as above for objects that are added, copied, deleted, hidden and renamed.
TEST_F(UndoPicturesTest, OfObjects) {
  using enum NewObject::Kind;
  for (const NewObject::Kind kind : {boat, mesh, light, cloud, cloud_layer, bookmark}) {
    const bool is_seen = kind != bookmark && kind != light;
    expect_undone_and_redone("add " + std::to_string(static_cast<int>(kind)), is_seen, [&] {
      editing_->do_to_object({.added = {.kind = kind, .shape = 1}}, screen());
    });
  }
  for (const SceneObject& object : objects_of(state_.scene)) {
    const std::string name = label_of(state_.scene, object);
    if (can_be_duplicated(object)) {
      expect_undone_and_redone("copy " + name, false, [&] {
        select_object(state_, object);
        editing_->duplicate_picked(screen());
      });
    }
    const bool is_beneath_a_body = object.kind == ObjectKind::sea;  // see below
    if (can_be_removed(state_.scene, object) && !is_beneath_a_body) {
      expect_undone_and_redone("delete " + name, false, [&] {
        select_object(state_, object);
        editing_->remove_picked();
      });
    }
    if (name_row(object.kind) != nullptr) {
      expect_undone_and_redone("rename " + name, false, [&] {
        editing_->do_to_object({.kind = ObjectEdit::Kind::rename, .object = object, .name = "other"},
                               screen());
      });
    }
  }
  change("hide", true,
         [](scene::Scene& scene) { scene.meshes[0].material.visible = world::MeshVisibility::off; });
  // A sea that carries bodies cannot be deleted.
  editing_->make([](scene::Scene& scene) {
    stop_floating(scene, 0);
    return std::string();
  });
  untouched_ = picture();
  expect_undone_and_redone("delete the sea", true, [&] {
    select_object(state_, {ObjectKind::sea, 0});
    editing_->remove_picked();
  });
}

// Fails if a boat that new terrain covers is not moved to water, in the same step of undo, or not named where
// there is no water within 20 km.
TEST_F(UndoPicturesTest, BoatsOnLandMoveToWater) {
  const TemporaryFolder folder;
  const auto open_plain = [&](int height_m, int side_m) {
    const std::string name = fmt::format("plain_{}_{}.asc", height_m, side_m);
    const std::filesystem::path map = folder.path() / name;
    std::ofstream file(map);
    file << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize " << side_m << '\n';
    for (int post = 0; post < 4; ++post) file << height_m << ' ';
    file.close();
    editing_->make([&](scene::Scene& scene) {
      std::string news = add_dropped(scene, map, DroppedKind::height_map, {});
      scene.terrain.origin_x_m = scene.terrain.origin_z_m = -0.5 * side_m;
      return news;
    });
    EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
  };
  const auto place = [&] { return glm::dvec2(state_.scene.bodies[0].x_m, state_.scene.bodies[0].z_m); };
  const glm::dvec2 start = place();
  editing_->make([](scene::Scene& scene) {
    scene.bodies[0].moorings.clear();
    return std::string();
  });
  open_plain(-30, 900);
  EXPECT_EQ(state_.message.text.find("on land"), std::string::npos) << state_.message.text;
  EXPECT_EQ(place(), start);
  editing_->undo();
  open_plain(40, 900);
  EXPECT_NE(state_.message.text.find("boat would be on land: moved"), std::string::npos)
      << state_.message.text;
  EXPECT_GT(std::max(std::abs(place().x), std::abs(place().y)), 450.0);
  EXPECT_LT(glm::length(place()), 700.0);
  EXPECT_EQ(sea_->scene().bodies[0].x_m, place().x) << "the world has another one";
  editing_->undo();
  EXPECT_EQ(place(), start);
  EXPECT_EQ(state_.scene.terrain.file, "") << "one step takes both back";
  open_plain(40, 90'000);
  EXPECT_NE(state_.message.text.find("on land now: boat"), std::string::npos) << state_.message.text;
  EXPECT_EQ(place(), start);
  open_plain(50, 90'000);
  EXPECT_EQ(state_.message.text.find("on land"), std::string::npos) << "it was before";
}

// Fails if a slider that brings ground under a boat leaves it there, moves it before the hand lets go, or
// takes another step of undo.
TEST_F(UndoPicturesTest, SlidersMoveBoatsToWater) {
  const auto drag = [&](double origin_x_m, Edit edit) {
    state_.scene.terrain.origin_x_m = origin_x_m;
    editing_->finish(edit);
    EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
  };
  const auto x_m = [&] { return state_.scene.bodies[0].x_m; };
  const TemporaryFolder folder;
  const std::filesystem::path map = folder.path() / "plain.asc";
  std::ofstream(map) << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 900\n40 40 40 40\n";
  editing_->make([&](scene::Scene& scene) {
    scene.bodies[0].moorings.clear();
    std::string news = add_dropped(scene, map, DroppedKind::height_map, {});
    scene.terrain.origin_x_m = 5000.0;
    scene.terrain.origin_z_m = -450.0;
    return news;
  });
  const double start_m = x_m();
  for (const double origin_x_m : {2000.0, -450.0}) drag(origin_x_m, Edit::going_on);
  EXPECT_EQ(x_m(), start_m);
  drag(-450.0, Edit::done);
  EXPECT_NE(state_.message.text.find("boat would be on land: moved"), std::string::npos)
      << state_.message.text;
  EXPECT_GT(std::max(std::abs(x_m()), std::abs(state_.scene.bodies[0].z_m)), 450.0);
  EXPECT_EQ(sea_->scene().bodies[0].x_m, x_m()) << "the world has another one";
  editing_->undo();
  EXPECT_EQ(x_m(), start_m);
  EXPECT_EQ(state_.scene.terrain.origin_x_m, 5000.0) << "one step takes both back";
}

// Fails if terrain has no place that a camera can look at: the middle of its map.
TEST_F(UndoPicturesTest, TerrainHasAPlace) {
  select_object(state_, {ObjectKind::terrain, 0});
  const std::optional<Sphere> place = editing_->selected_place(screen());
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->centre_m.x, 0.0, 1.0);
  EXPECT_NEAR(place->centre_m.z, -300.0, 1.0);
  EXPECT_NEAR(place->radius_m, 100.0, 1.0);
}

/// A bowl of 240 m with a rim 20 m above its floor, and a camera that looks into it.
class UndoLakePicturesTest : public UndoPicturesTest {
 protected:
  scene::Scene first_scene() override {
    constexpr int posts = 11, middle = 5, rim = 4;
    std::ofstream map(folder_.path() / "bowl.asc");
    map << "ncols 11\nnrows 11\nxllcenter 0\nyllcenter 0\ncellsize 30\n";
    for (int row = 0; row < posts; ++row) {
      for (int column = 0; column < posts; ++column) {
        const int ring = std::max(std::abs(row - middle), std::abs(column - middle));
        map << (ring > rim ? 30.0 : 20.0 + 20.0 * ring * ring / (rim * rim)) << ' ';
      }
      map << '\n';
    }
    map.close();
    return scene::parse_scene(
        "version = 1\n[camera]\ny_m = 130\nz_m = 130\npitch_deg = -40\n[terrain]\nfile = "
        "\"bowl.asc\"\norigin_x_m = -150\norigin_z_m = -150\n",
        "a.toml", folder_.path());
  }
  void put_lake() { editing_->do_to_object({.added = {.kind = NewObject::Kind::lake}}, screen()); }

  const TemporaryFolder folder_;
};

// Fails as above for lakes.
TEST_F(UndoLakePicturesTest, OfLakes) {
  expect_undone_and_redone("add a lake", true, [&] { put_lake(); });
  put_lake();
  ASSERT_FALSE(state_.message.is_fault) << state_.message.text;
  untouched_ = picture();
  change("level", true, [](scene::Scene& scene) { scene.lakes.at(0).level_m = 26.0; });
  change("place", false, [](scene::Scene& scene) { scene.lakes.at(0).x_m += 5.0; });
  const SceneObject lake{ObjectKind::lake, 0};
  expect_undone_and_redone("rename a lake", false, [&] {
    editing_->do_to_object({.kind = ObjectEdit::Kind::rename, .object = lake, .name = "tarn"}, screen());
  });
  for (const SceneObject& object : {lake, SceneObject{ObjectKind::terrain, 0}}) {
    if (!can_be_removed(state_.scene, object)) continue;
    expect_undone_and_redone("delete " + label_of(state_.scene, object), true, [&] {
      select_object(state_, object);
      editing_->remove_picked();
    });
  }
}

// Fails if an edit waits until its lake is filled, a lake comes up that was undone meanwhile, or one that
// cannot be there stays in the scene.
TEST_F(UndoLakePicturesTest, LakesAreFilledInTheBackground) {
  put_lake();
  EXPECT_TRUE(sea_->is_making());
  EXPECT_TRUE(sea_->scene().lakes.empty()) << "it was waited for";
  editing_->undo();
  EXPECT_FALSE(sea_->is_making());
  EXPECT_TRUE(picture() == untouched_);
  editing_->redo();
  EXPECT_FALSE(picture() == untouched_);
  ASSERT_EQ(sea_->scene().lakes.size(), 1u);
  const std::vector<unsigned char> full = picture();
  const std::string before = text();
  editing_->make([](scene::Scene& scene) {
    scene.lakes.at(0).level_m = 1000.0;
    return std::string();
  });
  EXPECT_TRUE(picture() == full);
  EXPECT_TRUE(state_.message.is_fault);
  EXPECT_NE(state_.message.text.find("lake 1: "), std::string::npos) << state_.message.text;
  EXPECT_EQ(text(), before);
}

// Fails if edits that came after a lake that cannot be filled are lost with it, or it comes back by undo or
// redo.
TEST_F(UndoLakePicturesTest, OtherEditsOutliveABadLake) {
  put_lake();
  picture();
  const auto edit = [&](const std::function<void(scene::Scene&)>& change) {
    editing_->make([&](scene::Scene& scene) {
      change(scene);
      return std::string();
    });
  };
  const auto spoil = [&] { edit([](scene::Scene& scene) { scene.lakes.at(0).level_m = 1000.0; }); };
  const auto low_sun = [](scene::Scene& scene) { scene.view.sun_direction.elevation_rad = 0.2; };
  const auto expect_good = [&](double elevation_rad) {
    EXPECT_TRUE(state_.message.is_fault);
    EXPECT_NE(state_.message.text.find("lake 1: "), std::string::npos) << state_.message.text;
    ASSERT_EQ(state_.scene.lakes.size(), 1u);
    EXPECT_LT(state_.scene.lakes[0].level_m.value_or(0.0), 100.0);
    EXPECT_EQ(sea_->scene().lakes.size(), 1u);
    EXPECT_EQ(sea_->scene().view.sun_direction.elevation_rad, elevation_rad);
    EXPECT_EQ(state_.scene.view.sun_direction.elevation_rad, elevation_rad);
  };
  const double high_rad = state_.scene.view.sun_direction.elevation_rad;
  spoil();
  edit(low_sun);
  picture();
  expect_good(0.2);
  EXPECT_EQ(editing_->undo_words(), "Sun: elevation");
  editing_->undo();
  EXPECT_EQ(state_.scene.view.sun_direction.elevation_rad, high_rad);
  EXPECT_EQ(editing_->undo_words(), "add lake");

  spoil();
  edit(low_sun);
  editing_->undo();
  picture();
  expect_good(high_rad);
  editing_->redo();
  EXPECT_EQ(state_.scene.view.sun_direction.elevation_rad, 0.2);
  EXPECT_LT(state_.scene.lakes.at(0).level_m.value_or(0.0), 100.0);
  editing_->undo();

  // A slider that is held goes on.
  spoil();
  low_sun(state_.scene);
  editing_->finish(Edit::going_on);
  picture();
  expect_good(0.2);
  EXPECT_TRUE(state_.edit.fault.empty());
  editing_->finish(Edit::done);
  EXPECT_EQ(editing_->undo_words(), "Sun: elevation");
  editing_->undo();
  EXPECT_EQ(editing_->undo_words(), "add lake");

  // The ground is to blame where the lake was there before: 13 m of it stay below the lake.
  edit([](scene::Scene& scene) { scene.terrain.origin_x_m = 1000.0; });
  edit(low_sun);
  picture();
  expect_good(0.2);
  EXPECT_EQ(state_.scene.terrain.origin_x_m, -150.0);
}

// Fails if a lake that no thread can fill ends the window, or takes other edits with it.
TEST_F(UndoLakePicturesTest, LakesWithoutAThreadAreRefused) {
  {
    const test::NoThreads none;
    put_lake();
    editing_->take_made();
  }
  EXPECT_TRUE(state_.message.is_fault);
  EXPECT_NE(state_.message.text.find("lakes: cannot start a thread"), std::string::npos)
      << state_.message.text;
  EXPECT_TRUE(state_.scene.lakes.empty());
  EXPECT_TRUE(picture() == untouched_);
  put_lake();
  EXPECT_FALSE(picture() == untouched_);
  EXPECT_EQ(sea_->scene().lakes.size(), 1u);
}

// Fails as above for presets, handles, keyframes, bookmarks and files.
TEST_F(UndoPicturesTest, OfAllElse) {
  std::set<scene::ParameterGroup> groups;
  for (const scene::Preset& preset : scene::presets()) {
    const bool is_heavy = preset.group == scene::ParameterGroup::cloud_layer;  // and like that of a cloud
    if (is_heavy || !groups.insert(preset.group).second) continue;
    change(std::string(preset.name), true, [&](scene::Scene& scene) { scene::apply(preset, scene); });
  }
  const ObjectPull pull{.way_m = {1.0, 0.5, -1.0}, .turn_rad = {0.0, 0.4, 0.0}};
  change("pull a mesh", true, [&](scene::Scene& scene) {
    pull_mesh(scene, {.mesh = 0, .local = {.rotation = glm::dmat3(1.0)}}, pull);
  });
  change("pull a body", true, [&](scene::Scene& scene) { pull_body(scene, {.body = 0, .hull = 1}, pull); });
  for (const SceneObject object : {SceneObject{ObjectKind::light, 0},
                                   {ObjectKind::cloud_layer, 0},
                                   {ObjectKind::wake, 0},
                                   {ObjectKind::bookmark, 0}}) {
    change("pull " + label_of(state_.scene, object), object.kind == ObjectKind::wake,
           [&](scene::Scene& scene) {
             pull_place(scene, object, place_of(scene, object, 0.0).value_or(Sphere{}), pull);
           });
  }
  change("keyframes", true, [](scene::Scene& scene) {
    scene.tracks[{"mesh.x_m", {0, 0}}] = {.keys = {{0.0, -2.0}, {5.0, 2.0}}};
  });
  change("set a bookmark", false,
         [&](scene::Scene& scene) { set_bookmark(scene, state_.camera.camera(), 2); });
  const TemporaryFolder folder;
  const std::filesystem::path mesh = folder.path() / "wedge.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  change("a mesh's file", true, [&](scene::Scene& scene) {
    add_dropped(scene, mesh, DroppedKind::mesh, {0.0, 3.0, 4.0});
  });
  const std::filesystem::path map = folder.path() / "hill.asc";
  std::ofstream(map) << "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 300\n-9 -9 -9\n-9 200 -9\n-9 "
                        "-9 -9\n";
  change("a map's file", true,
         [&](scene::Scene& scene) { add_dropped(scene, map, DroppedKind::height_map, {}); });
  const std::filesystem::path cloud = folder.path() / "haze.ply";
  std::ofstream(cloud) << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                          "property float z\nproperty float radius\nproperty float optical_mass\nend_header\n"
                          "0 300 -900 120 80000\n";
  change("a cloud's file", true,
         [&](scene::Scene& scene) { add_dropped(scene, cloud, DroppedKind::cloud, {}); });
  change("a spectrum's file", true, [&](scene::Scene& scene) {
    add_dropped(scene, OFFING_SOURCES "/scenes/example_sea.data_spec", DroppedKind::spectrum, {});
  });
}

}  // namespace
}  // namespace offing::present
