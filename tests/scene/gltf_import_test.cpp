// Scenes that are made of glTF files.
#include "host/scene/file/gltf_import.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/mesh_data.h"
#include "host/scene/prepare/moving_view.h"
#include "host/sky/sun_position.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

using ::testing::HasSubstr;

class GltfImport : public testing::Test {
 protected:
  /// Of the seeds of fuzzers.
  std::filesystem::path copy(const std::string& seed, const std::string& name) const {
    std::filesystem::copy_file(std::filesystem::path(OFFING_CORPUS) / seed, folder_.path() / name);
    return folder_.path() / name;
  }
  /// The scene as a file brings it back.
  Scene read_back(const ImportedScene& imported) const {
    save_scene(imported.scene, folder_.path() / "scene.toml", Existing::replace);
    return load_scene(folder_.path() / "scene.toml");
  }

  TemporaryFolder folder_;
};

/// The basis that a node's axes give, from a quaternion's turn around y.
CameraBasis turned(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {.right = {c, 0, -s}, .up = {0, 1, 0}, .forward = {-s, 0, -c}};
}

// The camera of gltf_stage_test.cpp turns by 73.74 degrees in 1 s. Fails if it does not look where its node
// does at each frame, if lights stand elsewhere or send other light, or if the sun still shines.
TEST_F(GltfImport, TakesCameraAndLights) {
  const ImportedScene imported = import_gltf(copy("gltf_stage/stage", "pan.glb"), {}, Trust::trusted);
  const Scene scene = read_back(imported);
  EXPECT_TRUE(scene.meshes.empty());
  EXPECT_EQ(scene.time.end_s, 1.0);
  EXPECT_EQ(scene.time.frames_per_second, 24.0);
  const double whole_rad = 2.0 * std::acos(0.8);
  for (const int frame : {0, 7, 24, 40}) {
    const double angle_rad = whole_rad * std::min(frame / 24.0, 1.0);
    const Camera camera = view_at(scene, frame / 24.0).camera;
    const CameraBasis found = basis(camera), expected = turned(angle_rad);
    EXPECT_LT(glm::distance(found.forward, expected.forward), 1e-6) << frame;
    EXPECT_LT(glm::distance(found.up, expected.up), 1e-6) << frame;
    EXPECT_LT(glm::distance(camera.eye_m, glm::dvec3(5 * std::sin(angle_rad), 2, 5 * std::cos(angle_rad))),
              1e-5)
        << frame;
    EXPECT_NEAR(camera.vertical_field_of_view_rad, 0.7, 1e-12);
  }
  // A steady turn is two keys, and what stands still has none.
  EXPECT_EQ(scene.tracks.at("camera.yaw_deg").keys.size(), 2u);
  EXPECT_FALSE(scene.tracks.contains("camera.y_m"));
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].name, "sky");
  EXPECT_EQ(scene.lights[0].kind, LightKind::direction);
  const auto [x, y, z] = sky::direction_of(scene.lights[0].azimuth_rad, scene.lights[0].elevation_rad);
  EXPECT_LT(glm::distance(glm::dvec3(x, y, z), glm::dvec3(0, 0, 1)), 1e-9);  // it shines along -z
  EXPECT_NEAR(scene.lights[0].illuminance_klx, 0.8, 1e-12);
  EXPECT_EQ(scene.lights[1].kind, LightKind::place);
  EXPECT_EQ(scene.lights[2].name, "light 2");
  EXPECT_LT(scene.view.sun_direction.elevation_rad, 0.0);
  EXPECT_TRUE(
      std::ranges::any_of(imported.left_out, [](const LeftOut& item) { return item.what == "materials"; }));
}

// Fails if the scene does not name the file so that it is found, or its mesh does not deform.
TEST_F(GltfImport, TakesMeshesThatDeform) {
  const Scene scene = read_back(import_gltf(copy("gltf/moving", "moving.glb"), {}, Trust::trusted));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].name, "moving");
  EXPECT_EQ(std::filesystem::path(scene.meshes[0].file).filename(), "moving.glb");
  const MeshData data = mesh_data(scene, 0);
  ASSERT_TRUE(data.deformation);
  EXPECT_EQ(data.deformation.end_s, 1.0);
  EXPECT_NE(data.deformation.form_at(0.0).positions_m, data.deformation.form_at(0.5).positions_m);
  EXPECT_GT(scene.view.sun_direction.elevation_rad, 0.0) << "there is no other light";
}

