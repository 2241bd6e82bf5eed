#include "host/io/animations/highlight_animation.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "host/base/error.h"
#include "host/io/percent_code.h"
#include "tests/io/temporary_folder.h"

namespace offing::animations {
namespace {

constexpr int frame_count = 8, first_frame = 30;
constexpr double frames_per_s = 15.0;

glm::dmat3 turned(double angle, const glm::dvec3& axis) {
  return glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis)));
}

RgbaImage checks() {
  RgbaImage image{4, 4, {}};
  for (int i = 0; i < 16; ++i)
    image.rgba.insert(image.rgba.end(), {255, 255, 255, static_cast<std::uint8_t>(17 * i)});
  return image;
}

ProjectorSample sample(std::uint64_t id, int frame) {
  ProjectorSample result;
  // Past half a turn, where the sign of a quaternion taken from a matrix flips.
  const glm::dmat3 axes = turned(2.2 + 0.4 * frame + 0.1 * static_cast<double>(id), {0.3, 1.0, -0.2});
  result.id = id;
  result.light = 1;
  result.position_m = {0.1 * frame, static_cast<double>(id), -0.5};
  result.right = axes[0];
  result.up = axes[1];
  result.normal = axes[2];
  result.width_m = 0.2 + 0.01 * frame;
  result.height_m = 0.3;
  result.opacity = 0.1 * (frame + 1);
  result.texture = id == 7 ? 1 : 0;
  result.softness = 0.25;
  result.colour = {1.0, 0.5, 0.25};
  return result;
}

/// Highlight 3 is always there, 7 from frame 2 to 5 but for frame 4.
HighlightAnimation example() {
  HighlightAnimation animation{.generator = "Offing test",
                               .frames_per_s = frames_per_s,
                               .first_frame = first_frame,
                               .lights = {"key", "sun"},
                               .textures = {{.name = "star", .file = {}, .image = checks()},
                                            {.name = "image", .file = "my spark#2.png", .image = {}}},
                               .meshes = {{.name = "knot", .file = "knot.ply", .scale = 0.5, .frames = {}}}};
  for (int frame = 0; frame < frame_count; ++frame) {
    MeshFrame mesh{.rotation = turned(0.3 * frame, {0.0, 1.0, 0.2}),
                   .translation_m = {0.0, 0.5 * frame, 1.0},
                   .projectors = {sample(3, frame)}};
    mesh.projectors[0].light = frame == 0 ? -1 : 1;
    if (frame >= 2 && frame <= 5 && frame != 4) mesh.projectors.push_back(sample(7, frame));
    animation.meshes[0].frames.push_back(std::move(mesh));
  }
  return animation;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Read by a library of other people, with what it complains of. Pictures keep their bytes; those in files of
/// their own are only named.
tinygltf::Model read_by_others(const std::filesystem::path& file, std::string& complaints) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(
      [](tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
         int size, void*) {
        image->image.assign(bytes, bytes + size);
        return true;
      },
      nullptr);
  tinygltf::Model model;
  std::string warning;
  const bool is_read = file.extension() == ".glb"
                           ? loader.LoadBinaryFromFile(&model, &complaints, &warning, file.string())
                           : loader.LoadASCIIFromFile(&model, &complaints, &warning, file.string());
  EXPECT_TRUE(is_read) << complaints;
  return model;
}

glm::dvec3 vector_of(const nlohmann::json& json) {
  return {json.at(0), json.at(1), json.at(2)};
}

