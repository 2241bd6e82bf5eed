// Edits of clouds that are made in the background: what is shown in the end, what is undone, and what becomes
// of edits that fail.
#include "present/editing/scene_editing.h"

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/io/clouds/cloud_particles.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "present/editing/cloud_picker.h"
#include "present/editing/objects/selection.h"
#include "tests/io/temporary_folder.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

using ::testing::HasSubstr;

constexpr const char* scene_text = R"(version = 1
[camera]
y_m = 900
z_m = 2500
[[cloud]]
y_m = 1000
[[cloud.ball]]
radius_m = 300
[[cloud.level]]
ratio = 0.5
)";

class SceneEditingTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    state_.scene = scene::parse_scene(scene_text, "a.toml", "");
    sea_ = std::make_unique<LiveSea>(*context_, LiveSeaSettings{.device = "", .frame = {}}, state_.scene);
    state_.camera = FreeCamera(state_.scene.view.camera);
    editing_ = std::make_unique<SceneEditing>(*sea_, state_);
  }
  void TearDown() override {
    editing_.reset();
    sea_.reset();
    GlTest::TearDown();
  }

  std::vector<unsigned char> picture() {
    Camera camera = state_.scene.view.camera;
    camera.width_px = 96;
    camera.height_px = 64;
    sea_->draw({.time_s = 0.0, .camera = camera});
    return sea_->frame().screen().read_bytes();
  }

  /// Frames go by until the clouds are made.
  void wait() {
    using clock = std::chrono::steady_clock;
    const auto end = clock::now() + std::chrono::seconds(60);
    while (sea_->clouds_progress()) {
      ASSERT_LT(clock::now(), end) << "the clouds are never made";
      editing_->take_made();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    editing_->take_made();
  }
  void edit(const std::function<void(scene::Scene&)>& change, Edit edit = Edit::done) {
    change(state_.scene);
    editing_->finish(edit);
  }
  std::string text() const { return scene::scene_text(state_.scene, ""); }

  /// An edit that cannot be made: one message that tells why, the scene and its picture as they were, and
  /// undo as if it had never been.
  void expect_refused(const std::function<void(scene::Scene&)>& change, const std::string& why) {
    const std::string before = text();
    const std::vector<unsigned char> shown = picture();
    state_.message = {};
    edit(change);
    wait();
    EXPECT_TRUE(state_.message.is_fault) << why;
    EXPECT_THAT(state_.message.text, HasSubstr(why));
    EXPECT_EQ(text(), before) << why;
    wait();  // what was given up for it
    EXPECT_TRUE(picture() == shown) << why;
  }

  ViewState state_{.scene = {}, .camera = FreeCamera(Camera{}), .clock = SceneClock(0.0)};
  std::unique_ptr<LiveSea> sea_;
  std::unique_ptr<SceneEditing> editing_;
};

// Fails if a slider that is dragged copies the scene but for undo, or if a frame does.
TEST_F(SceneEditingTest, ADragCopiesTheSceneOnce) {
  picture();
  const std::size_t before = scene::CopyCount::copies();
  for (const double elevation_rad : {0.3, 0.4, 0.5}) {
    edit([&](scene::Scene& scene) { scene.view.sun_direction.elevation_rad = elevation_rad; },
         Edit::going_on);
    picture();
  }
  EXPECT_EQ(scene::CopyCount::copies(), before);
  edit([](scene::Scene& scene) { scene.view.sun_direction.elevation_rad = 0.6; });
  EXPECT_EQ(scene::CopyCount::copies(), before + 1);
  EXPECT_EQ(sea_->scene().view.sun_direction.elevation_rad, 0.6);
  EXPECT_EQ(sea_->wanted().view.sun_direction.elevation_rad, 0.6);
}

// Fails if an edit shows anything but what a fresh start with it shows, or undo and redo do.
TEST_F(SceneEditingTest, ShowsWhatAFreshStartShows) {
  const std::vector<unsigned char> untouched = picture();
  edit([](scene::Scene& scene) { scene.clouds[0].balls[0].radius_m = 350.0; });
  EXPECT_TRUE(picture() == untouched);  // until they are taken, however soon they are made
  wait();
  const std::vector<unsigned char> larger = picture();
  EXPECT_FALSE(larger == untouched);
  edit([](scene::Scene& scene) { scene.clouds[0].position_m.x = 200.0; });
  edit([](scene::Scene& scene) { scene.view.sun_direction.elevation_rad = 0.1; });
  wait();
  const std::vector<unsigned char> all = picture();
  LiveSea fresh(*context_, {.device = "", .frame = {}}, state_.scene);
  Camera camera = state_.scene.view.camera;
  camera.width_px = 96;
  camera.height_px = 64;
  fresh.draw({.time_s = 0.0, .camera = camera});
  EXPECT_TRUE(fresh.frame().screen().read_bytes() == all);
  editing_->undo();
  editing_->undo();
  wait();
  EXPECT_TRUE(picture() == larger);
  editing_->undo();
  wait();
  EXPECT_TRUE(picture() == untouched);
  for (int i = 0; i < 3; ++i) editing_->redo();
  wait();
  EXPECT_TRUE(picture() == all);
}

