// Meshes of glTF that deform: nodes, morphs and skins that animations move, against the formulas of glTF 2.0.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/meshes/gltf_mesh.h"
#include "tests/io/meshes/mesh_samples.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

/// A document with one buffer of floats, to which accessors are added one by one.
class GltfText {
 public:
  /// Returns the accessor's number.
  int add(const char* type, std::size_t width, const std::vector<float>& numbers) {
    views_ += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", views_.empty() ? "" : ",",
                          bytes_.size(), 4 * numbers.size());
    accessors_ += fmt::format(R"({}{{"bufferView":{},"componentType":5126,"count":{},"type":"{}"}})",
                              accessors_.empty() ? "" : ",", view_count_++, numbers.size() / width, type);
    const std::size_t first = bytes_.size();
    bytes_.resize(first + 4 * numbers.size());
    std::memcpy(bytes_.data() + first, numbers.data(), 4 * numbers.size());
    return accessor_count_++;
  }
  int times(const std::vector<float>& times_s) { return add("SCALAR", 1, times_s); }
  /// An accessor of text of its own, such as a sparse one, whose views are those of the last ones added.
  int add_text(const std::string& accessor) {
    accessors_ += (accessors_.empty() ? "" : ",") + accessor;
    return accessor_count_++;
  }
  int view_count() const { return view_count_; }

  /// A .glb with these members beside its buffer.
  std::string glb(const std::string& members) const {
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},{},"buffers":[{{"byteLength":{}}}],"bufferViews":[{}],"accessors":[{}]}})",
        members, bytes_.size(), views_, accessors_);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
      const auto number = static_cast<std::uint32_t>(value);
      std::string text(4, '\0');
      std::memcpy(text.data(), &number, 4);
      return text;
    };
    return "glTF" + word(2) + word(28 + json.size() + bytes_.size()) + word(json.size()) + "JSON" + json +
           word(bytes_.size()) + std::string("BIN\0", 4) + bytes_;
  }

 private:
  std::string bytes_, views_, accessors_;
  int view_count_ = 0, accessor_count_ = 0;
};

MeshFile parse(const std::string& glb, const std::string& animation = "") {
  return meshes::parse_gltf(glb, "/nowhere/test.glb", Trust::trusted, animation);
}

std::string refusal(const std::string& glb, const std::string& animation = "") {
  try {
    const MeshFile file = parse(glb, animation);
    if (file.deformation) file.deformation.form_at(0.5);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

/// Within the rounding of the file's floats.
void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-6)
      << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

const std::vector<float> corner{0, 0, 0, 1, 0, 0, 0, 1, 0};  // a triangle

/// One sampler and one channel of an animation.
std::string animation(int node, const char* path, int times, int values, const char* kind = "LINEAR",
                      const char* name = "") {
  return fmt::format(R"({{"name":"{}","samplers":[{{"input":{},"output":{},"interpolation":"{}"}}],)"
                     R"("channels":[{{"sampler":0,"target":{{"node":{},"path":"{}"}}}}]}})",
                     name, times, values, kind, node, path);
}

// A triangle below two nodes: the upper one goes 4 m along x and turns a quarter around z, the lower one
// grows in a step. Fails if a path is not applied, in another order than translation, rotation, scale, if
// turns are not made at a constant rate, or if a form before the first key or after the last is not held.
TEST(GltfAnimation, NodesMove) {
  GltfText text;
  const float half = std::sqrt(0.5f);
  const int positions = text.add("VEC3", 3, corner), times = text.times({1, 3});
  const int ways = text.add("VEC3", 3, {0, 0, 0, 4, 0, 0}),
            turns = text.add("VEC4", 4, {0, 0, 0, 1, 0, 0, half, half});
  const int sizes = text.add("VEC3", 3, {1, 1, 1, 3, 3, 3});
  const std::string members =
      R"("nodes":[{"children":[1]},{"mesh":0,"translation":[0,0,5]}],)" +
      fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],)", positions) +
      R"("animations":[)" + animation(0, "translation", times, ways) + ',' +
      animation(0, "rotation", times, turns) + ',' + animation(1, "scale", times, sizes, "STEP") + ']';
  const MeshFile file = parse(text.glb(members));
  ASSERT_TRUE(file.deformation);
  EXPECT_EQ(file.deformation.end_s, 3.0);
  EXPECT_TRUE(file.report.left_out.empty());
  expect_near(file.mesh.positions_m[1], {1, 0, 5});
  expect_near(file.deformation.form_at(0.0).positions_m[1], {1, 0, 5});
  const double c = std::cos(std::numbers::pi / 8.0), s = std::sin(std::numbers::pi / 8.0);
  expect_near(file.deformation.form_at(1.5).positions_m[1], {1.0 + c, s, 5});
  expect_near(file.deformation.form_at(1.5).positions_m[2], {1.0 - s, c, 5});
  for (const double time_s : {3.0, 9.0})
    expect_near(file.deformation.form_at(time_s).positions_m[1], {4, 3, 5});
  EXPECT_TRUE(file.deformation.form_at(1.5).normals.empty());
}

