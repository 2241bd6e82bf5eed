// Cameras and lights of glTF files.
#include "host/io/meshes/gltf_stage.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::meshes {
namespace {

using ::testing::HasSubstr;

std::string sample() {
  std::ifstream file(OFFING_CORPUS "/gltf_stage/stage", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string json(const std::string& members) {
  return R"({"asset":{"version":"2.0"},)" + members + "}";
}

std::string refusal(const std::string& bytes) {
  try {
    parse_gltf_stage(bytes, "/nowhere/test");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

std::size_t left_out(const GltfStage& stage, const std::string& what) {
  const auto found = std::ranges::find(stage.left_out, what, &LeftOut::what);
  return found == stage.left_out.end() ? 0 : found->count;
}

// A camera 5 m south of a node 2 m up, which turns by 2 acos(0.8) = 73.74 degrees around y in 1 s; lights of
// three types. Fails if one is lost, in other units, or not below its node, and if what is left out is not
// reported.
TEST(GltfStage, HasCamerasAndLights) {
  const GltfStage stage = parse_gltf_stage(sample(), "/nowhere/test");
  ASSERT_EQ(stage.cameras.size(), 1u);
  EXPECT_EQ(stage.cameras[0].name, "shot");
  EXPECT_EQ(stage.cameras[0].vertical_field_of_view_rad, 0.7);
  EXPECT_FALSE(stage.has_meshes);
  EXPECT_EQ(stage.nodes->end_s(), 1.0);
  const glm::dvec3 start_m(stage.nodes->to_world(0.0)[stage.cameras[0].node][3]);
  const glm::dvec3 end_m(stage.nodes->to_world(1.0)[stage.cameras[0].node][3]);
  EXPECT_LT(glm::distance(start_m, glm::dvec3(0, 2, 5)), 1e-12);
  EXPECT_LT(glm::distance(end_m, glm::dvec3(5.0 * 0.96, 2, 5.0 * 0.28)), 1e-6);  // of floats
  ASSERT_EQ(stage.lights.size(), 3u);
  EXPECT_TRUE(stage.lights[0].is_directional);
  EXPECT_EQ(stage.lights[0].name, "sky");
  EXPECT_EQ(stage.lights[0].colour, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(stage.lights[0].intensity, 800.0);
  EXPECT_FALSE(stage.lights[1].is_directional);
  EXPECT_EQ(stage.lights[1].intensity, 90.0);
  EXPECT_EQ(stage.lights[2].intensity, 1.0);
  EXPECT_EQ(stage.lights[2].node, 5u);
  for (const char* const what :
       {"orthographic cameras", "cones of spot lights", "ranges of lights", "materials"})
    EXPECT_EQ(left_out(stage, what), 1u) << what;
}

// Fails if a file that is cut or damaged crashes the reader.
TEST(GltfStage, SurvivesDamage) {
  const std::string whole = sample();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(whole.substr(0, size)), "") << "cut at " << size;
  std::mt19937 random(3);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int value : {0x00, 0xff, int{'-'}, static_cast<int>(random() % 256u)}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(value);
      refusal(bytes);
    }
  }
}

// Fails if a camera or a light that leads out of the file, or a number that is none, is taken, or if the line
// does not say where.
TEST(GltfStage, RefusesWrongOnes) {
  EXPECT_THAT(refusal(json(R"("nodes":[{"camera":2}])")), HasSubstr("cameras[2]"));
  const auto camera = [](const std::string& values) {
    return refusal(json(R"("nodes":[{"camera":0}],"cameras":[{"perspective":{)" + values + "}}]"));
  };
  EXPECT_EQ(camera(R"("yfov":0.5)"), "");
  EXPECT_THAT(camera(""), HasSubstr("test: expected a number yfov, got none"));
  EXPECT_THAT(camera(R"("yfov":0)"), HasSubstr("a yfov between 0 and pi in cameras[0], got 0"));
  EXPECT_THAT(camera(R"("yfov":"wide")"), HasSubstr("a number yfov, got wide"));
  const auto light = [](const std::string& values) {
    return refusal(json(R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}}],)"
                        R"("extensions":{"KHR_lights_punctual":{"lights":[{)" +
                        values + "}]}}"));
  };
  EXPECT_EQ(light(R"("type":"point")"), "");
  EXPECT_THAT(light(R"("type":"area")"), HasSubstr("directional, point or spot in lights[0], got area"));
  EXPECT_THAT(light(R"("type":"point","intensity":-1)"), HasSubstr("of at least 0 in lights[0], got -1"));
  EXPECT_THAT(light(R"("type":"point","color":[1,1])"), HasSubstr("3 numbers in color"));
  EXPECT_THAT(refusal(json(R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}}])")),
              HasSubstr("a light 0 of KHR_lights_punctual"));
}

}  // namespace
}  // namespace offing::meshes
