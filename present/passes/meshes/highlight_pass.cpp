#include "present/passes/meshes/highlight_pass.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "host/highlights/projectors/texture_shapes.h"
#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int sky_map_unit = 0, highlight_image_unit = 1;

ShaderProgram highlight_program(highlights::HighlightTexture texture) {
  const ShaderPart compiled_for{"features of highlights",
                                fmt::format("#define TEXTURE_KIND {:d}\n", static_cast<int>(texture))};
  std::vector<ShaderPart> vertex =
      mesh_uniforms("Highlight", "ViewUniforms view; MeshMatrices matrices; HighlightUniforms highlight;");
  std::vector<ShaderPart> fragment = vertex;
  for (const char* name : {"meshes/mesh_place.glsl", "meshes/highlight.vert"})
    vertex.push_back(shader_file(name));
  for (const ShaderPart& part :
       {uniform_block("Lights", "LightUniforms lighting;"), compiled_for, CloudShadows::glsl()})
    fragment.push_back(part);
  for (const char* name : {"sky/environment.glsl", "air.glsl", "meshes/mesh_light.glsl",
                           "meshes/highlight_shapes.glsl", "meshes/highlight.frag"})
    fragment.push_back(shader_file(name));
  return ShaderProgram({.vertex = std::move(vertex), .fragment = std::move(fragment)});
}

int box_show(MeshShow show) {
  return show == MeshShow::ids ? 1 : show == MeshShow::regions ? 2 : 0;
}

}  // namespace

glm::vec3 id_colour(std::uint64_t id) {
  // Steps by the golden section around the colours' circle never come back to a place.
  const double turn = 0.618033988749895 * static_cast<double>(id % 1'000'003);
  const glm::dvec3 place = glm::fract(turn + glm::dvec3(0.0, 1.0 / 3.0, 2.0 / 3.0));
  return glm::vec3(glm::clamp(glm::abs(6.0 * place - 3.0) - 1.0, 0.02, 1.0));
}

HighlightPass::HighlightPass() : programs_(highlight_program), block_("Highlight", pass_binding) {}

glsl::HighlightUniforms HighlightPass::uniforms_of(const world::WorldMesh& mesh,
                                                   const highlights::DrawnHighlight& highlight,
                                                   const FrameRequest& request,
                                                   const Scenery& scenery) const {
  const highlights::HighlightControls& controls = highlight.controls;
  const glm::dmat4 to_box = highlights::projection_of(highlight.projector) *
                            glm::translate(glm::dmat4(1.0), mesh.surface().middle_m());
  return {.to_box = to_box,
          .colour = controls.colour,
          .opacity = static_cast<float>(highlight.opacity * scenery.lights.highlight_share(highlight.light)),
          .light_kcdpm2 = scenery.lights.highlight_kcdpm2(highlight.light),
          .softness = static_cast<float>(controls.softness),
          .box_right = mesh.motion().rotation * highlight.projector.right,
          .shape_depth = static_cast<float>(highlights::depth_of(controls.texture)),
          .box_light = id_colour(highlight.id) / static_cast<float>(request.exposure),
          .shows_box = box_show(request.meshes)};
}

void HighlightPass::bind_image(const ShaderProgram& program, const highlights::HighlightControls& controls,
                               const Scenery& scenery) const {
  const ImageUse use =
      controls.texture == highlights::HighlightTexture::normal_map ? ImageUse::normals : ImageUse::colours;
  const int picture = is_image(controls.texture) ? controls.picture : -1;
  bind_sampler(program, "picture", highlight_image_unit,
               scenery.pictures.texture(scenery.world.parameters().pictures, picture, use));
}

void HighlightPass::draw(const world::WorldMesh& mesh, const MeshGeometry& geometry,
                         const MeshViewMatrices& matrices, const FrameRequest& request,
                         const Scenery& scenery) {
  if (mesh.highlights().empty()) return;
  corners_.clear();
  for (const std::uint32_t face : mesh.highlight_faces()) {
    const TriangleIndices& corners = mesh.surface().mesh().faces[face];
    corners_.insert(corners_.end(), corners.begin(), corners.end());
  }
  geometry.set_drawn_faces(corners_);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glsl::ViewUniforms view = view_uniforms(request.camera);
  view.haze_perm = haze_perm(scenery.world.parameters().atmosphere);
  const ShaderProgram* used = nullptr;
  for (const highlights::DrawnHighlight& highlight : mesh.highlights()) {
    const ShaderProgram& program = programs_.with(highlight.controls.texture);
    if (&program != used) {
      program.use();
      scenery.lights.bind(program);
      bind_sampler(program, "environment", sky_map_unit, scenery.environment);
      used = &program;
    }
    bind_image(program, highlight.controls, scenery);
    block_.fill(view, matrices.uniforms(), uniforms_of(mesh, highlight, request, scenery));
    block_.bind(program);
    geometry.draw(static_cast<GLsizei>(3 * highlight.first_face),
                  static_cast<GLsizei>(3 * highlight.face_count));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace offing::present