// Fails if a file, a camera or an animation that is not there, or a scene that could not be read back, gives
// something else than one line that says so.
TEST_F(GltfImport, RefusesWhatIsNotThere) {
  const std::filesystem::path stage = copy("gltf_stage/stage", "pan.glb");
  const auto refusal = [](const std::filesystem::path& file, const GltfChoice& choice) -> std::string {
    try {
      import_gltf(file, choice, Trust::trusted);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_FALSE(error.hint().empty());
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(stage, {.animation = "pan", .camera = "shot"}), "");
  EXPECT_THAT(refusal(folder_.path() / "none.glb", {}), HasSubstr("none.glb"));
  EXPECT_THAT(refusal(stage, {.camera = "shop"}),
              HasSubstr("expected a camera \"shop\", got none of this name"));
  EXPECT_THAT(refusal(stage, {.animation = "walk"}), HasSubstr("an animation \"walk\", got \"pan\""));
  EXPECT_THAT(refusal(stage, {.frames_per_s = 20000.0}),
              HasSubstr("an animation of fewer than 10000 frames"));
  std::ofstream(folder_.path() / "far.gltf")
      << R"({"asset":{"version":"2.0"},"cameras":[{"perspective":{"yfov":1}}],)"
      << R"("nodes":[{"camera":0,"translation":[0,1e9,0]}]})";
  EXPECT_THAT(refusal(folder_.path() / "far.gltf", {}), HasSubstr("values that a scene can have"));
}

/// A glTF whose node 0 turns around y at a steady rate for 4 s, with four keys a second.
std::filesystem::path write_turn(const std::filesystem::path& folder, double whole_rad,
                                 const std::string& members) {
  constexpr int last = 16;
  std::vector<float> numbers;
  for (int key = 0; key <= last; ++key) numbers.push_back(0.25f * static_cast<float>(key));
  for (int key = 0; key <= last; ++key) {
    const double half_rad = 0.5 * whole_rad * key / last;
    for (const double value : {0.0, std::sin(half_rad), 0.0, std::cos(half_rad)})
      numbers.push_back(static_cast<float>(value));
  }
  const std::size_t bytes = numbers.size() * sizeof(float);
  std::ofstream(folder / "turn.bin", std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(bytes));
  std::ofstream(folder / "turn.gltf")
      << R"({"asset":{"version":"2.0"},"buffers":[{"uri":"turn.bin","byteLength":)" << bytes << "}],"
      << R"("bufferViews":[{"buffer":0,"byteLength":)" << bytes << R"(}],"accessors":[)"
      << R"({"bufferView":0,"componentType":5126,"count":17,"type":"SCALAR"},)"
      << R"({"bufferView":0,"byteOffset":68,"componentType":5126,"count":17,"type":"VEC4"}],)"
      << R"("animations":[{"samplers":[{"input":0,"output":1}],"channels":[)"
      << R"({"sampler":0,"target":{"node":0,"path":"rotation"}}]}],)" << members << '}';
  return folder / "turn.gltf";
}

// A node with a camera and a light turns by up to two and a half turns. Fails if one of both turns the other
// way, not at all or at another speed, or if a turn has a key for each frame.
TEST_F(GltfImport, WholeTurnsKeepTheirWay) {
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  for (const double turns : {0.5, 0.75, 1.0, -1.0, 2.0, 2.5}) {
    SCOPED_TRACE(turns);
    const auto file = write_turn(
        folder_.path(), turns * turn_rad,
        R"("nodes":[{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}],)"
        R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)"
        R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":800}]}})");
    const ImportedScene imported = import_gltf(file, {}, Trust::trusted);
    const Scene scene = read_back(imported);
    for (int frame = 0; frame <= 96; ++frame) {
      const ViewScene view = view_at(scene, frame / 24.0);
      const CameraBasis expected = turned(turns * turn_rad * frame / 96.0);
      EXPECT_LT(glm::distance(basis(view.camera).forward, expected.forward), 1e-6) << frame;
    }
    for (const auto& [key, track] : scene.tracks) EXPECT_LT(track.keys.size(), 16u);
    const KeyframeTrack& light = scene.tracks.at({"light.azimuth_deg", ElementIndex{0, 0}});
    for (int frame = 0; frame <= 96; ++frame) {
      const double azimuth_rad = value_at(light, frame / 24.0);
      // It comes from behind.
      const glm::dvec3 expected = -turned(turns * turn_rad * frame / 96.0).forward;
      EXPECT_NEAR(std::sin(azimuth_rad), expected.x, 1e-6) << frame;
      EXPECT_NEAR(-std::cos(azimuth_rad), expected.z, 1e-6) << frame;
    }
  }
}

// Fails if a zero of a scene is written with a sign.
TEST_F(GltfImport, ZerosHaveNoSign) {
  const auto file = write_turn(folder_.path(), 2.0 * std::numbers::pi,
                               R"("nodes":[{"camera":0},{"camera":0}],)"
                               R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])");
  const std::string text = scene_text(import_gltf(file, {}, Trust::trusted).scene, "");
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("-0[^.0-9]")));
}

}  // namespace
}  // namespace offing::scene
