#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class Highlights : public ::testing::Test {
 protected:
  Highlights() {
    std::ofstream(scene()) << R"(version = 1
[time]
fps = 10
end_s = 0.5

[camera]
x_m = 1
y_m = 2
z_m = 6

[sun]
azimuth_deg = 200
elevation_deg = 40

[[light]]
name = "key"
azimuth_deg = 120
elevation_deg = 30

[[mesh]]
name = "ball"
shape = "sphere"
size_m = 1.6
detail = 5
x_m = 0.5
y_m = 1
spin_deg_per_s = 40

[[mesh.highlight]]
light = "sun"
texture = "star"
split = 2
)";
  }
  std::string scene() const { return path("ball.toml"); }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  static nlohmann::json read(const std::string& file) {
    std::ifstream stream(file);
    return nlohmann::json::parse(std::string{std::istreambuf_iterator<char>(stream), {}});
  }

  TemporaryFolder folder_;
};

glm::dvec3 vector_of(const nlohmann::json& json) {
  return {json.at(0), json.at(1), json.at(2)};
}

/// Toward a light, in the world's axes: azimuth clockwise from north (-z).
glm::dvec3 toward(double azimuth_deg, double elevation_deg) {
  const double azimuth = azimuth_deg * std::numbers::pi / 180.0,
               elevation = elevation_deg * std::numbers::pi / 180.0;
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

// Blinn by hand: on a ball that turns, the key light's highlight stands where the normal is half way between
// eye and light, the same one in every frame. Bound: a ball of this detail is found within 0.003 edges of
// 0.05. Measured 3e-4. Gate 2e-3: axes of the mesh in the stead of the world's, or the eye at the wrong
// place, are off by tenths. The sun's is split in two.
TEST_F(Highlights, AreThoseOfTheScene) {
  const ProgramResult result = run_offing({"highlights", scene(), "-o", path("ball.json"), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto summary = nlohmann::json::parse(result.output);
  EXPECT_EQ(summary.at("frames"), 5);
  EXPECT_EQ(summary.at("highlights"), 2);
  EXPECT_EQ(summary.at("most_in_a_frame"), 3);
  const nlohmann::json json = read(path("ball.json"));
  EXPECT_EQ(json.at("lamps"), nlohmann::json({"key", "sun"}));
  ASSERT_EQ(json.at("meshes").at(0).at("frames").size(), 5u);
  const glm::dvec3 eye(1.0, 2.0, 6.0), middle(0.5, 1.0, 0.0);
  for (const nlohmann::json& frame : json.at("meshes").at(0).at("frames")) {
    EXPECT_EQ(frame.at("highlights").size(), 3u);
    for (const nlohmann::json& highlight : frame.at("highlights")) {
      const std::string texture =
          json.at("textures").at(highlight.at("texture").get<std::size_t>()).at("name");
      EXPECT_EQ(texture, highlight.at("lamp") == 1 ? "star" : "dot");
      if (highlight.at("lamp") != 0) continue;
      const glm::dvec3 place = vector_of(highlight.at("position_m"));
      const glm::dvec3 half = glm::normalize(toward(120.0, 30.0) + glm::normalize(eye - place));
      EXPECT_LE(glm::distance(vector_of(highlight.at("normal")), half), 2e-3);
      EXPECT_LE(glm::distance(glm::normalize(place - middle), half), 2e-3);
      EXPECT_EQ(highlight.at("id"), json["meshes"][0]["frames"][0]["highlights"][0]["id"]);
    }
  }
}

// A scene of a mesh alone that places no camera is seen from the south, from where all of it is in the
// picture (scene::look_at_meshes()): 0.55 diagonals of its box over sin(fov / 2) away, a fifth of that above.
// Fails if other programs are given highlights for another eye than offing-view draws them for. Gate as
// above.
TEST_F(Highlights, AreSeenByTheEyeOfTheView) {
  std::ofstream(path("alone.toml")) << R"(version = 1
[sun]
elevation_deg = -20

[[light]]
name = "key"
azimuth_deg = 120
elevation_deg = 30

[[mesh]]
shape = "sphere"
size_m = 1.6
detail = 5
x_m = 0.5
y_m = 1
)";
  const ProgramResult result =
      run_offing({"highlights", path("alone.toml"), "-o", path("alone.json"), "--frames", "0", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json found =
      read(path("alone.json")).at("meshes").at(0).at("frames").at(0).at("highlights");
  ASSERT_EQ(found.size(), 1u);
  const glm::dvec3 middle(0.5, 1.0, 0.0), place = vector_of(found[0].at("position_m"));
  const double diagonal_m = 2.0 * glm::distance(place, middle) * std::sqrt(3.0);
  const double away_m = 0.55 * diagonal_m / std::sin(22.5 * std::numbers::pi / 180.0);
  const glm::dvec3 eye = middle + away_m * glm::normalize(glm::dvec3(0.0, 0.2, 1.0));
  const glm::dvec3 half = glm::normalize(toward(120.0, 30.0) + glm::normalize(eye - place));
  EXPECT_LE(glm::distance(vector_of(found[0].at("normal")), half), 2e-3);
}

// A ball afloat is led along x on a calm sea. Its centre of mass follows that path: measured to the last bit,
// and 4 cm higher than at rest, under way as it is. Gates 1e-6 m and 10 cm. Blinn's highlight is on it there;
// gate as above. Fails if hulls are exported where their meshes stand without a sea, at the origin.
TEST_F(Highlights, FollowFloatingBodies) {
  std::ofstream(path("afloat.toml")) << R"(version = 1
[time]
fps = 4

[wind]
speed_mps = 0.5

[ocean]
size = 16
hs_m = 0.02
tp_s = 4
gerstner.count = 0

[camera]
x_m = 31
y_m = 2
z_m = -14

[sun]
elevation_deg = -20

[[light]]
name = "key"
azimuth_deg = 120
elevation_deg = 30

[[mesh]]
name = "ball"
shape = "sphere"
size_m = 1.6
detail = 5

[[mesh]]
name = "mast"
shape = "box"
aboard = "buoy"
y_m = 2
highlights = "off"

[[body]]
name = "buoy"
mesh = "ball"
motion = "path"
draught_m = 1
mass_centre_m = [0, -0.5, 0]
x_m = 30
z_m = -20
speed_mps = 4
)";
  const ProgramResult result = run_offing(
      {"highlights", path("afloat.toml"), "-o", path("afloat.json"), "--frames", "0:4", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json meshes = read(path("afloat.json")).at("meshes");
  const glm::dvec3 eye(31.0, 2.0, -14.0);
  for (std::size_t i = 0; i < 5; ++i) {
    const nlohmann::json& frame = meshes.at(0).at("frames").at(i);
    const glm::dvec3 middle = vector_of(frame.at("mesh").at("translation_m"));
    const nlohmann::json& turn = frame.at("mesh").at("rotation");
    const glm::dvec3 mass =
        middle + glm::dquat(turn[3], turn[0], turn[1], turn[2]) * glm::dvec3(0.0, -0.5, 0.0);
    EXPECT_NEAR(mass.x, 30.0 + 4.0 * frame.at("time_s").get<double>(), 1e-6) << i;
    EXPECT_NEAR(mass.y, 0.1, 0.1) << i;
    EXPECT_NEAR(mass.z, -20.0, 1e-6) << i;
    const glm::dvec3 mast = vector_of(meshes.at(1).at("frames").at(i).at("mesh").at("translation_m"));
    EXPECT_NEAR(glm::distance(mast, middle), 2.0, 1e-9);
    ASSERT_EQ(frame.at("highlights").size(), 1u);
    const glm::dvec3 place = vector_of(frame.at("highlights").at(0).at("position_m"));
    const glm::dvec3 half = glm::normalize(toward(120.0, 30.0) + glm::normalize(eye - place));
    EXPECT_LE(glm::distance(glm::normalize(place - middle), half), 2e-3) << i;
  }
}

// Frames asked for are those written, at their own times; the same call writes the same bytes.
TEST_F(Highlights, FramesAreThoseAskedFor) {
  for (const char* name : {"a.glb", "b.glb", "c.json"}) {
    const ProgramResult result =
        run_offing({"highlights", scene(), "-o", path(name), "--frames", "7:9", "--fps", "20", "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
  }
  const nlohmann::json frames = read(path("c.json")).at("meshes").at(0).at("frames");
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].at("frame"), 7);
  EXPECT_EQ(frames[2].at("time_s"), 9 / 20.0);
  std::ifstream a(path("a.glb"), std::ios::binary), b(path("b.glb"), std::ios::binary);
  EXPECT_TRUE(std::equal(std::istreambuf_iterator<char>(a), {}, std::istreambuf_iterator<char>(b), {}));
}

// Fails if --with-scene leaves out the mesh, the camera or a light, or writes those of another scene; its
// values are checked in tests/io/animations.
TEST_F(Highlights, CanHaveTheirScene) {
  const ProgramResult result = run_offing(
      {"highlights", scene(), "-o", path("shot.gltf"), "--with-scene", "--frames", "0:1", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json json = read(path("shot.gltf"));
  const nlohmann::json& nodes = json.at("nodes");
  EXPECT_EQ(nodes.at(0).at("name"), "ball");
  const nlohmann::json& ball = json.at("meshes").at(nodes[0].at("mesh").get<std::size_t>());
  EXPECT_EQ(ball.at("name"), "ball");
  const nlohmann::json& places =
      json.at("accessors").at(ball.at("primitives").at(0).at("attributes").at("POSITION").get<std::size_t>());
  EXPECT_NEAR(places.at("max").at(1), 1.6, 1e-3);
  const auto eye =
      std::find_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.contains("camera"); });
  ASSERT_NE(eye, nodes.end());
  EXPECT_EQ(eye->at("translation"), nlohmann::json({1.0, 2.0, 6.0}));
  const nlohmann::json& lights = json.at("extensions").at("KHR_lights_punctual").at("lights");
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0].at("name"), "key");
  EXPECT_EQ(lights[0].at("intensity"), 50e3);
  EXPECT_EQ(lights[1].at("name"), "sun");
}

// A tetrahedron that grows from a file to the next. Fails if the mesh of --with-scene stays at rest.
TEST_F(Highlights, SceneHasMeshesThatDeform) {
  for (int number = 0; number < 2; ++number) {
    std::ofstream(path(fmt::format("form_{}.obj", number))) << fmt::format(
        "v 0 0 0\nv 1 0 0\nv 0 {} 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", 1 + number);
  }
  std::ofstream(path("growing.toml"))
      << "version = 1\n[time]\nfps = 10\nend_s = 0.5\n[[mesh]]\nname = \"growing\"\n"
         "file = \"form_%d.obj\"\nsequence_fps = 2\n";
  const ProgramResult result =
      run_offing({"highlights", path("growing.toml"), "-o", path("shot.gltf"), "--with-scene", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json json = read(path("shot.gltf"));
  const nlohmann::json& look = json.at("meshes").at(json.at("nodes").at(0).at("mesh").get<std::size_t>());
  // Frames 0 to 4 are different forms; the first one is as the mesh at rest.
  const nlohmann::json& targets = look.at("primitives").at(0).at("targets");
  ASSERT_EQ(targets.size(), 5u);
  const auto largest_y = [&](std::size_t target) {
    return json.at("accessors")
        .at(targets.at(target).at("POSITION").get<std::size_t>())
        .at("max")
        .at(1)
        .get<double>();
  };
  EXPECT_EQ(largest_y(0), 0.0);
  EXPECT_NEAR(largest_y(2), 0.4, 1e-6);
  EXPECT_NEAR(largest_y(4), 0.8, 1e-6);
}

// A mesh whose forms would take more bytes than a glTF can count. Fails if it is not refused before the first
// frame, or if the hint names other frames than those that just fit.
TEST_F(Highlights, FormsBeyondFourGibibytesAreRefusedAtOnce) {
  for (int number = 0; number < 2; ++number) {
    std::ofstream(path(fmt::format("form_{}.obj", number))) << fmt::format(
        "v 0 0 0\nv 1 0 0\nv 0 {} 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", 1 + number);
  }
  std::ofstream(path("growing.toml")) << "version = 1\n[time]\nfps = 10\n[[mesh]]\nname = \"growing\"\n"
                                         "file = \"form_%d.obj\"\nanimation_repeat = \"on\"\n";
  const auto errors = [&](const char* frames) {
    return run_offing({"highlights", path("growing.toml"), "-o", path("shot.glb"), "--with-scene", "--frames",
                       frames, "--quiet"})
        .errors;
  };
  // 4 vertices and normals are 96 bytes of a form: n (96 + 4 n) = 2^32 for n = 32756.
  EXPECT_THAT(errors("5:39999"), HasSubstr("fit into 4 GiB, got 6.0 GiB in 39995 frames"));
  EXPECT_THAT(errors("5:39999"), HasSubstr("--frames 5:32760\n"));
  EXPECT_FALSE(std::filesystem::exists(path("shot.glb")));
}

// The shipped figure, whose skin moves, over one wave at 24 frames a second. Fails if its window, star,
// streak or stripes are missing in a frame or blink, if highlights crowd, or if one changes faster than its
// limits.
TEST_F(Highlights, TheShippedFigureKeepsItsLooks) {
  const ProgramResult result =
      run_offing({"highlights", std::string(OFFING_SCENES) + "/figure.toml", "-o", path("figure.json"),
                  "--frames", "0:95", "--fps", "24", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const nlohmann::json& mesh : read(path("figure.json")).at("meshes")) {
    std::map<std::vector<int>, nlohmann::json> before;  // by id, rule and copy
    for (const nlohmann::json& frame : mesh.at("frames")) {
      std::map<std::vector<int>, nlohmann::json> now;
      std::set<int> ids;
      std::map<int, double> opacities;  // by rule
      for (const nlohmann::json& shown : frame.at("highlights")) {
        now[{shown.at("id"), shown.at("rule"), shown.at("copy")}] = shown;
        ids.insert(shown.at("id").get<int>());
        if (shown.at("copy") == 0) opacities[shown.at("rule")] += shown.at("opacity").get<double>();
      }
      EXPECT_LE(ids.size(), 9u);
      for (const int rule : {1, 2})
        EXPECT_GE(opacities[rule], 0.5) << mesh.at("name") << " " << frame.at("frame");
      for (const auto& [name, shown] : now) {
        const auto old = before.find(name);
        if (old == before.end()) continue;
        for (const char* size : {"width_m", "height_m"})
          EXPECT_LE(std::abs(std::log(shown.at(size).get<double>() / old->second.at(size).get<double>())),
                    0.101);
        EXPECT_LE(std::abs(shown.at("opacity").get<double>() - old->second.at("opacity").get<double>()),
                  0.18);
      }
      before = std::move(now);
    }
  }
}

// Fails if a texture that needs a picture and has none is written as one without a file, or found only after
// all frames.
TEST_F(Highlights, TexturesNeedTheirPictures) {
  for (const char* texture : {"image", "normal_map"}) {
    std::ofstream(path("bare.toml")) << R"(version = 1
[[mesh]]
shape = "sphere"

[[mesh.highlight]]
texture = ")" << texture << "\"\n";
    for (const char* name : {"out.json", "out.glb"}) {
      const ProgramResult result = run_offing({"highlights", path("bare.toml"), "-o", path(name)});
      EXPECT_EQ(result.exit_code, 2);
      EXPECT_THAT(result.errors, HasSubstr("expected a mesh.highlight.picture beside it, found none"));
      EXPECT_FALSE(std::filesystem::exists(path(name)));
    }
  }
}

// Fails if a wrong call costs a file, leaves a part of one, or does not say the fix.
TEST_F(Highlights, RefusesWithAHint) {
  std::ofstream(path("dry.toml")) << "version = 1\n";
  std::ofstream(path("there.json")) << "mine";
  struct Case {
    std::vector<std::string> arguments;
    const char* text;
  };
  for (const Case& one : {Case{{scene(), "-o", path("out.abc")}, ".json or .glb or .gltf"},
                          {{path("dry.toml"), "-o", path("out.json")}, "[[mesh]]"},
                          {{path("none.toml"), "-o", path("out.json")}, "none.toml"},
                          {{scene(), "-o", path("there.json")}, "there.json"},
                          {{scene(), "-o", path("no/out.json")}, "no/out.json"},
                          {{scene(), "-o", path("out.json"), "--with-scene"}, ".glb or .gltf"},
                          {{scene(), "-o", path("out.json"), "--fps", "0"}, "--fps"},
                          {{scene(), "-o", path("out.json"), "--frames", "9:3"}, "--frames"}}) {
    std::vector<std::string> arguments{"highlights"};
    arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
    const ProgramResult result = run_offing(arguments);
    EXPECT_TRUE(result.exit_code == 1 || result.exit_code == 2) << result.exit_code;
    EXPECT_THAT(result.errors, HasSubstr(one.text));
    EXPECT_THAT(result.errors, HasSubstr("hint: "));
    EXPECT_FALSE(std::filesystem::exists(path("out.json")));
  }
  std::ifstream there(path("there.json"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(there), {}), "mine");
}

}  // namespace
}  // namespace offing::test