// Fails if a number is rounded, if axes stay those of the mesh, or if frames are numbered from 0.
TEST(HighlightAnimationTest, JsonReadsBackInTheWorldsAxes) {
  const TemporaryFolder folder;
  const HighlightAnimation animation = example();
  write_highlights(folder.path() / "h.json", animation);
  const nlohmann::json json = nlohmann::json::parse(content(folder.path() / "h.json"));
  EXPECT_EQ(json.at("frame_count"), frame_count);
  EXPECT_EQ(json.at("lights"), nlohmann::json({"key", "sun"}));
  EXPECT_EQ(json.at("lamps"), json.at("lights"));
  EXPECT_EQ(json.at("textures").at(0), nlohmann::json({{"name", "star"}}));
  EXPECT_EQ(json.at("textures").at(1), nlohmann::json({{"name", "image"}, {"file", "my spark#2.png"}}));
  EXPECT_EQ(json.at("meshes").at(0).at("file"), "knot.ply");
  EXPECT_EQ(json.at("meshes").at(0).at("scale"), 0.5);
  for (int frame = 0; frame < frame_count; ++frame) {
    const MeshFrame& mesh = animation.meshes[0].frames[static_cast<std::size_t>(frame)];
    const nlohmann::json& read = json.at("meshes").at(0).at("frames").at(frame);
    EXPECT_EQ(read.at("frame"), first_frame + frame);
    EXPECT_EQ(read.at("time_s"), (first_frame + frame) / frames_per_s);
    const nlohmann::json& turn = read.at("mesh").at("rotation");
    const glm::dquat rotation(turn.at(3), turn.at(0), turn.at(1), turn.at(2));
    ASSERT_EQ(read.at("highlights").size(), mesh.projectors.size());
    for (std::size_t i = 0; i < mesh.projectors.size(); ++i) {
      const ProjectorSample& asked = mesh.projectors[i];
      const nlohmann::json& got = read.at("highlights").at(i);
      EXPECT_EQ(got.at("id"), asked.id);
      EXPECT_EQ(got.at("light"), frame == 0 ? nlohmann::json() : nlohmann::json(1));
      EXPECT_EQ(got.at("lamp"), got.at("light"));
      EXPECT_EQ(got.at("opacity"), asked.opacity);
      EXPECT_EQ(got.at("width_m"), asked.width_m);
      EXPECT_EQ(got.at("texture"), asked.texture);
      EXPECT_EQ(vector_of(got.at("colour")), asked.colour);
      const glm::dvec3 place_m = rotation * asked.position_m + mesh.translation_m;
      EXPECT_LE(glm::distance(vector_of(got.at("position_m")), place_m), 1e-14);
      EXPECT_LE(glm::distance(vector_of(got.at("normal")), rotation * asked.normal), 1e-14);
      EXPECT_LE(glm::distance(glm::cross(vector_of(got.at("right")), vector_of(got.at("up"))),
                              vector_of(got.at("normal"))),
                1e-14);
    }
  }
}

std::vector<std::vector<double>> rows(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  EXPECT_EQ(accessor.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
  std::vector<std::vector<double>> result;
  const unsigned char* bytes = model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset;
  for (std::size_t row = 0; row < accessor.count; ++row) {
    result.emplace_back();
    for (int c = 0; c < components; ++c, bytes += sizeof(float)) {
      float value;
      std::memcpy(&value, bytes, sizeof value);
      result.back().push_back(value);
    }
  }
  return result;
}

/// What a player makes of a node's channel at a time.
std::vector<double> value_at(const tinygltf::Model& model, int node, const std::string& path, double time_s) {
  for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
    if (channel.target_node != node || channel.target_path != path) continue;
    const tinygltf::AnimationSampler& sampler =
        model.animations.at(0).samplers.at(static_cast<std::size_t>(channel.sampler));
    const std::vector<std::vector<double>> times = rows(model, sampler.input),
                                           values = rows(model, sampler.output);
    EXPECT_EQ(times.size(), values.size());
    std::size_t next = 0;
    while (next < times.size() && times[next][0] < time_s - 1e-5) ++next;
    return values[std::min(next, values.size() - 1)];
  }
  ADD_FAILURE() << "no channel " << path << " of node " << node;
  return {};
}

glm::dvec3 vector_of(const std::vector<double>& v) {
  return {v.at(0), v.at(1), v.at(2)};
}