// Fails if a cubic is not that of glTF's appendix C, or its tangents lie in another order: from 1 with a
// slope of 2 a second to 5 with one of -1, in 2 s; in the middle (1 + 5) / 2 + 2 (2 - -1) / 8 = 3.75.
TEST(GltfAnimation, CubicsHaveTheirTangents) {
  GltfText text;
  const int positions = text.add("VEC3", 3, corner), times = text.times({0, 2});
  const int ways = text.add("VEC3", 3, {9, 9, 9, 1, 0, 0, 2, 0, 0, -1, 0, 0, 5, 0, 0, 9, 9, 9});
  const MeshFile file = parse(text.glb(
      R"("nodes":[{"mesh":0}],)" +
      fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],)", positions) +
      R"("animations":[)" + animation(0, "translation", times, ways, "CUBICSPLINE") + ']'));
  expect_near(file.deformation.form_at(0.0).positions_m[0], {1, 0, 0});
  expect_near(file.deformation.form_at(1.0).positions_m[0], {3.75, 0, 0});
  expect_near(file.deformation.form_at(2.0).positions_m[0], {5, 0, 0});
}

/// A triangle with two morphs: one raises vertex 2 by (0, 0, 1) and its normal, one, sparse, moves vertex 1
/// by (2, 0, 0). `normals` is text of the second target.
std::string morphing(GltfText& text, const std::string& normals, const std::string& more) {
  const int positions = text.add("VEC3", 3, corner);
  const int normal = text.add("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int raised = text.add("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, 0, 1});
  const int turned = text.add("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, -1, 0});
  std::vector<float> index(1);
  const std::uint32_t one = 1;
  std::memcpy(index.data(), &one, 4);
  text.add("SCALAR", 1, index);
  text.add("VEC3", 3, {2, 0, 0});
  const int sparse = text.add_text(
      fmt::format(R"({{"componentType":5126,"count":3,"type":"VEC3","sparse":{{"count":1,)"
                  R"("indices":{{"bufferView":{},"componentType":5125}},"values":{{"bufferView":{}}}}}}})",
                  text.view_count() - 2, text.view_count() - 1));
  return fmt::format(R"("nodes":[{{"mesh":0}}],"meshes":[{{"weights":[0.5,0],"primitives":[{{)"
                     R"("attributes":{{"POSITION":{},"NORMAL":{}}},"targets":[{{"POSITION":{},"NORMAL":{}}},)"
                     R"({{"POSITION":{}{}}}]}}]}}])",
                     positions, normal, raised, turned, sparse, normals) +
         more;
}

// Fails if morphs are not added by their weights, at rest or as they move, if a sparse accessor moves another
// vertex, or if normals do not go along.
TEST(GltfAnimation, MorphsGoByTheirWeights) {
  GltfText text;
  const int times = text.times({0, 1}), weights = text.add("SCALAR", 1, {0, 0, 1, 0.5f});
  const int none = text.add("VEC3", 3, std::vector<float>(9, 0.0f));
  const MeshFile file =
      parse(text.glb(morphing(text, fmt::format(R"(,"NORMAL":{})", none),
                              R"(,"animations":[)" + animation(0, "weights", times, weights) + ']')));
  expect_near(file.mesh.positions_m[2], {0, 1, 0.5});
  expect_near(file.mesh.positions_m[1], {1, 0, 0});
  expect_near(file.mesh.normals[2], glm::normalize(glm::dvec3(0, -0.5, 1)));
  const MeshForm form = file.deformation.form_at(0.5);
  expect_near(form.positions_m[2], {0, 1, 0.5});
  expect_near(form.positions_m[1], {1.5, 0, 0});
  expect_near(form.positions_m[0], {0, 0, 0});
  expect_near(form.normals[2], {0, -0.5, 1});
}