// Fails if clouds of an edit that came later are replaced by those of an earlier one, or other edits wait for
// clouds.
TEST_F(SceneEditingTest, OtherEditsDoNotWait) {
  edit([](scene::Scene& scene) { scene.clouds[0].seed = 4; });
  edit([](scene::Scene& scene) { scene.view.sun_direction.elevation_rad = 0.05; });
  EXPECT_EQ(sea_->scene().view.sun_direction.elevation_rad, 0.05);
  EXPECT_EQ(sea_->wanted().clouds[0].seed, 4u);
  wait();
  EXPECT_EQ(sea_->scene().clouds[0].seed, 4u);
  EXPECT_EQ(sea_->scene().view.sun_direction.elevation_rad, 0.05);
}

// A scene gets its first cloud and loses it again. Fails if either cannot be shown.
TEST_F(SceneEditingTest, TheLastCloudMayGo) {
  edit([](scene::Scene& scene) { scene.clouds.clear(); });
  wait();
  EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
  EXPECT_EQ(sea_->clouds(), nullptr);
  picture();
  editing_->undo();
  wait();
  ASSERT_NE(sea_->clouds(), nullptr);
  EXPECT_GT(sea_->clouds()->count(), 0u);
  picture();
}

// Fails if a picture with a hidden cloud is not the one without the cloud, a hidden cloud can be picked, or
// undo does not show it again.
TEST_F(SceneEditingTest, HiddenCloudsAreNotThere) {
  const std::vector<unsigned char> both = picture();
  edit([](scene::Scene& scene) { scene.clouds[0].visible = scene::CloudVisibility::off; });
  wait();
  EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
  const std::vector<unsigned char> hidden = picture();
  EXPECT_FALSE(hidden == both);
  EXPECT_EQ(sea_->clouds(), nullptr) << "nothing of it is left to draw";
  const ShownClouds shown{state_.scene, sea_->clouds(), 0.0};
  const ClipBox all{.low = {-1.0, -1.0}, .high = {1.0, 1.0}};
  EXPECT_TRUE(parts_in(shown, {state_.scene.view.camera, {96.0, 64.0}}, all, PartKind::balls).empty());
  editing_->undo();
  wait();
  EXPECT_TRUE(picture() == both);
}

// Fails if a cloud is drawn or lit in another way because hidden ones are listed beside it: their number
// made the grids of its light coarser.
TEST_F(SceneEditingTest, HiddenCloudsLeaveOthersAsTheyAre) {
  const std::vector<unsigned char> alone = picture();
  edit([](scene::Scene& scene) {
    scene::CloudScene hidden = scene.clouds[0];
    hidden.position_m.x = 3000.0;
    hidden.motion.wind_mps = glm::dvec3(5.0, 0.0, 0.0);
    hidden.visible = scene::CloudVisibility::off;
    scene.clouds.insert(scene.clouds.begin(), 2, hidden);
    scene.clouds.insert(scene.clouds.end(), 2, hidden);
  });
  wait();
  EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
  EXPECT_TRUE(picture() == alone);
}