void expect_nodes(const tinygltf::Model& model, const HighlightAnimation& animation) {
  std::map<std::uint64_t, int> nodes;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].extras.Has("id"))
      nodes[static_cast<std::uint64_t>(model.nodes[i].extras.Get("id").GetNumberAsInt())] =
          static_cast<int>(i);
  }
  ASSERT_EQ(nodes.size(), 2u);
  ASSERT_EQ(model.scenes.at(0).nodes, std::vector<int>{0});
  EXPECT_EQ(model.nodes[0].name, "knot");
  EXPECT_EQ(model.nodes[0].children.size(), 2u);
  EXPECT_EQ(model.nodes[0].extras.Get("file").Get<std::string>(), "knot.ply");
  EXPECT_EQ(model.nodes[0].extras.Get("scale").GetNumberAsDouble(), 0.5);
  EXPECT_EQ(model.extras.Get("lamps").Get(1).Get<std::string>(), "sun");
  // Blender's importer stops at an unlit material without a name.
  ASSERT_EQ(model.materials.size(), 2u);
  for (const tinygltf::Material& material : model.materials) EXPECT_NE(material.name, "");
  // Where animations are left out, all is as in the first frame.
  const glm::dvec3 at_rest = vector_of(model.nodes[static_cast<std::size_t>(nodes.at(3))].translation);
  EXPECT_LE(glm::distance(at_rest, sample(3, 0).position_m), 1e-6);
  for (int frame = 0; frame < frame_count; ++frame) {
    const double time_s = (first_frame + frame) / frames_per_s;
    const MeshFrame& mesh = animation.meshes[0].frames[static_cast<std::size_t>(frame)];
    EXPECT_LE(glm::distance(vector_of(value_at(model, 0, "translation", time_s)), mesh.translation_m), 1e-6);
    std::map<std::uint64_t, const ProjectorSample*> there;
    for (const ProjectorSample& projector : mesh.projectors) there[projector.id] = &projector;
    for (const auto& [id, node] : nodes) {
      const glm::dvec3 scale = vector_of(value_at(model, node, "scale", time_s));
      if (there.count(id) == 0) {
        EXPECT_EQ(scale, glm::dvec3(0.0)) << id << " " << frame;
        // It shrinks and grows where it is, and does not travel: of two frames as near it is in the earlier.
        if (id == 7 && frame == 4) {
          EXPECT_LE(
              glm::distance(vector_of(value_at(model, node, "translation", time_s)), sample(7, 3).position_m),
              1e-6);
        }
        continue;
      }
      const ProjectorSample& asked = *there[id];
      EXPECT_NEAR(scale.x, asked.width_m, 1e-7);
      EXPECT_NEAR(scale.y, asked.height_m, 1e-7);
      const std::vector<double> turn = value_at(model, node, "rotation", time_s);
      const glm::dmat3 axes = glm::mat3_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
      EXPECT_LE(glm::distance(axes[0], asked.right), 1e-6);
      EXPECT_LE(glm::distance(axes[2], asked.normal), 1e-6);
      EXPECT_LE(glm::distance(vector_of(value_at(model, node, "translation", time_s)), asked.position_m),
                1e-6);
    }
  }
}

// Numbers are floats: 1e-6. Fails if a node is anywhere else than its
// projector at any frame, or shows where it is not.
TEST(HighlightAnimationTest, GltfReadsBackAsTextAndBinary) {
  const TemporaryFolder folder;
  const HighlightAnimation animation = example();
  for (const char* name : {"h.gltf", "h.glb"}) {
    const std::string file = (folder.path() / name).string();
    write_highlights(file, animation);
    std::string error;
    const tinygltf::Model model = read_by_others(file, error);
    // This reader is older than KHR_animation_pointer, whose channels name no node; it leaves them out, as it
    // should.
    std::istringstream complaints(error);
    for (std::string line; std::getline(complaints, line);)
      EXPECT_NE(line.find("node"), std::string::npos) << line;
    expect_nodes(model, animation);
    // Left as it is, "#" would begin a fragment of the URI, and a blank is none of its characters.
    EXPECT_EQ(model.images.at(1).uri, "my%20spark%232.png");
    EXPECT_EQ(decode_percent(model.images.at(1).uri), animation.textures[1].file);
    const std::vector<unsigned char>& png = model.images.at(0).image;
    ASSERT_GT(png.size(), 8u);
    EXPECT_EQ(std::string(png.begin() + 1, png.begin() + 4), "PNG");
  }
}

