#include "present/gl/uniform_block.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "present/passes/meshes/mesh_uniforms.h"
#include "present/passes/view_uniforms.h"
#include "present/passes/water/water_uniforms.h"
#include "present/passes/water/wave_features.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

using UniformBlockTest = test::GlTest;

ShaderProgram program_with(const std::vector<ShaderPart>& structs) {
  std::vector<ShaderPart> fragment = structs;
  fragment.push_back({"main", "out vec4 light; void main() { light = vec4(1.0); }"});
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = std::move(fragment)});
}

/// Where the driver has a member of a block without an instance name; -1: nowhere.
int offset_of(const char* member) {
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  GLuint index = GL_INVALID_INDEX;
  glGetUniformIndices(static_cast<GLuint>(program), 1, &member, &index);
  if (index == GL_INVALID_INDEX) return -1;
  GLint offset = -1;
  glGetActiveUniformsiv(static_cast<GLuint>(program), 1, &index, GL_UNIFORM_OFFSET, &offset);
  return offset;
}

// Fails if a compiler's layout of a struct is not std140's: vectors after scalars, and matrices.
TEST_F(UniformBlockTest, StructsLieAsInTheShader) {
  const ShaderProgram view =
      program_with({shader_file("view_uniforms.h"), uniform_block("View", "ViewUniforms view;")});
  view.use();
  EXPECT_EQ(offset_of("view.ray_forward"), offsetof(glsl::ViewUniforms, ray_forward));
  EXPECT_EQ(offset_of("view.near_m"), offsetof(glsl::ViewUniforms, near_m));
  EXPECT_EQ(offset_of("view.ray_right"), offsetof(glsl::ViewUniforms, ray_right));
  EXPECT_EQ(offset_of("view.haze_perm"), offsetof(glsl::ViewUniforms, haze_perm));

  const ShaderProgram mesh =
      program_with({shader_file("meshes/mesh_uniforms.h"),
                    uniform_block("Highlight", "MeshMatrices matrices; HighlightUniforms highlight;")});
  mesh.use();
  const auto second = static_cast<int>(sizeof(glsl::MeshMatrices));
  EXPECT_EQ(offset_of("matrices.cut_m"), offsetof(glsl::MeshMatrices, cut_m));
  EXPECT_EQ(offset_of("highlight.to_box"),
            second + static_cast<int>(offsetof(glsl::HighlightUniforms, to_box)));
  EXPECT_EQ(offset_of("highlight.opacity"),
            second + static_cast<int>(offsetof(glsl::HighlightUniforms, opacity)));
  EXPECT_EQ(offset_of("highlight.shows_box"),
            second + static_cast<int>(offsetof(glsl::HighlightUniforms, shows_box)));

  const ShaderProgram water =
      program_with(water_uniforms("Water", "WaterUniforms water; ShapeUniforms shape;"));
  water.use();
  const auto shape = static_cast<int>(sizeof(glsl::WaterUniforms));
  EXPECT_EQ(offset_of("water.foam_steepness"), offsetof(glsl::WaterUniforms, foam_steepness));
  EXPECT_EQ(offset_of("water.level_count"), offsetof(glsl::WaterUniforms, level_count));
  EXPECT_EQ(offset_of("water.foam_place"), offsetof(glsl::WaterUniforms, foam_place));
  EXPECT_EQ(offset_of("shape.cells"), shape + static_cast<int>(offsetof(glsl::ShapeUniforms, cells)));
  EXPECT_EQ(offset_of("shape.gerstner_mean_square"),
            shape + static_cast<int>(offsetof(glsl::ShapeUniforms, gerstner_mean_square)));
}

struct Values {
  glsl::vec4 values;
};

// Fails if a shader reads a struct that has grown on one side alone.
TEST_F(UniformBlockTest, RefusesABlockOfAnotherSize) {
  const ShaderProgram program =
      program_with({{"block", "layout(std140) uniform Tone { vec4 a; vec4 b; };\n"}});
  program.use();
  UniformBlock<Values> half("Tone", 0);
  half.fill({});
  EXPECT_THROW(half.bind(program), Error);
  UniformBlock<Values, Values> whole("Tone", 0);
  whole.fill({}, {});
  EXPECT_NO_THROW(whole.bind(program));
}

}  // namespace
}  // namespace offing::present