TEST_F(SceneEditingTest, RefusesBrokenFiles) {
  TemporaryFolder folder;
  const auto name = [&](const char* file) { return (folder.path() / file).string(); };
  const auto cut = [&](const char* whole, const char* file) {
    std::ifstream in(name(whole), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::ofstream(name(file), std::ios::binary) << bytes.substr(0, bytes.size() * 2 / 3);
  };
  CloudVolume volume{
      .cell_m = 40.0, .bricks = {1, 1, 1}, .brick_of = {0}, .density = std::vector<float>(512, 1.0f)};
  write_vdb(name("whole.vdb"), {.volume = volume, .albedo = {}});
  cut("whole.vdb", "cut.vdb");
  ParticleCloud particles{.origin_m = {}, .particles = std::vector<CloudParticle>(20)};
  for (CloudParticle& particle : particles.particles) {
    particle = {};
    particle.radius = 100.0f;
    particle.optical_mass = 1e4f;
  }
  write_cloud_particles(name("whole.ply"), particles);
  cut("whole.ply", "cut.ply");
  std::ofstream(name("nan.ply"))
      << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
         "y\nproperty float z\nproperty float radius\nproperty float "
         "optical_mass\nend_header\n1 2 3 40 nan\n";
  std::filesystem::create_directory(folder.path() / "puffs");
  for (int i = 0; i < CLOUD_TEXTURES; ++i) {
    std::ofstream(folder.path() / "puffs" / (std::to_string(i) + ".png")) << "no picture";
  }
  for (const char* file : {"cut.vdb", "cut.ply", "nan.ply", "nowhere.vdb"}) {
    expect_refused([&](scene::Scene& scene) { scene.clouds[0].shape.file = name(file); }, file);
  }
  expect_refused([&](scene::Scene& scene) { scene.cloud_settings.soft_billboards = name("puffs"); },
                 "clouds.soft_billboards");
  for (const char* file : {"whole.vdb", "whole.ply"}) {
    edit([&](scene::Scene& scene) { scene.clouds[0].shape.file = name(file); });
    wait();
    EXPECT_FALSE(state_.message.is_fault) << state_.message.text;
    EXPECT_EQ(sea_->scene().clouds[0].shape.file, name(file));
  }
}

TEST_F(SceneEditingTest, RefusesValuesThatNoCloudHas) {
  expect_refused([](scene::Scene& scene) { scene.clouds[0].balls[0].radius_m = -3.0; },
                 "cloud.ball[0].radius_m");
  expect_refused(
      [](scene::Scene& scene) {
        scene.clouds[0].look.extinction_per_m = std::numeric_limits<double>::quiet_NaN();
      },
      "cloud.extinction_per_m");
  expect_refused(
      [](scene::Scene& scene) {
        scene.clouds[0].motion.heat_k = 1.0;
        scene.clouds[0].motion.heat.damping_per_s = 1.0;
      },
      "cloud.heat_damping_per_s");
}

// A bad edit comes while a good one is being made, which it takes the place of. Fails if the good one is lost
// with the bad one, or if letting go of a slider that was held there counts as an edit that is done.
TEST_F(SceneEditingTest, GoodEditsOutliveBadOnes) {
  edit([](scene::Scene& scene) { scene.clouds[0].seed = 4; });
  edit([](scene::Scene& scene) { scene.clouds[0].shape.file = "nowhere.vdb"; });
  wait();
  EXPECT_TRUE(state_.message.is_fault);
  wait();
  EXPECT_EQ(state_.scene.clouds[0].seed, 4u);
  EXPECT_EQ(sea_->scene().clouds[0].seed, 4u);
  EXPECT_TRUE(state_.message.is_fault) << "the message is gone before anybody has read it";
  editing_->undo();
  EXPECT_EQ(state_.scene.clouds[0].seed, 1u);
  EXPECT_TRUE(state_.scene.clouds[0].shape.file.empty());
  // While a slider is held there is nothing to take back.
  edit([](scene::Scene& scene) { scene.clouds[0].shape.file = "nowhere.vdb"; }, Edit::going_on);
  wait();
  EXPECT_TRUE(state_.scene.clouds[0].shape.file.empty());
  EXPECT_THAT(state_.edit.fault, HasSubstr("nowhere.vdb"));
  editing_->redo();
  EXPECT_EQ(state_.scene.clouds[0].seed, 4u);
}

// Fails if an object that goes leaves the next one of its list selected, for the next Delete; or undo and
// redo leave another one selected than before.
TEST_F(SceneEditingTest, NothingElseGetsSelected) {
  edit([](scene::Scene& scene) {
    scene.lights.resize(3);
    for (std::size_t i = 0; i < 3; ++i) scene.lights[i].name = std::string(1, static_cast<char>('a' + i));
  });
  select_object(state_, {ObjectKind::light, 1});
  editing_->remove_picked();
  EXPECT_EQ(state_.message.text, "deleted b");
  EXPECT_FALSE(selected_object(state_));
  editing_->remove_picked();
  ASSERT_EQ(state_.scene.lights.size(), 2u);
  EXPECT_EQ(state_.scene.lights[1].name, "c");
  select_object(state_, {ObjectKind::light, 1});
  editing_->undo();
  ASSERT_EQ(state_.scene.lights.size(), 3u);
  EXPECT_FALSE(selected_object(state_)) << "it would be b";
  select_object(state_, {ObjectKind::light, 1});
  editing_->redo();
  EXPECT_FALSE(selected_object(state_)) << "it would be c";
  // What is still itself stays selected.
  select_object(state_, {ObjectKind::light, 1});
  edit([](scene::Scene& scene) { scene.lights[1].place_m.x = 7.0; });
  editing_->undo();
  EXPECT_EQ(selected_object(state_), (SceneObject{ObjectKind::light, 1}));
}

// Fails if the Delete key takes a mesh away while one of its highlights is picked.
TEST_F(SceneEditingTest, AHighlightIsNotItsMesh) {
  edit([](scene::Scene& scene) { scene.meshes.resize(1); });
  select_object(state_, {ObjectKind::mesh, 0});
  state_.picked = HighlightName{0, 0};
  editing_->remove_picked();
  EXPECT_EQ(state_.scene.meshes.size(), 1u);
  EXPECT_TRUE(state_.message.is_fault);
  EXPECT_THAT(state_.message.text, HasSubstr("highlight"));
}

/// A hand on the arrow along x of the only ball.
class HeldHandleTest : public SceneEditingTest {
 protected:
  void SetUp() override {
    SceneEditingTest::SetUp();
    if (IsSkipped()) return;
    state_.clouds.pick = CloudPick::balls;
    state_.clouds.picked = {{0, 0}};
    screen_.camera = state_.camera.camera();
    for (const ObjectHandlePlace& place :
         object_handle_places(screen_, balls_of(state_.scene, 0, 0.0)[0], sphere_handles())) {
      if (place.handle == ObjectHandle::x) start_ = clip_of(place.place_px);
    }
    using enum PointerEvent::Kind;
    editing_->turn(screen_, {{.kind = pressed, .clip = start_}}, {.clip = start_});
    move_to(0.1);
    EXPECT_GT(ball_x_m(), 10.0);
  }
  glm::dvec2 clip_of(glm::dvec2 px) const {
    // pixel_of_clip() is of both axes apart, and linear.
    const glm::dvec2 zero = pixel_of_clip(screen_, glm::dvec2(0.0)),
                     one = pixel_of_clip(screen_, glm::dvec2(1.0));
    return (px - zero) / (one - zero);
  }
  void move_to(double way) { editing_->turn(screen_, {}, {.clip = start_ + glm::dvec2(way, 0.0)}); }
  void release(double way) {
    const glm::dvec2 clip = start_ + glm::dvec2(way, 0.0);
    editing_->turn(screen_, {{.kind = PointerEvent::Kind::released, .clip = clip}}, {.clip = clip});
  }
  double ball_x_m() const { return state_.scene.clouds[0].balls[0].centre_m.x; }

  Screen screen_{.camera = {}, .size_px = {640.0, 480.0}};
  glm::dvec2 start_{0.0};
};

// Fails if what is shown stays where the hand was on its way, when it lets go where it took hold.
TEST_F(HeldHandleTest, BackToWhereItBeganIsShown) {
  release(0.0);
  wait();
  EXPECT_NEAR(ball_x_m(), 0.0, 1e-9);
  EXPECT_NEAR(sea_->scene().clouds[0].balls[0].centre_m.x, 0.0, 1e-9);
  editing_->undo();
  EXPECT_THAT(state_.message.text, HasSubstr("nothing to undo"));
  EXPECT_FALSE(editing_->history().can_undo()) << "nor where the scene is shown again";
}

// Fails if a hand that still holds overwrites what a key has done meanwhile.
TEST_F(HeldHandleTest, OtherEditsLetGo) {
  editing_->remove_picked();
  EXPECT_TRUE(state_.scene.clouds.empty());
  move_to(0.2);
  EXPECT_TRUE(state_.scene.clouds.empty());
  editing_->undo();
  EXPECT_EQ(state_.scene.clouds.size(), 1u);
  EXPECT_NEAR(ball_x_m(), 0.0, 1e-9);
  release(0.2);
  EXPECT_NEAR(ball_x_m(), 0.0, 1e-9);
  wait();
}

TEST_F(HeldHandleTest, UndoLetsGo) {
  edit([](scene::Scene& scene) { scene.clouds[0].seed = 9; });
  editing_->undo();
  const double x_m = ball_x_m();
  EXPECT_EQ(state_.scene.clouds[0].seed, 1u);
  move_to(0.3);
  EXPECT_EQ(ball_x_m(), x_m);
  EXPECT_EQ(state_.scene.clouds[0].seed, 1u);
  wait();
}

}  // namespace
}  // namespace offing::present