/// The example with a mesh of two faces, an eye that moves and zooms, a light that dims and a sun that
/// stands.
HighlightAnimation example_with_scene() {
  HighlightAnimation animation = example();
  TriangleMesh mesh;
  mesh.positions_m = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 2.0, 0.0}, {0.0, 2.0, 0.5}};
  mesh.normals.assign(4, {0.0, 0.0, 1.0});
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  animation.meshes[0].look = {std::make_shared<TriangleMesh>(mesh), {0.5, 0.25, 0.125}};
  AnimatedLight key{.is_near = true, .distance_m = 3.0, .frames = {}}, sun;
  AnimatedScene around;
  for (int frame = 0; frame < frame_count; ++frame) {
    around.cameras.push_back({.eye_m = {1.0 + frame, 2.0, 5.0},
                              .yaw_rad = 0.3 * frame,
                              .pitch_rad = -0.2,
                              .vertical_field_of_view_rad = 0.8 + 0.01 * frame});
    key.frames.push_back({{-3.0, 5.0, 0.5 * frame}, (1.0 - 0.1 * frame) * glm::dvec3(20.0, 10.0, 5.0)});
    sun.frames.push_back({glm::normalize(glm::dvec3(1.0, 1.0, 0.0)), {90.0, 90.0, 45.0}});
  }
  around.lights = {key, sun};
  animation.scene = around;
  return animation;
}

/// Values of the channel of a pointer; none where there is none.
std::vector<std::vector<double>> pointed(const nlohmann::json& json, const tinygltf::Model& model,
                                         const std::string& pointer) {
  for (const nlohmann::json& channel : json.at("animations").at(0).at("channels")) {
    if (channel.at("target").at("path") == "pointer" &&
        channel.at("target").at("extensions").at("KHR_animation_pointer").at("pointer") == pointer)
      return rows(model,
                  json["animations"][0]["samplers"][channel.at("sampler").get<std::size_t>()]["output"]);
  }
  return {};
}