// Fails if normals of a mesh stay where a morph moves its vertices without saying what becomes of them.
TEST(GltfAnimation, NormalsThatMorphsLackComeFromFaces) {
  GltfText text;
  const MeshFile file = parse(text.glb(morphing(text, "", "")));
  EXPECT_TRUE(file.mesh.normals.empty());
  EXPECT_EQ(left_out(file, "normals, since some morphs have none"), 3u);
  EXPECT_FALSE(file.deformation);
}

/// A triangle below a node that would move it, with a skin of two joints: the second one, bound 1 m up, turns
/// around z. Vertex 1 goes with both alike, vertex 2 with the second.
std::string skinned(GltfText& text, const std::vector<float>& joints, const std::string& more = "") {
  const int positions = text.add("VEC3", 3, corner);
  const int joint = text.add("VEC4", 4, joints);
  const int weights = text.add("VEC4", 4, {1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0});
  const int matrices = text.add("MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                             1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  return fmt::format(
             R"("nodes":[{{"mesh":0,"skin":0,"translation":[7,7,7]}},{{"children":[2]}},)"
             R"({{"translation":[0,1,0]}}],"skins":[{{"joints":[1,2],"inverseBindMatrices":{}}}],)"
             R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{},"JOINTS_0":{},"WEIGHTS_0":{}}}}}]}}])",
             matrices, positions, joint, weights) +
         more;
}

// Fails if a skin does not go with its joints, if weights are not made to sum to 1 (those of vertex 1 sum to
// 2), or if the node that has the skin moves it too.
TEST(GltfAnimation, SkinsGoWithTheirJoints) {
  GltfText text;
  const float half = std::sqrt(0.5f);
  const int times = text.times({0, 1}), turns = text.add("VEC4", 4, {0, 0, 0, 1, 0, 0, half, half});
  const std::vector<float> joints{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
  const MeshFile file = parse(
      text.glb(skinned(text, joints, R"(,"animations":[)" + animation(2, "rotation", times, turns) + ']')));
  for (std::size_t i = 0; i < 3; ++i)
    expect_near(file.mesh.positions_m[i], {corner[3 * i], corner[3 * i + 1], corner[3 * i + 2]});
  const MeshForm form = file.deformation.form_at(1.0);
  expect_near(form.positions_m[0], {0, 0, 0});
  // Around (0, 1, 0), (1, 0, 0) goes to (1, 2, 0).
  expect_near(form.positions_m[1], {1, 1, 0});
  expect_near(form.positions_m[2], {0, 1, 0});
}

// Two animations move the same node. Fails if another than the named one is played, if without a name the
// later one counts, if this is not reported, or if a wrong name is taken.
TEST(GltfAnimation, OneIsChosenByItsName) {
  GltfText text;
  const int positions = text.add("VEC3", 3, corner), times = text.times({0, 1});
  const int near = text.add("VEC3", 3, {0, 0, 0, 1, 0, 0}), far = text.add("VEC3", 3, {0, 0, 0, 8, 0, 0});
  const std::string glb = text.glb(
      R"("nodes":[{"mesh":0}],)" +
      fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],)", positions) +
      R"("animations":[)" + animation(0, "translation", times, near, "LINEAR", "step") + ',' +
      animation(0, "translation", times, far, "LINEAR", "leap") + ']');
  const MeshFile all = parse(glb);
  expect_near(all.deformation.form_at(1.0).positions_m[0], {1, 0, 0});
  EXPECT_EQ(left_out(all, "animations that move what an earlier one moves"), 1u);
  const MeshFile leap = parse(glb, "leap");
  expect_near(leap.deformation.form_at(1.0).positions_m[0], {8, 0, 0});
  EXPECT_TRUE(leap.report.left_out.empty());
  EXPECT_THAT(refusal(glb, "walk"),
              HasSubstr("test.glb: expected an animation \"walk\", got \"step\", \"leap\""));
}

