#include "present/passes/terrain/terrain_pass.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "host/terrain/cast/step_colours.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int terrain_image_unit = 0, planes_unit = 1;

std::vector<ShaderPart> terrain_shaders(std::initializer_list<const char*> last) {
  std::vector<ShaderPart> parts{
      shader_file("view_uniforms.h"), shader_file("terrain/terrain_uniforms.h"),
      uniform_block("TerrainPass", "ViewUniforms view; TerrainUniforms terrain_pass;"),
      shader_file("view_ray.glsl"), shader_file("terrain/terrain_texels.glsl")};
  for (const char* name : last) parts.push_back(shader_file(name));
  return parts;
}

ShaderProgram light_program(const char* terrain_here) {
  return ShaderProgram({.vertex = {shader_file("screen.vert")},
                        .fragment = terrain_shaders({terrain_here, "terrain/terrain.frag"})});
}

ShaderProgram steps_program() {
  return ShaderProgram(
      {.vertex = {shader_file("screen.vert")}, .fragment = terrain_shaders({"terrain/terrain_steps.frag"})});
}

void fit(TextureArray& texture, const TextureArray::Shape& shape) {
  if (texture.shape() != shape) texture = TextureArray(shape);
}

}  // namespace

TerrainPass::TerrainPass()
    : exact_(light_program("terrain/terrain_exact.glsl")),
      enlarged_(light_program("terrain/terrain_enlarged.glsl")),
      steps_(steps_program()),
      block_("TerrainPass", pass_binding),
      no_vertices_(GlVertexArray::make()) {}

bool TerrainPass::is_exact(const Camera& camera) const {
  return image_.shape().width == camera.width_px && image_.shape().height == camera.height_px;
}

void TerrainPass::prepare(const world::TerrainImage& terrain, Transfer& transfer) {
  glActiveTexture(GL_TEXTURE0);
  const int width = terrain.width_px, height = terrain.height_px;
  fit(image_, {.width = width, .height = height, .layers = 1, .channels = 4});
  fit(planes_, {.width = width, .height = height, .layers = terrain::HitPlanes::plane_count, .channels = 1});
  const std::array<Upload, 2> uploads{{{terrain.image, &image_}, {terrain.planes, &planes_}}};
  transfer.upload(uploads);
}

void TerrainPass::bind(const ShaderProgram& program) const {
  program.use();
  image_.bind(terrain_image_unit);
  planes_.bind(planes_unit);
  program.set("terrain_image", terrain_image_unit);
  program.set("terrain_planes", planes_unit);
  glBindVertexArray(no_vertices_.name());
}

void TerrainPass::draw(const Camera& camera, Part part, LayerLight light) {
  const ShaderProgram& program = is_exact(camera) ? exact_ : enlarged_;
  bind(program);
  glsl::TerrainUniforms values{};
  values.draws_edges = part == Part::edges ? 1 : 0;
  block_.fill(view_uniforms(camera), values);
  block_.bind(program);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  if (part == Part::edges) {
    glEnable(GL_BLEND);
    set_layer_blending(light);
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

void TerrainPass::draw_steps() {
  bind(steps_);
  glsl::TerrainUniforms values{};
  static_assert(std::size(values.step_marks) == std::size(terrain::step_colours));
  std::ranges::transform(terrain::step_colours, values.step_marks, [](const terrain::StepColour& mark) {
    return glm::vec4(mark.rgb[0], mark.rgb[1], mark.rgb[2], mark.steps);
  });
  block_.fill({}, values);
  block_.bind(steps_);
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present