// glTF's cameras look along -z with y up, its lights shine along -z. Fails if eye or lights stand or turn
// elsewhere than in the scene at any frame, if candela do not make the scene's illuminance at the distance of
// the mesh, if what stands still has keys, or if the mesh is another one. Numbers are floats: 1e-6.
TEST(HighlightAnimationTest, GltfHasTheSceneAround) {
  const TemporaryFolder folder;
  const HighlightAnimation animation = example_with_scene();
  write_highlights(folder.path() / "h.gltf", animation);
  std::string error;
  const tinygltf::Model model = read_by_others(folder.path() / "h.gltf", error);
  const nlohmann::json json = nlohmann::json::parse(content(folder.path() / "h.gltf"));
  std::map<std::string, int> nodes;
  for (const int root : model.scenes.at(0).nodes)
    nodes[model.nodes[static_cast<std::size_t>(root)].name] = root;
  ASSERT_EQ(nodes.size(), 4u);  // knot, camera, key, sun
  const int eye = nodes.at("camera"), key = nodes.at("key"), sun = nodes.at("sun");
  EXPECT_EQ(model.nodes[static_cast<std::size_t>(eye)].camera, 0);
  ASSERT_EQ(model.lights.size(), 2u);
  EXPECT_EQ(model.lights[0].type, "point");
  EXPECT_EQ(model.lights[1].type, "directional");
  const auto fields = pointed(json, model, "/cameras/0/perspective/yfov");
  const auto candela = pointed(json, model, "/extensions/KHR_lights_punctual/lights/0/intensity");
  ASSERT_EQ(fields.size(), static_cast<std::size_t>(frame_count));
  ASSERT_EQ(candela.size(), fields.size());
  for (int frame = 0; frame < frame_count; ++frame) {
    const auto i = static_cast<std::size_t>(frame);
    const double time_s = (first_frame + frame) / frames_per_s;
    const Camera& camera = animation.scene->cameras[i];
    const std::vector<double> turn = value_at(model, eye, "rotation", time_s);
    const glm::dmat3 axes = glm::mat3_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
    EXPECT_LE(glm::distance(-axes[2], basis(camera).forward), 1e-6);
    EXPECT_LE(glm::distance(axes[1], basis(camera).up), 1e-6);
    EXPECT_LE(glm::distance(vector_of(value_at(model, eye, "translation", time_s)), camera.eye_m), 1e-6);
    EXPECT_NEAR(fields[i][0], camera.vertical_field_of_view_rad, 1e-6);
    const LightFrame& near = animation.scene->lights[0].frames[i];
    EXPECT_LE(glm::distance(vector_of(value_at(model, key, "translation", time_s)), near.vector), 1e-6);
    EXPECT_NEAR(candela[i][0] / (3.0 * 3.0), 1000.0 * near.illuminance_klx.r, 1e-2);
  }
  EXPECT_THAT(model.lights[0].color, testing::ElementsAre(1.0, 0.5, 0.25));
  EXPECT_THAT(model.lights[1].color, testing::ElementsAre(1.0, 1.0, 0.5));
  EXPECT_EQ(model.lights[1].intensity, 90e3);
  EXPECT_TRUE(pointed(json, model, "/extensions/KHR_lights_punctual/lights/0/color").empty());
  EXPECT_TRUE(pointed(json, model, "/extensions/KHR_lights_punctual/lights/1/intensity").empty());
  const std::vector<double>& still = model.nodes[static_cast<std::size_t>(sun)].rotation;
  const glm::dmat3 sun_axes = glm::mat3_cast(glm::dquat(still.at(3), still.at(0), still.at(1), still.at(2)));
  EXPECT_LE(glm::distance(sun_axes[2], animation.scene->lights[1].frames[0].vector), 1e-6);
  for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels)
    EXPECT_NE(channel.target_node, sun);

  const tinygltf::Primitive& look =
      model.meshes.at(static_cast<std::size_t>(model.nodes[0].mesh)).primitives.at(0);
  const TriangleMesh& mesh = *animation.meshes[0].look->mesh;
  const auto places = rows(model, look.attributes.at("POSITION"));
  ASSERT_EQ(places.size(), mesh.positions_m.size());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(vector_of(places[i]), mesh.positions_m[i]);
  EXPECT_EQ(rows(model, look.attributes.at("NORMAL")).size(), mesh.normals.size());
  EXPECT_EQ(model.accessors.at(static_cast<std::size_t>(look.indices)).count, 3 * mesh.faces.size());
  EXPECT_EQ(model.materials.at(static_cast<std::size_t>(look.material)).name, "knot");
}

/// The example with a mesh that rises from frame 2 to 4 and keeps its form from then on.
HighlightAnimation example_that_deforms() {
  HighlightAnimation animation = example_with_scene();
  const TriangleMesh& at_rest = *animation.meshes[0].look->mesh;
  for (std::size_t frame = 2; frame < frame_count; ++frame) {
    MeshFrame& shown = animation.meshes[0].frames[frame];
    if (frame > 4) {
      shown.form = animation.meshes[0].frames[4].form;
      continue;
    }
    MeshForm form{.positions_m = at_rest.positions_m, .normals = at_rest.normals};
    form.positions_m[3] += glm::dvec3(0.0, 0.25 * static_cast<double>(frame), 0.0);
    form.normals[3] = {1.0, 0.0, 0.0};
    shown.form = std::make_shared<MeshForm>(form);
  }
  return animation;
}