// Fails if an animation, a morph or a skin that leads out of the file is taken, or its refusal does not say
// which one it is.
TEST(GltfAnimation, DamagedOnesAreRefused) {
  const auto moved = [](int node, const char* path, const std::vector<float>& times_s,
                        const std::vector<float>& values, const char* kind = "LINEAR") {
    GltfText text;
    const int positions = text.add("VEC3", 3, corner), times = text.times(times_s);
    const int to = text.add("VEC3", 3, values);
    return refusal(text.glb(
        R"("nodes":[{"mesh":0}],)" +
        fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],)", positions) +
        R"("animations":[)" + animation(node, path, times, to, kind) + ']'));
  };
  const std::vector<float> two{0, 0, 0, 1, 0, 0};
  EXPECT_EQ(moved(0, "translation", {0, 1}, two), "");
  EXPECT_THAT(moved(3, "translation", {0, 1}, two), HasSubstr("nodes below 1 in animations[0], got 3"));
  EXPECT_THAT(moved(0, "translation", {1, 0}, two), HasSubstr("times that rise from 0 in animations[0]"));
  EXPECT_THAT(moved(0, "translation", {0, NAN}, two), HasSubstr("finite numbers in accessors[1]"));
  EXPECT_THAT(moved(0, "translation", {0, 1, 2}, two), HasSubstr("3 values in animations[0], got 6 numbers"));
  EXPECT_THAT(moved(0, "translation", {0, 1}, two, "CUBICSPLINE"), HasSubstr("6 values in animations[0]"));
  EXPECT_THAT(moved(0, "translation", {0, 1}, two, "BOUNCE"), HasSubstr("STEP, LINEAR or CUBICSPLINE"));
  EXPECT_THAT(moved(0, "rotation", {0, 1}, two), HasSubstr("accessors[2] of type VEC4"));
  EXPECT_THAT(moved(0, "translation", {0, 1}, {0, 0, 0, 3e38f, 3e38f, 0}), HasSubstr("within 1e30"));

  GltfText text;
  const std::vector<float> joints{0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0};
  EXPECT_THAT(refusal(text.glb(skinned(text, joints))), HasSubstr("joints below 2, got 2"));
  GltfText wide;
  EXPECT_THAT(refusal(wide.glb(morphing(wide, R"(,"NORMAL":99)", ""))), HasSubstr("accessors[99]"));
  // Zeros that are not in the file must not fill the memory.
  GltfText zeros;
  const int huge = zeros.add_text(R"({"componentType":5126,"count":4000000000,"type":"VEC3"})");
  EXPECT_THAT(refusal(zeros.glb(
                  fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}])", huge))),
              HasSubstr("got"));
}

/// CPU time of reading a file of `count` nodes that show one mesh with `count` targets and one skin of
/// `count` joints, and of one form of it; the least of three times.
double seconds_of_crowd(int count) {
  GltfText text;
  const int position = text.add("VEC3", 3, corner), times = text.times({0, 1});
  const int joint = text.add("VEC4", 4, std::vector<float>(12, 0.0f));
  const int weight = text.add("VEC4", 4, std::vector<float>(12, 1.0f));
  const int ways = text.add("VEC3", 3, {0, 0, 0, 4, 0, 0});
  std::string nodes, joints, targets;
  for (int i = 0; i < count; ++i) {
    const char* const comma = i == 0 ? "" : ",";
    nodes += fmt::format(R"({}{{"mesh":0,"skin":0}})", comma);
    joints += fmt::format("{}{}", comma, i);
    targets += fmt::format(R"({}{{"POSITION":{}}})", comma, position);
  }
  const std::string glb = text.glb(
      fmt::format(R"("nodes":[{}],"skins":[{{"joints":[{}]}}],"meshes":[{{"primitives":[{{"targets":[{}],)"
                  R"("attributes":{{"POSITION":{},"JOINTS_0":{},"WEIGHTS_0":{}}}}}]}}],"animations":[{}])",
                  nodes, joints, targets, position, joint, weight, animation(0, "translation", times, ways)));
  double least_s = 1e9;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t start = std::clock();
    const MeshFile file = parse(glb);
    const MeshForm form = file.deformation.form_at(0.5);
    least_s = std::min(least_s, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    EXPECT_EQ(form.positions_m.size(), 3 * static_cast<std::size_t>(count));
    expect_near(form.positions_m.back(), {2, 1, 0});  // all go with the first joint
  }
  return least_s;
}

// Fails if each node that shows a mesh makes all joints of its skin anew or looks at all targets of the mesh:
// eight times the file would then take some sixty times as long (bound: 8, limit: 24).
TEST(GltfAnimation, TimeGrowsWithTheFile) {
  const double small_s = seconds_of_crowd(500), large_s = seconds_of_crowd(4000);
  EXPECT_LT(large_s, 24.0 * small_s) << small_s << " s and " << large_s << " s";
}

}  // namespace
}  // namespace offing::test