// Fails if a mesh that deforms is at rest in any frame (as it was before), if a form is written twice, or if
// weights are those of another frame.
TEST(HighlightAnimationTest, GltfHasTheFormOfEachFrame) {
  const TemporaryFolder folder;
  const HighlightAnimation animation = example_that_deforms();
  write_highlights(folder.path() / "h.gltf", animation);
  std::string error;
  const tinygltf::Model model = read_by_others(folder.path() / "h.gltf", error);
  const tinygltf::Mesh& mesh = model.meshes.at(static_cast<std::size_t>(model.nodes[0].mesh));
  const tinygltf::Primitive& look = mesh.primitives.at(0);
  ASSERT_EQ(look.targets.size(), 3u);
  EXPECT_EQ(mesh.extras.Get("targetNames").Get(2).Get<std::string>(), "frame 34");
  EXPECT_THAT(mesh.weights, testing::ElementsAre(0.0, 0.0, 0.0));
  std::vector<double> weights;
  for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
    if (channel.target_node != 0 || channel.target_path != "weights") continue;
    for (const auto& row :
         rows(model, model.animations[0].samplers.at(static_cast<std::size_t>(channel.sampler)).output))
      weights.push_back(row.at(0));
  }
  ASSERT_EQ(weights.size(), 3u * frame_count);
  for (const char* name : {"POSITION", "NORMAL"}) {
    const auto at_rest = rows(model, look.attributes.at(name));
    for (std::size_t frame = 0; frame < frame_count; ++frame) {
      const MeshForm* form = animation.meshes[0].frames[frame].form.get();
      const TriangleMesh& look_mesh = *animation.meshes[0].look->mesh;
      const bool has_places = std::string(name) == "POSITION";
      const std::vector<glm::dvec3>& asked = form == nullptr
                                                 ? (has_places ? look_mesh.positions_m : look_mesh.normals)
                                                 : (has_places ? form->positions_m : form->normals);
      for (std::size_t vertex = 0; vertex < asked.size(); ++vertex) {
        glm::dvec3 found = vector_of(at_rest[vertex]);
        for (std::size_t target = 0; target < 3; ++target)
          found +=
              weights[3 * frame + target] * vector_of(rows(model, look.targets[target].at(name))[vertex]);
        EXPECT_LE(glm::distance(found, asked[vertex]), 1e-6) << name << " " << frame;
      }
    }
  }
}

// Neighbouring keys of a rotation are less than half a turn apart as numbers too: players mix them so. Fails
// where the sign that a matrix leaves open flips.
TEST(HighlightAnimationTest, RotationsDoNotFlipTheirSign) {
  const TemporaryFolder folder;
  write_highlights(folder.path() / "h.glb", example());
  std::string error;
  const tinygltf::Model model = read_by_others(folder.path() / "h.glb", error);
  int checked = 0;
  for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
    if (channel.target_path != "rotation") continue;
    const auto keys =
        rows(model, model.animations[0].samplers.at(static_cast<std::size_t>(channel.sampler)).output);
    for (std::size_t i = 1; i < keys.size(); ++i, ++checked) {
      double cosine = 0.0;
      for (std::size_t c = 0; c < 4; ++c) cosine += keys[i][c] * keys[i - 1][c];
      EXPECT_GT(cosine, 0.0);
    }
  }
  EXPECT_GT(checked, 10);
}

TEST(HighlightAnimationTest, EqualAnimationsGiveEqualBytesAndEmptyOnesAreFiles) {
  const TemporaryFolder folder;
  for (const char* ending : {".json", ".gltf", ".glb"}) {
    write_highlights(folder.path() / (std::string("a") + ending), example());
    write_highlights(folder.path() / (std::string("b") + ending), example());
    EXPECT_EQ(content(folder.path() / (std::string("a") + ending)),
              content(folder.path() / (std::string("b") + ending)));
    HighlightAnimation empty = example();
    for (MeshFrame& frame : empty.meshes[0].frames) frame.projectors.clear();
    write_highlights(folder.path() / (std::string("c") + ending), empty);
    EXPECT_GT(content(folder.path() / (std::string("c") + ending)).size(), 100u);
  }
}

// Fails if a wrong name is found out only after the work, or a failed write leaves a part of a file.
TEST(HighlightAnimationTest, WrongNamesAndFoldersAreErrors) {
  const TemporaryFolder folder;
  try {
    write_highlights(folder.path() / "h.abc", example());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
    EXPECT_NE(std::string(error.what()).find(".json or .glb or .gltf"), std::string::npos) << error.what();
  }
  EXPECT_THROW(write_highlights(folder.path() / "not there" / "h.json", example()), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace offing::animations
